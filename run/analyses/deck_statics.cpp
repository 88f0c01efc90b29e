#include "run/analyses/deck_statics.hpp"

#include "model/description/deck_model.hpp"
#include "model/shape/build_deck.hpp"
#include "model/shape/constraint_clash.hpp"
#include "model/shape/deck.hpp"
#include "run/analyses/deck_expansion.hpp"
#include "run/routes/route.hpp"
#include "run/stages.hpp"
#include "solve/modes.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <memory>
#include <set>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr const char* key = "analyses.static";

bool same_rows(const std::vector<Constraint>& a, const std::vector<Constraint>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const Constraint& x, const Constraint& y) {
        return x.node == y.node && x.dof == y.dof && x.terms.empty() == y.terms.empty();
      });
}

// A case in which a deck holds what one of its load cases holds. What that moves stands in the rows
// of the supports as a term of one more coordinate, which is given: u = ... + value c.
struct HeldCase {
  BuiltCase built;
  int moved = -1;        // node of the coordinate c, the last of the model; none: nothing moves
  double coordinate = 0; // c, so that a value in the units of the deck is one in SI
  std::vector<int> numbers = {}; // of each node of the deck in the model, -1: nothing uses it
  Model placed = {};             // what the deck alone makes,
  std::vector<int> all = {};     // and the numbers of its nodes in the model
};

// Rows of the supports with the coordinate that moves them, by node and DOF of the model.
void let_move(HeldCase& held, const DeckPart& part, const DeckLoadCase& loads,
              const std::vector<int>& all) {
  DeckModel deck = *part.content;
  const int scalar = static_cast<int>(deck.nodes.size());
  deck.nodes.emplace_back(0, 0, 0);
  deck.labels.push_back(0);
  deck.scalars.insert(scalar);
  deck.supports = loads.supports;
  for (Constraint& row : deck.supports)
    if (const auto found = loads.moved.find({row.node, row.dof});
        found != loads.moved.end() && held.numbers[std::size_t(row.node)] >= 0)
      row.terms.push_back({scalar, 0, found->second});
  std::vector<int> numbers;
  const Model placed = place(deck, placing_of(part), &numbers);
  const int there = numbers[std::size_t(scalar)];
  if (there < 0) return; // nothing uses the nodes that move
  Model& model = held.built.model;
  held.moved = add_node(model, {0, 0, 0});
  held.coordinate = part.length_unit;
  model.scalar_nodes.insert(held.moved);
  const auto number = [&](int node) {
    return node == there ? held.moved : all[std::size_t(node < there ? node : node - 1)];
  };
  std::map<std::pair<int, int>, const Constraint*> rows;
  for (const Constraint& row : placed.constraints)
    if (row.node != there) rows[{number(row.node), row.dof}] = &row;
  for (Constraint& own : model.constraints) {
    const auto row = rows.find({own.node, own.dof});
    if (row == rows.end()) continue;
    for (const ConstraintTerm& term : row->second->terms)
      if (term.node == there) own.terms.push_back({held.moved, term.dof, term.factor});
  }
}

HeldCase held_case(const Case& data, std::size_t number, const DeckLoadCase& loads) {
  Case changed = data;
  auto& part = std::get<DeckPart>(changed.parts[number].body);
  auto deck = std::make_shared<DeckModel>(*part.content);
  deck->supports = loads.supports;
  part.content = deck;
  HeldCase held{.built = build(changed)};
  held.placed = place(*deck, placing_of(part), &held.numbers);
  held.all = held.built.model.mesh.sets.at(changed.parts[number].name + ".all");
  for (int& node : held.numbers)
    if (node >= 0) node = held.all[std::size_t(node)];
  if (part.held && !loads.moved.empty()) let_move(held, part, loads, held.all);
  return held;
}

System assembled(const Model& model) {
  try {
    return assemble(model);
  } catch (const ConstraintError& error) {
    refuse_clash(error);
  } catch (const std::invalid_argument& error) {
    input_error("", error.what(), "");
  }
}

// Rows that hold or move a node: terms of that node alone, and of the coordinate that moves it.
bool is_support(const Constraint& row, int moved) {
  return std::all_of(row.terms.begin(), row.terms.end(), [&](const ConstraintTerm& t) {
    return t.node == row.node || t.node == moved;
  });
}

