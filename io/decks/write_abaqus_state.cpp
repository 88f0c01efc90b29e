#include "io/decks/write_abaqus_state.hpp"

#include "model/description/place_keys.hpp"
#include "solve/state_shape.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace plica {
namespace {

using Eigen::Vector3d;

void refuse(const Case& data, const BuiltCase& built) {
  const OperatingState& state = *data.state;
  const std::string at = state.name.empty() ? "state" : "states." + state.name;
  if (!state.bolt.empty())
    input_error(at + ".bolt", "is not possible in a deck: it holds no beams that are tightened",
                "the state without its bolts");
  if (state.follow)
    input_error(at + ".follow", "is not possible in a deck: its loads only grow",
                "a state on this side of the snap, without follow");
  if (!built.joints.empty())
    input_error(at,
                "is not possible in a deck of a case with joints that have friction, clearance or "
                "nonlinear springs: " +
                    joint_name(built.joints.front()) + " takes up the state by them",
                "the case with linear joints, or without its state");
  for (const EndOffset& offset : state.offset) {
    const auto mount = std::find_if(data.mount.begin(), data.mount.end(),
                                    [&](const Mount& m) { return m.cap == offset.cap; });
    if (mount->kind == MountKind::springs && offset.turn != Triple{})
      input_error(at + ".offset." + offset.cap + ".turn",
                  "is not possible in a deck: its springs stay along the global axes",
                  "a cap that is held rigidly, or move alone");
  }
}

// Where held nodes go, and what they carry; what grows on other nodes.
void add_moved(const Model& model, const StateLoads& loads, AbaqusState& state) {
  StateShape shape(model, loads);
  const auto& rest = model.mesh.nodes;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(dof_count(model));
  std::map<int, Vector3d> turns;
  for (const MovedHold& hold : loads.holds) {
    u.segment<3>(6 * hold.node) = hold.shift;
    u.segment<3>(6 * hold.node + 3) = hold.turn;
    turns[hold.node] = hold.turn;
    if (!hold.turn.isZero(0)) state.turned.insert(hold.node);
  }
  shape.move_by(u, 1);
  const auto add = [&](int node, const Vector3d& turn) {
    const Vector3d shift = shape.nodes()[std::size_t(node)] - rest[std::size_t(node)];
    for (int d = 0; d < 3; ++d)
      if (shift[d] != 0) state.moved.push_back({node, d, shift[d]});
    for (int d = 0; d < 3; ++d)
      if (turn[d] != 0) state.moved.push_back({node, 3 + d, turn[d]});
  };
  for (const auto& [node, turn] : turns) add(node, turn);
  for (const auto& [node, leader] : rigid_followers(model)) {
    if (const auto held = turns.find(leader); held != turns.end()) {
      state.carried[node] = leader;
      add(node, held->second);
    } else if (loads.growth.contains(leader)) {
      state.growth[node] = loads.growth.at(leader);
    }
  }
}

void add_pushed(const Model& model, const StateLoads& loads, const std::set<int>& held,
                AbaqusState& state) {
  const auto add = [&](int node, int dof, double value) {
    if (value != 0 && !held.contains(node)) state.pushed.push_back({node, dof, value});
  };
  for (Eigen::Index i = 0; i < loads.force.size(); ++i) add(int(i / 6), int(i % 6), loads.force[i]);
  for (const PressedEnd& end : model.pressed_ends)
    for (int d = 0; d < 3; ++d) add(end.node, d, end.pressure * end.area[d]);
  for (const BushingElement& b : model.bushings)
    for (int d = 0; b.node2 < 0 && d < 3; ++d)
      add(b.node1, d, b.bushing.law(d, d) * b.ground_shift[d]);
}

// 1 where the normal that the order of the nodes gives lies along the directors, -1 where against.
template <class Shell> int side_of(const Mesh& mesh, const Shell& shell) {
  const auto x = [&](std::size_t i) -> const Vector3d& {
    return mesh.nodes[std::size_t(shell.nodes[i])];
  };
  const Vector3d normal = (x(1) - x(0)).cross(x(2) - x(0));
  return normal.dot(shell.directors.rowwise().sum()) > 0 ? 1 : -1;
}

// Pressure against the walls along their directors, as *DLOAD P takes it along the normals.
std::string pressure_lines(const Model& model) {
  std::string text;
  for (std::size_t s = 0; s < model.shells.size(); ++s) {
    const ShellProperties& p = model.shells[s];
    if (p.pressure == 0) continue;
    std::set<int> sides;
    for (const ShellQuad& q : model.mesh.quads)
      if (q.section == int(s)) sides.insert(side_of(model.mesh, q));
    for (const ShellTriangle& t : model.mesh.triangles)
      if (t.section == int(s)) sides.insert(side_of(model.mesh, t));
    if (sides.size() > 1)
      input_error(part_key(model.components[std::size_t(p.component)]),
                  "has walls whose normals point to both sides: a deck cannot press on them",
                  "one side throughout");
    if (!sides.empty())
      text += fmt::format("SHELL{}, P, {:.12e}\n", s + 1, *sides.begin() * p.pressure);
  }
  return text;
}

// Lines "node, dof, value", of boundaries "node, dof, dof, value".
std::string values(const std::vector<DofValue>& all, const DeckOfState& deck, bool boundary) {
  std::string text;
  for (const DofValue& v : all)
    if (const auto at = deck.place(v.node, v.dof))
      text += boundary
                  ? fmt::format("{}, {}, {}, {:.12e}\n", at->first, at->second, at->second, v.value)
                  : fmt::format("{}, {}, {:.12e}\n", at->first, at->second, v.value);
  return text;
}

std::string weights(const AbaqusState& state, const DeckOfState& deck) {
  std::string text;
  for (const auto& [node, mass] : deck.masses)
    for (int d = 0; d < 3; ++d)
      if (state.gravity[d] != 0)
        text += fmt::format("{}, {}, {:.12e}\n", node, d + 1, mass * state.gravity[d]);
  return text;
}

std::string gravity_lines(const AbaqusState& state, const DeckOfState& deck) {
  const double g = state.gravity.norm();
  if (g == 0) return "";
  const Vector3d n = state.gravity / g;
  std::string text;
  for (const std::string& set : deck.heavy)
    text += fmt::format("{}, GRAV, {:.12e}, {:.9e}, {:.9e}, {:.9e}\n", set, g, n[0], n[1], n[2]);
  return text;
}

std::string under(const char* keyword, const std::string& lines) {
  return lines.empty() ? "" : std::string(keyword) + "\n" + lines;
}

bool is_hot(const Model& model) {
  const auto hot = [](const auto& p) { return p.section.thermal_strain != 0; };
  return std::any_of(model.shells.begin(), model.shells.end(), hot) ||
         std::any_of(model.beams.begin(), model.beams.end(), hot);
}

} // namespace

