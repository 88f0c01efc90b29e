#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/terminal.hpp"
#include "compare/sensors_by_place.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/lab_files/universal_modes.hpp"
#include "io/tables/correlation_words.hpp"
#include "io/write/write_correlation.hpp"
#include "lab/measured/states.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

struct CompareOptions {
  std::string result, measured; // each a measured.yaml or a folder of results
  Output out;
};

namespace fs = std::filesystem;

// A measured.yaml, or a folder of results with its simulated.yaml.
MeasuredFile measured_file(const std::string& path) {
  const fs::path file = fs::is_directory(path) ? fs::path(path) / "simulated.yaml" : fs::path(path);
  if (!fs::is_regular_file(file))
    throw InputError({{.file = file.string(),
                       .line = 0,
                       .key = "",
                       .wrong = "is not there",
                       .allowed = "a measured.yaml, or a folder that `plica run` has written"}});
  return read_measured_file(file.string());
}

// What belongs to the specimen as the case draws it.
TestData test_data(const MeasuredFile& file) {
  Measured data = measured_as_drawn(file.data);
  std::vector<std::vector<FrfSet>> responses = load_each_frf(data, file.path.parent_path());
  return {.data = std::move(data), .responses = std::move(responses)};
}

int compare_files(const CompareOptions& options) {
  const MeasuredFile result = measured_file(options.result), test = measured_file(options.measured);
  std::vector<fs::path> inputs = files_of(result);
  for (fs::path& file : files_of(test)) inputs.push_back(std::move(file));
  OutputFolder out(options.out.folder, {.command = "compare",
                                        .inputs = std::move(inputs),
                                        .names = correlation_files(),
                                        .json_only = options.out.json_only});
  const TestData simulated = test_data(result);
  TestData measured = test_data(test);
  if (is_universal_file(test.path))
    measured.data = named_by_place(std::move(measured.data), simulated.data);
  const Correlation c = correlate(simulated, measured);
  write_correlation(c, simulated, measured, out);
  hand_over(out);
  if (!options.out.quiet)
    print(fmt::format("{}\nReport: {}\n", correlation_text(c, simulated, measured),
                      out.shown("correlation.html", "correlation.json").string()));
  return 0;
}

} // namespace

void add_compare_command(CommandLine& line) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command =
      line.add("compare", "simulation and test side by side: modes, shapes, responses",
               [options] { return compare_files(*options); });
  command.add_option("RESULT", options->result, "folder of a run, or a measured.yaml")->required();
  command
      .add_option("MEASURED", options->measured,
                  "a measured.yaml, a universal file with modes, or a folder of a run")
      ->required();
  add_output(command, options->out);
}

} // namespace plica
