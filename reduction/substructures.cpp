#include "reduction/substructures.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

// Sets of nodes that grow together (Tarjan, J. ACM 22 (1975) 215).
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void join(int a, int b) { parent_[root(a)] = root(b); }

private:
  std::vector<int> parent_;
};

std::vector<int> nodes_of(const ShellQuad& q) {
  return {q.nodes.begin(), q.nodes.end()};
}
std::vector<int> nodes_of(const ShellTriangle& t) {
  return {t.nodes.begin(), t.nodes.end()};
}
std::vector<int> nodes_of(const BeamElement& b) {
  return {b.node1, b.node2};
}
std::vector<int> nodes_of(const MassElement& m) {
  return {m.node};
}
std::vector<int> nodes_of(const BushingElement& b) {
  return b.node2 < 0 ? std::vector<int>{b.node1} : std::vector<int>{b.node1, b.node2};
}
std::vector<int> nodes_of(const MatrixElement& m) {
  return m.nodes;
}
std::vector<int> nodes_of(const Constraint& c) {
  std::vector<int> nodes{c.node};
  for (const ConstraintTerm& t : c.terms) nodes.push_back(t.node);
  return nodes;
}

template <class F> void for_each_item(const Model& model, F&& f) {
  for (const ShellQuad& x : model.mesh.quads) f(x);
  for (const ShellTriangle& x : model.mesh.triangles) f(x);
  for (const BeamElement& x : model.beams) f(x);
  for (const MassElement& x : model.masses) f(x);
  for (const BushingElement& x : model.bushings) f(x);
  for (const MatrixElement& x : model.matrices) f(x);
  for (const Constraint& x : model.constraints) f(x);
}

// The nodes of an item by their new numbers, `to(node)`.
template <class To> void renumber(ShellQuad& q, const To& to) {
  for (int& node : q.nodes) node = to(node);
}
template <class To> void renumber(ShellTriangle& t, const To& to) {
  for (int& node : t.nodes) node = to(node);
}
template <class To> void renumber(BeamElement& b, const To& to) {
  b.node1 = to(b.node1);
  b.node2 = to(b.node2);
}
template <class To> void renumber(MassElement& m, const To& to) {
  m.node = to(m.node);
}
template <class To> void renumber(BushingElement& b, const To& to) {
  b.node1 = to(b.node1);
  if (b.node2 >= 0) b.node2 = to(b.node2);
}
template <class To> void renumber(MatrixElement& m, const To& to) {
  for (int& node : m.nodes) node = to(node);
}
template <class To> void renumber(Constraint& c, const To& to) {
  c.node = to(c.node);
  for (ConstraintTerm& t : c.terms) t.node = to(t.node);
}

void add(Model& model, ShellQuad x) {
  model.mesh.quads.push_back(std::move(x));
}
void add(Model& model, ShellTriangle x) {
  model.mesh.triangles.push_back(std::move(x));
}
void add(Model& model, BeamElement x) {
  model.beams.push_back(std::move(x));
}
void add(Model& model, MassElement x) {
  model.masses.push_back(std::move(x));
}
void add(Model& model, BushingElement x) {
  model.bushings.push_back(std::move(x));
}
void add(Model& model, MatrixElement x) {
  model.matrices.push_back(std::move(x));
}
void add(Model& model, Constraint x) {
  model.constraints.push_back(std::move(x));
}

class Cutter {
public:
  Cutter(const Model& model, const std::vector<int>& interface_nodes)
      : model_(model), is_interface_(model.mesh.nodes.size(), false),
        group_(model.mesh.nodes.size(), -1) {
    for (int node : interface_nodes) is_interface_[node] = true;
  }

  CutModel result() {
    int groups = find_groups();
    if (keep_what_floats()) groups = find_groups();
    cut_.parts.resize(groups);
    for (Substructure& part : cut_.parts) copy_frame(part.model);
    copy_frame(cut_.frame);
    number_nodes();
    copy_rings();
    for_each_item(model_, [&](const auto& item) {
      const int group = group_of(item);
      auto copy = item;
      renumber(copy, [&](int node) { return number_in(group, node); });
      add(group < 0 ? cut_.frame : cut_.parts[group].model, std::move(copy));
    });
    return std::move(cut_);
  }

private:
  // The group of the inner nodes of an item; -1 = all of them are interface nodes.
  template <class Item> int group_of(const Item& item) const {
    for (int node : nodes_of(item))
      if (!is_interface_[node]) return group_[node];
    return -1;
  }

  void copy_frame(Model& model) const {
    model.components = model_.components;
    model.shells = model_.shells;
  }

