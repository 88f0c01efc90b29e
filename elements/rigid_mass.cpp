#include "elements/rigid_mass.hpp"

#include <Eigen/Eigenvalues>

namespace plica {

bool is_body(const RigidMass& body) {
  const Eigen::Vector3d J =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia).eigenvalues();
  const double slack = 1e-6 * J.cwiseAbs().maxCoeff();
  return body.mass >= 0 && J[0] >= -slack && J[2] <= J[0] + J[1] + slack;
}

Matrix6 rigid_mass_matrix(const RigidMass& body) {
  const Eigen::Vector3d& c = body.offset;
  Eigen::Matrix3d C;
  C << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  Matrix6 M;
  M << body.mass * Eigen::Matrix3d::Identity(), -body.mass * C, //
      body.mass * C, body.inertia - body.mass * C * C;
  return M;
}

} // namespace plica
