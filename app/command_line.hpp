// The command line. Every command registers itself once, with its options and its work
// (add_run_command() and its kin, below); the options that several have are declared here.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace plica {

class CommandLine {
public:
  CommandLine();

  // A command. `work` is done when it is the one that was given; it returns the exit code: 0 good,
  // 2 a numerical verdict failed. User errors are thrown as InputError (exit code 1).
  CLI::App& add(const std::string& name, const std::string& help, std::function<int()> work);

  CLI::App& whole() { return app_; }

  // The exit code.
  int run(int argc, char** argv);

private:
  CLI::App app_{"Plica: dynamics of flexible exhaust pipes"};
  std::function<int()> chosen_;
  std::string messages_ = "text";
};

// In the order in which the help lists them.
void add_run_command(CommandLine& line);
void add_reduce_command(CommandLine& line);
void add_identify_command(CommandLine& line);
void add_fit_command(CommandLine& line);
void add_sweep_command(CommandLine& line);
void add_diagnose_command(CommandLine& line);
void add_compare_command(CommandLine& line);
void add_ejma_command(CommandLine& line);
void add_stiffness_command(CommandLine& line);
void add_check_command(CommandLine& line);
void add_init_command(CommandLine& line);
void add_schema_command(CommandLine& line);
void add_completion_command(CommandLine& line);
void add_manual_command(CommandLine& line);

// CASE, --model and --set. A folder stands for the case in it (case_in_folder.hpp).
struct ChosenCase {
  std::string path;
  std::string model;                      // one of the models of the case; empty = its parts
  std::string state;                      // one of its named states; empty = its `state`, or none
  std::map<std::string, std::string> set; // path: new value, put into the case before it is read
};
void add_case(CLI::App& command, ChosenCase& chosen);
void add_state(CLI::App& command, ChosenCase& chosen);       // --state
void add_measured(CLI::App& command, std::string& measured); // the test, in place of the case's

// --out and --quiet; of commands with a report --only.
struct Output {
  std::filesystem::path folder = "out";
  bool quiet = false;
  bool json_only = false;
};
void add_folder(CLI::App& command, Output& output);
void add_output(CLI::App& command, Output& output); // with --only
void add_threads(CLI::App& command, int& threads);  // 0 = all cores

// A number that is finite and, by `top`, above zero (0) or from zero to `top`.
CLI::Validator number_in(double top, const std::string& allowed);

// One word out of several; the help lists them.
template <class E>
CLI::Option* add_choice(CLI::App& command, const std::string& name, E& value,
                        const std::vector<std::pair<std::string, E>>& names,
                        const std::string& help) {
  std::vector<std::string> words(names.size());
  std::transform(names.begin(), names.end(), words.begin(), [](const auto& n) { return n.first; });
  return command
      .add_option_function<std::string>(
          name,
          [&value, names](const std::string& word) {
            for (const auto& [known, meaning] : names)
              if (known == word) value = meaning;
          },
          help)
      ->check(CLI::IsMember(words))
      ->type_name("");
}

} // namespace plica
