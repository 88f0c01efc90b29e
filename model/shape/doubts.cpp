#include "model/shape/doubts.hpp"

#include "model/description/deck_model.hpp"
#include "model/description/place_keys.hpp"
#include "model/shape/wall_places.hpp"
#include "words/short_text.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <set>

namespace plica {
namespace {

using Box = Eigen::AlignedBox3d;

struct Range {
  double low, high;
  bool holds(double x) const { return x >= low && x <= high; }
};
constexpr Range modulus{1e9, 1.3e12};         // Pa: plastics to diamond
constexpr Range density{10, 23e3};            // kg/m3: foam to osmium
constexpr Range extent{1e-3, 20};             // m, of a model
constexpr double thickest_wall = 0.25;        // of the largest extent of its part
constexpr double widest_joint = 2;            // radii of the larger end that a cap joins
constexpr double heaviest = 100;              // kg, of a body in an exhaust system
constexpr double highest_convolution = 1;     // of the root radius
constexpr double far_from_its_place = 2.5e-3; // m, of a sensor
constexpr double one_place = 1e-3; // m: ends that lie there are one, however small they are

std::string listed(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Box box_of(const Mesh& mesh, const std::vector<int>& nodes) {
  Box box;
  for (int node : nodes) box.extend(mesh.nodes[std::size_t(node)]);
  return box;
}

// Nodes that move together or bear on each other, by union-find.
class Pieces {
public:
  explicit Pieces(std::size_t nodes) : parent_(nodes) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int node) {
    while (parent_[std::size_t(node)] != node)
      node = parent_[std::size_t(node)] = parent_[std::size_t(parent_[std::size_t(node)])];
    return node;
  }
  void join(int a, int b) { parent_[std::size_t(root(a))] = root(b); }
  template <class Nodes> void join(const Nodes& nodes) {
    for (int node : nodes) join(nodes[0], node);
  }

private:
  std::vector<int> parent_;
};

std::set<std::string> unused_materials(const Case& data) {
  std::set<std::string> unused;
  if (!data.model.empty()) return unused; // the parts of the case use them
  for (const auto& [name, material] : data.materials) unused.insert(name);
  for (const Part& part : data.parts) {
    // A chain needs none; its case may keep that of the bellows.
    if (std::holds_alternative<ConnectorChain>(part.body)) return {};
    if (const auto* b = std::get_if<Bellows>(&part.body)) unused.erase(b->material);
    if (const auto* p = std::get_if<Plate>(&part.body)) unused.erase(p->material);
    if (const auto* p = std::get_if<EquivalentPipe>(&part.body)) unused.erase(p->material);
    if (const auto* s = std::get_if<SurfacePart>(&part.body)) unused.erase(s->material);
    if (const auto* b = std::get_if<BeamPart>(&part.body)) unused.erase(b->section.material);
  }
  for (const Variant& variant : data.variants)
    for (const auto& [path, value] : variant.set) unused.erase(value);
  return unused;
}

class Doubts {
public:
  Doubts(const Case& data, const BuiltCase& built)
      : case_(data), model_(built.model), held_nodes_(built.held_nodes), sensors_(built.sensors),
        boxes_(model_.components.size()) {
    for_each_shell([&](const auto& shell) {
      for (int node : shell.nodes)
        boxes_[component(shell)].extend(model_.mesh.nodes[std::size_t(node)]);
    });
  }

  std::vector<std::string> found() {
    materials();
    walls();
    for (const Part& part : case_.parts)
      std::visit([&](const auto& body) { placed(part.name, body); }, part.body);
    size();
    caps();
    sensors();
    pieces();
    return std::move(doubts_);
  }

private:
  void add(const std::string& text) {
    if (said_.insert(text).second) doubts_.push_back(text);
  }

  template <class F> void for_each_shell(F&& f) const {
    for (const ShellQuad& quad : model_.mesh.quads) f(quad);
    for (const ShellTriangle& triangle : model_.mesh.triangles) f(triangle);
  }

  std::size_t component(const auto& shell) const {
    return std::size_t(model_.shells[std::size_t(shell.section)].component);
  }

