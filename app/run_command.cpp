#include "app/chosen_case.hpp"
#include "app/finish.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/run_options.hpp"
#include "app/terminal.hpp"
#include "compare/whole_run.hpp"
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
#include "model/shape/build.hpp"
#include "run/routes/operating_state.hpp"
#include "run/routes/state_loads.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

// Named by its path from the folder of results, so that both may be moved together.
InputFile input_file(const std::filesystem::path& path, const std::string& text,
                     const OutputFolder& out) {
  return {std::filesystem::proximate(path, out.path()).generic_string(), text};
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

// An error of a part of the work, with its place in the file.
std::string located_words(const CaseFile& file, const std::exception_ptr& error) {
  try {
    located(file, [&] { std::rethrow_exception(error); });
  } catch (const std::exception& found) {
    return found.what();
  }
  return {};
}

WholeRun run_and_tell(const CaseFile& file, const TestData* test, const RunOptions& options,
                      Progress& progress) {
  WholeRunRequest request{
      .data = file.data,
      .variants = file.variants,
      .test = test,
      .assumptions = set_by_hand(file),
      .error_bars = options.error_bars,
      .others = options.variants,
      .shapes = options.out.json_only && options.geometry.empty() ? Shapes::left_out : Shapes::kept,
      .words = [&](const std::exception_ptr& error) { return located_words(file, error); }};
  return with_doubts(file, [&] {
    return located(file, [&] {
      return whole_run(std::move(request), [&](const RunStep& step) {
        progress.title(step.of);
        progress.share(step.done);
        progress.stage(step.stage);
      });
    });
  });
}

int run_case(const RunOptions& options) {
  if (is_benchmark(options.chosen.path)) return run_benchmark(options);
  set_threads(options.threads);
  if (!options.deck.empty()) {
    const CaseFile file = read_case(options.chosen);
    return located(file, [&] { return write_deck(file, options); });
  }
  TestedCase tested = read_tested_case(options.chosen);
  const CaseFile& file = tested.file;
  const std::optional<MeasuredFile>& measured = tested.test;
  TestData test;
  if (measured) {
    test.data = measured->data;
    test.responses = load_each_frf(measured_as_drawn(test.data), measured->path.parent_path());
  }
  OutputFolder out(options.out.folder, work_of(file, measured, options));
  Progress progress(options.out.quiet);
  WholeRun whole = run_and_tell(file, measured ? &test : nullptr, options, progress);
  Results& results = whole.results;
  results.plica_version = PLICA_VERSION;
  results.versions = PLICA_LIBRARIES;
  results.inputs.push_back(input_file(file.path, file.text, out));
  if (measured) results.inputs.push_back(input_file(measured->path, measured->text, out));
  if (whole.stopped) { // the run itself is finished
    forget_interrupt();
    results.warnings.push_back("stopped by " + interrupted_by() + " before \"" +
                               whole.stopped->stage + "\": what would follow is left out");
  }
  progress.title(file.data.name);
  progress.share(whole.done);
  progress.stage("writing " + options.out.folder.string());
  write_geometry(results, options.geometry, out);
  write_results(results, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet) print(summary_text(results, out.shown("report.html", "results.json")));
  if (speaks_json())
    for (const std::string& warning : results.warnings) say_warning(warning);
  if (whole.stopped) {
    say_failure(fmt::format("plica: {}", results.warnings.back()));
    return interrupted_exit();
  }
  if (results.verification.made && !results.verification.passed) {
    say_failure(fmt::format("plica: the proof failed: {}", results.verification.reason));
    return 2;
  }
  return whole.states_found ? 0 : 2;
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
