#include "reduction/cyclic_state.hpp"

#include "solve/sparse_factor.hpp"
#include "solve/state_elements.hpp"
#include "solve/statics.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

bool along_axis(const Vector3d& v) {
  return v.x() == 0 && v.z() == 0;
}

// Quads between the first two steps of their rings: gathered over the harmonic n = 0 they weigh as
// much as those of every other sector.
std::vector<int> first_sector(const Model& model) {
  std::vector<int> step(model.mesh.nodes.size(), -1);
  for (const Ring& ring : model.mesh.rings)
    for (std::size_t j = 0; j < ring.nodes.size(); ++j) step[std::size_t(ring.nodes[j])] = int(j);
  std::vector<int> quads;
  for (std::size_t e = 0; e < model.mesh.quads.size(); ++e)
    if (std::all_of(model.mesh.quads[e].nodes.begin(), model.mesh.quads[e].nodes.end(),
                    [&](int node) { return step[std::size_t(node)] <= 1; }))
      quads.push_back(int(e));
  return quads;
}

} // namespace

bool is_axisymmetric(const Model& at_rest, const StateLoads& loads) {
  for (const MovedHold& hold : loads.holds)
    if (!along_axis(hold.shift) || !hold.turn.isZero()) return false;
  for (const BushingElement& b : at_rest.bushings)
    if (!along_axis(b.ground_shift) || !b.ground_turn.isIdentity()) return false;
  if (!along_axis(loads.gravity)) return false;
  for (Eigen::Index i = 0; i < loads.force.size(); ++i)
    if (loads.force[i] != 0 && i % 6 != 1) return false;
  return std::holds_alternative<CyclicModel>(cyclic_model(at_rest));
}

StateSolver cyclic_state_solver(const Model& at_rest, std::vector<int> holds) {
  const auto step = [holds = std::move(holds)](const Model& now, const VectorXd& unbalanced,
                                               const VectorXd& still_to_go) -> StateIncrement {
    const auto view = cyclic_model(now);
    if (const auto* reason = std::get_if<std::string>(&view))
      throw StateError("the state does not keep the rotational symmetry: " + *reason);
    const auto& model = std::get<CyclicModel>(view);
    const HarmonicSystem system = model.system({0, false});
    VectorXd q = VectorXd::Zero(system.K.rows());
    std::vector<int> held;
    for (const AxisUnknown& a : system.axis) {
      const auto hold = std::find(holds.begin(), holds.end(), a.node);
      if (hold == holds.end() || a.number < 0) continue;
      q[a.number] = a.direction.dot(still_to_go.segment<6>(6 * (hold - holds.begin())));
      held.push_back(a.number);
    }
    StateIncrement increment =
        solve_increment(system.K, model.gather(system, unbalanced).col(0), held, q);
    if (increment.stable) increment.u = model.expand(system, q).col(0);
    return increment;
  };
  const double around = double(at_rest.mesh.rings.front().nodes.size());
  return {step, [quads = first_sector(at_rest), around](const Model& now) {
            return state_forces(now, quads, around);
          }};
}

} // namespace plica
