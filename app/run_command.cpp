#include "app/chosen_case.hpp"
#include "app/finish.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/run_options.hpp"
#include "app/run_shares.hpp"
#include "app/terminal.hpp"
#include "compare/compare.hpp"
#include "io/decks/write_abaqus.hpp"
#include "io/decks/write_nastran.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/tables/summary.hpp"
#include "io/write/geometry.hpp"
#include "io/write/write_results.hpp"
#include "lab/measured/states.hpp"
#include "run/analyses/run.hpp"
#include "run/routes/operating_state.hpp"
#include "run/routes/state_loads.hpp"
#include "run/stages.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/life_intervals.hpp"
#include "run/study/refine.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

// Named by its path from the folder of results, so that both may be moved together.
InputFile input_file(const std::filesystem::path& path, const std::string& text,
                     const OutputFolder& out) {
  return {std::filesystem::proximate(path, out.path()).generic_string(), text};
}

VariantResult run_variant(const CaseFile& file, const Case& changed, const std::string& name,
                          std::vector<std::pair<std::string, std::string>> set,
                          const std::optional<MeasuredFile>& measured, Progress& progress) {
  progress.title(file.data.name + ", " + name);
  const Results results = located(file, [&] {
    return run(
        measured ? for_comparison(changed) : for_headline(changed),
        [&](const std::string& s) { progress.stage(s); }, nullptr, Shapes::left_out);
  });
  VariantResult result{
      .name = name, .set = std::move(set), .headline = headline(results), .comparison = {}};
  if (measured) result.comparison = compare(results, measured->data);
  if (results.state && !results.state->name.empty()) result.state = results.state;
  return result;
}

// Work of a stage of the error bars, in runs for the headline: finer meshes cost more, those of
// tolerances are coarse.
double work_of(const Stage& stage) {
  if (stage.kind == stages::finer_along) return 2;
  if (stage.kind == stages::finer_around) return 1.5;
  return stage.kind == stages::tolerance_of ? 0.6 : 0.3;
}

// Runs that follow the first one. Their work is counted in runs for the headline; the first does
// more.
struct Plan {
  Plan(const Case& data, const RunOptions& options)
      : bars(options.error_bars && data.analyses.error_bars),
        shapes(options.out.json_only && options.geometry.empty() && !bars ? Shapes::left_out
                                                                          : Shapes::kept),
        at_rest(options.variants && data.state), states(options.variants ? data.states.size() : 0),
        variants(options.variants ? data.variants.size() : 0) {
    const double tolerances = double(data.tolerances.size());
    of_bars = bars ? 3.5 + (tolerances > 0 ? 0.6 + 0.6 * tolerances : 0) : 0;
    all = first + of_bars + double(variants + states) + (at_rest ? 1 : 0) + writing;
  }

  bool bars;
  Shapes shapes; // error bars find the modes of finer meshes by them
  bool at_rest;
  std::size_t states, variants;
  double first = 1.5, of_bars = 0, writing = 0.1, all = 0;
};

// False: a named state has no equilibrium.
bool add_error_bars_and_variants(Results& results, const CaseFile& file, const Plan& plan,
                                 const std::optional<MeasuredFile>& measured, Progress& progress) {
  if (plan.bars) {
    double done = plan.first;
    try {
      results.error_bars = error_bars(file.data, results, [&](const Stage& s) {
        progress.share(done / plan.all);
        progress.stage(s);
        done += work_of(s);
      });
      if (const std::string beyond = beyond_accuracy(file.data, results); !beyond.empty())
        results.warnings.push_back(beyond);
    } catch (const std::exception& error) { // the run itself is good
      results.warnings.push_back(std::string("error bars left out: ") + error.what());
    }
  }
  add_life_intervals(file.data, results);
  bool state_found = true;
  double done = plan.first + plan.of_bars;
  const auto add = [&](const Case& changed, const std::string& name,
                       std::vector<std::pair<std::string, std::string>> set) {
    progress.share(done / plan.all);
    done += 1;
    try {
      results.variants.push_back(
          run_variant(file, changed, name, std::move(set), measured, progress));
    } catch (const std::exception& error) {
      const bool is_state = changed.state && !changed.state->name.empty();
      state_found = state_found && !is_state;
      results.warnings.push_back((is_state ? "state '" : "variant '") + name +
                                 "' left out: " + error.what());
    }
  };
  if (plan.at_rest) {
    Case rest = file.data;
    rest.state.reset();
    rest.states.clear();
    add(rest, variant_at_rest, {{"state", "none"}});
  }
  for (std::size_t i = 0; i < plan.states; ++i) {
    const std::string& name = file.data.states[i].name;
    add(in_state(file.data, name), name, {{"state", "states." + name}});
  }
  for (std::size_t i = 0; i < plan.variants; ++i) {
    const Variant& variant = file.data.variants[i];
    add(file.variants[i], variant.name, {variant.set.begin(), variant.set.end()});
  }
  return state_found;
}

// Of the whole model at rest, or in the state of the case.
std::string deck_text(const Case& data, bool nastran) {
  if (nastran)
    require_rest(data,
                 "a deck for Nastran (whose modes under load, SOL 103 with STATSUB, are those "
                 "around a linear state; --write-deck abaqus takes it)");
  BuiltCase built = build(data);
  if (nastran) return nastran_model(data, built);
  if (!data.state) return abaqus_model(data, built);
  StateResult words;
  const StateLoads loads = state_loads(data, built, words);
  return abaqus_model_in_state(data, built, loads);
}

int write_deck(const CaseFile& file, const RunOptions& options) {
  const bool nastran = options.deck == "nastran";
  const std::string name = nastran ? "model.bdf" : "model.inp";
  OutputFolder out(options.out.folder,
                   {.command = "deck", .inputs = files_of(file), .names = {name}});
  out.add(name, deck_text(file.data, nastran));
  out.commit();
  if (!options.out.quiet) print((out.path() / name).string() + "\n");
  return 0;
}

