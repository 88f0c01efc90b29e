#include "run/routes/operating_state.hpp"

#include "reduction/cyclic_state.hpp"
#include "run/routes/route.hpp"
#include "solve/buckling.hpp"
#include "solve/state_elements.hpp"
#include "solve/stopwatch.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d vector_of(const Triple& t) {
  return {t[0], t[1], t[2]};
}

Matrix3d turned_by(const Triple& t) {
  const Vector3d v = vector_of(t);
  const double angle = v.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, v / angle).toRotationMatrix()
                   : Matrix3d(Matrix3d::Identity());
}

// What a temperature makes of a material: E against that at rest, and free strain since.
struct Heated {
  double modulus = 1, strain = 0;
};

class Preparation {
public:
  Preparation(const Case& data, BuiltCase& built)
      : data_(data), state_(*data.state), built_(built), model_(built.model) {}

  StateLoads loads() {
    for (const PartTemperature& t : state_.temperature) heat(t);
    if (state_.pressure != 0) press();
    StateLoads loads;
    loads.gravity = vector_of(state_.gravity);
    for (int node : built_.held_nodes) loads.holds.push_back({.node = node});
    for (const EndOffset& offset : state_.offset) move_end(offset, loads);
    loads.force = VectorXd::Zero(dof_count(model_));
    for (const Cap& cap : data_.caps) grow(cap, loads);
    for (const EndLoad& load : state_.force) {
      const int node = built_.cap_nodes.at(load.cap);
      loads.force.segment<3>(6 * node) += vector_of(load.force);
      loads.force.segment<3>(6 * node + 3) += vector_of(load.moment);
    }
    return loads;
  }

private:
  int component_of(const std::string& part) const {
    const auto& names = model_.components;
    return int(std::find(names.begin(), names.end(), part) - names.begin());
  }

  Heated heated(const Material& m, double temperature) const {
    constexpr double mean_from = 20; // of the tables of expansion
    const double rest = state_.free_of_stress_at;
    return {.modulus = at_temperature(m.E_over_temperature, temperature) /
                       at_temperature(m.E_over_temperature, rest),
            .strain = at_temperature(m.expansion, temperature) * (temperature - mean_from) -
                      at_temperature(m.expansion, rest) * (rest - mean_from)};
  }

  // Shells of one temperature share a section.
  template <class Shell>
  void heat_shells(std::vector<Shell>& shells, int component, const PartTemperature& t,
                   const Material& m, std::map<std::pair<int, double>, int>& sections) {
    for (Shell& shell : shells) {
      if (model_.shells[std::size_t(shell.section)].component != component) continue;
      double y = 0;
      for (int node : shell.nodes)
        y += model_.mesh.nodes[std::size_t(node)].y() / double(shell.nodes.size());
      constexpr double step = 0.01; // degC, below which two are one
      const double temperature = std::round(temperature_at(t, y) / step) * step;
      const auto [at, is_new] =
          sections.try_emplace({shell.section, temperature}, int(model_.shells.size()));
      if (is_new) {
        ShellProperties hot = model_.shells[std::size_t(shell.section)];
        const Heated change = heated(m, temperature);
        hot.section.E *= change.modulus;
        hot.section.thermal_strain = change.strain;
        model_.shells.push_back(hot);
      }
      shell.section = at->second;
    }
  }

  void heat(const PartTemperature& t) {
    const auto part = std::find_if(data_.parts.begin(), data_.parts.end(),
                                   [&](const Part& p) { return p.name == t.part; });
    const Material& m = data_.materials.at(material_of(*part));
    const int component = component_of(t.part);
    std::map<std::pair<int, double>, int> sections;
    heat_shells(model_.mesh.quads, component, t, m, sections);
    heat_shells(model_.mesh.triangles, component, t, m, sections);
    for (BeamElement& b : model_.beams) {
      if (b.component != component) continue;
      const double y = (model_.mesh.nodes[std::size_t(b.node1)].y() +
                        model_.mesh.nodes[std::size_t(b.node2)].y()) /
                       2;
      const Heated change = heated(m, temperature_at(t, y));
      for (double* stiffness : {&b.section.EA, &b.section.EI_y, &b.section.EI_z, &b.section.GJ,
                                &b.section.GA_y, &b.section.GA_z, &b.section.E})
        *stiffness *= change.modulus;
      b.section.thermal_strain = change.strain;
    }
  }

