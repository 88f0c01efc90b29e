#include "app/chosen_case.hpp"
#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/fit_settings.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/fit_baseline.hpp"
#include "diagnose/suppose.hpp"
#include "io/input/measured_file.hpp"
#include "io/input/measured_states.hpp"
#include "io/input/supposition_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/tables/ledger_words.hpp"
#include "io/write/explained_case.hpp"
#include "io/write/write_diagnosis.hpp"
#include "io/write/write_pretest.hpp"
#include "io/write/write_supposition.hpp"
#include "lab/measured/states.hpp"
#include "solve/sparse_factor.hpp"
#include "words/directions.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

struct DiagnoseOptions {
  ChosenCase chosen;
  std::string measured;             // folder with a measured.yaml, or that file
  std::vector<std::string> without; // guards left out, for ablations
  Output out;
  int threads = 0;
  bool plan_next = true;
  bool fit_baseline = false;
  bool add = false;     // writes the case with the named effects in it
  bool pretest = false; // what a planned test could tell, before it is made
  TestPlan plan;
  std::string supposed; // file of effects whose shares are asked for, in place of a diagnosis
};

namespace fs = std::filesystem;

const MeasuredFile& required(const std::optional<MeasuredFile>& test, const CaseFile& file) {
  if (!test)
    throw InputError(
        {{.file = file.path,
          .line = 0,
          .key = "measured",
          .wrong = "the case has no test to be held against",
          .allowed = "--measured FILE, a measured.yaml or its folder, or measured: in the case"}});
  return *test;
}

std::string title_of(const Case& data) {
  return data.title.empty() ? data.name : data.title;
}

int plan_test(const DiagnoseOptions& options, const CaseFile& file) {
  OutputFolder out(options.out.folder, {.command = "pretest",
                                        .inputs = files_of(file),
                                        .names = pretest_files(),
                                        .json_only = options.out.json_only});
  Progress progress(options.out.quiet);
  progress.title(file.data.name);
  Pretest result;
  try {
    result = located(file, [&] {
      return pretest(file.data, options.plan, [&](const std::string& s) { progress.stage(s); });
    });
  } catch (const std::invalid_argument& error) {
    throw InputError({{.file = file.path,
                       .line = 0,
                       .key = "sensors",
                       .wrong = error.what(),
                       .allowed = "sensors: [{name: mid, at: [...]}]"}});
  }
  write_pretest(result, title_of(file.data), PLICA_VERSION, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\nReport: {}\n", pretest_text(result),
                      out.shown("pretest.html", "pretest.json").string()));
  return 0;
}

// What is wrong with a supposed effect stands in its file.
Ledger suppose_from(const SuppositionFile& supposed, const Case& data, const TestData& test,
                    const DiagnosisSettings& settings) {
  try {
    return suppose(data, test, supposed.data, settings);
  } catch (const InputError& error) {
    std::vector<InputProblem> problems = error.problems();
    for (InputProblem& p : problems) {
      if (!p.file.empty() || !p.key.starts_with("effects")) continue;
      p.file = supposed.path;
      std::string key = p.key; // a key that is missing stands where the one above it does
      while (!supposed.lines.contains(key) && key.find('.') != std::string::npos)
        key.erase(key.rfind('.'));
      if (const auto line = supposed.lines.find(key); line != supposed.lines.end())
        p.line = line->second;
    }
    throw InputError(std::move(problems));
  }
}

// A case with its test, and the files they were read from.
struct Asked {
  CaseFile file;
  MeasuredFile test_file;
  TestData test;
  std::vector<fs::path> inputs;
};

Asked asked_for(const TestedCase& tested) {
  const CaseFile& file = tested.file;
  Asked a{.file = file, .test_file = required(tested.test, file), .test = {}, .inputs = {}};
  check_states_of_diagnosis(
      a.test_file.data,
      {.file = a.test_file.path.string(), .problems = {}, .lines = a.test_file.lines});
  resolve_states(a.test_file, file);
  a.test.data = a.test_file.data;
  a.test.responses = load_each_frf(a.test.data, a.test_file.path.parent_path());
  a.inputs = files_of(file);
  for (fs::path& path : files_of(a.test_file)) a.inputs.push_back(std::move(path));
  return a;
}

