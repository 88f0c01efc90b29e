#include "run/routes/state_buckling.hpp"

#include "model/description/ejma.hpp"
#include "run/routes/route.hpp"
#include "solve/buckling.hpp"
#include "solve/state_shape.hpp"
#include "solve/statics.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
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

// Displacement of a node out from the axis, around and along it.
Eigen::Vector3d in_cylinder(const Model& model, int node, const VectorXd& u) {
  const Eigen::Vector3d& x = model.mesh.nodes[std::size_t(node)];
  const Eigen::Vector3d d = u.segment<3>(6 * node);
  const auto turn = std::polar(1., std::atan2(x.z(), x.x()));
  return {turn.real() * d.x() + turn.imag() * d.z(), turn.real() * d.z() - turn.imag() * d.x(),
          d.y()};
}

// Motion of the crowns of a bellows in a buckling mode, by harmonics around.
struct CrownMotion {
  std::string bellows;
  double all = 0, uniform = 0, once_around = 0; // mean squares, summed over the crowns
  double agreement = 0; // of the tilts of neighbours, from -1 (against each other) to 1
};

CrownMotion crown_motion(const std::string& bellows, const Model& model, const VectorXd& u) {
  using std::complex;
  CrownMotion motion{.bellows = bellows};
  std::vector<complex<double>> tilt;
  const auto& sets = model.mesh.sets;
  for (int k = 1; sets.contains(bellows + ".crown[" + std::to_string(k) + "]"); ++k) {
    const std::vector<int>& circle = sets.at(bellows + ".crown[" + std::to_string(k) + "]");
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Vector3cd first = Eigen::Vector3cd::Zero();
    const double share = 1 / double(circle.size());
    for (int node : circle) {
      const Eigen::Vector3d& x = model.mesh.nodes[std::size_t(node)];
      const Eigen::Vector3d d = in_cylinder(model, node, u);
      mean += share * d;
      first += 2 * share * std::polar(1., std::atan2(x.z(), x.x())) * d.cast<complex<double>>();
      motion.all += share * d.squaredNorm();
    }
    motion.uniform += mean.squaredNorm();
    motion.once_around += first.squaredNorm() / 2;
    tilt.push_back(first.z());
  }
  double alike = 0, total = 0;
  for (std::size_t k = 0; k < tilt.size(); ++k) {
    total += std::norm(tilt[k]);
    if (k > 0) alike += (tilt[k - 1] * std::conj(tilt[k])).real();
  }
  motion.agreement = total > 0 ? alike / total : 0;
  return motion;
}

// How the bellows that moves most buckles; none where it is pressed along or nothing moves it.
std::optional<SquirmResult> elastic_squirm(const Case& data, const Model& model, const VectorXd& u,
                                           double factor) {
  CrownMotion most;
  for (const Part& part : data.parts)
    if (std::holds_alternative<Bellows>(part.body)) {
      CrownMotion motion = crown_motion(part.name, model, u);
      if (motion.all > most.all) most = std::move(motion);
    }
  if (!(most.all > 0) || most.uniform > most.all / 2) return std::nullopt;
  constexpr double against = -0.25; // tilts in waves of less than 3.5 convolutions
  const SquirmKind kind = most.once_around < most.all / 2 ? SquirmKind::elastic_wall
                          : most.agreement > against      ? SquirmKind::elastic_column
                                                          : SquirmKind::elastic_in_plane;
  return SquirmResult{most.bellows, kind, factor * data.state->pressure, factor};
}

// The lowest of each kind.
void add_elastic_squirm(const Case& data, const Model& model, const VectorXd& u, double factor,
                        StateResult& result) {
  if (!(data.state->pressure > 0)) return;
  const auto found = elastic_squirm(data, model, u, factor);
  const auto is_same = [&](const SquirmResult& s) {
    return s.bellows == found->bellows && s.kind == found->kind;
  };
  if (found && std::none_of(result.squirm.begin(), result.squirm.end(), is_same))
    result.squirm.push_back(*found);
}

// Waves around that are shorter than four elements are those of the mesh: their loads grow with the
// square of its number around.
bool is_resolved(const Model& model, const VectorXd& u) {
  double alike = 0;
  for (const Ring& ring : model.mesh.rings)
    for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
      const int node = ring.nodes[i], next = ring.nodes[(i + 1) % ring.nodes.size()];
      alike += in_cylinder(model, node, u).dot(in_cylinder(model, next, u));
    }
  return alike >= 0;
}

} // namespace

void add_buckling(const Case& data, const Model& at_rest, const StateLoads& acting,
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
  const BucklingLoads loads =
      buckling_loads(restrict_to(rest.K, free), SparseMatrix(restrict_to(now.K, free) / share),
                     data.state->buckling, beyond);
  for (Eigen::Index k = 0; k < loads.factor.size(); ++k) {
    VectorXd q = VectorXd::Zero(now.map.size());
    q(free) = loads.shapes.col(k);
    const VectorXd u = expand(now.map, q).col(0);
    if (!is_resolved(at_rest, u)) continue;
    double across = 0, all = 0;
    for (Eigen::Index n = 0; n < u.size(); n += 6) {
      across += u[n] * u[n] + u[n + 2] * u[n + 2];
      all += u.segment<3>(n).squaredNorm();
    }
    result.buckling.push_back({loads.factor[k], all > 0 ? across / all : 0});
    add_elastic_squirm(data, at_rest, u, loads.factor[k], result);
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
    const auto add = [&](SquirmKind kind, double limit) {
      result.squirm.push_back({part.name, kind, limit, limit / state.pressure});
    };
    try {
      const EjmaFactors factors = ejma_factors(*ejma);
      add(SquirmKind::column, ejma_column_squirm(*ejma, factors));
      if (state.yield)
        add(SquirmKind::in_plane, ejma_in_plane_squirm(*ejma, factors, *state.yield));
    } catch (const std::invalid_argument&) { // outside the range of the coefficients
    }
  }
}

} // namespace plica
