#include "solve/decompositions.hpp"

namespace Eigen {
PLICA_DECOMPOSITIONS(template)
namespace internal {
PLICA_PRODUCTS(template)
}
} // namespace Eigen

namespace plica {

Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& A) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(A);
  return qr.householderQ() * Eigen::MatrixXd::Identity(A.rows(), A.cols());
}

} // namespace plica
