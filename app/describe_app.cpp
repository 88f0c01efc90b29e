#include "app/describe_app.hpp"

#include "io/files/json_text.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <sstream>

namespace plica {
namespace {

// Text of a manual: backslashes and leading dots mean something to roff, a hyphen is a minus.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result.starts_with('.') ? "\\&" + result : result;
}

std::vector<CLI::App*> commands(CLI::App& app) {
  return app.get_subcommands([](CLI::App* a) { return !a->get_name().empty(); });
}

std::string options_of(CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    const std::string names = option->get_name(false, true);
    text += ".TP\n.B " + roff(names);
    if (option->get_expected_min() > 0 && !option->get_positional() &&
        option->get_items_expected_max() > 0)
      text += " \\fI" + roff(option->get_type_name()) + "\\fR";
    text += "\n" + roff(option->get_description());
    if (!option->get_default_str().empty()) text += roff(" (" + option->get_default_str() + ")");
    text += "\n";
  }
  return text;
}

std::string words_of(CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames())
      words += (words.empty() ? "--" : " --") + name;
  return words;
}

// Shell cases of the options whose values are words of a list, "{m,mm}" in their type.
std::string value_cases(CLI::App& command) {
  std::string cases;
  for (const CLI::Option* option : command.get_options()) {
    const std::string type = option->get_type_name();
    const std::size_t begin = type.find('{'), end = type.find('}');
    if (begin == std::string::npos || end == std::string::npos || option->get_lnames().empty())
      continue;
    std::string words = type.substr(begin + 1, end - begin - 1);
    std::replace(words.begin(), words.end(), ',', ' ');
    cases += fmt::format("    \"{} --{}\") COMPREPLY=($(compgen -W \"{}\" -- \"$2\")); return ;;\n",
                         command.get_name(), option->get_lnames().front(), words);
  }
  return cases;
}

// The words of "{m,mm}" in the type of an option; null where it has none.
Json choices_of(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return nullptr;
  Json words = Json::array();
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

// The bounds of "INT in [0 - 256]"; null where the type states none.
std::pair<Json, Json> bounds_of(const std::string& type) {
  double low = 0, high = 0;
  const std::size_t at = type.find(" in [");
  if (at == std::string::npos ||
      std::sscanf(type.c_str() + at, " in [%lf - %lf]", &low, &high) != 2)
    return {nullptr, nullptr};
  const auto whole = [&](double x) { return type.starts_with("FLOAT") ? Json(x) : Json(long(x)); };
  return {whole(low), whole(high)};
}

Json option_json(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const bool flag = option.get_items_expected_max() == 0;
  const auto [low, high] = bounds_of(type);
  const char delimiter = option.get_delimiter();
  const std::string usual = option.get_default_str();
  return {{"name", option.get_lnames().empty() ? option.get_name() : option.get_lnames().front()},
          {"kind", flag                                                  ? "flag"
                   : type.starts_with("INT") || type.starts_with("UINT") ? "whole"
                   : type.starts_with("FLOAT")                           ? "number"
                                                                         : "text"},
          {"list", option.get_items_expected_max() > 1},
          {"delimiter", delimiter == '\0' ? Json(nullptr) : Json(std::string(1, delimiter))},
          {"required", option.get_required()},
          {"choices", choices_of(type)},
          {"min", low},
          {"max", high},
          {"default", usual.empty() ? Json(nullptr) : Json(usual)},
          {"help", option.get_description()}};
}

} // namespace

std::string commands_json(CLI::App& app, const std::string& version) {
  Json all = Json::object();
  for (CLI::App* command : commands(app)) {
    Json positionals = Json::array(), options = Json::array();
    for (const CLI::Option* option : command->get_options()) {
      if (option->check_lname("help")) continue;
      (option->get_positional() ? positionals : options).push_back(option_json(*option));
    }
    all[command->get_name()] = {
        {"help", command->get_description()}, {"positionals", positionals}, {"options", options}};
  }
  Json global = Json::array();
  for (const CLI::Option* option : app.get_options())
    if (!option->check_lname("help") && !option->check_lname("version"))
      global.push_back(option_json(*option));
  return Json{{"plica_version", version}, {"global", global}, {"commands", all}}.dump(1);
}

std::string manual_page(CLI::App& app, const std::string& version) {
  std::string text =
      fmt::format(".TH PLICA 1 \"\" \"Plica {}\"\n.SH NAME\nplica \\- {}\n.SH SYNOPSIS\n", version,
                  roff(app.get_description()));
  for (CLI::App* command : commands(app))
    text += ".B plica " + command->get_name() + "\n[\\fIoptions\\fR] ...\n.br\n";
  text += ".SH COMMANDS\n";
  for (CLI::App* command : commands(app))
    text += ".SS plica " + command->get_name() + "\n" + roff(command->get_description()) + ".\n" +
            options_of(*command);
  text += ".SH EXIT STATUS\n"
          "0 good, 1 an error in the input, 2 a numerical verdict failed, 3 an error within, 130 "
          "stopped by Ctrl\\-C, 143 by SIGTERM.\n"
          ".SH FILES\nThe keys of a case file: \\fBplica schema \\-\\-reference\\fR; one to begin "
          "with: \\fBplica init\\fR.\n";
  return text;
}

std::string completion(CLI::App& app, const std::string& shell) {
  std::string names, cases, values;
  for (CLI::App* command : commands(app)) {
    names += (names.empty() ? "" : " ") + command->get_name();
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), words_of(*command));
    values += value_cases(*command);
  }
  const std::string head = shell == "zsh" ? "autoload -U +X bashcompinit && bashcompinit\n" : "";
  return head +
         fmt::format(
             R"(# Completion of plica: source it, or put it where the shell looks for completions.
_plica() {{
  local words
  case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}" in
{}    *) ;;
  esac
  case "${{COMP_WORDS[1]}}" in
{}    *) words="{} --help --version" ;;
  esac
  if [ "$COMP_CWORD" -gt 1 ] && [ "${{2#-}}" = "$2" ]; then
    COMPREPLY=($(compgen -f -- "$2"))
  else
    [ "$COMP_CWORD" -eq 1 ] && words="{} --help --version"
    COMPREPLY=($(compgen -W "$words" -- "$2"))
  fi
}}
complete -o filenames -F _plica plica
)",
             values, cases, names, names);
}

} // namespace plica
