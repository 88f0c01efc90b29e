#include "io/decks/abaqus_joints.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::vector<int> all_six{0, 1, 2, 3, 4, 5};

// DOFs "first, last" of a data line, from a field on; all six when there are none.
std::vector<int> dof_range(const Keyword& k, const DataLine& line, std::size_t field) {
  if (field >= line.fields.size() || line.fields[field].empty()) return all_six;
  const int first = dof_in(k, line, field);
  const bool has_last = field + 1 < line.fields.size() && !line.fields[field + 1].empty();
  const int last = has_last ? dof_in(k, line, field + 1) : first;
  std::vector<int> dofs;
  for (int d = first; d <= last; ++d) dofs.push_back(d);
  return dofs;
}

// Of all data lines; all six without any.
std::vector<int> dofs_of(const Keyword& k) {
  std::set<int> dofs;
  for (const DataLine& line : k.data)
    for (int d : dof_range(k, line, 0)) dofs.insert(d);
  return k.data.empty() ? all_six : std::vector<int>(dofs.begin(), dofs.end());
}

} // namespace

KeywordHandlers AbaqusJoints::handlers() {
  const auto by = [this](void (AbaqusJoints::*read)(const Keyword&)) {
    return [this, read](const Keyword& k) { (this->*read)(k); };
  };
  using J = AbaqusJoints;
  return {
      {"COUPLING",
       {[this](const Keyword& k) {
          no_open_coupling();
          coupling_ = k;
        },
        {"CONSTRAINT NAME", "REF NODE", "SURFACE"}}},
      {"KINEMATIC", {by(&J::kinematic), {}}},
      {"DISTRIBUTING", {by(&J::distributing), {"COUPLING", "WEIGHTING METHOD"}}},
      {"KINEMATIC COUPLING", {by(&J::kinematic_coupling), {"REF NODE"}}},
      {"DISTRIBUTING COUPLING", {by(&J::distributing_coupling), {"ELSET"}}},
      {"RIGID BODY",
       {by(&J::rigid_body),
        {"REF NODE", "ROT NODE", "ELSET", "NSET", "TIE NSET", "PIN NSET", "POSITION",
         "ISOTHERMAL"}}},
      {"MPC", {by(&J::mpc), {}}},
      {"EQUATION", {by(&J::equation), {"REMOVE"}}},
      {"MATRIX INPUT", {by(&J::matrix_input), {"NAME", "INPUT", "TYPE"}}},
      {"MATRIX ASSEMBLE",
       {by(&J::matrix_assemble), {"STIFFNESS", "MASS", "VISCOUS DAMPING", "STRUCTURAL DAMPING"}}},
      {"STEP", {[this](const Keyword&) { kept_in_step_ = true; }, {}}},
      {"TIE", {by(&J::tie), {"NAME", "ADJUST", "POSITION TOLERANCE", "TYPE"}}},
      {"BOUNDARY",
       {by(&J::boundary),
        {"TYPE", "OP", "AMPLITUDE", "LOAD CASE", "FIXED", "REGION TYPE", "TIME DELAY"}}}};
}

void AbaqusJoints::finish() {
  find_modal_points();
  if (moved_ > 0)
    deck_.notes.push_back(
        std::to_string(moved_) +
        " lines of *BOUNDARY prescribe a displacement other than zero: they hold, and move where "
        "the case says static: deck");
  no_open_coupling();
}

// Surfaces whose nodes lie in pairs at the same places, tied pair by pair.
void AbaqusJoints::tie(const Keyword& k) {
  for (const DataLine& line : k.data) {
    if (line.fields.size() < 2) deck_error(line.at, "*TIE", "names one surface", "two");
    const std::vector<int> follow = surface_nodes(k, in_capitals(line.fields[0])).nodes;
    const std::vector<int> lead = surface_nodes(k, in_capitals(line.fields[1])).nodes;
    for (int n : follow) {
      const Vector3d& x = deck_.nodes[n];
      const auto distance = [&](int m) { return (deck_.nodes[m] - x).norm(); };
      const auto nearest = std::min_element(
          lead.begin(), lead.end(), [&](int a, int b) { return distance(a) < distance(b); });
      if (nearest == lead.end() || distance(*nearest) > 1e-6 * (1 + x.norm()))
        deck_error(line.at, "*TIE", "ties meshes whose nodes do not meet", "nodes in pairs");
      if (*nearest != n)
        deck_.couplings.push_back({.reference = *nearest,
                                   .nodes = {n},
                                   .weights = {},
                                   .dofs = all_six,
                                   .origin = origin(k, k.word_or("NAME", ""))});
    }
  }
}