OutputWork work_of(const CaseFile& file, const std::optional<MeasuredFile>& measured,
                   const RunOptions& options) {
  OutputWork work{.command = "run",
                  .inputs = files_of(file),
                  .names = result_files(file.data),
                  .json_only = options.out.json_only};
  if (measured)
    for (std::filesystem::path& path : files_of(*measured)) work.inputs.push_back(std::move(path));
  const auto& modes = file.data.analyses.modes;
  for (std::string& name : geometry_files(options.geometry, modes ? modes->count : 0))
    work.names.push_back(std::move(name));
  return work;
}

// The case on a mesh that resolves the waves around of its own modes, where one chosen by an
// accuracy does not: once more, with its variants on the same.
Results run_resolved(CaseFile& file, const Plan& plan, Progress& progress) {
  const auto run_it = [&] {
    RunShares shares(file.data);
    return located(file, [&] {
      return run(
          file.data,
          [&](const Stage& s) {
            progress.share(plan.first / plan.all * shares.at(s));
            progress.stage(s);
          },
          nullptr, plan.shapes);
    });
  };
  Results results = run_it();
  const int waves = unresolved_waves(file.data, results);
  if (waves == 0) return results;
  const CaseFile first = file;
  file.data = resolving(file.data, waves);
  for (Case& variant : file.variants) variant = resolving(variant, waves);
  try {
    const int elements = results.model.elements;
    results = run_it();
    results.mesh_choice =
        fmt::format("refined around for modes of {} waves, from {} elements", waves, elements);
  } catch (const std::exception& error) { // the first run is good
    results.warnings.push_back(fmt::format("not refined for modes of {} waves around, which miss "
                                           "the accuracy: {}",
                                           waves, error.what()));
    file = first;
  }
  return results;
}

// What the results are put beside, as it was when it was read.
void add_test(Results& results, const TestData& test) {
  results.comparison = compare(results, test.data);
  results.unanswered = unanswered(results, test.data);
  add_test_curves(results, test);
  for (std::string& warning : warnings_of(test)) results.warnings.push_back(std::move(warning));
  for (const std::string& caveat : test.data.caveats)
    results.assumptions.push_back("Measurement: " + caveat);
}

int run_case(const RunOptions& options) {
  if (is_benchmark(options.chosen.path)) return run_benchmark(options);
  set_threads(options.threads);
  if (!options.deck.empty()) {
    const CaseFile file = read_case(options.chosen);
    return located(file, [&] { return write_deck(file, options); });
  }
  TestedCase tested = read_tested_case(options.chosen);
  CaseFile& file = tested.file;
  const std::optional<MeasuredFile>& measured = tested.test;
  TestData test;
  if (measured) {
    test.data = measured->data;
    test.responses = load_each_frf(measured_as_drawn(test.data), measured->path.parent_path());
  }
  OutputFolder out(options.out.folder, work_of(file, measured, options));
  const Plan plan(file.data, options);
  Progress progress(options.out.quiet);
  progress.title(file.data.name);
  Results results = with_doubts(file, [&] { return run_resolved(file, plan, progress); });
  results.plica_version = PLICA_VERSION;
  results.versions = PLICA_LIBRARIES;
  results.inputs.push_back(input_file(file.path, file.text, out));
  if (measured) results.inputs.push_back(input_file(measured->path, measured->text, out));
  for (std::string& words : set_by_hand(file)) results.assumptions.push_back(std::move(words));
  if (measured) add_test(results, test);
  bool interrupted = false, states_found = true;
  try {
    states_found = add_error_bars_and_variants(results, file, plan, measured, progress);
  } catch (const Interrupted& stop) { // the run itself is finished
    interrupted = true;
    forget_interrupt();
    results.warnings.push_back("stopped by " + interrupted_by() + " before \"" + stop.stage +
                               "\": what would follow is left out");
  }
  progress.title(file.data.name);
  progress.share(1 - plan.writing / plan.all);
  progress.stage("writing " + options.out.folder.string());
  write_geometry(results, options.geometry, out);
  write_results(results, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet) print(summary_text(results, out.shown("report.html", "results.json")));
  if (speaks_json())
    for (const std::string& warning : results.warnings) say_warning(warning);
  if (interrupted) {
    say_failure(fmt::format("plica: {}", results.warnings.back()));
    return interrupted_exit();
  }
  if (results.verification.made && !results.verification.passed) {
    say_failure(fmt::format("plica: the proof failed: {}", results.verification.reason));
    return 2;
  }
  return states_found ? 0 : 2;
}

} // namespace

void add_run_command(CommandLine& line) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = line.add("run", "statics, modes and report of a case",
                               [options] { return run_case(*options); });
  add_case(command, options->chosen);
  add_state(command, options->chosen);
  add_output(command, options->out);
  add_threads(command, options->threads);
  command
      .add_option("--geometry", options->geometry,
                  "write the part and its modes besides, as msh, uff, glb, obj, ply, stl")
      ->delimiter(',')
      ->check(CLI::IsMember(geometry_formats()));
  command
      .add_option("--write-deck", options->deck,
                  "only write the whole model as a deck for another solver: model.inp or model.bdf")
      ->check(CLI::IsMember({"abaqus", "nastran"}));
  command.add_flag_callback(
      "--no-variants", [options] { options->variants = false; },
      "leave the variants and the named states of the case out");
  command.add_flag_callback(
      "--no-error-bars", [options] { options->error_bars = false; },
      "leave out the runs on finer meshes and over the tolerances");
}

} // namespace plica
