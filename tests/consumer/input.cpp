// A case file is read into SI, a misspelt key is told by its line, and a sweep is planned on it.
#include "expect.hpp"
#include "plica/io/files/files.hpp"
#include "plica/io/input/sweep_plan.hpp"
#include "plica/model/description/case_path.hpp"

int main() {
  using namespace plica;
  const std::string text = "case: rod\n"
                           "materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7.85 g/cm3}}\n"
                           "parts:\n"
                           "  rod:\n"
                           "    type: beam\n"
                           "    points: [[0, 0, 0], [0, 250 mm, 0]]\n"
                           "    elements: 4\n"
                           "    section: {shape: solid, material: steel, radius: 5 mm}\n"
                           "supports: [{set: rod.start, fix: [ux, uy, uz, rx, ry, rz]}]\n"
                           "analyses: {static: false, modes: {count: 2}}\n";
  write_whole("consumer.yaml", text);
  CaseFile file = read_case("consumer.yaml");
  const double* density = number_at(file.data, "materials.steel.rho");
  expect(density != nullptr, "a density at its path");
  if (density) expect_near(*density, 7850, "density");
  expect_near(std::get<BeamPart>(file.data.parts[0].body).points[1][1], 0.25, "length");
  expect(file.lines.at("parts.rod.section.radius") == 8, "the radius is in line 8");

  const SweepPlan plan = sweep_plan(file, {.vary = {"parts.rod.section.radius=4mm:8mm:3"}});
  expect(plan.variants == 3, "three variants");
  expect_near(plan.columns[0].numbers[1], 6e-3, "radius of the second one");

  write_whole("consumer.yaml", std::string(text).replace(text.find("radius"), 6, "raduis"));
  try {
    read_case("consumer.yaml");
    expect(false, "a misspelt key is refused");
  } catch (const InputError& error) {
    expect(error.problems()[0].line == 8, "the misspelt key is in line 8");
    expect(std::string(error.what()).find("did you mean 'radius'?") != std::string::npos,
           "radius was meant");
  }
  return differs;
}
