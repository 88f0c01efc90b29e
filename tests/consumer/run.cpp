// A case without a file: the rod of a pendulum, to show that description, shape and runs link.
#include "plica/run/analyses/run.hpp"
#include "plica/model/description/case.hpp"

#include <cstdio>

int main() {
  using namespace plica;
  Case data;
  data.name = "rod";
  data.materials["steel"] = {200e9, 0.3, 7850};
  BeamPart rod;
  rod.points = {{0, 0, 0}, {0, 1, 0}};
  rod.elements = 20;
  rod.section = {.shape = BeamShape::solid, .material = "steel", .radius = 5e-3};
  data.parts.push_back({"rod", rod});
  data.supports.push_back({"rod.start", {0, 1, 2, 3, 4, 5}});
  data.analyses.modes = Modes{.count = 1};
  const Results results = run(data, [](const std::string&) {});
  const double f = results.modes.front().frequency; // Euler beam: 7.062 Hz
  std::printf("%.3f Hz\n", f);
  return results.verification.passed && f > 7.05 && f < 7.065 ? 0 : 1;
}
