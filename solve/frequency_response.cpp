#include "solve/frequency_response.hpp"

namespace plica {

using Eigen::MatrixXcd;
using Eigen::VectorXd;

MatrixXcd frequency_response(const ModalModel& model, int load, const VectorXd& omega) {
  const Eigen::Index modes = model.lambda.size();
  const Eigen::ArrayXd structural = model.lambda.array() * model.eta.array();
  const Eigen::ArrayXd viscous = 2 * model.zeta.array() * model.lambda.array().max(0).sqrt();
  const Eigen::ArrayXd force = model.input.col(load).array();
  MatrixXcd response(omega.size(), model.output.rows());
  constexpr Eigen::Index block = 64; // frequencies whose modal coordinates stay in the cache
#pragma omp parallel for schedule(static)
  for (Eigen::Index first = 0; first < omega.size(); first += block) {
    const Eigen::Index count = std::min(block, omega.size() - first);
    // Real and imaginary parts apart: two real products in place of complex ones.
    Eigen::MatrixXd real(modes, count), imaginary(modes, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const double w = omega[first + k];
      const Eigen::ArrayXd stiff = model.lambda.array() - w * w, damp = structural + viscous * w;
      const Eigen::ArrayXd scale = force / (stiff.square() + damp.square());
      real.col(k) = scale * stiff;
      imaginary.col(k) = -scale * damp;
    }
    const Eigen::MatrixXd re = model.output * real, im = model.output * imaginary;
    response.middleRows(first, count).real() = re.transpose();
    response.middleRows(first, count).imag() = im.transpose();
  }
  return response;
}

} // namespace plica
