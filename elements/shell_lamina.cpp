#include "elements/shell_lamina.hpp"

#include <Eigen/LU>

namespace plica {

using Eigen::Matrix3d;
using Eigen::Vector3d;

LaminaFrame lamina_frame(const Matrix3d& G, const Vector3d& along) {
  LaminaFrame f;
  f.volume = G.determinant();
  const Vector3d e3 = G.col(0).cross(G.col(1)).normalized();
  const Vector3d e1 = (along - along.dot(e3) * e3).normalized();
  f.basis << e1, e3.cross(e1), e3;
  const Matrix3d c = f.basis.transpose() * G.inverse().transpose(); // c(a, i) = e_a . g^i
  const auto strain_row = [&](int a, int b) {
    return Eigen::RowVector3d(c(a, 0) * c(b, 0), c(a, 1) * c(b, 1),
                              (c(a, 0) * c(b, 1) + c(a, 1) * c(b, 0)) / 2);
  };
  f.in_plane << strain_row(0, 0), strain_row(1, 1), 2 * strain_row(0, 1);
  f.into_shear << 2 * strain_row(0, 2), 2 * strain_row(1, 2);
  f.shear = c.topLeftCorner<2, 2>() * c(2, 2); // e_1 and e_2 have no part along g^z
  return f;
}

Eigen::Matrix<double, 6, 3> stress_to_global(const Matrix3d& basis) {
  const Vector3d e1 = basis.col(0), e2 = basis.col(1);
  Eigen::Matrix<double, 6, 3> turn;
  for (int k = 0; k < 6; ++k) {
    const int i = k % 3, j = k < 3 ? i : (i + 1) % 3;
    turn.row(k) << e1[i] * e1[j], e2[i] * e2[j], e1[i] * e2[j] + e2[i] * e1[j];
  }
  return turn;
}

} // namespace plica
