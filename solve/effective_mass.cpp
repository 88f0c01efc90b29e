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

double total_mass(const Model& model) {
  double mass = 0;
  const auto add = [&](const auto& M) {
    for (Eigen::Index i = 0; i < M.rows(); i += 6)
      for (Eigen::Index j = 0; j < M.cols(); j += 6) mass += M(i, j); // moved along x
  };
  for (const ShellQuad& q : model.mesh.quads)
    add(shell_mitc4_mass(shell_geometry(model.mesh, q), model.shells[q.section].section));
  for (const ShellTriangle& t : model.mesh.triangles)
    add(shell_mitc3_mass(shell_geometry(model.mesh, t), model.shells[t.section].section));
  for (const BeamElement& b : model.beams) add(beam_mass(beam_geometry(model.mesh, b), b.section));
  for (const MassElement& m : model.masses) mass += m.body.mass;
  for (const MatrixElement& m : model.matrices) add(m.M);
  return mass;
}

} // namespace plica
