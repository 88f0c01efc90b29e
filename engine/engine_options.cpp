#include "engine/engine_options.hpp"

#include "app/terminal.hpp"
#include "words/input_error.hpp"

namespace plica {
namespace {

void add_options(CLI::App& app, EngineOptions& options) {
  app.set_version_flag("--version", "plica-mpi " PLICA_VERSION "\nwith " PLICA_ENGINE_LIBRARIES);
  add_case(app, options.chosen);
  add_output(app, options.out);
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
  } catch (const InputError& error) { // a folder that holds no case
    if (speaks) say_problems(error);
    return 1;
  } catch (const CLI::ParseError& error) {
    if (!speaks) return error.get_exit_code() == 0 ? 0 : 1;
    return app.exit(error) == 0 ? 0 : 1;
  }
  return std::nullopt;
}

} // namespace plica
