#include "solve/couplings.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Vector3d;

// Rows of u + theta x d in (u, theta).
Eigen::Matrix<double, 3, 6> rigid_rows(const Vector3d& d) {
  Eigen::Matrix<double, 3, 6> R;
  R << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  R.rightCols<3>() << 0, d.z(), -d.y(), -d.z(), 0, d.x(), d.y(), -d.x(), 0;
  return R;
}

} // namespace

void add_kinematic_coupling(Model& model, int reference, const std::vector<int>& nodes,
                            const std::vector<int>& dofs, const std::string& origin) {
  const auto& x = model.mesh.nodes;
  for (int node : nodes) {
    if (node == reference) continue;
    const auto R = rigid_rows(x[node] - x[reference]);
    for (int dof : dofs) {
      Constraint row{.node = node, .dof = dof, .terms = {}, .origin = origin};
      if (dof >= 3) {
        row.terms.push_back({reference, dof, 1});
      } else {
        for (int j = 0; j < 6; ++j)
          if (R(dof, j) != 0) row.terms.push_back({reference, j, R(dof, j)});
      }
      model.constraints.push_back(std::move(row));
    }
  }
}

void add_distributing_coupling(Model& model, int reference, const std::vector<int>& nodes,
                               const std::string& origin, const std::vector<double>& weights) {
  const auto& x = model.mesh.nodes;
  const auto weight = [&](std::size_t i) { return weights.empty() ? 1 : weights[i]; };
  Matrix6 normal = Matrix6::Zero();
  double size = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto R = rigid_rows(x[nodes[i]] - x[reference]);
    normal.noalias() += weight(i) * R.transpose() * R;
    size = std::max(size, (x[nodes[i]] - x[reference]).norm());
  }
  Eigen::Matrix<double, 6, 1> scale; // lengths out, so that definiteness can be judged
  scale << 1, 1, 1, 1 / size, 1 / size, 1 / size;
  const Matrix6 scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  if (nodes.size() < 3 || eigen.eigenvalues()[0] < 1e-10 * eigen.eigenvalues()[5])
    throw std::invalid_argument(origin + ": a distributing coupling needs at least three nodes " +
                                "that do not lie on one line");
  const Matrix6 inverse = scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
  std::array<Constraint, 6> rows;
  for (int i = 0; i < 6; ++i)
    rows[i] = {.node = reference, .dof = i, .terms = {}, .origin = origin};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Eigen::Matrix<double, 6, 3> share =
        weight(n) * inverse * rigid_rows(x[nodes[n]] - x[reference]).transpose();
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 3; ++j)
        if (share(i, j) != 0) rows[i].terms.push_back({nodes[n], j, share(i, j)});
  }
  for (Constraint& row : rows) model.constraints.push_back(std::move(row));
}

void add_support(Model& model, const std::vector<int>& nodes, const std::vector<int>& dofs,
                 const std::string& origin) {
  for (int node : nodes)
    for (int dof : dofs)
      model.constraints.push_back({.node = node, .dof = dof, .terms = {}, .origin = origin});
}

} // namespace plica
