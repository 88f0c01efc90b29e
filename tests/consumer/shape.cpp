// A cuff with a heavy flange becomes a model: what it weighs, and where a sensor sits.
#include "expect.hpp"
#include "plica/model/shape/build.hpp"
#include "plica/solve/effective_mass.hpp"

#include <numbers>

int main() {
  using namespace plica;
  constexpr double rho = 8000, radius = 0.05, length = 0.2, wall = 1e-3, flange = 0.75;
  Case data;
  data.name = "cuff";
  data.materials["steel"] = {200e9, 0.3, rho};
  Bellows cuff{.material = "steel", .root_radius = radius};
  cuff.profile = {{.shape = SectionShape::cuff, .length = length}};
  cuff.wall.plies = {wall};
  cuff.mesh = {.around = 96, .arc = 4, .wall = 10};
  data.parts.push_back({"cuff", cuff});
  data.caps = {{.name = "flange", .of = {"cuff.right"}, .mass = flange}};
  data.sensors = {{.name = "side", .at = {radius, length / 2, 0}}};

  const BuiltCase built = build(data);
  expect_near(total_mass(built.model), rho * 2 * std::numbers::pi * radius * length * wall + flange,
              "mass", 1e-3);
  expect(built.sensors.size() == 1 && built.sensors[0].distance < 1e-9, "the sensor has a node");
  const Eigen::Vector3d end = built.model.mesh.nodes[built.cap_nodes.at("flange")];
  expect((end - Eigen::Vector3d(0, length, 0)).norm() < 1e-9, "the flange is at the right end");
  return differs;
}
