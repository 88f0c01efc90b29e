#include "elements/bushing.hpp"

namespace plica {
namespace {

Matrix6 rotation(const Bushing& bushing) {
  Matrix6 R = Matrix6::Zero();
  R.topLeftCorner<3, 3>() = bushing.axes.transpose();
  R.bottomRightCorner<3, 3>() = bushing.axes.transpose();
  return R;
}

// Motion at the end of a rigid arm: u + theta x arm.
Matrix6 carried_by(const Eigen::Vector3d& a) {
  Matrix6 T = Matrix6::Identity();
  T.topRightCorner<3, 3>() << 0, a.z(), -a.y(), -a.z(), 0, a.x(), a.y(), -a.x(), 0;
  return T;
}

} // namespace

Matrix12 bushing_matrix(const Bushing& bushing, const Eigen::Vector3d& node1,
                        const Eigen::Vector3d& node2, const Eigen::Vector3d& point) {
  Eigen::Matrix<double, 6, 12> difference;
  difference << -carried_by(point - node1), carried_by(point - node2);
  difference = (rotation(bushing) * difference).eval();
  return difference.transpose() * bushing.law * difference;
}

Matrix6 ground_bushing_matrix(const Bushing& bushing) {
  const Matrix6 R = rotation(bushing);
  return R.transpose() * bushing.law * R;
}

} // namespace plica
