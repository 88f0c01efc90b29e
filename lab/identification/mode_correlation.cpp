#include "lab/identification/mode_correlation.hpp"

#include <cmath>
#include <complex>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

double mac(const VectorXcd& a, const VectorXcd& b) {
  const double size = a.squaredNorm() * b.squaredNorm();
  return size > 0 ? std::norm(a.dot(b)) / size : 0;
}

MatrixXd mac_matrix(const MatrixXcd& a, const MatrixXcd& b) {
  MatrixXd m(a.cols(), b.cols());
  for (Index i = 0; i < a.cols(); ++i)
    for (Index j = 0; j < b.cols(); ++j) m(i, j) = mac(a.col(i), b.col(j));
  return m;
}

VectorXd comac(const MatrixXcd& a, const MatrixXcd& b) {
  VectorXd c(a.rows());
  for (Index q = 0; q < a.rows(); ++q) {
    const double size = a.row(q).squaredNorm() * b.row(q).squaredNorm();
    const double sum = a.row(q).cwiseProduct(b.row(q).conjugate()).cwiseAbs().sum();
    c[q] = size > 0 ? sum * sum / size : 0;
  }
  return c;
}

VectorXd frac(const MatrixXcd& a, const MatrixXcd& b) {
  VectorXd f(a.cols());
  for (Index c = 0; c < a.cols(); ++c) f[c] = mac(a.col(c), b.col(c));
  return f;
}

VectorXd csac(const MatrixXcd& a, const MatrixXcd& b) {
  return frac(a.transpose(), b.transpose());
}

VectorXd csf(const MatrixXcd& a, const MatrixXcd& b) {
  VectorXd f(a.rows());
  for (Index r = 0; r < a.rows(); ++r) {
    const double size = a.row(r).squaredNorm() + b.row(r).squaredNorm();
    f[r] = size > 0 ? 2 * std::abs(a.row(r).dot(b.row(r))) / size : 0;
  }
  return f;
}

namespace {

// sum of squares of real and imaginary parts and of their product
struct Moments {
  double rr = 0, ii = 0, ri = 0;
};

Moments moments(const VectorXcd& shape) {
  return {shape.real().squaredNorm(), shape.imag().squaredNorm(), shape.real().dot(shape.imag())};
}

} // namespace

double phase_collinearity(const VectorXcd& shape) {
  const Moments m = moments(shape);
  const double sum = m.rr + m.ii;
  if (!(sum > 0)) return 0;
  return (std::pow(m.rr - m.ii, 2) + 4 * m.ri * m.ri) / (sum * sum);
}

VectorXcd turned_real(const VectorXcd& shape) {
  const Moments m = moments(shape);
  const double angle = 0.5 * std::atan2(2 * m.ri, m.rr - m.ii);
  VectorXcd turned = shape * std::polar(1., -angle);
  Index largest = 0;
  if (turned.size() == 0) return turned;
  turned.cwiseAbs().maxCoeff(&largest);
  if (turned[largest].real() < 0) turned = -turned;
  return turned;
}

} // namespace plica
