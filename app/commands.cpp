#include "app/commands.hpp"

#include "app/interrupt.hpp"
#include "app/located.hpp"
#include "app/progress.hpp"
#include "diagnose/compare.hpp"
#include "io/decks/abaqus.hpp"
#include "io/decks/nastran.hpp"
#include "io/files.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/input/reference.hpp"
#include "io/input/schema.hpp"
#include "io/measured_data.hpp"
#include "io/results/geometry.hpp"
#include "io/results/summary.hpp"
#include "io/results/write_beam.hpp"
#include "io/results/write_results.hpp"
#include "io/superelements/labels.hpp"
#include "io/superelements/write.hpp"
#include "model/doubts.hpp"
#include "model/equivalent_beam.hpp"
#include "model/error_bars.hpp"
#include "model/reduce.hpp"
#include "model/route.hpp"
#include "model/run.hpp"
#include "solve/sparse_factor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/core.h>

namespace plica {
namespace {

VariantResult run_variant(const CaseFile& file, const Variant& variant,
                          const std::optional<Measured>& measured, Progress& progress) {
  progress.title(file.data.name + ", " + variant.name);
  CaseFile changed = read_case(file.path, file.data.model, variant.set);
  const Results results = located(file, [&] {
    return run(measured ? for_comparison(changed.data) : for_headline(changed.data),
               [&](const std::string& s) { progress.stage(s); });
  });
  VariantResult result{
      .name = variant.name, .set = {}, .headline = headline(results), .comparison = {}};
  if (measured) result.comparison = compare(results, *measured);
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
                                 const std::optional<Measured>& measured, Progress& progress) {
  const bool bars = options.error_bars && file.data.analyses.error_bars;
  const double tolerances = double(file.data.tolerances.size());
  const double first = 1.5,
               of_bars = bars ? 3.5 + (tolerances > 0 ? 0.6 + 0.6 * tolerances : 0) : 0;
  const auto variants = options.variants ? file.data.variants.size() : 0;
  const double all = first + of_bars + double(variants);
  if (bars) {
    double done = first;
    try {
      results.error_bars = error_bars(file.data, headline(results), [&](const std::string& s) {
        progress.share(done / all);
        progress.stage(s);
        done += work_of(s);
      });
    } catch (const std::exception& error) { // the run itself is good
      results.warnings.push_back(std::string("error bars left out: ") + error.what());
    }
  }
  for (std::size_t i = 0; i < variants; ++i) {
    progress.share((first + of_bars + double(i)) / all);
    results.variants.push_back(run_variant(file, file.data.variants[i], measured, progress));
  }
}

int write_deck(const CaseFile& file, const RunOptions& options) {
  const BuiltCase built = build(file.data);
  const bool nastran = options.deck == "nastran";
  const std::filesystem::path path = options.out / (nastran ? "model.bdf" : "model.inp");
  write_whole(path, nastran ? nastran_model(file.data, built) : abaqus_model(file.data, built));
  if (!options.quiet) fmt::print("{}\n", path.string());
  return 0;
}

} // namespace

std::string case_file_of(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return path;
  const std::filesystem::path folder = std::filesystem::canonical(path, ignored);
  return (std::filesystem::path(path) / folder.filename()).string() + ".yaml";
}

InputFile input_file(const std::filesystem::path& path) {
  return {path.filename().string(), read_whole(path)};
}

int run_command(const RunOptions& options) {
  if (is_benchmark(options.case_path)) return benchmark_command(options);
  set_threads(options.threads);
  const CaseFile file = read_case(options.case_path, options.model);
  std::optional<Measured> measured;
  const std::filesystem::path measured_file =
      std::filesystem::path(file.path).parent_path() / file.data.measured;
  if (!file.data.measured.empty()) measured = read_measured(measured_file.string());

  make_folder(options.out);
  if (!options.deck.empty()) return located(file, [&] { return write_deck(file, options); });
  Progress progress(options.quiet);
  progress.title(file.data.name);
  Results results = located(
      file, [&] { return run(file.data, [&](const std::string& s) { progress.stage(s); }); });
  results.plica_version = PLICA_VERSION;
  results.versions = PLICA_LIBRARIES;
  results.inputs.push_back(input_file(file.path));
  if (measured) {
    results.inputs.push_back(input_file(measured_file));
    results.comparison = compare(results, *measured);
    results.unanswered = unanswered(results, *measured);
    if (!measured->frf.empty()) {
      const std::vector<FrfSet> frfs = load_frfs(*measured, measured_file.parent_path());
      add_test_curves(results, frfs);
      for (std::string& warning : warnings_of(frfs)) results.warnings.push_back(std::move(warning));
    }
    for (const std::string& caveat : measured->caveats)
      results.assumptions.push_back("Measurement: " + caveat);
  }
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
  write_results(results, options.out);
  write_geometry(results, options.geometry, options.out);
  progress.finish();
  if (!options.quiet) fmt::print("{}", summary_text(results, options.out / "report.html"));
  if (interrupted) {
    fmt::print(stderr, "plica: {}\n", results.warnings.back());
    return interrupted_exit();
  }
  if (results.verification.made && !results.verification.passed) {
    fmt::print(stderr, "plica: the proof failed: {}\n", results.verification.reason);
    return 2;
  }
  return 0;
}

int reduce_command(const ReduceOptions& options) {
  set_threads(options.threads);
  const CaseFile file = read_case(options.case_path, options.model);
  make_folder(options.out);
  Progress progress(options.quiet);
  progress.title(file.data.name);
  const ReducedCase reduced = located(file, [&] {
    return reduce_case(file.data, options.request,
                       [&](const std::string& s) { progress.stage(s); });
  });
  std::optional<EquivalentBeam> beam;
  if (options.beam)
    beam = located(file, [&] {
      return equivalent_beam(file.data, [&](const std::string& s) { progress.stage(s); });
    });
  write_superelement(reduced, options.units, options.out);
  if (beam) write_beam(*beam, options.out);
  progress.finish();
  if (!options.quiet)
    fmt::print("{}\n{}Report: {}\n", certificate_text(reduced), beam ? beam_text(*beam) + "\n" : "",
               (options.out / "report.html").string());
  return reduced.certificate.passed && reduced.proved ? 0 : 2;
}

int check_command(const CheckOptions& options) {
  set_threads(options.threads);
  if (is_benchmark(options.case_path)) {
    read_benchmark(options.case_path);
    fmt::print("{}: the benchmark is valid\n", options.case_path);
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
  fmt::print("{}: the case is valid\n", options.case_path);
  fmt::print("  {} nodes, {} elements, {} degrees of freedom\n", cost.nodes, cost.elements,
             cost.dofs);
  if (!built.model.shells.empty())
    fmt::print("  mesh: warp at most {:.2g}, aspect ratio at most {:.2g}, Jacobian ratio at least "
               "{:.2g}\n",
               quality.max_warp, quality.max_aspect, quality.min_jacobian);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : built.model.mesh.nodes) box.extend(x);
  fmt::print("  {:.4g} x {:.4g} x {:.4g} m (x, y, z)\n", box.sizes().x(), box.sizes().y(),
             box.sizes().z());
  for (const std::string& doubt : doubts(file.data, built)) fmt::print("  warning: {}\n", doubt);
  for (const BuiltSensor& sensor : built.sensors)
    fmt::print("  sensor {}: {:.2f} mm from the nearest node\n", sensor.name,
               1e3 * sensor.distance);
  const std::size_t variants = file.data.variants.size(), limits = 2 * file.data.tolerances.size();
  if (const auto* view = std::get_if<CyclicModel>(&symmetry))
    fmt::print("  repeats around its axis: solved in {} sectors, in far less than the estimate\n",
               view->around());
  else if (!file.data.analyses.reduction)
    fmt::print("  full mesh: {}\n", std::get<std::string>(symmetry));
  fmt::print("  estimate: {:.1f} GB, {:.0f} s a run", cost.memory / 1e9, cost.seconds);
  if (variants > 0) fmt::print("; {} variants about as long each", variants);
  if (file.data.analyses.error_bars)
    fmt::print("; error bars: 2 runs on finer meshes, {} on coarse ones",
               limits > 0 ? limits + 2 : 0);
  fmt::print("\n");
  return 0;
}

int schema_command(const std::string& what, bool reference) {
  const std::string schema = what == "measured"    ? measured_schema()
                             : what == "benchmark" ? benchmark_schema()
                                                   : case_schema();
  fmt::print("{}\n", reference ? reference_of(schema) : schema);
  return 0;
}

} // namespace plica
