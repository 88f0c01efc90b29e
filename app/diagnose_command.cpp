#include "app/commands.hpp"
#include "app/finish.hpp"
#include "app/located.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "diagnose/diagnose.hpp"
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

// Of the work of a diagnosis, what lies before a stage: as pipe A2 has it.
double share_before(const std::string& stage) {
  constexpr std::array<std::pair<const char*, double>, 7> shares{{{"admissible specimens", 0.08},
                                                                  {"signatures", 0.26},
                                                                  {"fits", 0.53},
                                                                  {"Markov chains", 0.56},
                                                                  {"pairs of effects", 0.58},
                                                                  {"report", 0.94},
                                                                  {"next measurement", 0.98}}};
  for (const auto& [name, share] : shares)
    if (stage.starts_with(name)) return share;
  return 0;
}

namespace fs = std::filesystem;

// measured.yaml of a folder, a file, or what the case names.
fs::path measured_file(const DiagnoseOptions& options, const CaseFile& file) {
  if (options.measured.empty()) {
    if (file.data.measured.empty())
      throw InputError(
          {{.file = file.path,
            .line = 0,
            .key = "measured",
            .wrong = "the case has no test to be held against",
            .allowed = "--measured DIR with a measured.yaml, or measured: in the case"}});
    return fs::path(file.path).parent_path() / file.data.measured;
  }
  const fs::path given = options.measured;
  return fs::is_directory(given) ? given / "measured.yaml" : given;
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
  OutputFolder out(options.out,
                   {.command = "pretest", .inputs = files_of(file), .names = pretest_files()});
  Progress progress(options.quiet);
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
  if (!options.quiet)
    print(fmt::format("{}\nReport: {}\n", pretest_text(result),
                      (out.path() / "pretest.html").string()));
  return 0;
}

} // namespace

int diagnose_command(const DiagnoseOptions& options) {
  set_threads(options.threads);
  const CaseFile file = read_case(options.case_path, options.model);
  if (options.pretest) return plan_test(options, file);
  const fs::path measured = measured_file(options, file);
  const MeasuredFile test_file = read_measured_file(measured.string());
  DiagnosisData test{.data = test_file.data, .responses = {}};
  resolve_states(test.data, file.data, measured.string());
  test.responses = responses_of(test.data, measured.parent_path());
  std::vector<fs::path> inputs = files_of(file);
  for (fs::path& path : files_of(test_file)) inputs.push_back(std::move(path));
  OutputFolder out(
      options.out,
      {.command = "diagnose", .inputs = std::move(inputs), .names = diagnosis_files()});
  Progress progress(options.quiet);
  progress.title(file.data.name + (options.model.empty() ? "" : ", " + options.model));
  DiagnosisSettings settings{.without = {options.without.begin(), options.without.end()},
                             .plan_next = options.plan_next};
  settings.stage = [&](const std::string& stage) {
    progress.share(share_before(stage));
    progress.stage(stage);
  };
  Diagnosis diagnosis;
  try {
    diagnosis = with_doubts(
        file, [&] { return located(file, [&] { return diagnose(file.data, test, settings); }); });
  } catch (const std::invalid_argument& error) {
    throw InputError({{.file = measured.string(),
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
  if (!options.quiet)
    print(fmt::format("{}\nReport: {}\n", diagnosis_text(diagnosis),
                      (out.path() / "diagnosis.html").string()));
  return 0;
}

} // namespace plica
