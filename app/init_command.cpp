#include "app/command_line.hpp"
#include "app/terminal.hpp"
#include "io/files/files.hpp"
#include "io/input/starter_case.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>

namespace plica {
namespace {

// A file that is there, and a name that no case can have, are errors.
int write_starter(const std::filesystem::path& given) {
  std::filesystem::path file = given;
  if (file.extension().empty()) file += ".yaml";
  const auto refused = [&](const char* wrong, const char* allowed) {
    return InputError(
        {{.file = file.string(), .line = 0, .key = "", .wrong = wrong, .allowed = allowed}});
  };
  const std::string name = file.stem().string();
  if (name.empty() || !std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_';
      }))
    throw refused("is no name for a case", "letters, digits and underscores, as in my_pipe.yaml");
  if (std::filesystem::exists(std::filesystem::symlink_status(file)))
    throw refused("is there already", "a new file; nothing is overwritten");
  write_new(file, starter_case(name), file);
  print(fmt::format("{} written. Next: plica run {} --out out\n", file.string(), file.string()));
  return 0;
}

} // namespace

void add_init_command(CommandLine& line) {
  const auto file = std::make_shared<std::filesystem::path>("pipe.yaml");
  CLI::App& command = line.add("init", "write a commented case file of a bellows to begin with",
                               [file] { return write_starter(*file); });
  command.add_option("FILE", *file, "the file, not there yet")->capture_default_str();
}

} // namespace plica
