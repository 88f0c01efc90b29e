#include "run/routes/seen_case.hpp"

#include "solve/drilling.hpp"

#include <algorithm>

namespace plica {
namespace {

std::vector<char> nodes_on_rings(const Mesh& mesh) {
  std::vector<char> on_ring(mesh.nodes.size(), 0);
  for (const Ring& ring : mesh.rings)
    for (const int node : ring.nodes) on_ring[std::size_t(node)] = 1;
  return on_ring;
}

template <class Shells> bool all_of_revolution(const Shells& shells, const std::vector<char>& on) {
  return std::all_of(shells.begin(), shells.end(), [&](const auto& shell) {
    return std::all_of(shell.nodes.begin(), shell.nodes.end(),
                       [&](int node) { return on[std::size_t(node)] != 0; });
  });
}

// Every n-th node, from the first on, so that `least` remain; the steps stay equal.
Ring thinned(const Ring& ring, std::size_t least) {
  std::size_t stride = 1;
  for (std::size_t k = 2; ring.nodes.size() / k >= least; ++k)
    if (ring.nodes.size() % k == 0) stride = k;
  Ring thin{.y = ring.y, .radius = ring.radius, .nodes = {}};
  for (std::size_t i = 0; i < ring.nodes.size(); i += stride) thin.nodes.push_back(ring.nodes[i]);
  return thin;
}

class View {
public:
  explicit View(const BuiltCase& whole) : whole_(whole), on_ring_(nodes_on_rings(mesh())) {}

  bool of_revolution() const {
    return all_of_revolution(mesh().quads, on_ring_) &&
           all_of_revolution(mesh().triangles, on_ring_);
  }

  SeenCase seen(const SeenRings& asked, const std::vector<std::string>& sets) {
    number_.assign(mesh().nodes.size(), -1);
    for (std::size_t node = 0; node < on_ring_.size(); ++node)
      if (!on_ring_[node]) see(int(node));
    for (const BuiltSensor& sensor : whole_.sensors) see(sensor.node);
    for (const std::string& name : sets)
      if (const auto set = mesh().sets.find(name); set != mesh().sets.end())
        for (const int node : set->second) see(node);
    choose_rings(asked);
    choose_shells(mesh().quads, model().mesh.quads);
    choose_shells(mesh().triangles, model().mesh.triangles);
    number_nodes();
    add_rings_and_sets(sets);
    add_elements();
    add_ends();
    return std::move(seen_);
  }

private:
  const Mesh& mesh() const { return whole_.model.mesh; }
  Model& model() { return seen_.built.model; }
  void see(int node) { number_[std::size_t(node)] = 0; }
  int number(int node) const { return number_[std::size_t(node)]; }

  void choose_rings(const SeenRings& asked) {
    const std::size_t stride = (mesh().rings.size() + asked.most - 1) / asked.most;
    for (std::size_t i = 0; i < mesh().rings.size(); i += std::max<std::size_t>(stride, 1)) {
      rings_.push_back(thinned(mesh().rings[i], asked.around));
      for (const int node : rings_.back().nodes) see(node);
    }
  }

  // Those that something sits on; or, so that it is known as a wall, the first.
  template <class Shell>
  void choose_shells(const std::vector<Shell>& all, std::vector<Shell>& chosen) {
    if (under_.empty())
      for (const int node : nodes_with_something(whole_.model))
        if (node >= 0 && on_ring_[std::size_t(node)]) under_.insert(node);
    for (const Shell& shell : all)
      if (std::any_of(shell.nodes.begin(), shell.nodes.end(),
                      [&](int node) { return under_.contains(node); }))
        chosen.push_back(shell);
    if (chosen.empty() && !all.empty()) chosen.push_back(all.front());
    for (const Shell& shell : chosen)
      for (const int node : shell.nodes) see(node);
  }

  void number_nodes() {
    for (std::size_t node = 0; node < number_.size(); ++node)
      if (number_[node] == 0) {
        number_[node] = static_cast<int>(seen_.nodes.size());
        seen_.nodes.push_back(static_cast<int>(node));
        model().mesh.nodes.push_back(mesh().nodes[node]);
      }
  }

  template <class Nodes> void renumber(Nodes& nodes) const {
    for (int& node : nodes) node = number(node);
  }

  void add_rings_and_sets(const std::vector<std::string>& sets) {
    for (Ring& ring : rings_) {
      renumber(ring.nodes);
      model().mesh.rings.push_back(std::move(ring));
    }
    for (const std::string& name : sets)
      if (const auto set = mesh().sets.find(name); set != mesh().sets.end())
        renumber(model().mesh.sets.emplace(*set).first->second);
    for (ShellQuad& quad : model().mesh.quads) renumber(quad.nodes);
    for (ShellTriangle& triangle : model().mesh.triangles) renumber(triangle.nodes);
  }

  void add_elements() {
    const Model& all = whole_.model;
    model().components = all.components;
    model().shells = all.shells;
    for (BeamElement beam : all.beams) {
      beam.node1 = number(beam.node1);
      beam.node2 = number(beam.node2);
      if (beam.node1 >= 0 && beam.node2 >= 0) model().beams.push_back(beam);
    }
    for (BushingElement spring : all.bushings) {
      const bool to_ground = spring.node2 < 0;
      spring.node1 = number(spring.node1);
      if (!to_ground) spring.node2 = number(spring.node2);
      if (spring.node1 >= 0 && (to_ground || spring.node2 >= 0)) model().bushings.push_back(spring);
    }
    for (MassElement mass : all.masses)
      if ((mass.node = number(mass.node)) >= 0) model().masses.push_back(mass);
    for (const Constraint& row : all.constraints) add_coupling(row);
  }

  // What follows the wall; that the wall follows an end says nothing of what sits on it.
  void add_coupling(Constraint row) {
    const bool to_wall = std::any_of(row.terms.begin(), row.terms.end(), [&](const auto& term) {
      return on_ring_[std::size_t(term.node)] != 0;
    });
    if (!to_wall || number(row.node) < 0) return;
    row.node = number(row.node);
    for (ConstraintTerm& term : row.terms) term.node = number(term.node);
    model().constraints.push_back(std::move(row));
  }

  void add_ends() {
    BuiltCase& built = seen_.built;
    for (const auto& [name, node] : whole_.cap_nodes) built.cap_nodes[name] = number(node);
    for (const auto& [name, node] : whole_.mass_nodes) built.mass_nodes[name] = number(node);
    for (const int node : whole_.held_nodes) built.held_nodes.push_back(number(node));
    for (BuiltSensor sensor : whole_.sensors) {
      sensor.node = number(sensor.node);
      built.sensors.push_back(sensor);
    }
    for (BuiltDamper damper : whole_.dampers) {
      damper.node1 = damper.node1 < 0 ? -1 : number(damper.node1);
      damper.node2 = damper.node2 < 0 ? -1 : number(damper.node2);
      built.dampers.push_back(damper);
    }
  }

  const BuiltCase& whole_;
  std::vector<char> on_ring_;
  std::vector<int> number_; // per node of the whole: seen as, -1 = not
  std::vector<Ring> rings_; // by the numbers of the whole
  std::set<int> under_;     // nodes of the wall that something sits on
  SeenCase seen_;
};

} // namespace

std::optional<SeenCase> seen_case(const BuiltCase& whole, const SeenRings& rings,
                                  const std::vector<std::string>& sets) {
  View view(whole);
  if (!view.of_revolution() || !whole.model.matrices.empty()) return std::nullopt;
  return view.seen(rings, sets);
}

} // namespace plica
