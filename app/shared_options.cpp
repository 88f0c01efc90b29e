// The options that several commands have (command_line.hpp).
#include "app/case_in_folder.hpp"
#include "app/command_line.hpp"

#include <cmath>

namespace plica {

void add_case(CLI::App& command, ChosenCase& chosen) {
  command
      .add_option_function<std::string>(
          "CASE", [&chosen](const std::string& path) { chosen.path = case_file_of(path); },
          "case file, or the folder of one")
      ->required();
  command.add_option("--model", chosen.model, "one of the models of the case; left out: its parts")
      ->type_name("NAME");
  const auto is_change = [](std::string& text) {
    const std::size_t equals = text.find('=');
    return equals == std::string::npos || equals == 0 ? "'" + text + "' is not PATH=VALUE" : "";
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&chosen](const std::vector<std::string>& changes) {
            for (const std::string& change : changes) {
              const std::size_t equals = change.find('=');
              chosen.set[change.substr(0, equals)] = change.substr(equals + 1);
            }
          },
          "put a value into the case before it is read, e.g. caps.left.mass=0.2kg; again for more")
      ->allow_extra_args(false)
      ->check(CLI::Validator(is_change, ""))
      ->type_name("PATH=VALUE");
}

void add_folder(CLI::App& command, Output& output) {
  command.add_option("--out", output.folder, "folder for the results")->capture_default_str();
  command.add_flag("--quiet", output.quiet, "print errors only");
}

void add_state(CLI::App& command, ChosenCase& chosen) {
  command
      .add_option("--state", chosen.state,
                  "one of the states of the case; left out: its state, or none")
      ->type_name("NAME");
}

void add_measured(CLI::App& command, std::string& measured) {
  command
      .add_option("--measured", measured,
                  "a measured.yaml, or its folder; left out: as the case says")
      ->type_name("FILE");
}

void add_output(CLI::App& command, Output& output) {
  add_folder(command, output);
  command
      .add_option_function<std::string>(
          "--only", [&output](const std::string&) { output.json_only = true; },
          "write JSON, and cases that are asked for, alone: no tables, no report, nothing for "
          "other programs")
      ->check(CLI::IsMember({"json"}))
      ->type_name("");
}

void add_threads(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "threads, 0 = all cores")->check(CLI::Range(0, 256));
}

CLI::Validator number_in(double top, const std::string& allowed) {
  return CLI::Validator(
      [top, allowed](std::string& text) -> std::string {
        double value = 0;
        const bool number = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        const bool good = number && (top > 0 ? value >= 0 && value <= top : value > 0);
        return good ? "" : "'" + text + "' is no number " + allowed;
      },
      "");
}

} // namespace plica