class HeldSolution {
public:
  HeldSolution(const Case& data, std::size_t part, const DeckLoadCase& loads)
      : deck_(std::get<DeckPart>(data.parts[part].body)), name_(data.parts[part].name),
        held_(held_case(data, part, loads)), model_(held_.built.model), system_(assembled(model_)) {
    std::vector<int> fixed = node_dofs(system_.map, held_.built.held_nodes);
    if (held_.moved >= 0)
      for (int dof : node_dofs(system_.map, {held_.moved})) fixed.push_back(dof);
    std::sort(fixed.begin(), fixed.end());
    free_ = complement(system_.map.size(), fixed);
    K_ = restrict_to(system_.K, free_);
    base_.emplace(factor_below_spectrum(K_, mass_or_scale(restrict_to(system_.M, free_))));
    require_held(base_->sigma < 0, held_.built);
    Model bare = model_;
    bare.constraints.clear();
    loose_ = assemble(bare);
    Model without = model_;
    std::erase_if(without.constraints,
                  [&](const Constraint& row) { return is_support(row, held_.moved); });
    unheld_ = eliminate(without);
    for (const Constraint& row : model_.constraints)
      if (is_support(row, held_.moved))
        for (int d = row.dof / 3 * 3; d < row.dof / 3 * 3 + 3; ++d)
          held_dofs_.insert(6 * row.node + d);
    for (int node : held_.built.held_nodes)
      for (int d = 0; d < 6; ++d) held_dofs_.insert(6 * node + d);
  }

  // Displacements over the DOFs of the case, to `u`.
  DeckLoadResult solve(const DeckLoadCase& loads, VectorXd& u) const {
    const ExpansionLoads hot = expansion_loads(*deck_.content, held_.placed, loads.strains);
    const VectorXd grown = over_the_model(hot.force), F = force(loads) + grown;
    VectorXd q = VectorXd::Zero(system_.map.size());
    if (held_.moved >= 0) q[system_.map.independent[6 * held_.moved]] = held_.coordinate;
    const VectorXd rest = gather(system_.map, F) - VectorXd(symmetric_product(system_.K, q));
    const VectorXd f = rest(free_);
    VectorXd x = base_->factor.solve(f);
    x += base_->factor.solve(f - symmetric_product(K_, x));
    q(free_) = x;
    u = expand(system_.map, q);
    DeckLoadResult result;
    result.residual = f.norm() > 0 ? (f - symmetric_product(K_, x)).norm() / f.norm() : 0;
    fill(result, F, u);
    result.energy += hot.energy - u.dot(grown);
    u.conservativeResize(own_dofs());
    return result;
  }

private:
  // Where nothing has mass, as statics may: the diagonal of K tells what is free as well.
  SparseMatrix mass_or_scale(const SparseMatrix& M) const {
    if (dofs_with_mass(M) > 0) return M;
    SparseMatrix scale(K_.rows(), K_.cols());
    scale.setIdentity();
    scale.diagonal() = K_.diagonal();
    return scale;
  }

  VectorXd over_the_model(const VectorXd& of_deck) const {
    VectorXd F = VectorXd::Zero(dof_count(model_));
    for (std::size_t node = 0; node < held_.all.size(); ++node)
      F.segment<6>(6 * held_.all[node]) = of_deck.segment<6>(6 * Eigen::Index(node));
    return F;
  }

  Eigen::Index own_dofs() const { return dof_count(model_) - (held_.moved >= 0 ? 6 : 0); }

  // Over all DOFs of the model.
  VectorXd force(const DeckLoadCase& loads) const {
    const DeckPlacing placing = placing_of(deck_);
    const double L = placing.units.length, M = placing.units.mass;
    VectorXd F = VectorXd::Zero(dof_count(model_));
    for (const DeckForce& f : loads.forces) {
      const int node = held_.numbers[std::size_t(f.node)];
      if (node < 0) continue; // deck_statics() has refused it
      if (model_.scalar_nodes.contains(node)) {
        F[6 * node] += M * L * f.force[0];
        continue;
      }
      F.segment<3>(6 * node) += placing.turn * (M * L * f.force);
      F.segment<3>(6 * node + 3) += placing.turn * (M * L * L * f.moment);
    }
    if (loads.gravity.isZero(0)) return F;
    VectorXd a = VectorXd::Zero(F.size());
    for (Eigen::Index node = 0; node < F.size() / 6; ++node)
      if (!model_.scalar_nodes.contains(int(node)))
        a.segment<3>(6 * node) = placing.turn * (L * loads.gravity);
    return F + of_all(loose_.M, a);
  }

  // Product with a matrix of the model without constraints, over all DOFs.
  VectorXd of_all(const SparseMatrix& lower, const VectorXd& x) const {
    return expand(loose_.map, symmetric_product(lower, gather(loose_.map, x)));
  }

