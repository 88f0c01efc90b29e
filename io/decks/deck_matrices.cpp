#include "io/decks/deck_matrices.hpp"

#include <cmath>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;

MatrixElement GivenMatrix::element(const DeckModel& deck, GivenKind kind, bool triangle,
                                   double factor, const DeckPosition& at,
                                   const std::string& name) const {
  constexpr std::size_t most = 1000;
  std::map<int, Index> first;
  for (const auto& [place, value] : entries_)
    first[place.first.node] = first[place.second.node] = 0;
  MatrixElement element;
  for (auto& [node, index] : first) {
    index = static_cast<Index>(6 * element.nodes.size());
    element.nodes.push_back(node);
  }
  if (first.size() > most)
    deck_error(at, name, "joins " + std::to_string(first.size()) + " points",
               "a matrix of at most 1000 points");
  const auto size = static_cast<Index>(6 * element.nodes.size());
  MatrixXd A = MatrixXd::Zero(size, size);
  for (const auto& [place, value] : entries_) {
    const Index i = first.at(place.first.node) + place.first.dof,
                j = first.at(place.second.node) + place.second.dof;
    A(i, j) += factor * value;
    if (triangle && i != j) A(j, i) += factor * value;
  }
  const Eigen::VectorXd root = A.diagonal().cwiseAbs().cwiseSqrt();
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i)
      if (std::abs(A(i, j) - A(j, i)) > 1e-6 * std::max(root[i] * root[j], std::abs(A(i, j))))
        deck_error(at, name, "is not symmetric", "a symmetric matrix");
  if (!A.allFinite() || (size > 0 && A.diagonal().minCoeff() < 0))
    deck_error(at, name, "has a diagonal below zero", "stiffness and mass of a body");
  MatrixXd R = MatrixXd::Identity(size, size);
  for (const auto& [node, axes] : deck.axes)
    if (const auto own = first.find(node); own != first.end() && !deck.scalars.contains(node))
      for (Index block : {0, 3}) R.block<3, 3>(own->second + block, own->second + block) = axes;
  element.K = element.M = MatrixXd::Zero(size, size);
  (kind == GivenKind::stiffness ? element.K : element.M) =
      R * ((A + A.transpose()) / 2) * R.transpose();
  return element;
}

} // namespace plica
