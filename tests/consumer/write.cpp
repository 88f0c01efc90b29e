// Everything at once: a case is read, run and written, and its files are read again.
#include "expect.hpp"
#include "plica/io/files/files.hpp"
#include "plica/io/input/case_file.hpp"
#include "plica/io/tables/result_path.hpp"
#include "plica/io/write/write_results.hpp"
#include "plica/run/analyses/run.hpp"

int main() {
  using namespace plica;
  write_whole("consumer.yaml", "case: rod\n"
                               "materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850 kg/m3}}\n"
                               "parts:\n"
                               "  rod:\n"
                               "    type: beam\n"
                               "    points: [[0, 0, 0], [0, 1 m, 0]]\n"
                               "    elements: 20\n"
                               "    section: {shape: solid, material: steel, radius: 5 mm}\n"
                               "supports: [{set: rod.start, fix: [ux, uy, uz, rx, ry, rz]}]\n"
                               "analyses: {static: false, modes: {count: 2}, error_bars: false}\n");
  const Case data = read_case("consumer.yaml").data;
  std::filesystem::remove_all("consumer_out");
  OutputFolder out("consumer_out",
                   {.command = "run", .inputs = {"consumer.yaml"}, .names = result_files(data)});
  write_results(run(data, [](const std::string&) {}), out);
  out.commit();
  const Json json = Json::parse(read_whole("consumer_out/results.json"));
  const auto f = number_in(json, "modes[0].frequency");
  expect(f.has_value(), "a first mode");
  if (f) expect_near(*f, 7.0614, "frequency of an Euler beam", 5e-4);
  for (const char* name : {"modes.vtu", "modes.csv", "report.html", "simulated.yaml"})
    expect(std::filesystem::exists(std::filesystem::path("consumer_out") / name), name);
  return differs;
}
