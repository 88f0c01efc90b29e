// A bellows with a sensor, a tap and damping, as it is reduced to a superelement.
#pragma once

#include "run/study/reduce.hpp"
#include "tests/bellows_case.hpp"

namespace plica::test {

inline Case sample_case() {
  Case data = verification_case("bellows_a", {20, 2, 3}, 4);
  data.caps[0].mass = 0.2;
  const BuiltCase built = build(data);
  const Eigen::Vector3d x = built.model.mesh.nodes[built.model.mesh.rings[40].nodes[3]];
  data.sensors = {{.name = "crown", .at = {x[0], x[1], x[2]}}};
  Force force;
  force.name = "tap";
  force.at = "bellows.crown[4]";
  data.analyses.response = Response{.bases = {1}, .forces = {force}, .band = {5, 900}};
  data.analyses.damping = {.modal = 0.02, .loss_factors = {{"bellows", 0.01}}};
  return data;
}

inline ReducedCase reduced(const Case& data, double cutoff = 2000) {
  return reduce_case(data, {.cutoff = cutoff, .boundary = {}}, [](const std::string&) {});
}

} // namespace plica::test