AbaqusState abaqus_state(const Case& data, const BuiltCase& built, const StateLoads& loads) {
  refuse(data, built);
  AbaqusState state;
  state.gravity = loads.gravity;
  add_moved(built.model, loads, state);
  std::set<int> held;
  for (const MovedHold& hold : loads.holds) held.insert(hold.node);
  add_pushed(built.model, loads, held, state);
  return state;
}

std::string abaqus_name(std::string name) {
  for (char& c : name)
    c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
  return name;
}

std::string abaqus_state_step(const BuiltCase& built, const AbaqusState& state,
                              const DeckOfState& deck) {
  const bool hot = is_hot(built.model);
  std::string text = hot ? "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNALL, 0.\n" : "";
  text += "** the state\n*STEP, NLGEOM, INC=1000\n*STATIC\n1., 1.\n";
  std::string moved = values(state.moved, deck, true);
  if (deck.heat > 0) moved += fmt::format("{}, 1, 1, 1.\n", deck.heat);
  text += under("*BOUNDARY", moved);
  text += under("*CLOAD", values(state.pushed, deck, false) + weights(state, deck));
  text += under("*DLOAD", pressure_lines(built.model) + gravity_lines(state, deck));
  if (hot) text += "*TEMPERATURE\nNALL, 1.\n";
  text += "*NODE FILE\nU\n";
  for (const BuiltSensor& sensor : built.sensors)
    text += "*NODE PRINT, NSET=" + abaqus_name(sensor.name) + "\nU\n";
  return text + "*END STEP\n";
}

} // namespace plica
