#include "elements/rigid_mass.hpp"

namespace plica {

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
