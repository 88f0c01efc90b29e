// A cantilever held against Euler's frequencies, which it has, to show that the diagnosis links.
#include "plica/diagnose/diagnose.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  using namespace plica;
  constexpr double E = 200e9, rho = 7850, length = 1, width = 0.02, depth = 0.01;
  Case data;
  data.name = "cantilever";
  data.materials["steel"] = {E, 0.3, rho};
  BeamPart beam;
  beam.points = {{0, 0, 0}, {0, length, 0}};
  beam.elements = 20;
  beam.up = {0, 0, 1};
  beam.section = {.shape = BeamShape::rectangle, .material = "steel"};
  beam.section.width = width;
  beam.section.depth = depth;
  data.parts.push_back({"beam", beam});
  Cap root;
  root.name = "root";
  root.of = {"beam.start"};
  data.caps.push_back(root);
  data.mount.push_back({.cap = "root"});
  TestData test;
  test.data.specimen = "cantilever";
  const double radius = depth / std::sqrt(12.); // of gyration, bending in z
  int order = 0;
  for (const double root_of : {1.875104, 4.694091, 7.854757}) {
    MeasuredMode mode;
    mode.shape = MeasuredShape::transverse;
    mode.direction = Axis::z;
    mode.order = ++order;
    mode.frequency =
        std::pow(root_of / length, 2) / (2 * std::numbers::pi) * radius * std::sqrt(E / rho);
    test.data.modes.push_back(mode);
  }
  const Diagnosis found = diagnose(data, test, {});
  std::printf("%s\n", found.headline.c_str());
  return found.verdict == Verdict::none ? 0 : 1;
}
