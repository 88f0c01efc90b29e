#include "solve/effective_mass.hpp"

namespace plica {

FreeMass free_mass(const Model& model, const DofMap& map, const std::vector<int>& free,
                   const SparseMatrix& M) {
  FreeMass result;
  const auto motions = [&](const Eigen::Vector3d& about) {
    return Eigen::MatrixXd(rigid_body_motions(model, map, about)(free, Eigen::all));
  };
  result.R = motions(Eigen::Vector3d::Zero());
  const Eigen::MatrixXd m = result.R.transpose() * symmetric_product(M, result.R);
  result.mass = m.topLeftCorner(3, 3).trace() / 3;
  // M_ij of translation i and rotation j is m (e_j x c)_i: each first moment stands there twice.
  if (result.mass > 0)
    result.centre = Eigen::Vector3d(m(1, 5) - m(2, 4), m(2, 3) - m(0, 5), m(0, 4) - m(1, 3)) /
                    (2 * result.mass);
  result.R = motions(result.centre);
  result.total = (result.R.transpose() * symmetric_product(M, result.R)).diagonal();
  return result;
}

Eigen::MatrixXd effective_masses(const FreeMass& free, const SparseMatrix& M,
                                 const Eigen::MatrixXd& Phi) {
  return (Phi.transpose() * symmetric_product(M, free.R)).array().square();
}

} // namespace plica