void AbaqusJoints::no_open_coupling() const {
  if (coupling_)
    deck_error(coupling_->at, "*COUPLING", "is neither kinematic nor distributing",
               "*KINEMATIC or *DISTRIBUTING after it");
}

Keyword AbaqusJoints::take_coupling(const Keyword& k) {
  if (!coupling_) deck_error(k.at, "*" + k.name, "follows no *COUPLING", "*COUPLING before it");
  return *std::exchange(coupling_, std::nullopt);
}

int AbaqusJoints::reference(const Keyword& k) const {
  return one_node(k, {k.at, {k.word("REF NODE")}}, 0);
}

int AbaqusJoints::one_node(const Keyword& k, const DataLine& line, std::size_t field) const {
  const std::vector<int> nodes = mesh_.nodes(k, line, line.fields.at(field));
  if (nodes.size() != 1)
    deck_error(line.at, "*" + k.name, "names " + std::to_string(nodes.size()) + " nodes",
               "one node");
  return nodes.front();
}

void AbaqusJoints::kinematic(const Keyword& k) {
  const Keyword of = take_coupling(k);
  deck_.couplings.push_back({.reference = reference(of),
                             .nodes = surface_nodes(of, of.word("SURFACE")).nodes,
                             .weights = {},
                             .dofs = dofs_of(k),
                             .origin = origin(of, of.word_or("CONSTRAINT NAME", ""))});
}

void AbaqusJoints::distributing(const Keyword& k) {
  const Keyword of = take_coupling(k);
  if (k.word_or("WEIGHTING METHOD", "UNIFORM") != "UNIFORM")
    deck_error(k.at, "*DISTRIBUTING", "has WEIGHTING METHOD=" + k.word("WEIGHTING METHOD"),
               "UNIFORM");
  if (k.word_or("COUPLING", "CONTINUUM") != "CONTINUUM")
    deck_error(k.at, "*DISTRIBUTING", "has COUPLING=" + k.word("COUPLING"), "CONTINUUM");
  const std::vector<int> dofs = dofs_of(k);
  if (dofs != all_six && dofs != std::vector{0, 1, 2})
    deck_error(k.at, "*DISTRIBUTING", "couples some degrees of freedom", "1, 3 or all six");
  const SurfaceNodes s = surface_nodes(of, of.word("SURFACE"));
  deck_.couplings.push_back({.distributing = true,
                             .reference = reference(of),
                             .nodes = s.nodes,
                             .weights = s.weights,
                             .dofs = dofs,
                             .origin = origin(of, of.word_or("CONSTRAINT NAME", ""))});
}

void AbaqusJoints::kinematic_coupling(const Keyword& k) {
  for (const DataLine& line : k.data)
    deck_.couplings.push_back({.reference = reference(k),
                               .nodes = mesh_.nodes(k, line, line.fields.at(0)),
                               .weights = {},
                               .dofs = dof_range(k, line, 1),
                               .origin = origin(k, "")});
}

void AbaqusJoints::distributing_coupling(const Keyword& k) {
  for (const AbaqusElement* e : mesh_.elements_for(k, {"DCOUP3D"})) {
    DeckCoupling c{.distributing = true,
                   .reference = e->nodes[0],
                   .nodes = {},
                   .weights = {},
                   .dofs = {},
                   .origin = origin(k, "")};
    for (const DataLine& line : k.data)
      for (int n : mesh_.nodes(k, line, line.fields.at(0))) {
        c.nodes.push_back(n);
        c.weights.push_back(number_in(k, line, 1, 1));
      }
    deck_.couplings.push_back(std::move(c));
  }
}