  void fill(DeckLoadResult& result, const VectorXd& F, const VectorXd& u) const {
    const VectorXd Ku = of_all(loose_.K, u);
    result.energy = u.dot(Ku) / 2;
    const VectorXd R = gather(unheld_, Ku - F); // zero where nothing holds
    VectorXd reaction = VectorXd::Zero(F.size());
    for (Eigen::Index i = 0; i < R.size(); ++i)
      if (const int dof = unheld_.full[std::size_t(i)]; held_dofs_.contains(dof))
        reaction[dof] = R[i];
    const auto& x = model_.mesh.nodes;
    for (int node = 0; node < int(own_dofs() / 6); ++node) {
      if (model_.scalar_nodes.contains(node)) continue;
      add_resultant(result.load, x[std::size_t(node)], F.segment<6>(6 * node));
      add_resultant(result.reaction, x[std::size_t(node)], reaction.segment<6>(6 * node));
      if (const double size = u.segment<3>(6 * node).norm(); size > result.largest) {
        result.largest = size;
        Vector3d::Map(result.at.data()) = x[std::size_t(node)];
      }
    }
    const auto& labels = deck_.content->labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const int node = held_.numbers[i];
      if (labels[i] <= 0 || node < 0) continue;
      bool held = false;
      for (int d = 0; d < 6; ++d) held = held || held_dofs_.contains(6 * node + d);
      result.nodes.push_back({name_, labels[i], x[std::size_t(node)], u.segment<6>(6 * node),
                              reaction.segment<6>(6 * node), held});
    }
    result.sensors.resize(Eigen::Index(held_.built.sensors.size()), 6);
    for (std::size_t s = 0; s < held_.built.sensors.size(); ++s)
      result.sensors.row(Eigen::Index(s)) = u.segment<6>(6 * held_.built.sensors[s].node);
  }

  static void add_resultant(std::array<double, 6>& sum, const Vector3d& at,
                            const Eigen::Matrix<double, 6, 1>& f) {
    const Vector3d force = f.head<3>(), moment = f.tail<3>() + at.cross(force);
    for (int d = 0; d < 3; ++d) {
      sum[std::size_t(d)] += force[d];
      sum[std::size_t(3 + d)] += moment[d];
    }
  }

  const DeckPart& deck_;
  std::string name_;
  HeldCase held_;
  const Model& model_;
  System system_;
  std::vector<int> free_;
  SparseMatrix K_;
  std::optional<BaseFactor> base_;
  System loose_;  // without constraints
  DofMap unheld_; // without supports
  std::set<int> held_dofs_;
};

// All that acts and is not had, of all decks at once.
void refuse_what_is_not_had(const Case& data) {
  std::vector<InputProblem> problems;
  std::set<std::string> said;
  const auto add = [&](const std::string& wrong, const std::string& allowed) {
    if (said.insert(wrong).second) problems.push_back({{}, 0, key, wrong, allowed});
  };
  for (const Part& part : data.parts) {
    const auto* deck = std::get_if<DeckPart>(&part.body);
    if (deck == nullptr || !deck->content) continue;
    if (deck->content->load_cases.empty())
      add("asks for the loads of a deck, and " + part.name +
              " has no subcase with LOAD or step of *STATIC that anything acts in",
          "a deck with one, or static: true");
    std::vector<int> numbers;
    place(*deck->content, placing_of(*deck), &numbers);
    for (const DeckLoadCase& loads : deck->content->load_cases) {
      for (const std::string& what : loads.not_had)
        add(part.name + ", " + loads.name + ": " + what, "loads of docs/decks.md, or static: true");
      if (!deck->held && !loads.moved.empty())
        add(part.name + ", " + loads.name + ": moves its supports, which `held: false` lets go",
            "held: true");
      if (!loads.strains.empty() && data.analyses.stress)
        add(part.name + ", " + loads.name +
                ": has temperatures, and stress of what expands is not had",
            "no stress, or loads without temperatures");
      for (const DeckForce& f : loads.forces)
        if (numbers[std::size_t(f.node)] < 0)
          add(part.name + ", " + loads.name + ": a force acts on node " +
                  std::to_string(deck->content->labels[std::size_t(f.node)]) +
                  ", which nothing uses",
              "forces on nodes of the structure");
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

} // namespace

DeckStatics deck_statics(const Case& data, const BuiltCase& built, const StageListener& stage) {
  refuse_what_is_not_had(data);
  stage(stages::statics);
  DeckStatics solved;
  std::vector<VectorXd> fields;
  for (std::size_t p = 0; p < data.parts.size(); ++p) {
    const auto* deck = std::get_if<DeckPart>(&data.parts[p].body);
    if (deck == nullptr || !deck->content) continue;
    std::unique_ptr<HeldSolution> held; // of the last load case
    const DeckLoadCase* of = nullptr;
    for (const DeckLoadCase& loads : deck->content->load_cases) {
      if (of == nullptr || !same_rows(of->supports, loads.supports) || of->moved != loads.moved) {
        held = std::make_unique<HeldSolution>(data, p, loads);
      }
      of = &loads;
      solved.results.push_back(held->solve(loads, fields.emplace_back()));
      solved.results.back().name = data.parts[p].name + ", " + loads.name;
      if (loads.along_beams && data.analyses.stress)
        solved.notes.push_back(solved.results.back().name +
                               ": stresses of beams are those of forces on their nodes, without "
                               "what a force along them bends between");
      for (const std::string& note : loads.notes)
        solved.notes.push_back(solved.results.back().name + ": " + note);
    }
  }
  solved.u.resize(dof_count(built.model), Eigen::Index(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) solved.u.col(Eigen::Index(i)) = fields[i];
  return solved;
}

} // namespace plica
