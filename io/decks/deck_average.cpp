#include "io/decks/deck_average.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

using Matrix66 = Eigen::Matrix<double, 6, 6>;

// Columns: the six directions of the DOFs of a node in the global axes.
Matrix66 directions(const DeckModel& deck, int node) {
  Matrix66 T = Matrix66::Identity();
  if (const auto own = deck.axes.find(node); own != deck.axes.end())
    T.topLeftCorner<3, 3>() = T.bottomRightCorner<3, 3>() = own->second;
  return T;
}

// Motion of a point at `arm` from the reference over the motion of that.
Matrix66 rigid(const Eigen::Vector3d& arm) {
  Matrix66 S = Matrix66::Identity();
  S.topRightCorner<3, 3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  return S;
}

} // namespace

std::vector<Constraint> average_rows(const DeckModel& deck, int point, const std::vector<int>& dofs,
                                     const std::vector<AveragedNode>& nodes,
                                     const std::string& origin) {
  const auto arm = [&](int node) {
    return Eigen::Vector3d(deck.nodes[std::size_t(node)] - deck.nodes[std::size_t(point)]);
  };
  double length = 0;
  for (const AveragedNode& n : nodes) length += arm(n.node).norm() / double(nodes.size());
  if (length == 0) length = 1; // all where the point is: rotations average among themselves
  Matrix66 A = Matrix66::Zero();
  std::vector<Matrix66> parts; // S' W along the axes of the node
  for (const AveragedNode& n : nodes) {
    const Matrix66 T = directions(deck, n.node), S = rigid(arm(n.node));
    Eigen::Matrix<double, 6, 1> w = Eigen::Matrix<double, 6, 1>::Zero();
    for (int d : n.dofs) w[d] = n.weight * (d < 3 ? 1 : length * length);
    parts.emplace_back(S.transpose() * T * w.asDiagonal());
    A += parts.back() * T.transpose() * S;
  }
  Eigen::Matrix<double, 6, 1> scale;
  scale << 1, 1, 1, 1 / length, 1 / length, 1 / length;
  const Matrix66 scaled = scale.asDiagonal() * A * scale.asDiagonal();
  const Eigen::LDLT<Matrix66> factor(scaled);
  if (factor.info() != Eigen::Success ||
      !(factor.vectorD().minCoeff() > 1e-9 * factor.vectorD().maxCoeff()))
    throw std::invalid_argument("the grid points do not determine its motion");
  const Matrix66 own = directions(deck, point);
  std::vector<Constraint> rows;
  for (int d : dofs) rows.push_back({point, d, {}, origin});
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Matrix66 G = own.transpose() * scale.asDiagonal() *
                       factor.solve(Matrix66(scale.asDiagonal() * parts[i]));
    for (Constraint& row : rows)
      for (int d : nodes[i].dofs)
        if (std::abs(G(row.dof, d)) > 1e-14) row.terms.push_back({nodes[i].node, d, G(row.dof, d)});
  }
  return rows;
}

std::vector<Constraint> solved_for(const std::vector<NodeDof>& following,
                                   const std::vector<Constraint>& rows) {
  if (following.size() != rows.size() ||
      std::set<NodeDof>(following.begin(), following.end()).size() != rows.size())
    throw std::invalid_argument("UM names " + std::to_string(following.size()) +
                                " components, not the " + std::to_string(rows.size()) + " of REFC");
  std::map<NodeDof, Eigen::Index> place; // columns: those that follow first
  for (const NodeDof& f : following) place.try_emplace(f, Eigen::Index(place.size()));
  for (const Constraint& row : rows) {
    place.try_emplace({row.node, row.dof}, Eigen::Index(place.size()));
    for (const ConstraintTerm& t : row.terms)
      place.try_emplace({t.node, t.dof}, Eigen::Index(place.size()));
  }
  const auto count = Eigen::Index(rows.size());
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(count, Eigen::Index(place.size()));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Constraint& row = rows[std::size_t(i)];
    C(i, place.at({row.node, row.dof})) += 1;
    for (const ConstraintTerm& t : row.terms) C(i, place.at({t.node, t.dof})) -= t.factor;
  }
  Eigen::FullPivLU<Eigen::MatrixXd> led(C.leftCols(count));
  led.setThreshold(1e-9);
  if (!led.isInvertible())
    throw std::invalid_argument("the components of UM do not follow from it");
  const Eigen::MatrixXd X = -led.solve(C.rightCols(C.cols() - count));
  std::vector<Constraint> solved;
  for (const NodeDof& f : following) solved.push_back({f.node, f.dof, {}, rows.front().origin});
  for (const auto& [dof, column] : place)
    for (Eigen::Index i = 0; i < count && column >= count; ++i)
      if (const double x = X(i, column - count); std::abs(x) > 1e-14)
        solved[std::size_t(i)].terms.push_back({dof.node, dof.dof, x});
  return solved;
}

} // namespace plica