void AbaqusJoints::rigid_body(const Keyword& k) {
  DeckCoupling c{
      .reference = reference(k), .nodes = {}, .weights = {}, .dofs = {}, .origin = origin(k, "")};
  std::set<int> tied, pinned;
  for (const char* parameter : {"NSET", "TIE NSET"})
    if (k.has(parameter))
      for (int n : mesh_.nodes(k, {k.at, {}}, k.word(parameter))) tied.insert(n);
  if (k.has("ELSET"))
    for (int e : mesh_.elements(k, {k.at, {}}, k.word("ELSET")))
      tied.insert(mesh_.element(e).nodes.begin(), mesh_.element(e).nodes.end());
  if (k.has("PIN NSET"))
    for (int n : mesh_.nodes(k, {k.at, {}}, k.word("PIN NSET")))
      if (!tied.contains(n)) pinned.insert(n);
  c.nodes = {tied.begin(), tied.end()};
  c.dofs = all_six;
  if (!tied.empty()) deck_.couplings.push_back(c);
  c.nodes = {pinned.begin(), pinned.end()};
  c.dofs = {0, 1, 2};
  if (!pinned.empty()) deck_.couplings.push_back(c);
  if (!k.has("ROT NODE")) return;
  // Of CalculiX: the translations of that node are the turns of the body.
  const int turns = one_node(k, {k.at, {k.word("ROT NODE")}}, 0);
  if (turns == c.reference)
    deck_error(k.at, "*RIGID BODY", "has one node as REF NODE and ROT NODE", "a node of its own");
  for (int d = 0; d < 3; ++d)
    deck_.equations.push_back({c.reference, 3 + d, {{turns, d, 1}}, origin(k, "ROT NODE")});
}

void AbaqusJoints::mpc(const Keyword& k) {
  static const std::map<std::string, std::vector<int>> kinds{
      {"BEAM", all_six}, {"TIE", all_six}, {"PIN", {0, 1, 2}}};
  for (const DataLine& line : k.data) {
    const auto kind = kinds.find(in_capitals(line.fields.at(0)));
    if (kind == kinds.end() || line.fields.size() != 3)
      deck_error(line.at, "*MPC",
                 "is \"" + line.fields.at(0) + "\" of " + std::to_string(line.fields.size() - 1) +
                     " nodes",
                 "BEAM, TIE or PIN, a node or set that follows, a node or set that leads");
    const std::vector<int> follow = mesh_.nodes(k, line, line.fields[1]);
    const std::vector<int> lead = mesh_.nodes(k, line, line.fields[2]);
    if (lead.size() != 1 && lead.size() != follow.size())
      deck_error(line.at, "*MPC",
                 "joins " + std::to_string(follow.size()) + " nodes to " +
                     std::to_string(lead.size()),
                 "as many, or to one");
    for (std::size_t i = 0; i < follow.size(); ++i) {
      const int leader = lead[lead.size() == 1 ? 0 : i];
      if (kind->first == "BEAM") {
        deck_.couplings.push_back({.reference = leader,
                                   .nodes = {follow[i]},
                                   .weights = {},
                                   .dofs = kind->second,
                                   .origin = origin(k, "BEAM")});
        continue;
      }
      for (int d : kind->second) // equal, wherever they are
        deck_.equations.push_back({follow[i], d, {{leader, d, 1}}, origin(k, kind->first)});
    }
  }
}

// Of CalculiX: in a later step, of a node and a range of its DOFs. The deck is taken as its last
// step has it, as with *BOUNDARY, OP=NEW.
void AbaqusJoints::remove_equations(const Keyword& k) {
  for (const DataLine& line : k.data) {
    const int node = one_node(k, line, 0);
    const std::vector<int> dofs = dof_range(k, line, 1);
    const auto is_it = [&](const Constraint& row) {
      return row.node == node && std::find(dofs.begin(), dofs.end(), row.dof) != dofs.end();
    };
    if (std::erase_if(deck_.equations, is_it) == 0)
      deck_error(line.at, "*EQUATION", "REMOVE names no equation", "its first node and DOF");
  }
  deck_.notes.push_back("*EQUATION, REMOVE in line " + std::to_string(k.at.line) +
                        ": the model is taken without these equations");
  doubts_.push_back(k.at.file + ":" + std::to_string(k.at.line) +
                    ": *EQUATION, REMOVE changes the equations");
}

