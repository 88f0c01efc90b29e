#include "diagnose/predict/nominal.hpp"

#include "diagnose/effects/on_table.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/effects/spots.hpp"
#include "diagnose/predict/built_in_state.hpp"
#include "diagnose/predict/loose_motions.hpp"
#include "diagnose/predict/sensor_axes.hpp"
#include "diagnose/predict/sprung_clamps.hpp"
#include "lab/measured/entries.hpp"
#include "model/description/case_path.hpp"
#include "model/description/end_caps.hpp"
#include "model/description/place_keys.hpp"
#include "model/shape/build_bellows.hpp"
#include "run/analyses/damping.hpp"
#include "solve/model_error.hpp"
#include "solve/parallel.hpp"
#include "words/did_you_mean.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int modes = 16, modes_of_a_free_part = 32; // which are made of those with a node held
constexpr std::size_t small_mesh = 2500;             // nodes; below, a coarse mesh saves nothing

// Counts in place of an accuracy, so that every specimen has the same mesh. Enough for how readings
// change: two elements a quarter arc, two a wall, sixteen around, of which four are a quarter of
// the circumference in every direction.
Case with_counted_mesh(Case data, bool light) {
  for (Part& part : data.parts)
    if (auto* bellows = std::get_if<Bellows>(&part.body)) {
      *bellows = with_counts(*bellows);
      if (!light) continue;
      MeshDensity& mesh = bellows->mesh;
      mesh.arc = std::min(mesh.arc, 2);
      mesh.wall = std::min(mesh.wall, 2);
      mesh.around = std::min(mesh.around, 16);
      // Straight pipes by quads that are nearly square.
      const double side = 2 * std::numbers::pi * bellows->root_radius / mesh.around;
      for (MeridianSection& s : bellows->profile)
        s.elements = std::min(s.elements, std::max(3, int(std::ceil(s.length / side))));
    }
  // The nearest node of the lighter mesh stands for the place.
  constexpr double off = 15e-3;
  if (light)
    for (Sensor& s : data.sensors) s.reach = std::max(s.reach, off);
  return data;
}

// Mounted nodes, and the caps where a rig pulls at them.
std::vector<int> boundary_of(const BuiltCase& built, const Case& data, const Measured& measured) {
  std::vector<int> nodes = built.held_nodes;
  for (const MeasuredStiffnessTable& table : measured.stiffness)
    for (const std::string& end : table.ends)
      if (const auto cap = built.cap_nodes.find(end); cap != built.cap_nodes.end())
        nodes.push_back(cap->second);
  for (const std::string& end : end_caps(data)) nodes.push_back(built.cap_nodes.at(end));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::set<int> dependent;
  for (const Constraint& c : built.model.constraints) dependent.insert(c.node);
  std::erase_if(nodes, [&](int node) { return dependent.contains(node); });
  return nodes;
}

// Supports, or springs to the ground.
bool held_otherwise(const BuiltCase& built) {
  const Model& model = built.model;
  const std::set<int> table(built.table_nodes.begin(), built.table_nodes.end());
  return std::any_of(
             model.constraints.begin(), model.constraints.end(),
             [&](const Constraint& c) { return c.terms.empty() && !table.contains(c.node); }) ||
         std::any_of(model.bushings.begin(), model.bushings.end(),
                     [](const BushingElement& b) { return b.node2 < 0; });
}

// Springs of mounts are all that holds it.
bool hangs_in_springs(const Case& data, const BuiltCase& built) {
  return !held_otherwise(built) &&
         std::none_of(data.mount.begin(), data.mount.end(),
                      [](const Mount& m) { return m.kind == MountKind::rigid; });
}

// A node whose six motions are its own: with it held, a free part is held, and the motions that
// follow it are rigid.
int anchor_of(const Model& model) {
  std::set<int> dependent;
  for (const Constraint& c : model.constraints) dependent.insert(c.node);
  for (const BeamElement& b : model.beams)
    if (!dependent.contains(b.node1)) return b.node1;
  for (const ShellQuad& q : model.mesh.quads)
    if (!dependent.contains(q.nodes[0])) return q.nodes[0];
  throw ModelError("nothing holds the part: hold it by a mount or supports");
}