// What `work` finds wrong at a key that the test has and the case has not stands in the test.
template <class Work> auto located_in_test(const Asked& a, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<InputProblem> problems = error.problems();
    for (InputProblem& p : problems) {
      if (!p.file.empty() || a.file.lines.contains(p.key)) continue;
      if (const auto line = a.test_file.lines.find(p.key); line != a.test_file.lines.end()) {
        p.file = a.test_file.path.string();
        p.line = line->second;
      }
    }
    throw InputError(std::move(problems));
  }
}

// What `work` finds wrong in the case is said at its lines, in the test at its own.
template <class Work> auto said_where(const Asked& a, const Work& work) {
  try {
    return with_doubts(a.file,
                       [&] { return located(a.file, [&] { return located_in_test(a, work); }); });
  } catch (const std::invalid_argument& error) {
    throw InputError({{.file = a.test_file.path.string(),
                       .line = 0,
                       .key = "",
                       .wrong = error.what(),
                       .allowed = "mass, static, modes, peaks or frf that this case answers"}});
  }
}

// The case, adjusted to its baseline where that is asked for.
FittedBaseline adjusted(const Asked& a, bool fit_baseline, DiagnosisSettings& settings) {
  if (!fit_baseline && !a.file.data.diagnose.fit_baseline)
    return {.data = a.file.data, .words = {}, .edits = {}};
  settings.stage("fit to the baseline", 0);
  FittedBaseline fitted =
      said_where(a, [&] { return fitted_to_baseline(a.file.data, a.test, fit_settings(a.file)); });
  settings.words = fitted.words;
  return fitted;
}

int suppose_case(const DiagnoseOptions& options, const Asked& a, DiagnosisSettings& settings,
                 Progress& progress) {
  const SuppositionFile supposed = read_supposition(options.supposed);
  std::vector<fs::path> inputs = a.inputs;
  inputs.emplace_back(options.supposed);
  OutputFolder out(
      options.out.folder,
      {.command = "suppose", .inputs = std::move(inputs), .names = supposition_files()});
  const FittedBaseline start = adjusted(a, options.fit_baseline, settings);
  const Ledger ledger =
      said_where(a, [&] { return suppose_from(supposed, start.data, a.test, settings); });
  write_supposition(ledger, a.file.data.name, PLICA_VERSION, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet) print(ledger_text(ledger));
  return 0;
}

constexpr const char* explained_file = "explained.yaml";

// Writes the case with the named effects in it, and says what gap it leaves.
std::string add_effects(const Asked& a, const CaseEdits& fitted, const Diagnosis& diagnosis,
                        const DiagnosisSettings& settings, OutputFolder& out) {
  const ExplainedCase explained =
      explained_case(a.file, fitted, diagnosis, a.test_file.path, out.path());
  std::string words = "\n";
  for (const std::string& effect : explained.left_out)
    words += fmt::format("No key of a case says {}: not taken over.\n", effect);
  if (explained.in.empty()) return words + "No effect was taken over into a case.\n";
  DiagnosisSettings solving = settings; // whose shares of the work are none of the diagnosis
  solving.stage = [&](const std::string& stage, double) { settings.stage(stage, 0); };
  solving.advance = [](double) {};
  out.add(explained_file, explained.text);
  words += fmt::format("{} has {} of {} effects in it: ", explained_file, explained.in.size(),
                       explained.in.size() + explained.left_out.size());
  if (has_baseline(a.test.data))
    return words + "the part after the change. No gap is solved for: the baseline is that of the "
                   "case without them\n";
  try { // the diagnosis is finished, whatever becomes of this
    solving.stage("the case with its effects", 0);
    const Ledger left =
        said_where(a, [&] { return suppose(explained.data, a.test, Supposition{}, solving); });
    const double foretold = diagnosis.ledger.gap * (1 - diagnosis.ledger.explained);
    return words + fmt::format("G falls from {:.3g} to {:.3g} (the ledger: {:.3g})\n",
                               diagnosis.ledger.gap, left.gap, foretold);
  } catch (const Interrupted&) {
    return words + "stopped before it was solved\n";
  } catch (const std::exception& error) {
    return words + fmt::format("it could not be solved: {}\n", error.what());
  }
}

