#include "run/routes/state_buckling.hpp"

#include "model/description/ejma.hpp"
#include "run/routes/route.hpp"
#include "solve/buckling.hpp"
#include "solve/state_shape.hpp"
#include "solve/statics.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::VectorXd;

// The same with a share of the loads.
Model with_share(Model model, double share) {
  for (ShellProperties& p : model.shells) {
    p.pressure *= share;
    p.section.thermal_strain *= share;
  }
  for (BeamElement& b : model.beams) {
    b.section.thermal_strain *= share;
    if (b.section.tightened) *b.section.tightened *= share;
  }
  for (PressedEnd& end : model.pressed_ends) end.pressure *= share;
  for (BushingElement& b : model.bushings) {
    b.ground_shift *= share;
    const Eigen::AngleAxisd turn(b.ground_turn);
    b.ground_turn = Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix();
  }
  return model;
}
StateLoads with_share(StateLoads loads, double share) {
  for (MovedHold& hold : loads.holds) {
    hold.shift *= share;
    hold.turn *= share;
  }
  loads.force *= share;
  loads.gravity *= share;
  for (auto& [node, strain] : loads.growth) strain *= share;
  return loads;
}

} // namespace

void add_buckling(int count, const Model& at_rest, const StateLoads& acting,
                  const StateSolver& solver, StateResult& result) {
  constexpr double share = 1e-3, beyond = 1000;
  BaseState little =
      find_state(with_share(at_rest, share), with_share(acting, share), solver, [](const auto&) {});
  Rest by_stress = *little.model.rest;
  by_stress.part = StiffnessPart::by_stress;
  little.model.rest = std::make_shared<Rest>(std::move(by_stress));
  const System rest = assemble(at_rest);
  System now = assemble(little.model);
  for (const MatrixElement& m : coupling_stiffness(little.model, at_rest, little.lacking, false)) {
    const auto first = now.map.independent.begin() + 6 * m.nodes.front();
    const std::vector<int> turns(first + 3, first + 6);
    if (std::all_of(turns.begin(), turns.end(), [](int number) { return number >= 0; }))
      add_dense(now.K, turns, m.K.bottomRightCorner<3, 3>());
  }
  std::vector<int> holds;
  for (const MovedHold& hold : acting.holds) holds.push_back(hold.node);
  const std::vector<int> free = complement(now.map.size(), node_dofs(now.map, holds));
  const BucklingLoads loads = buckling_loads(
      restrict_to(rest.K, free), SparseMatrix(restrict_to(now.K, free) / share), count, beyond);
  for (Eigen::Index k = 0; k < loads.factor.size(); ++k) {
    VectorXd q = VectorXd::Zero(now.map.size());
    q(free) = loads.shapes.col(k);
    const VectorXd u = expand(now.map, q).col(0);
    double across = 0, all = 0;
    for (Eigen::Index n = 0; n < u.size(); n += 6) {
      across += u[n] * u[n] + u[n + 2] * u[n + 2];
      all += u.segment<3>(n).squaredNorm();
    }
    result.buckling.push_back({loads.factor[k], all > 0 ? across / all : 0});
  }
  result.buckling_looked_for = true;
  result.buckling_proved = loads.proved;
  result.buckling_reason = loads.reason;
}

void add_squirm(const Case& data, StateResult& result) {
  const OperatingState& state = *data.state;
  if (!(state.pressure > 0)) return;
  for (const Part& part : data.parts) {
    const auto* bellows = std::get_if<Bellows>(&part.body);
    if (!bellows) continue;
    Material material = data.materials.at(bellows->material);
    for (const PartTemperature& t : state.temperature)
      if (t.part == part.name)
        material.E *= at_temperature(material.E_over_temperature, range_of(t)[1]) /
                      at_temperature(material.E_over_temperature, state.free_of_stress_at);
    const auto formula = ejma_bellows(*bellows, material);
    const auto* ejma = std::get_if<EjmaBellows>(&formula);
    if (!ejma) continue;
    const auto add = [&](const char* kind, double limit) {
      result.squirm.push_back({part.name, kind, limit, limit / state.pressure});
    };
    try {
      const EjmaFactors factors = ejma_factors(*ejma);
      add("column", ejma_column_squirm(*ejma, factors));
      if (state.yield) add("in plane", ejma_in_plane_squirm(*ejma, factors, *state.yield));
    } catch (const std::invalid_argument&) { // outside the range of the coefficients
    }
  }
}

} // namespace plica