  // A cap has the temperature of the first end it closes.
  void grow(const Cap& cap, StateLoads& loads) const {
    const std::string part_name = cap.of.front().substr(0, cap.of.front().find('.'));
    for (const PartTemperature& t : state_.temperature) {
      if (t.part != part_name) continue;
      const auto part = std::find_if(data_.parts.begin(), data_.parts.end(),
                                     [&](const Part& p) { return p.name == t.part; });
      const int node = built_.cap_nodes.at(cap.name);
      const double y = model_.mesh.nodes[std::size_t(node)].y();
      loads.growth[node] =
          heated(data_.materials.at(material_of(*part)), temperature_at(t, y)).strain;
    }
  }

  void press() {
    for (const Part& part : data_.parts) {
      if (!std::holds_alternative<Bellows>(part.body)) continue;
      const int component = component_of(part.name);
      for (ShellProperties& p : model_.shells)
        if (p.component == component) p.pressure = state_.pressure;
      for (const auto& [side, sign] : {std::pair{".left", -1.}, std::pair{".right", 1.}})
        close_end(part.name + side, sign);
    }
  }

  // Area vector of the end about the node of its cap, out of the bellows.
  void close_end(const std::string& set, double sign) {
    const auto cap = std::find_if(data_.caps.begin(), data_.caps.end(), [&](const Cap& c) {
      return std::find(c.of.begin(), c.of.end(), set) != c.of.end();
    });
    const int node = built_.cap_nodes.at(cap->name);
    const auto& x = model_.mesh.nodes;
    const std::vector<int>& circle = model_.mesh.sets.at(set);
    Vector3d area = Vector3d::Zero();
    for (std::size_t i = 0; i < circle.size(); ++i)
      area += (x[std::size_t(circle[i])] - x[std::size_t(node)])
                  .cross(x[std::size_t(circle[(i + 1) % circle.size()])] - x[std::size_t(node)]) /
              2;
    if (area.y() * sign < 0) area = -area;
    model_.pressed_ends.push_back({.node = node, .area = area, .pressure = state_.pressure});
  }

  void move_end(const EndOffset& offset, StateLoads& loads) {
    const int node = built_.cap_nodes.at(offset.cap);
    for (MovedHold& hold : loads.holds)
      if (hold.node == node) {
        hold.shift = vector_of(offset.move);
        hold.turn = vector_of(offset.turn);
      }
    for (BushingElement& b : model_.bushings)
      if (b.node2 < 0 && b.node1 == node) {
        b.ground_shift = vector_of(offset.move);
        b.ground_turn = turned_by(offset.turn);
      }
  }

  const Case& data_;
  const OperatingState& state_;
  BuiltCase& built_;
  Model& model_;
};

std::string list_of(const Triple& t, double unit) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", t[0] / unit, t[1] / unit, t[2] / unit);
}

std::vector<std::string> in_words(const OperatingState& s) {
  constexpr Triple none{};
  std::vector<std::string> words;
  for (const EndOffset& o : s.offset) {
    if (o.move != none)
      words.push_back("cap " + o.cap + " moved by " + list_of(o.move, 1e-3) + " mm");
    if (o.turn != none)
      words.push_back("cap " + o.cap + " turned by " + list_of(o.turn, M_PI / 180) + " deg");
  }
  for (const EndLoad& l : s.force) {
    if (l.force != none) words.push_back(list_of(l.force, 1) + " N on cap " + l.cap);
    if (l.moment != none) words.push_back(list_of(l.moment, 1) + " Nm on cap " + l.cap);
  }
  if (s.pressure != 0) words.push_back(fmt::format("{:.4g} bar inside", s.pressure / 1e5));
  for (const PartTemperature& t : s.temperature)
    words.push_back(t.part + (t.at ? fmt::format(" at {:.4g} degC", *t.at)
                                   : fmt::format(" at {:.4g} to {:.4g} degC", t.along.front()[1],
                                                 t.along.back()[1])));
  if (s.gravity != none) words.push_back("gravity " + list_of(s.gravity, 1) + " m/s2");
  return words;
}