// Held ends, and some places along the parts.
std::vector<BuiltSensor> further_places(const Structure& s) {
  constexpr std::size_t most = 6;
  std::vector<BuiltSensor> places;
  for (const Mount& m : s.data.mount)
    if (const int node = cap_node(s, m.cap); node >= 0)
      places.push_back({.name = place_of(m), .node = node});
  for (const Spot& spot : spots(s))
    if (!is_at_sensor(spot.place) && places.size() < most)
      places.push_back({.name = spot.place, .node = spot.touched});
  return places;
}

// What damped springs add to the damping of each mode, to first order as loss factors of parts do:
// 2 zeta omega^2 = stretch^2 Im k(i omega). A spring whose stiffness depends on frequency would
// move the modes, too, which have one stiffness here.
VectorXd damping_of_springs(const BuiltCase& built, const Model& model, const VectorXd& lambda,
                            const MatrixXd& u) {
  VectorXd zeta = VectorXd::Zero(lambda.size());
  for (const BuiltDamper& d : built.dampers) {
    if (!d.law.maxwell.empty() || d.law.springpot || !d.law.table.empty())
      input_error(
          d.place + ".damping",
          "gives a stiffness over frequency, and a diagnosis has one stiffness for a spring",
          "dashpot or loss_factor, and the stiffness that it has at the first modes");
    const VectorXd stretch =
        u.transpose() * unit_force(model, d.node1, d.node2, d.dof).head(u.rows());
    for (Index j = 0; j < zeta.size(); ++j)
      if (lambda[j] > 0)
        zeta[j] += stretch[j] * stretch[j] / (2 * lambda[j]) *
                   added_stiffness(d.law, d.dof, d.stiffness, {0, std::sqrt(lambda[j])}).imag();
  }
  return zeta;
}

// Where a test sees shapes or drives and the case has no sensor, then what sits beside the part, as
// sensors without mass.
std::vector<Sensor> stations_of(const Case& data, const Measured& measured) {
  std::set<std::string> seen;
  for (const MeasuredMode& mode : measured.modes)
    if (mode.vector)
      for (const std::string& channel : mode.vector->channels)
        seen.emplace(sensor_of_channel(channel));
  for (const MeasuredMode& mode : measured.modes) seen.emplace(sensor_of_channel(mode.drive));
  for (const MeasuredFrf& frf : measured.frf) seen.emplace(sensor_of_channel(frf.force));
  seen.erase("");
  for (const Sensor& sensor : data.sensors) seen.erase(sensor.name);
  std::vector<Sensor> stations, beside;
  for (const MeasuredSensor& m : measured.sensors)
    if (!m.on.empty())
      beside.push_back({.name = m.name, .at = m.at, .on = m.on});
    else if (seen.contains(m.name))
      stations.push_back({.name = m.name, .at = m.at, .if_there = true});
  stations.insert(stations.end(), beside.begin(), beside.end());
  return stations;
}