void AbaqusJoints::equation(const Keyword& k) {
  if (k.has("REMOVE")) return remove_equations(k);
  for (std::size_t i = 0; i < k.data.size();) {
    const DataLine& head = k.data[i++];
    const int terms = whole_in(k, head, 0);
    std::vector<ConstraintTerm> all;
    while (static_cast<int>(all.size()) < terms) {
      const DataLine& line = data_line(k, i++);
      for (std::size_t field = 0; field + 2 < line.fields.size(); field += 3)
        all.push_back(
            {one_node(k, line, field), dof_in(k, line, field + 1), number_in(k, line, field + 2)});
      if (line.fields.size() < 3)
        deck_error(line.at, "*EQUATION", "is no term", "node, degree of freedom, factor");
    }
    if (static_cast<int>(all.size()) != terms || all.empty() || all.front().factor == 0)
      deck_error(head.at, "*EQUATION",
                 "has " + std::to_string(all.size()) + " terms for " + std::to_string(terms) +
                     ", or a first factor of zero",
                 "as many terms as it says, the first of which follows the others");
    Constraint row{all.front().node, all.front().dof, {}, origin(k, "")};
    for (std::size_t t = 1; t < all.size(); ++t)
      row.terms.push_back({all[t].node, all[t].dof, -all[t].factor / all.front().factor});
    (row.terms.empty() ? deck_.supports : deck_.equations).push_back(std::move(row));
  }
}

void AbaqusJoints::boundary(const Keyword& k) {
  if (k.word_or("OP", "MOD") == "NEW" && std::exchange(kept_in_step_, false)) {
    std::erase_if(deck_.supports, [&](const Constraint& row) { // of boundaries before this step
      return held_.contains({row.node, row.dof});
    });
    held_.clear();
    values_.clear();
  }
  static const std::map<std::string, std::vector<int>> words{
      {"ENCASTRE", all_six}, {"PINNED", {0, 1, 2}}, {"XSYMM", {0, 4, 5}},  {"YSYMM", {1, 3, 5}},
      {"ZSYMM", {2, 3, 4}},  {"XASYMM", {1, 2, 3}}, {"YASYMM", {0, 2, 4}}, {"ZASYMM", {0, 1, 5}}};
  for (const DataLine& line : k.data) {
    const std::vector<int> nodes = mesh_.nodes(k, line, line.fields.at(0));
    std::vector<int> dofs;
    double value = 0;
    if (k.has("FIXED"))
      doubts_.push_back(line.at.file + ":" + std::to_string(line.at.line) +
                        ": *BOUNDARY holds by FIXED what has moved");
    if (line.fields.size() > 1)
      if (const auto word = words.find(in_capitals(line.fields[1])); word != words.end())
        dofs = word->second;
    if (dofs.empty()) {
      if (line.fields.size() < 2)
        deck_error(line.at, "*BOUNDARY", "holds nothing", "degrees of freedom, or ENCASTRE ...");
      if (whole_in(k, line, 1) > 6 && whole_in(k, line, 1) != 7)
        continue; // temperatures and the like
      dofs = dof_range(k, line, 1);
      value = number_in(k, line, 3, 0);
      moved_ += value != 0;
      if (value != 0 && (k.has("AMPLITUDE") || k.word_or("LOAD CASE", "1") != "1" ||
                         k.word_or("TYPE", "DISPLACEMENT") != "DISPLACEMENT"))
        doubts_.push_back(line.at.file + ":" + std::to_string(line.at.line) +
                          ": *BOUNDARY moves by AMPLITUDE, TYPE or LOAD CASE");
    }
    for (int n : nodes)
      for (int d : dofs) {
        values_.erase({n, d});
        if (value != 0) values_[{n, d}] = value;
        if (held_.insert({n, d}).second)
          deck_.supports.push_back({n, d, {}, origin(k, line.fields[0])});
      }
  }
}

} // namespace plica
