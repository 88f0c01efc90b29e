// An element over the independent DOFs: T' K T and T' M T of its matrices, T the rows of u = T q
// (solve/constraints.hpp) that its nodes have. One rule for every assembly.
#pragma once

#include "solve/constraints.hpp"

#include <algorithm>

namespace plica {

// Calls add(q, K, M), q the independent number of each row and column, -1 = held at zero.
template <class Nodes, class Matrix, class Add>
void on_independent(const DofMap& map, const Nodes& nodes, const Matrix& K, const Matrix& M,
                    Add&& add) {
  std::vector<int> q;
  bool plain = true;
  for (int node : nodes)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof) {
      q.push_back(map.independent[dof]);
      plain = plain && map.dependent[dof].empty();
    }
  if (plain) return add(q, K, M);
  std::vector<int> reached;
  for (std::size_t a = 0; a < q.size(); ++a) {
    if (q[a] >= 0) reached.push_back(q[a]);
    for (const WeightedDof& w : map.dependent[6 * nodes[a / 6] + int(a % 6)])
      reached.push_back(w.dof);
  }
  std::sort(reached.begin(), reached.end());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  const auto column = [&](int dof) {
    return std::lower_bound(reached.begin(), reached.end(), dof) - reached.begin();
  };
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(q.size()),
                                            static_cast<Eigen::Index>(reached.size()));
  for (std::size_t a = 0; a < q.size(); ++a) {
    if (q[a] >= 0) T(a, column(q[a])) = 1;
    for (const WeightedDof& w : map.dependent[6 * nodes[a / 6] + int(a % 6)])
      T(a, column(w.dof)) = w.factor;
  }
  add(reached, Eigen::MatrixXd(T.transpose() * K * T), Eigen::MatrixXd(T.transpose() * M * T));
}

// Nodes whose independent DOFs an element reaches, itself or through constraints; increasing.
inline std::vector<int> reached_nodes(const DofMap& map, const std::vector<int>& nodes) {
  std::vector<int> reached;
  for (int node : nodes) {
    if (map.first[node + 1] > map.first[node]) reached.push_back(node);
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
      for (const WeightedDof& w : map.dependent[dof]) reached.push_back(map.full[w.dof] / 6);
  }
  std::sort(reached.begin(), reached.end());
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  return reached;
}

} // namespace plica
