#include "solve/constraints.hpp"

#include "words/directions.hpp"

#include <algorithm>
#include <map>

namespace plica {
namespace {

std::string row_name(const Constraint& row) {
  return row.origin + " (node " + std::to_string(row.node + 1) + ", " + dof_name(row.dof) + ")";
}

// Which constraint determines each DOF, -1 = none.
std::vector<int> owners(const Model& model) {
  std::vector<int> owner(dof_count(model), -1);
  for (int r = 0; r < static_cast<int>(model.constraints.size()); ++r) {
    const Constraint& row = model.constraints[r];
    int& taken = owner[6 * row.node + row.dof];
    if (taken < 0) {
      taken = r;
      continue;
    }
    const Constraint& other = model.constraints[taken];
    if (row.terms.empty() && other.terms.empty()) continue;
    throw ConstraintError("two constraints determine one degree of freedom: " + row_name(other) +
                              " and " + row_name(row),
                          {other, row});
  }
  return owner;
}

// Follows the chains of dependent DOFs, depth first.
class Resolver {
public:
  Resolver(const Model& model, DofMap& map) : model_(model), map_(map), owner_(owners(model)) {
    state_.assign(owner_.size(), State::untouched);
  }

  void number_independent() {
    map_.independent.assign(owner_.size(), -1);
    map_.dependent.resize(owner_.size());
    map_.first.clear();
    for (int dof = 0; dof < static_cast<int>(owner_.size()); ++dof) {
      if (dof % 6 == 0) map_.first.push_back(map_.size());
      if (owner_[dof] >= 0) continue;
      map_.independent[dof] = map_.size();
      map_.full.push_back(dof);
    }
    map_.first.push_back(map_.size());
  }

  void resolve(int dof) {
    if (owner_[dof] < 0 || state_[dof] == State::done) return;
    const Constraint& row = model_.constraints[owner_[dof]];
    state_[dof] = State::open;
    std::map<int, double> sum;
    for (const ConstraintTerm& term : row.terms) {
      const int from = 6 * term.node + term.dof;
      if (state_[from] == State::open)
        throw ConstraintError("constraints determine each other in a circle: " + row_name(row) +
                                  " and " + row_name(model_.constraints[owner_[from]]),
                              {row, model_.constraints[owner_[from]]});
      resolve(from);
      if (owner_[from] < 0)
        sum[map_.independent[from]] += term.factor;
      else
        for (const WeightedDof& w : map_.dependent[from]) sum[w.dof] += term.factor * w.factor;
    }
    for (const auto& [independent, factor] : sum)
      map_.dependent[dof].push_back({independent, factor});
    state_[dof] = State::done;
  }

private:
  enum class State { untouched, open, done };
  const Model& model_;
  DofMap& map_;
  std::vector<int> owner_;
  std::vector<State> state_;
};

} // namespace

DofMap eliminate(const Model& model) {
  DofMap map;
  Resolver resolver(model, map);
  resolver.number_independent();
  for (int dof = 0; dof < dof_count(model); ++dof) resolver.resolve(dof);
  return map;
}

Eigen::MatrixXd expand(const DofMap& map, const Eigen::MatrixXd& q) {
  Eigen::MatrixXd u =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(map.independent.size()), q.cols());
  for (std::size_t dof = 0; dof < map.independent.size(); ++dof) {
    if (map.independent[dof] >= 0) u.row(dof) = q.row(map.independent[dof]);
    for (const WeightedDof& w : map.dependent[dof]) u.row(dof) += w.factor * q.row(w.dof);
  }
  return u;
}

Eigen::VectorXd gather(const DofMap& map, const Eigen::VectorXd& force) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(map.size());
  for (std::size_t dof = 0; dof < map.independent.size(); ++dof) {
    if (map.independent[dof] >= 0) f[map.independent[dof]] += force[dof];
    for (const WeightedDof& w : map.dependent[dof]) f[w.dof] += w.factor * force[dof];
  }
  return f;
}

} // namespace plica