  // Those that sit on a node of a wall: others are tied to a section, a line or a wall where they
  // are.
  void sensors() {
    std::set<int> of_walls;
    for_each_shell(
        [&](const auto& shell) { of_walls.insert(shell.nodes.begin(), shell.nodes.end()); });
    for (const BuiltSensor& s : sensors_) {
      if (s.distance <= far_from_its_place || !of_walls.contains(s.node)) continue;
      const auto own = std::find_if(case_.sensors.begin(), case_.sensors.end(),
                                    [&](const Sensor& c) { return c.name == s.name; });
      const double off = off_wall(nearest_on_wall(model_, {own->at[0], own->at[1], own->at[2]}));
      if (off > far_from_its_place)
        add("sensor " + s.name + " is " + short_text(1e3 * off, 2) +
            " mm off the part, and moves as the nearest node of its wall does: is its place meant "
            "so?");
    }
  }

  void material(const std::string& of, double E, double rho) {
    if (!modulus.holds(E))
      add(of + " has E = " + short_text(E, 4) +
          " Pa, which no metal has: is its unit missing or another?");
    if (rho == 0)
      add(of + " has no density: its wall moves without mass");
    else if (!density.holds(rho))
      add(of + " has a density of " + short_text(rho, 4) +
          " kg/m3, which no solid has (steel: 7850 kg/m3, in a deck of t and mm 7.85e-9): is its "
          "unit missing or another?");
  }

  void materials() {
    const std::set<std::string> unused = unused_materials(case_);
    for (const std::string& name : unused) add("materials." + name + ": no part uses it");
    for (const auto& [name, m] : case_.materials)
      if (!unused.contains(name)) material("material " + name, m.E, m.rho);
    for (const Part& part : case_.parts)
      if (const auto* deck = std::get_if<DeckPart>(&part.body))
        for (const ShellSection& wall : deck->content->sections) {
          const double L = deck->length_unit, M = deck->mass_unit;
          material("a material of the deck " + part.name, wall.E * M / L,
                   wall.rho * M / (L * L * L));
        }
  }

  void walls() {
    std::vector<double> thickest(boxes_.size(), 0);
    for_each_shell([&](const auto& shell) {
      double& t = thickest[component(shell)];
      t = std::max(t, shell.thickness.maxCoeff());
    });
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (!boxes_[i].isEmpty() && thickest[i] > thickest_wall * boxes_[i].sizes().maxCoeff())
        add(model_.components[i] + " has a wall of " + short_text(1e3 * thickest[i], 4) +
            " mm and is no larger than " + short_text(1e3 * boxes_[i].sizes().maxCoeff(), 4) +
            " mm: lengths without unit are in m");
  }

  void turned(const std::string& name, const Triple& rotate) {
    for (double angle : rotate)
      if (std::abs(angle) > 2 * std::numbers::pi + 1e-9)
        add(part_key(name) + ".rotate turns by " + short_text(angle, 4) +
            " rad: an angle without unit is "
            "in rad, write " +
            short_text(angle, 4) + " deg if you mean that");
  }

  void placed(const std::string& name, const DeckPart& deck) {
    turned(name, deck.rotate);
    for (const std::string& card : deck.content->left_out) add("left out of the deck: " + card);
    for (const std::string& note : deck.content->notes) add(part_key(name) + ": " + note);
  }

  void placed(const std::string& name, const Bellows& bellows) {
    for (const MeridianSection& section : bellows.profile)
      if (section.height > highest_convolution * bellows.root_radius)
        add(part_key(name) + ".profile has convolutions of " + short_text(1e3 * section.height, 4) +
            " mm on a pipe of radius " + short_text(1e3 * bellows.root_radius, 4) + " mm");
  }

  void placed(const std::string& name, const Interlock& liner) {
    heavy(part_key(name) + ".mass", liner.mass);
    for (const Part& part : case_.parts)
      if (const auto* bellows = std::get_if<Bellows>(&part.body);
          bellows && part.name == liner.along && liner.radius > bellows->root_radius)
        add(part_key(name) + ".radius is " + short_text(1e3 * liner.radius, 4) +
            " mm, that of the bellows around it " + short_text(1e3 * bellows->root_radius, 4) +
            " mm");
  }

  void placed(const std::string& name, const PointMass& mass) {
    heavy(part_key(name) + ".mass", mass.mass);
  }

  void heavy(const std::string& key, double mass) {
    if (mass > heaviest)
      add(key + " is " + short_text(mass, 4) + " kg: a mass without unit is in kg");
  }

