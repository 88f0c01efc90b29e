#include "app/commands.hpp"

#include "app/finish.hpp"
#include "app/interrupt.hpp"
#include "app/located.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "compare/compare.hpp"
#include "io/decks/abaqus.hpp"
#include "io/decks/nastran.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/input/reference.hpp"
#include "io/input/schema.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/write/geometry.hpp"
#include "io/tables/summary.hpp"
#include "io/write/write_beam.hpp"
#include "io/write/write_results.hpp"
#include "io/superelements/labels.hpp"
#include "io/write/write_superelement.hpp"
#include "model/shape/doubts.hpp"
#include "run/study/equivalent_beam.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/reduce.hpp"
#include "run/routes/route.hpp"
#include "run/analyses/run.hpp"
#include "solve/sparse_factor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/core.h>

namespace plica {
namespace {

InputFile input_file(const std::filesystem::path& path, const std::string& text) {
  return {path.filename().string(), text};
}

VariantResult run_variant(const CaseFile& file, std::size_t number,
                          const std::optional<MeasuredFile>& measured, Progress& progress) {
  const Variant& variant = file.data.variants[number];
  const Case& changed = file.variants[number];
  progress.title(file.data.name + ", " + variant.name);
  const Results results = located(file, [&] {
    return run(measured ? for_comparison(changed) : for_headline(changed),
               [&](const std::string& s) { progress.stage(s); });
  });
  VariantResult result{
      .name = variant.name, .set = {}, .headline = headline(results), .comparison = {}};
  if (measured) result.comparison = compare(results, measured->data);
  result.set.assign(variant.set.begin(), variant.set.end());
  return result;
}

// Work of a stage of the error bars, in runs for the headline: finer meshes cost more, those of
// tolerances are coarse.
double work_of(const std::string& stage) {
  if (stage == "finer along") return 2;
  if (stage == "finer around") return 1.5;
  return stage.starts_with("tolerance of") ? 0.6 : 0.3;
}

// Shares of the work are counted in runs for the headline; the first one does more.
void add_error_bars_and_variants(Results& results, const CaseFile& file, const RunOptions& options,
                                 const std::optional<MeasuredFile>& measured, Progress& progress) {
  const bool bars = options.error_bars && file.data.analyses.error_bars;
  const double tolerances = double(file.data.tolerances.size());
  const double first = 1.5,
               of_bars = bars ? 3.5 + (tolerances > 0 ? 0.6 + 0.6 * tolerances : 0) : 0;
  const auto variants = options.variants ? file.data.variants.size() : 0;
  const double all = first + of_bars + double(variants);
  if (bars) {
    double done = first;
    try {
      results.error_bars = error_bars(file.data, results, [&](const std::string& s) {
        progress.share(done / all);
        progress.stage(s);
        done += work_of(s);
      });
      if (const std::string beyond = beyond_accuracy(file.data, results); !beyond.empty())
        results.warnings.push_back(beyond);
    } catch (const std::exception& error) { // the run itself is good
      results.warnings.push_back(std::string("error bars left out: ") + error.what());
    }
  }
  for (std::size_t i = 0; i < variants; ++i) {
    progress.share((first + of_bars + double(i)) / all);
    try {
      results.variants.push_back(run_variant(file, i, measured, progress));
    } catch (const std::exception& error) {
      results.warnings.push_back("variant '" + file.data.variants[i].name +
                                 "' left out: " + error.what());
    }
  }
}

int write_deck(const CaseFile& file, const RunOptions& options) {
  const bool nastran = options.deck == "nastran";
  const std::string name = nastran ? "model.bdf" : "model.inp";
  OutputFolder out(options.out, {.command = "deck", .inputs = files_of(file), .names = {name}});
  const BuiltCase built = build(file.data);
  out.add(name, nastran ? nastran_model(file.data, built) : abaqus_model(file.data, built));
  out.commit();
  if (!options.quiet) print((out.path() / name).string() + "\n");
  return 0;
}

// The test that the case names.
std::optional<MeasuredFile> test_of(const CaseFile& file) {
  if (file.data.measured.empty()) return std::nullopt;
  return read_measured_file(
      (std::filesystem::path(file.path).parent_path() / file.data.measured).string());
}

OutputWork work_of(const CaseFile& file, const std::optional<MeasuredFile>& measured,
                   const RunOptions& options) {
  OutputWork work{.command = "run", .inputs = files_of(file), .names = result_files(file.data)};
  if (measured)
    for (std::filesystem::path& path : files_of(*measured)) work.inputs.push_back(std::move(path));
  const auto& modes = file.data.analyses.modes;
  for (std::string& name : geometry_files(options.geometry, modes ? modes->count : 0))
    work.names.push_back(std::move(name));
  return work;
}

// What the results are put beside, as it was when it was read.
void add_test(Results& results, const MeasuredFile& measured, const std::vector<FrfSet>& frfs) {
  results.inputs.push_back(input_file(measured.path, measured.text));
  results.comparison = compare(results, measured.data);
  results.unanswered = unanswered(results, measured.data);
  if (!frfs.empty()) add_test_curves(results, frfs);
  for (std::string& warning : warnings_of(frfs)) results.warnings.push_back(std::move(warning));
  for (const std::string& caveat : measured.data.caveats)
    results.assumptions.push_back("Measurement: " + caveat);
}

} // namespace

std::string case_file_of(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return path;
  const std::filesystem::path folder = std::filesystem::canonical(path, ignored);
  return (std::filesystem::path(path) / folder.filename()).string() + ".yaml";
}

int run_command(const RunOptions& options) {
  if (is_benchmark(options.case_path)) return benchmark_command(options);
  set_threads(options.threads);
  const CaseFile file = read_case(options.case_path, options.model);
  if (!options.deck.empty()) return located(file, [&] { return write_deck(file, options); });
  const std::optional<MeasuredFile> measured = test_of(file);
  std::vector<FrfSet> frfs;
  if (measured) frfs = load_frfs(measured->data, measured->path.parent_path());
  OutputFolder out(options.out, work_of(file, measured, options));
  Progress progress(options.quiet);
  progress.title(file.data.name);
  Results results = with_doubts(file, [&] {
    return located(
        file, [&] { return run(file.data, [&](const std::string& s) { progress.stage(s); }); });
  });
  results.plica_version = PLICA_VERSION;
  results.versions = PLICA_LIBRARIES;
  results.inputs.push_back(input_file(file.path, file.text));
  if (measured) add_test(results, *measured, frfs);
  bool interrupted = false;
  try {
    add_error_bars_and_variants(results, file, options, measured, progress);
  } catch (const Interrupted& stop) { // the run itself is finished
    interrupted = true;
    forget_interrupt();
    results.warnings.push_back("stopped by " + interrupted_by() + " before \"" + stop.stage +
                               "\": what would follow is left out");
  }
  progress.title(file.data.name);
  progress.stage("writing " + options.out.string());
  write_geometry(results, options.geometry, out);
  write_results(results, out);
  hand_over(out);
  progress.finish();
  if (!options.quiet) print(summary_text(results, options.out / "report.html"));
  if (interrupted) {
    say(fmt::format("plica: {}\n", results.warnings.back()));
    return interrupted_exit();
  }
  if (results.verification.made && !results.verification.passed) {
    say(fmt::format("plica: the proof failed: {}\n", results.verification.reason));
    return 2;
  }
  return 0;
}

int reduce_command(const ReduceOptions& options) {
  set_threads(options.threads);
  const CaseFile file = read_case(options.case_path, options.model);
  std::vector<std::string> names = superelement_files(false);
  if (options.beam)
    for (std::string& name : beam_files()) names.push_back(std::move(name));
  OutputFolder out(options.out,
                   {.command = "reduce", .inputs = files_of(file), .names = std::move(names)});
  Progress progress(options.quiet);
  progress.title(file.data.name);
  const ReducedCase reduced = with_doubts(file, [&] {
    return located(file, [&] {
      return reduce_case(file.data, options.request,
                         [&](const std::string& s) { progress.stage(s); });
    });
  });
  std::optional<EquivalentBeam> beam;
  if (options.beam)
    beam = located(file, [&] {
      return equivalent_beam(file.data, [&](const std::string& s) { progress.stage(s); });
    });
  write_superelement(reduced, options.units, out);
  if (beam) write_beam(*beam, out);
  hand_over(out);
  progress.finish();
  if (!options.quiet)
    print(fmt::format("{}\n{}Report: {}\n", certificate_text(reduced),
                      beam ? beam_text(*beam) + "\n" : "",
                      (out.path() / "certificate.html").string()));
  return reduced.certificate.passed && reduced.proved ? 0 : 2;
}

int check_command(const CheckOptions& options) {
  set_threads(options.threads);
  if (is_benchmark(options.case_path)) {
    read_benchmark(options.case_path);
    print(fmt::format("{}: the benchmark is valid\n", options.case_path));
    return 0;
  }
  const CaseFile file = read_case(options.case_path, options.model);
  if (!file.data.measured.empty())
    read_measured((std::filesystem::path(file.path).parent_path() / file.data.measured).string());
  const BuiltCase built = located(file, [&] { return build(file.data); });
  const auto symmetry = located(file, [&] {
    return symmetric_view(built.model, file.data.analyses.reduction ? Symmetry::automatic
                                                                    : file.data.analyses.symmetry);
  });
  const Estimate cost = located(file, [&] { return estimate(built, file.data.analyses); });
  const MeshQuality quality = mesh_quality(built.model.mesh);
  print(fmt::format("{}: the case is valid\n", options.case_path));
  print(fmt::format("  {} nodes, {} elements, {} degrees of freedom\n", cost.nodes, cost.elements,
                    cost.dofs));
  if (!built.model.shells.empty())
    print(fmt::format(
        "  mesh: warp at most {:.2g}, aspect ratio at most {:.2g}, Jacobian ratio at least "
        "{:.2g}\n",
        quality.max_warp, quality.max_aspect, quality.min_jacobian));
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : built.model.mesh.nodes) box.extend(x);
  print(fmt::format("  {:.4g} x {:.4g} x {:.4g} m (x, y, z)\n", box.sizes().x(), box.sizes().y(),
                    box.sizes().z()));
  for (const std::string& doubt : doubts(file.data, built)) print("  warning: " + doubt + "\n");
  for (const BuiltSensor& sensor : built.sensors)
    print(fmt::format("  sensor {}: {:.2f} mm from the nearest node\n", sensor.name,
                      1e3 * sensor.distance));
  const std::size_t variants = file.data.variants.size(), limits = 2 * file.data.tolerances.size();
  if (const auto* view = std::get_if<CyclicModel>(&symmetry))
    print(fmt::format(
        "  repeats around its axis: solved in {} sectors, in far less than the estimate\n",
        view->around()));
  else if (!file.data.analyses.reduction)
    print(fmt::format("  full mesh: {}\n", std::get<std::string>(symmetry)));
  print(fmt::format("  estimate: {:.1f} GB, {:.0f} s a run", cost.memory / 1e9, cost.seconds));
  if (variants > 0) print(fmt::format("; {} variants about as long each", variants));
  if (file.data.analyses.error_bars)
    print(fmt::format("; error bars: 2 runs on finer meshes, {} on coarse ones",
                      limits > 0 ? limits + 2 : 0));
  print("\n");
  return 0;
}

int schema_command(const std::string& what, bool reference) {
  const std::string schema = what == "measured"    ? measured_schema()
                             : what == "benchmark" ? benchmark_schema()
                                                   : case_schema();
  print((reference ? reference_of(schema) : schema) + "\n");
  return 0;
}

} // namespace plica