  int find_groups() {
    DisjointSets sets(model_.mesh.nodes.size());
    std::vector<bool> used(model_.mesh.nodes.size(), false);
    for_each_item(model_, [&](const auto& item) {
      int first = -1;
      for (int node : nodes_of(item)) {
        used[node] = true;
        if (is_interface_[node]) continue;
        if (first >= 0) sets.join(node, first);
        first = node;
      }
    });
    meets_.clear();
    interface_of_.clear();
    std::fill(group_.begin(), group_.end(), -1);
    for_each_item(model_, [&](const auto& item) {
      const std::vector<int> nodes = nodes_of(item);
      for (int node : nodes)
        if (!is_interface_[node])
          for (int other : nodes)
            if (is_interface_[other]) meets_[sets.root(node)].insert(other);
    });
    std::map<std::set<int>, int> by_interface;
    int groups = 0;
    for (std::size_t node = 0; node < group_.size(); ++node) {
      if (is_interface_[node] || !used[node]) continue;
      const auto met = meets_.find(sets.root(int(node)));
      if (met == meets_.end())
        throw std::invalid_argument("node " + std::to_string(node + 1) +
                                    " belongs to a part that meets no cap");
      const auto [entry, is_new] = by_interface.try_emplace(met->second, groups);
      if (is_new) {
        ++groups;
        interface_of_.push_back(met->second);
      }
      group_[node] = entry->second;
    }
    return groups;
  }

  // A stretch of wall between two dents meets wall nodes alone: nothing would hold it when it is
  // reduced. It stays in the frame.
  bool keep_what_floats() {
    std::vector<bool> on_wall(model_.mesh.nodes.size(), false);
    for (const Ring& ring : model_.mesh.rings)
      for (int node : ring.nodes) on_wall[node] = true;
    std::set<int> floating;
    for (std::size_t group = 0; group < interface_of_.size(); ++group)
      if (std::all_of(interface_of_[group].begin(), interface_of_[group].end(),
                      [&](int node) { return on_wall[node]; }))
        floating.insert(static_cast<int>(group));
    if (floating.empty()) return false;
    for (std::size_t node = 0; node < group_.size(); ++node)
      if (floating.contains(group_[node])) is_interface_[node] = true;
    return true;
  }

  void number_nodes() {
    const auto all = static_cast<int>(group_.size());
    inner_.assign(all, -1);
    at_interface_.resize(cut_.parts.size());
    cut_.number.assign(all, -1);
    const auto put = [&](int part, int node) {
      Substructure& s = cut_.parts[part];
      const int number = add_node(s.model, model_.mesh.nodes[node]);
      if (model_.scalar_nodes.contains(node)) s.model.scalar_nodes.insert(number);
      s.nodes.push_back(node);
      return number;
    };
    for (int node = 0; node < all; ++node) {
      if (group_[node] >= 0) inner_[node] = put(group_[node], node);
      if (!is_interface_[node]) continue;
      cut_.number[node] = add_node(cut_.frame, model_.mesh.nodes[node]);
      for (int part = 0; part < static_cast<int>(cut_.parts.size()); ++part)
        if (interface_of_[part].contains(node)) at_interface_[part][node] = put(part, node);
    }
    for (std::size_t part = 0; part < cut_.parts.size(); ++part)
      for (int node : interface_of_[part])
        cut_.parts[part].boundary.push_back(at_interface_[part].at(node));
  }

  // In a part, or with -1 in the frame; -1 = not there.
  int number_in(int part, int node) const {
    if (part < 0) return cut_.number[node];
    if (group_[node] == part) return inner_[node];
    const auto found = at_interface_[part].find(node);
    return found == at_interface_[part].end() ? -1 : found->second;
  }

  void copy_rings() {
    for (const Ring& ring : model_.mesh.rings) {
      const auto inner = std::find_if(ring.nodes.begin(), ring.nodes.end(),
                                      [&](int node) { return group_[node] >= 0; });
      for (int part = 0; part < static_cast<int>(cut_.parts.size()); ++part) {
        if (inner != ring.nodes.end() && group_[*inner] != part) continue;
        Ring own = ring;
        for (int& node : own.nodes) node = number_in(part, node);
        if (std::find(own.nodes.begin(), own.nodes.end(), -1) == own.nodes.end())
          cut_.parts[part].model.mesh.rings.push_back(std::move(own));
      }
    }
  }

  const Model& model_;
  std::vector<bool> is_interface_;
  std::vector<int> group_;             // per node, -1 = interface
  std::map<int, std::set<int>> meets_; // interface nodes by root of the set
  std::vector<std::set<int>> interface_of_;
  std::vector<int> inner_;                       // own number of a node in its group
  std::vector<std::map<int, int>> at_interface_; // per group: own numbers of interface nodes
  CutModel cut_;
};

} // namespace

CutModel cut(const Model& model, const std::vector<int>& interface_nodes) {
  return Cutter(model, interface_nodes).result();
}

} // namespace plica