int diagnose_case(const DiagnoseOptions& options) {
  set_threads(options.threads);
  if (options.pretest) return plan_test(options, read_case(options.chosen));
  const TestedCase tested = read_tested_case(options.chosen, options.measured);
  const CaseFile& file = tested.file;
  const Asked a = asked_for(tested);
  Progress progress(options.out.quiet);
  progress.title(file.data.name +
                 (options.chosen.model.empty() ? "" : ", " + options.chosen.model));
  DiagnosisSettings settings{.plan_next = options.plan_next};
  for (const std::string& guard : options.without)
    settings.without.insert(static_cast<Guard>(place_among(guard_names, guard)));
  settings.stage = [&](const std::string& stage, double share) {
    if (options.supposed.empty()) progress.share(share);
    progress.stage(stage);
  };
  settings.advance = [&](double share) {
    if (options.supposed.empty()) progress.advance(share);
  };
  settings.search = let_searches_end;
  settings.stop = search_is_ended;
  if (!options.supposed.empty()) return suppose_case(options, a, settings, progress);
  std::vector<std::string> names = diagnosis_files();
  if (options.add) names.emplace_back(explained_file);
  OutputFolder out(options.out.folder, {.command = "diagnose",
                                        .inputs = a.inputs,
                                        .names = std::move(names),
                                        .json_only = options.out.json_only});
  const FittedBaseline start = adjusted(a, options.fit_baseline, settings);
  Diagnosis diagnosis = said_where(a, [&] { return diagnose(start.data, a.test, settings); });
  watch_interrupts();
  for (std::string& warning : warnings_of(a.test)) diagnosis.warnings.push_back(std::move(warning));
  write_diagnosis(diagnosis, title_of(file.data), PLICA_VERSION, out);
  std::string words = diagnosis_text(diagnosis);
  if (options.add) words += add_effects(a, start.edits, diagnosis, settings, out);
  const bool stopped = search_is_ended() || is_interrupted();
  forget_interrupt();
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\nReport: {}\n", words,
                      out.shown("diagnosis.html", "diagnosis.json").string()));
  return stopped ? interrupted_exit() : 0;
}

} // namespace

void add_diagnose_command(CommandLine& line) {
  const auto options = std::make_shared<DiagnoseOptions>();
  CLI::App& command = line.add(
      "diagnose", "where the gap to a test lies, which effect causes it, how far it shrinks",
      [options] { return diagnose_case(*options); });
  add_case(command, options->chosen);
  add_measured(command, options->measured);
  command.add_option("--without", options->without, "leave a guard out, to see what it does")
      ->check(CLI::IsMember(std::vector<std::string>(guard_names.begin(), guard_names.end())));
  command.add_flag("--fit-baseline", options->fit_baseline,
                   "adjust the case to the baseline first, by its section fit");
  command.add_flag("--pretest", options->pretest,
                   "before a test: what looks alike, how small an effect would be found");
  command.add_flag("--add", options->add,
                   "write explained.yaml, the case with the named effects in it");
  command
      .add_option("--suppose", options->supposed,
                  "in place of a diagnosis: what the effects in this file would explain of the gap")
      ->type_name("FILE")
      ->excludes("--pretest");
  command
      .add_option_function<std::vector<std::string>>(
          "--bases",
          [options](const std::vector<std::string>& axes) {
            for (const std::string& axis : axes)
              options->plan.bases.push_back(place_among(axis_names, axis));
          },
          "of a planned test: axes of the table")
      ->check(CLI::IsMember(std::vector<std::string>(axis_names.begin(), axis_names.end())));
  command.add_option("--levels", options->plan.levels, "of a planned test: m/s2")
      ->check(CLI::PositiveNumber);
  command.add_flag_callback(
      "--no-plan", [options] { options->plan_next = false; },
      "do not look for the next measurement");
  add_output(command, options->out);
  add_threads(command, options->threads);
}

} // namespace plica
