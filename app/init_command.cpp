#include "app/command_line.hpp"
#include "app/terminal.hpp"
#include "io/files/files.hpp"
#include "io/input/starter_case.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <map>

namespace plica {
namespace {

const std::map<std::string, Starter> starters{{"bellows", Starter::bellows},
                                              {"decoupler", Starter::decoupler},
                                              {"line", Starter::line},
                                              {"beam", Starter::beam},
                                              {"measured", Starter::measured}};

// Files that are there, and a name that no case can have, are errors.
int write_starter(const std::filesystem::path& given, Starter kind) {
  std::filesystem::path file = given;
  if (file.extension().empty()) file += ".yaml";
  const auto refused = [](const std::filesystem::path& path, const char* wrong,
                          const char* allowed) {
    return InputError(
        {{.file = path.string(), .line = 0, .key = "", .wrong = wrong, .allowed = allowed}});
  };
  const std::string name = file.stem().string();
  if (name.empty() || !std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_';
      }))
    throw refused(file, "is no name for a case",
                  "letters, digits and underscores, as in my_pipe.yaml");
  const std::vector<StarterFile> files = starter_files(kind, name);
  const auto path_of = [&](const StarterFile& f) {
    return &f == &files.front() ? file : file.parent_path() / f.name;
  };
  for (const StarterFile& f : files)
    if (&f != &files.front() && path_of(f) == file)
      throw refused(file, "is what the file beside it is called", "another name for the case");
  for (const StarterFile& f : files)
    if (std::filesystem::exists(std::filesystem::symlink_status(path_of(f))))
      throw refused(path_of(f), "is there already", "a new file; nothing is overwritten");
  for (const StarterFile& f : files) write_new(path_of(f), f.text, path_of(f));
  const char* next = kind == Starter::measured ? "plica diagnose {0}" : "plica run {0} --out out";
  print(fmt::format("{} written. Next: {}\n", file.string(),
                    fmt::format(fmt::runtime(next), file.string())));
  return 0;
}

} // namespace

void add_init_command(CommandLine& line) {
  const auto file = std::make_shared<std::filesystem::path>("pipe.yaml");
  const auto kind = std::make_shared<Starter>(Starter::bellows);
  CLI::App& command = line.add("init", "write a commented case file to begin with",
                               [file, kind] { return write_starter(*file, *kind); });
  command.add_option("FILE", *file, "the file, not there yet")->capture_default_str();
  command
      .add_option("--kind", *kind,
                  "bellows, decoupler between pipes, exhaust line on its engine, beam, or a beam "
                  "with measured data")
      ->transform(
          CLI::CheckedTransformer(starters).description("{bellows,decoupler,line,beam,measured}"))
      ->default_str("bellows");
}

} // namespace plica
