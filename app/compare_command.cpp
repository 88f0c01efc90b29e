#include "app/commands.hpp"

#include "io/input/measured_file.hpp"
#include "io/measured_data.hpp"
#include "io/results/write_correlation.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

namespace fs = std::filesystem;

// A measured.yaml, or a folder of results with its simulated.yaml.
TestData test_data(const std::string& path) {
  const fs::path file = fs::is_directory(path) ? fs::path(path) / "simulated.yaml" : fs::path(path);
  if (!fs::is_regular_file(file))
    throw InputError({{.file = file.string(),
                       .line = 0,
                       .key = "",
                       .wrong = "is not there",
                       .allowed = "a measured.yaml, or a folder that `plica run` has written"}});
  TestData side{.data = read_measured(file.string()), .frfs = {}};
  side.frfs = load_frfs(side.data, file.parent_path());
  return side;
}

} // namespace

int compare_command(const CompareOptions& options) {
  const TestData simulated = test_data(options.result), measured = test_data(options.measured);
  const Correlation c = correlate(simulated, measured);
  write_correlation(c, simulated, measured, options.out);
  if (!options.quiet)
    fmt::print("{}\nReport: {}\n", correlation_text(c, simulated, measured),
               (options.out / "report.html").string());
  return 0;
}

} // namespace plica
