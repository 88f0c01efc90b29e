#include "app/command_line.hpp"

#include "app/describe_app.hpp"
#include "app/terminal.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica {
namespace {

// What is wrong with the first word when it is no command; empty when it is one, or an option.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return "";
  return "plica: there is no command '" + shown(argv[1]) + "'; " + suggestion(argv[1], names);
}

// Before the words are parsed, so that what is wrong with them is said in that way, too.
bool asks_for_json(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--messages=json") return true;
    if (word == "--messages" && i + 1 < argc) return std::string(argv[i + 1]) == "json";
  }
  return false;
}

} // namespace

CommandLine::CommandLine() {
  app_.set_version_flag("--version", "plica " PLICA_VERSION "\nwith " PLICA_LIBRARIES);
  app_.require_subcommand(1);
  app_.add_option(
          "--messages", messages_,
          "how progress, warnings and errors are said on standard error: as text, or as one "
          "JSON object a line")
      ->check(CLI::IsMember({"text", "json"}))
      ->type_name("")
      ->capture_default_str();
  for (const auto& add_command :
       {add_run_command, add_reduce_command, add_identify_command, add_fit_command,
        add_sweep_command, add_diagnose_command, add_compare_command, add_ejma_command,
        add_stiffness_command, add_check_command, add_init_command, add_schema_command,
        add_completion_command, add_manual_command})
    add_command(*this);
}

CLI::App& CommandLine::add(const std::string& name, const std::string& help,
                           std::function<int()> work) {
  CLI::App& command = *app_.add_subcommand(name, help)->fallthrough();
  command.callback([this, work = std::move(work)] { chosen_ = work; });
  return command;
}

int CommandLine::run(int argc, char** argv) {
  if (asks_for_json(argc, argv)) speak_json();
  if (const std::string unknown = unknown_command(app_, argc, argv); !unknown.empty()) {
    say_failure(unknown);
    return 1;
  }
  try {
    app_.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0 && speaks_json()) {
      say_failure(error.what());
      return 1;
    }
    return app_.exit(error) == 0 ? 0 : 1;
  }
  return chosen_();
}

void add_completion_command(CommandLine& line) {
  const auto shell = std::make_shared<std::string>("bash");
  CLI::App& command = line.add(
      "completion", "print the completions of the command line for a shell", [&line, shell] {
        print(completion(line.whole(), *shell));
        return 0;
      });
  command.add_option("SHELL", *shell, "bash or zsh")
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->capture_default_str();
}

void add_manual_command(CommandLine& line) {
  line.add("manual", "print the manual page, as man reads it", [&line] {
    print(manual_page(line.whole(), PLICA_VERSION));
    return 0;
  });
}

} // namespace plica
