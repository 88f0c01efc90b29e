#include "solve/effective_mass.hpp"

#include <Eigen/Geometry>

#include <array>

namespace plica {
namespace {

// Calls f(nodes, M) for every element that has mass.
template <class F> void for_each_mass(const Model& model, F&& f) {
  for (const ShellQuad& q : model.mesh.quads)
    f(q.nodes, shell_mitc4_mass(mass_geometry(model, q), model.shells[q.section].section));
  for (const ShellTriangle& t : model.mesh.triangles)
    f(t.nodes, shell_mitc3_mass(mass_geometry(model, t), model.shells[t.section].section));
  for (const BeamElement& b : model.beams)
    f(std::array{b.node1, b.node2}, beam_mass(beam_geometry(model.mesh, b), b.section));
  for (const MassElement& m : model.masses) f(std::array{m.node}, rigid_mass_matrix(m.body));
  for (const MatrixElement& m : model.matrices) f(m.nodes, m.M);
}

Eigen::Vector3d centre_of(const Eigen::MatrixXd& m, double mass) {
  if (mass <= 0) return Eigen::Vector3d::Zero();
  // M_ij of translation i and rotation j is m (e_j x c)_i: each first moment stands there twice.
  return Eigen::Vector3d(m(1, 5) - m(2, 4), m(2, 3) - m(0, 5), m(0, 4) - m(1, 3)) / (2 * mass);
}

} // namespace

FreeMass free_mass(const Model& model, const DofMap& map, const std::vector<int>& free,
                   const SparseMatrix& M) {
  FreeMass result;
  const auto motions = [&](const Eigen::Vector3d& about) {
    return Eigen::MatrixXd(rigid_body_motions(model, map, about)(free, Eigen::all));
  };
  result.R = motions(Eigen::Vector3d::Zero());
  const Eigen::MatrixXd m = result.R.transpose() * symmetric_product(M, result.R);
  result.mass = m.topLeftCorner(3, 3).trace() / 3;
  result.centre = centre_of(m, result.mass);
  result.R = motions(result.centre);
  result.total = (result.R.transpose() * symmetric_product(M, result.R)).diagonal();
  return result;
}

double total_mass(const Model& model) {
  double mass = 0;
  for_each_mass(model, [&](const auto&, const auto& M) {
    for (Eigen::Index i = 0; i < M.rows(); i += 6)
      for (Eigen::Index j = 0; j < M.cols(); j += 6) mass += M(i, j); // moved along x
  });
  return mass;
}

Eigen::MatrixXd mass_product(const Model& model, const Eigen::MatrixXd& u) {
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(u.rows(), u.cols());
  for_each_mass(model, [&](const auto& nodes, const auto& M) {
    Eigen::MatrixXd own(M.rows(), u.cols());
    for (std::size_t a = 0; a < nodes.size(); ++a)
      own.middleRows(6 * Eigen::Index(a), 6) = u.middleRows(6 * nodes[a], 6);
    const Eigen::MatrixXd product = M * own;
    for (std::size_t a = 0; a < nodes.size(); ++a)
      force.middleRows(6 * nodes[a], 6) += product.middleRows(6 * Eigen::Index(a), 6);
  });
  return force;
}

CentralMass refer_to_centre(const Eigen::Matrix<double, 6, 6>& m, Eigen::MatrixXd& participation) {
  CentralMass result{.mass = m.topLeftCorner(3, 3).trace() / 3, .total = {}};
  const Eigen::Vector3d centre = centre_of(m, result.mass);
  Eigen::Matrix<double, 6, 6> shift = Eigen::Matrix<double, 6, 6>::Identity();
  for (int j = 0; j < 3; ++j)
    shift.block<3, 1>(0, 3 + j) = -Eigen::Vector3d(Eigen::Vector3d::Unit(j)).cross(centre);
  participation = (participation * shift).eval();
  result.total = (shift.transpose() * m * shift).diagonal();
  return result;
}

} // namespace plica
