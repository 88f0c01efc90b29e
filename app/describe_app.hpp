// The manual page and the completions of the command line, from its one declaration.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace plica {

std::string manual_page(CLI::App& app, const std::string& version); // roff, section 1

// Every command with its options, as JSON: {"plica_version", "commands": {"run": {"help",
// "positionals": [...], "options": [{"name", "kind": flag | whole | number | text, "list",
// "delimiter", "required", "choices", "min", "max", "default", "help"}]}}}.
std::string commands_json(CLI::App& app, const std::string& version);

// For bash; for zsh the same behind its bashcompinit.
std::string completion(CLI::App& app, const std::string& shell);

} // namespace plica
