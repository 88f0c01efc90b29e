#include "run/routes/state_loads.hpp"

#include "model/description/place_keys.hpp"
#include "model/description/steels.hpp"
#include "solve/heat_conduction.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

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

// What a temperature makes of a material: E against that at rest, what Poisson's ratio changes by,
// free strain since.
struct Heated {
  double modulus = 1, nu = 0, strain = 0;
};

class Preparation {
public:
  Preparation(const Case& data, BuiltCase& built, StateResult& result)
      : data_(data), state_(*data.state), built_(built), model_(built.model), result_(result) {}

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
    const auto nu = [&](double t) {
      return m.nu_over_temperature.empty() ? m.nu : at_temperature(m.nu_over_temperature, t);
    };
    return {.modulus = at_temperature(m.E_over_temperature, temperature) /
                       at_temperature(m.E_over_temperature, rest),
            .nu = nu(temperature) - nu(rest),
            .strain = at_temperature(m.expansion, temperature) * (temperature - mean_from) -
                      at_temperature(m.expansion, rest) * (rest - mean_from)};
  }

  const Part& part_of(const PartTemperature& t) const {
    return *std::find_if(data_.parts.begin(), data_.parts.end(),
                         [&](const Part& p) { return p.name == t.part; });
  }

  // Where heat is conducted, the temperature of every node of the part.
  void conduct(const PartTemperature& t, const Material& m, int component) {
    HeatLoads heat;
    for (const HeldTemperature& held : t.held)
      for (int node : model_.mesh.sets.at(held.set)) heat.held[node] = held.temperature;
    if (t.inside) heat.below = {t.inside->gas, t.inside->coefficient};
    if (t.outside) heat.above = {t.outside->gas, t.outside->coefficient};
    try {
      const WallTemperature wall = conducted_temperature(
          model_, component, [&](double T) { return at_temperature(m.conductivity, T); }, heat);
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (double T : wall.at)
        if (std::isfinite(T)) {
          low = std::min(low, T);
          high = std::max(high, T);
        }
      result_.heat.push_back({t.part, low, high, wall.across, wall.through});
      conducted_[t.part] = wall.at;
    } catch (const std::runtime_error& error) {
      input_error("state.temperature." + t.part, error.what(), "held, inside or outside for each");
    }
  }

  // Mean over the nodes, of what is conducted or given along the part. What is no node of the wall,
  // as a place on it, has no temperature of its own: then that of the wall.
  template <class Nodes> double temperature_of(const PartTemperature& t, const Nodes& nodes) const {
    const auto conducted = conducted_.find(t.part);
    if (conducted != conducted_.end()) {
      double sum = 0, count = 0;
      const auto add = [&](double temperature) {
        if (!std::isfinite(temperature)) return;
        sum += temperature;
        ++count;
      };
      for (int node : nodes) add(conducted->second[node]);
      if (count == 0)
        for (double temperature : conducted->second) add(temperature);
      return sum / count;
    }
    double y = 0;
    for (int node : nodes) y += model_.mesh.nodes[std::size_t(node)].y() / double(nodes.size());
    return temperature_at(t, y);
  }

  // Shells of one temperature share a section.
  template <class Shell>
  void heat_shells(std::vector<Shell>& shells, int component, const PartTemperature& t,
                   const Material& m, std::map<std::pair<int, double>, int>& sections) {
    for (Shell& shell : shells) {
      if (model_.shells[std::size_t(shell.section)].component != component) continue;
      constexpr double step = 0.01; // degC, below which two are one
      const double temperature = std::round(temperature_of(t, shell.nodes) / step) * step;
      const auto [at, is_new] =
          sections.try_emplace({shell.section, temperature}, int(model_.shells.size()));
      if (is_new) {
        ShellProperties hot = model_.shells[std::size_t(shell.section)];
        const Heated change = heated(m, temperature);
        hot.section.E *= change.modulus;
        hot.section.nu += change.nu;
        hot.section.thermal_strain = change.strain;
        model_.shells.push_back(hot);
      }
      shell.section = at->second;
    }
  }

  void heat(const PartTemperature& t) {
    const std::string name = material_of(part_of(t));
    const Material& m = data_.materials.at(name);
    for (const Steel& steel : steels())
      if (steel.name == name) result_.sources.push_back(name + ": " + steel.source);
    const int component = component_of(t.part);
    if (t.conducted()) conduct(t, m, component);
    std::map<std::pair<int, double>, int> sections;
    heat_shells(model_.mesh.quads, component, t, m, sections);
    heat_shells(model_.mesh.triangles, component, t, m, sections);
    for (BeamElement& b : model_.beams) {
      if (b.component != component) continue;
      const Heated change = heated(m, temperature_of(t, std::array{b.node1, b.node2}));
      BeamProperties& s = b.section;
      // Shear moduli besides by nu, where the material gives it over the temperature.
      const double shear = change.modulus * (1 + m.nu) / (1 + m.nu + change.nu);
      for (double* stiffness : {&s.EA, &s.EI_y, &s.EI_z, &s.E}) *stiffness *= change.modulus;
      for (double* stiffness : {&s.GJ, &s.GA_y, &s.GA_z}) *stiffness *= shear;
      s.thermal_strain = change.strain;
    }
  }

  // A cap has the temperature of the first end it closes; across its springs, of the first end
  // there.
  void grow(const Cap& cap, StateLoads& loads) const {
    std::set<int> grown;
    const auto grow_as = [&](int node, const std::string& end) {
      if (!grown.insert(node).second) return;
      for (const PartTemperature& t : state_.temperature) {
        if (t.part != part_of_set(end)) continue;
        const Material& m = data_.materials.at(material_of(part_of(t)));
        loads.growth[node] = heated(m, temperature_of(t, model_.mesh.sets.at(end))).strain;
      }
    };
    grow_as(built_.cap_nodes.at(cap.name), cap.of.front());
    for (const std::string& end : cap.of) grow_as(built_.end_nodes.at(end), end);
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

  // Area vector of the end about the node of its cap, which closes it, out of the bellows.
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

  // What holds the cap: its node, the ground under its springs, or their feet.
  void move_end(const EndOffset& offset, StateLoads& loads) {
    const int node = built_.cap_nodes.at(offset.cap);
    std::set<int> moved{node};
    for (BushingElement& b : model_.bushings) {
      if (b.node1 != node) continue;
      if (b.node2 >= 0 && b.component == component_of(mount_key(offset.cap))) moved.insert(b.node2);
      if (b.node2 >= 0) continue;
      b.ground_shift = vector_of(offset.move);
      b.ground_turn = turned_by(offset.turn);
    }
    for (MovedHold& hold : loads.holds)
      if (moved.contains(hold.node)) {
        hold.shift = vector_of(offset.move);
        hold.turn = vector_of(offset.turn);
      }
  }

  const Case& data_;
  const OperatingState& state_;
  BuiltCase& built_;
  Model& model_;
  StateResult& result_;
  std::map<std::string, VectorXd> conducted_; // by part, per node
};

std::string list_of(const Triple& t, double unit) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", t[0] / unit, t[1] / unit, t[2] / unit);
}

std::string temperature_in_words(const PartTemperature& t) {
  if (t.at) return fmt::format("{} at {:.4g} degC", t.part, *t.at);
  const auto [low, high] = range_of(t);
  return t.conducted()
             ? fmt::format("heat conducted in {} between {:.4g} and {:.4g} degC", t.part, low, high)
             : fmt::format("{} at {:.4g} to {:.4g} degC", t.part, t.along.front()[1],
                           t.along.back()[1]);
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
  for (const PartTemperature& t : s.temperature) words.push_back(temperature_in_words(t));
  for (const BoltForce& b : s.bolt)
    words.push_back(fmt::format("bolt {} tightened to {:.4g} N", b.part, b.force));
  if (s.gravity != none) words.push_back("gravity " + list_of(s.gravity, 1) + " m/s2");
  return words;
}

} // namespace

StateLoads state_loads(const Case& data, BuiltCase& built, StateResult& result) {
  result.loads = in_words(*data.state);
  return Preparation(data, built, result).loads();
}

} // namespace plica
