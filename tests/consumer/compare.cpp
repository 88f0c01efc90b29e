// A rod and one that is thicker, to show that whole runs and comparison link.
#include "plica/compare/whole_run.hpp"

#include <cmath>
#include <cstdio>

namespace {

plica::Case rod_of(double radius) {
  using namespace plica;
  Case data;
  data.name = "rod";
  data.materials["steel"] = {200e9, 0.3, 7850};
  BeamPart rod;
  rod.points = {{0, 0, 0}, {0, 1, 0}};
  rod.elements = 20;
  rod.section = {.shape = BeamShape::solid, .material = "steel", .radius = radius};
  data.parts.push_back({"rod", rod});
  data.supports.push_back({"rod.start", {0, 1, 2, 3, 4, 5}});
  data.analyses.modes = Modes{.count = 1};
  data.analyses.error_bars = false;
  return data;
}

} // namespace

int main() {
  using namespace plica;
  WholeRunRequest request{.data = rod_of(5e-3), .variants = {rod_of(6e-3)}};
  request.data.variants = {{"thicker", {{"parts.rod.section.radius", "6 mm"}}}};
  const WholeRun done = whole_run(request);
  const std::map<std::string, double> own = headline(done.results);
  if (done.results.variants.size() != 1 || own.empty()) return 1;
  // Slender: frequencies go with the radius.
  for (const auto& [key, value] : done.results.variants[0].headline) {
    std::printf("%s: %g, thicker %g\n", key.c_str(), own.at(key), value);
    if (key.starts_with("f_") && std::abs(value / own.at(key) - 1.2) > 1e-3) return 1;
  }
  return done.results.verification.passed ? 0 : 1;
}