// Sensors beside the part need something that is there, and a name of their own.
void check_sensors_beside_the_part(const Case& data, const Measured& measured) {
  std::vector<std::string> places{on_the_table};
  for (const Mount& m : data.mount)
    if (m.kind != MountKind::free) places.push_back(place_of(m));
  std::vector<InputProblem> problems;
  for (std::size_t i = 0; i < measured.sensors.size(); ++i) {
    const MeasuredSensor& own = measured.sensors[i];
    if (own.on.empty()) continue;
    const std::string key = "sensors[" + std::to_string(i) + "].";
    if (std::find(places.begin(), places.end(), own.on) == places.end())
      problems.push_back({"", 0, key + "on", "the case stands on no '" + own.on + "'",
                          suggestion(own.on, places)});
    if (std::any_of(data.sensors.begin(), data.sensors.end(),
                    [&](const Sensor& s) { return s.name == own.name; }))
      problems.push_back({"", 0, key + "on", "the case has sensor '" + own.name + "' on the part",
                          "a name that no sensor of the case has, or no `on`"});
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

// Builds the case of the state, with the stations of the test that lie on it: what shows at one
// beside it is no reading.
std::vector<BuiltSensor> build_with_stations(NominalState& state, const Measured& measured) {
  std::vector<Sensor>& sensors = state.data.sensors;
  const std::size_t own = sensors.size();
  for (Sensor& station : stations_of(state.data, measured)) sensors.push_back(std::move(station));
  state.built = build_on_table(state.data);
  std::vector<BuiltSensor>& all = state.built.sensors;
  std::erase_if(sensors, [&](const Sensor& s) {
    return std::none_of(all.begin(), all.end(),
                        [&](const BuiltSensor& built) { return built.name == s.name; });
  });
  const auto first = all.begin() + std::ptrdiff_t(own);
  std::vector<BuiltSensor> built(first, all.end());
  all.erase(first, all.end());
  return built;
}

// What was driven has a place on the model: a sensor of the case, or one of the test on the part.
void check_driven_places(const NominalState& state, const Measured& measured) {
  std::vector<std::string> places;
  for (const BuiltSensor& s : state.observed) places.push_back(s.name);
  std::vector<InputProblem> problems;
  const auto check = [&](const std::string& channel, const std::string& key) {
    const std::string sensor(sensor_of_channel(channel));
    if (channel.empty() || state.number_of(sensor) >= 0) return;
    problems.push_back({"", 0, key,
                        "it was driven at '" + shown(sensor) +
                            "', which is no sensor of the case, nor one of the test on the part",
                        places.empty() ? "a sensor there" : suggestion(sensor, places)});
  };
  for (std::size_t i = 0; i < measured.modes.size(); ++i)
    check(measured.modes[i].drive, entry_name("modes", i) + ".drive");
  for (std::size_t i = 0; i < measured.frf.size(); ++i)
    check(measured.frf[i].force, entry_name("frf", i) + ".force");
  if (!problems.empty()) throw InputError(std::move(problems));
}

// The sensors, where one might be put besides, and the stations.
void observe(NominalState& state, const std::vector<BuiltSensor>& stations,
             const Measured& measured) {
  state.observed = state.built.sensors;
  for (BuiltSensor& place :
       further_places({.data = state.data, .built = state.built, .measured = measured}))
    state.observed.push_back(std::move(place));
  state.observed.insert(state.observed.end(), stations.begin(), stations.end());
  state.stations = stations.size();
  for (const BuiltSensor& s : state.observed) state.axes.push_back(axes_of(s, measured));
}

// The model in the state of its case.
std::unique_ptr<ParametricModel> reduced_model(const NominalState& state,
                                               const Measured& measured) {
  const BuiltCase& built = state.built;
  std::vector<int> seen;
  for (const BuiltSensor& s : state.observed) seen.push_back(s.node);
  const auto sensors = seen.begin() + std::ptrdiff_t(built.sensors.size());
  std::vector<int> boundary = boundary_of(built, state.data, measured);
  std::vector<int> held = built.held_nodes;
  std::erase_if(held, [&](int node) {
    return std::find(boundary.begin(), boundary.end(), node) == boundary.end();
  });
  std::sort(held.begin(), held.end());
  const bool free = held.empty() && !held_otherwise(built);
  const bool hung = !free && hangs_in_springs(state.data, built);
  if (free && boundary.empty()) boundary = {anchor_of(built.model)};
  Model model = model_in_state(state.data, built);
  MatrixXd loose = MatrixXd::Identity(6, free || hung ? 6 : 0);
  if (held.empty() && !free && !hung) { // supports alone
    loose = loose_motions(model);
    if (loose.cols() > 0) model = on_a_soft_spring(std::move(model), loose.cols());
  }
  return std::make_unique<ParametricModel>(std::move(model), boundary,
                                           std::vector<int>(seen.begin(), sensors),
                                           free || hung ? modes_of_a_free_part : modes,
                                           std::vector<int>(sensors, seen.end()), held, loose);
}

void label_modes(NominalState& state, const MatrixXd& u) {
  const AffineModel plain = state.model->with({});
  const MatrixXd gamma = plain.nominal.transpose() * plain.load;
  for (Index j = 0; j < u.cols(); ++j) {
    Eigen::Matrix<double, 6, 1> share = Eigen::Matrix<double, 6, 1>::Zero();
    share.head<3>() = gamma.row(j).transpose().array().square() / plain.mass;
    state.labels.push_back(label_mode(state.built.model, u.col(j), false, share));
  }
  std::map<std::pair<std::string, std::string>, int> kinds;
  for (const ModeLabel& label : state.labels)
    state.kinds.push_back(
        kinds.try_emplace({label.shape, label.direction}, int(kinds.size())).first->second);
}

NominalState state_of(Case data, const std::string& name, const Measured& measured) {
  NominalState state;
  state.name = name;
  state.data = std::move(data);
  state.data.analyses.damping.coupled = false; // all of it acts mode by mode
  observe(state, build_with_stations(state, measured), measured);
  check_driven_places(state, measured);
  state.model = reduced_model(state, measured);
  const Model& model = state.model->model();
  const VectorXd& lambda = state.model->lambda();
  const MatrixXd u = state.model->nominal_shapes();
  const ModalDamping damping =
      modal_damping(state.data.analyses.damping, model, lambda, u, static_cast<int>(lambda.size()));
  state.viscous = damping.zeta;
  if (!measured.stiffness.empty())
    state.losses = rig_losses(state.data.analyses.damping, state.built, *state.model);
  state.zeta = damping.zeta + damping.eta / 2 + damping_of_springs(state.built, model, lambda, u);
  label_modes(state, u);
  return state;
}

// The longest side of what encloses the part.
double length_of(const NominalState& state) {
  std::set<int> beside;
  for (const Sensor& s : state.data.sensors)
    if (!s.on.empty()) beside.insert(state.observed[std::size_t(state.number_of(s.name))].node);
  const std::vector<Eigen::Vector3d>& nodes = state.built.model.mesh.nodes;
  Eigen::Vector3d low = nodes.front(), high = low;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (beside.contains(int(i))) continue;
    low = low.cwiseMin(nodes[i]);
    high = high.cwiseMax(nodes[i]);
  }
  return (high - low).maxCoeff();
}

} // namespace

