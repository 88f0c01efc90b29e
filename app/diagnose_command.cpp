#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/fit_settings.hpp"
#include "app/located.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/fit_baseline.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/write/write_diagnosis.hpp"
#include "io/write/write_pretest.hpp"
#include "solve/sparse_factor.hpp"

#include <array>
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
  bool pretest = false; // what a planned test could tell, before it is made
  TestPlan plan;
};

// Of the work of a diagnosis, what lies before a stage: as pipe A2 has it.
double share_before(const std::string& stage) {
  constexpr std::array<std::pair<const char*, double>, 7> shares{{{"admissible specimens", 0.08},
                                                                  {"signatures", 0.26},
                                                                  {"fits", 0.53},
                                                                  {"Markov chains", 0.56},
                                                                  {"several effects at once", 0.58},
                                                                  {"report", 0.94},
                                                                  {"next measurement", 0.98}}};
  for (const auto& [name, share] : shares)
    if (stage.starts_with(name)) return share;
  return 0;
}

namespace fs = std::filesystem;

MeasuredFile measured_file(const DiagnoseOptions& options, const CaseFile& file) {
  std::optional<MeasuredFile> test = test_of(file, options.measured);
  if (!test)
    throw InputError(
        {{.file = file.path,
          .line = 0,
          .key = "measured",
          .wrong = "the case has no test to be held against",
          .allowed = "--measured DIR with a measured.yaml, or measured: in the case"}});
  return std::move(*test);
}

// The responses of each entry on its own; problems keep the number of the entry.
std::vector<std::vector<FrfSet>> responses_of(const Measured& measured, const fs::path& folder) {
  std::vector<std::vector<FrfSet>> all;
  for (std::size_t i = 0; i < measured.frf.size(); ++i) {
    Measured one = measured;
    one.frf = {measured.frf[i]};
    try {
      all.push_back(load_frfs(one, folder));
    } catch (const InputError& error) {
      std::vector<InputProblem> problems = error.problems();
      for (InputProblem& p : problems)
        if (p.key.starts_with("frf[0]")) p.key = "frf[" + std::to_string(i) + "]" + p.key.substr(6);
      throw InputError(std::move(problems));
    }
  }
  return all;
}

std::string title_of(const Case& data) {
  return data.title.empty() ? data.name : data.title;
}

int plan_test(const DiagnoseOptions& options, const CaseFile& file) {
  OutputFolder out(options.out.folder,
                   {.command = "pretest", .inputs = files_of(file), .names = pretest_files()});
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
                      (out.path() / "pretest.html").string()));
  return 0;
}

int diagnose_case(const DiagnoseOptions& options) {
  set_threads(options.threads);
  const CaseFile file = read_case(options.chosen.path, options.chosen.model);
  if (options.pretest) return plan_test(options, file);
  const MeasuredFile test_file = measured_file(options, file);
  DiagnosisData test{.data = test_file.data, .responses = {}};
  resolve_states(test.data, file.data, test_file.path.string());
  test.responses = responses_of(test.data, test_file.path.parent_path());
  std::vector<fs::path> inputs = files_of(file);
  for (fs::path& path : files_of(test_file)) inputs.push_back(std::move(path));
  OutputFolder out(
      options.out.folder,
      {.command = "diagnose", .inputs = std::move(inputs), .names = diagnosis_files()});
  Progress progress(options.out.quiet);
  progress.title(file.data.name +
                 (options.chosen.model.empty() ? "" : ", " + options.chosen.model));
  DiagnosisSettings settings{.without = {options.without.begin(), options.without.end()},
                             .plan_next = options.plan_next};
  settings.stage = [&](const std::string& stage) {
    progress.share(share_before(stage));
    progress.stage(stage);
  };
  Diagnosis diagnosis;
  try {
    diagnosis = with_doubts(file, [&] {
      return located(file, [&] {
        if (!options.fit_baseline && !file.data.diagnose.fit_baseline)
          return diagnose(file.data, test, settings);
        settings.stage("fit to the baseline");
        FittedBaseline fitted = fitted_to_baseline(file.data, test, fit_settings(file));
        settings.words = std::move(fitted.words);
        return diagnose(fitted.data, test, settings);
      });
    });
  } catch (const std::invalid_argument& error) {
    throw InputError({{.file = test_file.path.string(),
                       .line = 0,
                       .key = "",
                       .wrong = error.what(),
                       .allowed = "mass, static, modes, peaks or frf that this case answers"}});
  }
  for (const std::vector<FrfSet>& sets : test.responses)
    for (std::string& warning : warnings_of(sets)) diagnosis.warnings.push_back(std::move(warning));
  write_diagnosis(diagnosis, title_of(file.data), PLICA_VERSION, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\nReport: {}\n", diagnosis_text(diagnosis),
                      (out.path() / "diagnosis.html").string()));
  return 0;
}

} // namespace

void add_diagnose_command(CommandLine& line) {
  const auto options = std::make_shared<DiagnoseOptions>();
  CLI::App& command = line.add(
      "diagnose", "where the gap to a test lies, which effect causes it, how far it shrinks",
      [options] { return diagnose_case(*options); });
  add_case(command, options->chosen);
  command
      .add_option("--measured", options->measured,
                  "a measured.yaml, or its folder; left out: as the case says")
      ->type_name("DIR");
  command.add_option("--without", options->without, "leave a guard out, to see what it does")
      ->check(CLI::IsMember({"form", "nuisance", "reassembly", "adequacy", "levels", "heldout"}));
  command.add_flag("--fit-baseline", options->fit_baseline,
                   "adjust the case to the baseline first, by its section fit");
  command.add_flag("--pretest", options->pretest,
                   "before a test: what looks alike, how small an effect would be found");
  command
      .add_option_function<std::vector<char>>(
          "--bases",
          [options](const std::vector<char>& axes) {
            for (char axis : axes) options->plan.bases.push_back(axis - 'x');
          },
          "of a planned test: axes of the table")
      ->check(CLI::IsMember({'x', 'y', 'z'}));
  command.add_option("--levels", options->plan.levels, "of a planned test: m/s2")
      ->check(CLI::PositiveNumber);
  command.add_flag_callback(
      "--no-plan", [options] { options->plan_next = false; },
      "do not look for the next measurement");
  add_output(command, options->out);
  add_threads(command, options->threads);
}

} // namespace plica
