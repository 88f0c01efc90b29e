#include "app/chosen_case.hpp"
#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/fit_settings.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/tables/fit_words.hpp"
#include "io/write/write_fit.hpp"
#include "lab/measured/entries.hpp"
#include "lab/measured/states.hpp"
#include "solve/sparse_factor.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fmt/core.h>

namespace plica {
namespace {

struct FitOptions {
  ChosenCase chosen;
  std::string measured; // in place of the file the case names
  std::string restart;  // fit.json of an earlier fit; empty = none
  Output out;
  int threads = 0;
  std::optional<FitSearch> search;
  std::optional<int> evaluations;
  unsigned seed = 1;
};

[[noreturn]] void refuse(const CaseFile& file, const std::string& wrong,
                         const std::string& allowed) {
  const auto line = file.lines.find("fit");
  throw InputError({{.file = file.path,
                     .line = line == file.lines.end() ? 0 : line->second,
                     .key = "fit",
                     .wrong = wrong,
                     .allowed = allowed}});
}

// Of the test what may be fitted: responses that are held out are not even read.
TestData fitted_data(const MeasuredFile& file) {
  TestData test{.data = file.data, .responses = {}};
  Measured fitted = test.data;
  std::erase_if(fitted.frf, [&, i = std::size_t(0)](const MeasuredFrf&) mutable {
    return is_held_out(test.data, entry_name("frf", i++));
  });
  test.responses = load_each_frf(measured_as_drawn(fitted), file.path.parent_path());
  return test;
}

// The case says what to fit, and to what.
void require_a_fit(const TestedCase& tested, const std::string& model) {
  const CaseFile& file = tested.file;
  if (!file.data.fit)
    refuse(file, "is missing" + (model.empty() ? "" : " in model '" + model + "'"),
           "fit: {parameters: [{path: ..., bounds: [..., ...]}]}");
  const auto& targets = file.data.fit->targets;
  if (!tested.test && std::none_of(targets.begin(), targets.end(),
                                   [](const FitTarget& t) { return is_goal(t.quantity); }))
    refuse(file, "has nothing to fit to",
           "measured: measured.yaml in the case, --measured FILE, or targets such as k_axial = 50 "
           "kN/m");
}

// Shows how far a fit is, which lasts no longer than `progress`.
void show_on(Progress& progress, FitSettings& settings) {
  settings.progress = [&](int evaluations, double cost) {
    progress.share(double(evaluations) / double(std::max(settings.evaluations, 1)));
    progress.stage(
        fmt::format("{} of {} evaluations, cost {:.4g}", evaluations, settings.evaluations, cost));
  };
  settings.step = [&](int step, int evaluations, double cost) {
    progress.share(0); // how many steps it takes, nobody knows
    progress.stage(fmt::format("step {}, {} evaluations, cost {:.4g}", step, evaluations, cost));
  };
}

int fit(const FitOptions& options) {
  set_threads(options.threads);
  const TestedCase tested = read_tested_case(options.chosen, options.measured);
  require_a_fit(tested, options.chosen.model);
  const CaseFile& file = tested.file;
  const std::optional<MeasuredFile>& test_file = tested.test;
  const TestData test = test_file ? fitted_data(*test_file) : TestData{};
  FitSettings settings = fit_settings(file);
  settings.search = options.search.value_or(settings.search);
  settings.evaluations = options.evaluations.value_or(settings.evaluations);
  settings.seed = options.seed;
  if (!options.restart.empty()) settings.starts = read_designs(options.restart, *file.data.fit);
  std::vector<std::filesystem::path> inputs = files_of(file);
  if (test_file)
    for (std::filesystem::path& path : files_of(*test_file)) inputs.push_back(std::move(path));
  if (!options.restart.empty()) inputs.emplace_back(options.restart);
  OutputFolder out(options.out.folder, {.command = "fit",
                                        .inputs = std::move(inputs),
                                        .names = fit_files(),
                                        .json_only = options.out.json_only});
  Progress progress(options.out.quiet);
  progress.title(file.data.name +
                 (options.chosen.model.empty() ? "" : ", " + options.chosen.model));
  progress.stage("fit of " + std::to_string(file.data.fit->parameters.size()) + " parameters");
  show_on(progress, settings);
  settings.stop = search_is_ended;
  let_searches_end(); // the best so far is refined and written
  FitResult fit;
  try {
    fit = with_doubts(file, [&] {
      return located(file, [&] { return fit_case(file.data, *file.data.fit, test, settings); });
    });
  } catch (const std::invalid_argument& error) {
    refuse(file, error.what(), "a start from which the model gives every target");
  }
  watch_interrupts();
  for (std::string& warning : warnings_of(test)) fit.warnings.push_back(std::move(warning));
  if (search_is_ended())
    fit.warnings.insert(fit.warnings.begin(),
                        fit.stopped ? "the search was stopped: these are the best values so far"
                                    : "the search was stopped before its budget");
  write_fit(fit, file.data.title.empty() ? file.data.name : file.data.title, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(
        fmt::format("{}\nReport: {}\n", fit_text(fit), out.shown("fit.html", "fit.json").string()));
  if (search_is_ended()) return interrupted_exit();
  return fit.converged ? 0 : 2;
}

} // namespace

void add_fit_command(CommandLine& line) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App& command =
      line.add("fit", "adjust numbers of a case to measured data or to goals (its section fit)",
               [options] { return fit(*options); });
  add_case(command, options->chosen);
  add_measured(command, options->measured);
  add_choice(command, "--search", options->search,
             {{"local", FitSearch::local}, {"global", FitSearch::global}},
             "from the values of the case, or over the whole box; left out: as the case says");
  command.add_option("--evaluations", options->evaluations, "budget of a global search")
      ->check(CLI::Range(10, 10000000));
  command.add_option("--seed", options->seed, "of a global search")->capture_default_str();
  command
      .add_option("--restart", options->restart, "begin with the designs of an earlier fit.json")
      ->type_name("FILE");
  add_output(command, options->out);
  add_threads(command, options->threads);
}

} // namespace plica
