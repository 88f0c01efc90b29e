#include "diagnose/predict/rig_stiffness.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

namespace plica {

using Eigen::Index;
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

std::optional<EndStiffness> rig_stiffness(const NominalState& state, const MatrixXd& K) {
  // Feet of spring mounts are among the others: nothing holds them here.
  const Case& data = state.data;
  if (data.caps.size() != 2) return std::nullopt;
  std::vector<Index> rows;
  const std::vector<int>& boundary = state.model->boundary();
  for (const Cap& cap : data.caps) {
    const auto at = std::find(boundary.begin(), boundary.end(), state.built.cap_nodes.at(cap.name));
    if (at == boundary.end()) return std::nullopt;
    for (int d = 0; d < 6; ++d) rows.push_back(6 * (at - boundary.begin()) + d);
  }
  std::vector<Index> others;
  for (Index i = 0; i < K.rows(); ++i)
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
