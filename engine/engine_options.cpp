#include "engine/engine_options.hpp"

#include "app/case_in_folder.hpp"
#include "app/terminal.hpp"

namespace plica {
namespace {

void add_options(CLI::App& app, EngineOptions& options) {
  app.set_version_flag("--version", "plica-mpi " PLICA_VERSION "\nwith " PLICA_ENGINE_LIBRARIES);
  app.add_option("CASE", options.chosen.path, "case file, or the folder of one")->required();
  app.add_option("--model", options.chosen.model,
                 "one of the models of the case; left out: its parts")
      ->type_name("NAME");
  app.add_option_function<std::vector<std::string>>(
         "--set",
         [&options](const std::vector<std::string>& changes) {
           for (const std::string& change : changes)
             options.chosen.set[change.substr(0, change.find('='))] =
                 change.substr(change.find('=') + 1);
         },
         "put a value into the case before it is read, as plica run does")
      ->allow_extra_args(false)
      ->check(CLI::Validator(
          [](std::string& text) {
            const std::size_t equals = text.find('=');
            return equals == std::string::npos || equals == 0 ? "'" + text + "' is not PATH=VALUE"
                                                              : std::string();
          },
          ""))
      ->type_name("PATH=VALUE");
  app.add_option("--out", options.out.folder, "folder for the results")->capture_default_str();
  app.add_flag("--quiet", options.out.quiet, "print errors only");
  app.add_option_function<std::string>(
         "--only", [&options](const std::string&) { options.out.json_only = true; },
         "write JSON alone")
      ->check(CLI::IsMember({"json"}))
      ->type_name("");
  app.add_option("--threads", options.threads, "threads of each rank")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  app.add_option("--workspace", options.workspace,
                 "workspace of MUMPS beyond its estimate, percent; taken larger where too small")
      ->check(CLI::Range(-95, 10000))
      ->capture_default_str();
  app.add_option("--mumps-memory", options.megabytes,
                 "most that MUMPS may take on a rank, MB; 0 = what it needs. Taken larger where "
                 "too small")
      ->check(CLI::Range(0, 100000000))
      ->capture_default_str();
}

} // namespace

std::optional<int> parse(EngineOptions& options, int argc, char** argv, bool speaks) {
  CLI::App app{"Plica over the ranks of mpirun: statics, modes and responses of large cases"};
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (!speaks) return error.get_exit_code() == 0 ? 0 : 1;
    return app.exit(error) == 0 ? 0 : 1;
  }
  return std::nullopt;
}

} // namespace plica
