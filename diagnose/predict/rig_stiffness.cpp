#include "diagnose/predict/rig_stiffness.hpp"

#include "model/description/end_caps.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

namespace plica {

using Eigen::MatrixXd;

double along(const EndStiffness& k, StaticDirection direction) {
  switch (direction) {
  case StaticDirection::axial:
    return k.axial;
  case StaticDirection::transverse_x:
    return k.transverse_x;
  case StaticDirection::transverse_z:
    return k.transverse_z;
  case StaticDirection::bending_x:
    return k.bending_x;
  case StaticDirection::bending_z:
    return k.bending_z;
  case StaticDirection::torsion:
    break;
  }
  return k.torsion;
}

std::vector<int> cap_coordinates(const NominalState& state, std::vector<std::string> names) {
  if (names.empty()) names = end_caps(state.data);
  if (names.size() != 2 || names[0] == names[1]) return {};
  std::vector<int> rows;
  const std::vector<int>& boundary = state.model->boundary();
  for (const std::string& name : names) {
    const auto node = state.built.cap_nodes.find(name);
    if (node == state.built.cap_nodes.end()) return {};
    const auto at = std::find(boundary.begin(), boundary.end(), node->second);
    if (at == boundary.end()) return {};
    for (int d = 0; d < 6; ++d) rows.push_back(6 * int(at - boundary.begin()) + d);
  }
  return rows;
}

std::optional<EndStiffness> rig_stiffness(const NominalState& state, const MatrixXd& K) {
  // Feet of spring mounts are among the others: nothing holds them here.
  const std::vector<int> rows = cap_coordinates(state);
  if (rows.empty()) return std::nullopt;
  std::vector<int> others;
  for (int i = 0; i < int(K.rows()); ++i)
    if (std::find(rows.begin(), rows.end(), i) == rows.end()) others.push_back(i);
  MatrixXd condensed = K(rows, rows);
  const Eigen::LDLT<MatrixXd> inner(MatrixXd(K(others, others)));
  condensed -= K(rows, others) * inner.solve(MatrixXd(K(others, rows)));
  try {
    return end_stiffness(Matrix6(condensed.bottomRightCorner<6, 6>()));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

} // namespace plica