void add_reactions(const Case& data, const BuiltCase& built, const VectorXd& lacking,
                   StateResult& result) {
  const DofMap map = eliminate(built.model);
  const VectorXd held = gather(map, lacking);
  for (const Mount& mount : data.mount) {
    const int node = built.cap_nodes.at(mount.cap);
    Eigen::Matrix<double, 6, 1> f = Eigen::Matrix<double, 6, 1>::Zero();
    if (mount.kind == MountKind::free) continue;
    if (mount.kind == MountKind::rigid)
      for (int d = 0; d < 6; ++d) {
        const int number = map.independent[std::size_t(6 * node + d)];
        if (number >= 0) f[d] = -held[number];
      }
    for (const BushingElement& b : built.model.bushings)
      if (mount.kind == MountKind::springs && b.node2 < 0 && b.node1 == node)
        f += VectorXd(state_tangent(built.model, b).force);
    EndReaction reaction{.cap = mount.cap, .force = {}, .moment = {}};
    Vector3d::Map(reaction.force.data()) = f.head<3>();
    Vector3d::Map(reaction.moment.data()) = f.tail<3>();
    result.reactions.push_back(reaction);
  }
}

// The same with a share of the loads.
Model with_share(Model model, double share) {
  for (ShellProperties& p : model.shells) {
    p.pressure *= share;
    p.section.thermal_strain *= share;
  }
  for (BeamElement& b : model.beams) b.section.thermal_strain *= share;
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

void add_buckling(int count, const Model& at_rest, const StateLoads& acting,
                  const StateSolver& solver, StateResult& result) {
  constexpr double share = 1e-3, beyond = 1000;
  BaseState little =
      find_state(with_share(at_rest, share), with_share(acting, share), solver, [](const auto&) {});
  Rest by_stress = *little.model.rest;
  by_stress.part = StiffnessPart::by_stress;
  little.model.rest = std::make_shared<Rest>(std::move(by_stress));
  const System rest = assemble(at_rest), now = assemble(little.model);
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

} // namespace

void require_rest(const Case& data, const std::string& what) {
  if (data.state)
    input_error("state", "is not possible here: " + what + " knows the part at rest alone",
                "the case without its state");
}

StateResult move_into_state(const Case& data, BuiltCase& built,
                            const std::function<void(const std::string&)>& stage,
                            std::map<std::string, double>& timing) {
  stage("state");
  Stopwatch watch;
  const StateLoads loads = Preparation(data, built).loads();
  StateResult result;
  result.loads = in_words(*data.state);
  const Model at_rest = built.model;
  const bool symmetric = data.analyses.symmetry != Symmetry::off && is_axisymmetric(at_rest, loads);
  result.route = symmetric ? "rotational symmetry" : "full mesh";
  const StateSolver solver = symmetric ? cyclic_state_solver(at_rest, built.held_nodes)
                                       : full_state_solver(built.held_nodes);
  if (data.state->buckling > 0) {
    stage("buckling");
    add_buckling(data.state->buckling, at_rest, loads, solver, result);
    watch.lap(timing, "buckling");
    stage("state");
  }
  BaseState state = find_state(at_rest, loads, solver, [&](const StateIteration& i) {
    result.iterations.push_back({i.share, i.residual, i.step});
    stage(fmt::format("state, {:.3g} % of the loads", 100 * i.share));
  });
  built.model = std::move(state.model);
  result.load_steps = state.load_steps;
  result.largest_displacement = state.largest_displacement;
  result.linear_error = state.linear_error;
  result.displacement.resize(Eigen::Index(at_rest.mesh.nodes.size()), 3);
  for (std::size_t n = 0; n < at_rest.mesh.nodes.size(); ++n)
    result.displacement.row(Eigen::Index(n)) =
        (built.model.mesh.nodes[n] - at_rest.mesh.nodes[n]).transpose();
  add_reactions(data, built, state.lacking, result);
  watch.lap(timing, "state");
  return result;
}

} // namespace plica