  void placed(const std::string& name, const SurfacePart& surface) {
    turned(name, surface.rotate);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (model_.components[i] == name && surface.size > boxes_[i].sizes().maxCoeff())
        add(part_key(name) + ".element_size is " + short_text(surface.size, 4) +
            " m, more than the part is long: a length without unit is in m");
  }

  template <class Body> void placed(const std::string&, const Body&) {}

  void size() {
    Box box;
    for (const Eigen::Vector3d& x : model_.mesh.nodes) box.extend(x);
    if (box.isEmpty() || extent.holds(box.sizes().maxCoeff())) return;
    add("the model is " + short_text(box.sizes().maxCoeff(), 4) +
        " m long: lengths without unit are in m, those of a file in the unit stated for it");
  }

  void caps() {
    for (const Cap& cap : case_.caps) heavy(cap_key(cap.name) + ".mass", cap.mass);
    const auto& sets = model_.mesh.sets;
    const auto is_ground = [&](const Cap& cap) { // the feet of a frame
      return std::any_of(case_.mount.begin(), case_.mount.end(), [&](const Mount& m) {
        return m.cap == cap.name && m.kind == MountKind::rigid;
      });
    };
    for (const Cap& cap : case_.caps)
      for (std::size_t i = 1; i < cap.of.size() && !is_ground(cap); ++i) {
        if (part_of_set(cap.of[i]) == part_of_set(cap.of[0]))
          continue; // the bolt holes of one flange
        const Box a = box_of(model_.mesh, sets.at(cap.of[0])),
                  b = box_of(model_.mesh, sets.at(cap.of[i]));
        const double apart = (a.center() - b.center()).norm();
        const double radius = std::max(a.sizes().maxCoeff(), b.sizes().maxCoeff()) / 2;
        if (apart > std::max(widest_joint * radius, one_place))
          add("cap " + cap.name + " joins " + cap.of[0] + " and " + cap.of[i] + ", " +
              short_text(1e3 * apart, 4) + " mm apart: is the part where it belongs?");
      }
  }

  void pieces() {
    Pieces pieces(model_.mesh.nodes.size());
    std::map<int, std::set<std::string>> parts; // of the piece with this root
    std::vector<std::pair<int, int>> elements;  // a node, its component
    const auto element = [&](const auto& nodes, int component) {
      pieces.join(nodes);
      elements.emplace_back(nodes[0], component);
    };
    for_each_shell([&](const auto& shell) { element(shell.nodes, int(component(shell))); });
    for (const BeamElement& b : model_.beams) element(std::array{b.node1, b.node2}, b.component);
    for (const BushingElement& b : model_.bushings) // springs join, and are no piece of their own
      if (b.node2 >= 0) pieces.join(b.node1, b.node2);
    for (const MatrixElement& m : model_.matrices) pieces.join(m.nodes);
    for (const Constraint& c : model_.constraints)
      for (const ConstraintTerm& t : c.terms) pieces.join(c.node, t.node);
    for (const auto& [node, component] : elements)
      parts[pieces.root(node)].insert(model_.components[std::size_t(component)]);
    if (parts.size() < 2) return;
    std::set<int> held;
    for (int node : held_nodes_) held.insert(pieces.root(node));
    for (const Constraint& c : model_.constraints)
      if (c.terms.empty()) held.insert(pieces.root(c.node));
    for (const BushingElement& b : model_.bushings)
      if (b.node2 < 0) held.insert(pieces.root(b.node1));
    constexpr std::size_t most = 4;
    std::string text = "the model falls into " + std::to_string(parts.size()) +
                       " pieces that nothing joins (a cap or a clamp does):";
    std::size_t said = 0;
    for (const auto& [root, names] : parts) {
      if (said == most) break;
      text += (said++ == 0 ? " " : " | ") + listed(names) +
              (held.contains(root) ? "" : " (held by nothing)");
    }
    add(text + (parts.size() > most ? " | ..." : ""));
  }

  const Case& case_;
  const Model& model_;
  const std::vector<int>& held_nodes_;
  const std::vector<BuiltSensor>& sensors_;
  std::vector<Box> boxes_; // of the shells of each component
  std::vector<std::string> doubts_;
  std::set<std::string> said_; // the same
};

} // namespace

std::vector<std::string> doubts(const Case& data, const BuiltCase& built) {
  return Doubts(data, built).found();
}

} // namespace plica