int NominalState::number_of(const std::string& sensor) const {
  for (std::size_t i = 0; i < observed.size(); ++i)
    if (observed[i].name == sensor) return int(i);
  return -1;
}

std::vector<std::string> NominalState::further_places() const {
  std::vector<std::string> names;
  for (std::size_t i = built.sensors.size(); i + stations < observed.size(); ++i)
    names.push_back(observed[i].name);
  return names;
}

const NominalState& Nominal::state(const std::string& name) const {
  for (const NominalState& s : states)
    if (s.name == name) return s;
  throw std::out_of_range("no state is called " + name);
}

Structure Nominal::structure(const Measured& measured) const {
  return {.data = states.front().data,
          .built = states.front().built,
          .measured = measured,
          .stiffness = stiffness,
          .mass = mass,
          .length = length,
          .frequency = frequency,
          .rigid_clamps = rigid_clamps};
}

namespace {

// A mass that a state sets to nothing is not there: what it held round is free.
void take_off(Case& data, const MeasuredState& state) {
  for (Part& part : data.parts)
    if (auto* body = std::get_if<PointMass>(&part.body);
        body && body->mass == 0 && state.numbers.contains(part_key(part.name) + ".mass")) {
      body->soft = true;
      body->inertia = {};
    }
}

} // namespace

Nominal nominal_of(const Case& data, const Measured& measured) {
  Case plain = clamped_by_mounts(data);
  check_sensors_beside_the_part(plain, measured);
  plain.analyses.error_bars = false;
  const bool coarse = build(plain).model.mesh.nodes.size() > small_mesh;
  plain = with_counted_mesh(plain, coarse);
  Nominal nominal;
  nominal.coarse = coarse;
  nominal.rigid_clamps = put_springs_in_clamps(plain);
  std::vector<std::pair<std::string, Case>> wanted{{"", plain}};
  for (const MeasuredState& s : measured.states) {
    Case changed = plain;
    for (const auto& [path, value] : s.numbers) *number_at(changed, path) = value;
    take_off(changed, s);
    wanted.emplace_back(s.name, std::move(changed));
  }
  nominal.states.resize(wanted.size());
  in_parallel(int(wanted.size()), [&](int i) {
    auto& [name, own] = wanted[std::size_t(i)];
    nominal.states[std::size_t(i)] = state_of(std::move(own), name, measured);
  });
  const NominalState& first = nominal.states.front();
  const AffineModel model = first.model->with({});
  nominal.mass = model.mass;
  constexpr Eigen::Index lowest = 4;
  const VectorXd& lambda = first.model->lambda();
  nominal.frequency =
      plica::frequency(std::exp(lambda.head(std::min(lowest, lambda.size())).array().log().mean()));
  nominal.stiffness = model.mass * lambda[0];
  nominal.length = length_of(first);
  return nominal;
}

} // namespace plica
