#include "lab/identification/circle_fit.hpp"

#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

struct Circle {
  Complex centre;
  double radius = 0;
};

// x^2 + y^2 = 2 a x + 2 b y + c, linear least squares.
Circle circle_through(const VectorXcd& z) {
  MatrixXd A(z.size(), 3);
  A << 2 * z.real(), 2 * z.imag(), VectorXd::Ones(z.size());
  const Eigen::Vector3d s = A.colPivHouseholderQr().solve(z.cwiseAbs2());
  const double square = s[2] + s[0] * s[0] + s[1] * s[1];
  return {{s[0], s[1]}, std::sqrt(std::max(0., square))};
}

// w^2 = a + b g tan((theta - gamma) / 2)
struct Sweep {
  double a = 0, b = 0, gamma = 0;
};

// The addition theorem makes it linear in a, s = tan(gamma / 2), a s, b, b s; Gauss-Newton in the
// three numbers themselves follows.
Sweep fit_sweep(const VectorXd& square, const VectorXd& g, const VectorXd& theta) {
  const VectorXd tau = (theta / 2).array().tan();
  MatrixXd A(theta.size(), 5);
  A << VectorXd::Ones(theta.size()), -square.cwiseProduct(tau), tau, g.cwiseProduct(tau), -g;
  const VectorXd scale = A.colwise().norm().transpose().cwiseMax(1e-300);
  const VectorXd c = (A * scale.cwiseInverse().asDiagonal())
                         .colPivHouseholderQr()
                         .solve(square)
                         .cwiseQuotient(scale);
  Sweep sweep{.a = c[0], .b = c[3], .gamma = 2 * std::atan(c[1])};
  for (int step = 0; step < 50; ++step) {
    const Eigen::ArrayXd t = ((theta.array() - sweep.gamma) / 2).tan();
    MatrixXd J(theta.size(), 3);
    J << VectorXd::Ones(theta.size()), (g.array() * t).matrix(),
        (-sweep.b / 2 * g.array() * (1 + t.square())).matrix();
    const VectorXd rest = square.array() - sweep.a - sweep.b * g.array() * t;
    // Points far from resonance, where the tangent grows, say little: weight by its slope.
    const VectorXd weight = (1 + t.square()).inverse();
    const VectorXd size = J.colwise().norm().transpose().cwiseMax(1e-300);
    const VectorXd d = (weight.asDiagonal() * J * size.cwiseInverse().asDiagonal())
                           .colPivHouseholderQr()
                           .solve(weight.cwiseProduct(rest))
                           .cwiseQuotient(size);
    sweep.a += d[0];
    sweep.b += d[1];
    sweep.gamma += d[2];
    if (std::abs(d[0]) < 1e-15 * sweep.a && std::abs(d[2]) < 1e-14) break;
  }
  return sweep;
}

CircleFit failed(std::string reason) {
  CircleFit fit;
  fit.reason = std::move(reason);
  return fit;
}

} // namespace

CircleFit fit_circle(const VectorXd& hertz, const VectorXcd& values, FrfQuantity quantity,
                     DampingModel model) {
  if (hertz.size() < 5) return failed("fewer than five lines in the band");
  const VectorXd w = 2 * std::numbers::pi * hertz;
  const bool viscous = model == DampingModel::viscous;
  // To mobility or receptance.
  VectorXcd z = values;
  for (Index f = 0; f < w.size(); ++f)
    z[f] *= std::pow(Complex(0, w[f]), (viscous ? 1 : 0) - derivatives(quantity));
  const Circle circle = circle_through(z);
  if (!(circle.radius > 0)) return failed("the points lie on no circle");
  const VectorXcd arms = z.array() - circle.centre;
  CircleFit fit;
  fit.centre = circle.centre;
  fit.radius = circle.radius;
  fit.misfit = (arms.cwiseAbs().array() - circle.radius).matrix().norm() /
               (circle.radius * std::sqrt(double(z.size())));
  // Where the angle runs fastest is near resonance; angles are taken from there, so that none of
  // the band wraps. They fall with frequency.
  Index fastest = 0;
  double rate = 0;
  for (Index f = 0; f + 1 < w.size(); ++f) {
    const double turn = std::abs(std::arg(arms[f + 1] / arms[f])) / (w[f + 1] - w[f]);
    if (turn > rate) {
      rate = turn;
      fastest = f;
    }
  }
  const Complex from = arms[fastest];
  VectorXd theta(w.size());
  for (Index f = 0; f < w.size(); ++f) theta[f] = -std::arg(arms[f] / from);
  const VectorXd g = viscous ? w : VectorXd::Ones(w.size());
  const Sweep sweep = fit_sweep(w.cwiseAbs2(), g, theta);
  if (!(sweep.a > 0 && sweep.b > 0)) return failed("the points do not sweep through a resonance");
  const double natural = std::sqrt(sweep.a);
  fit.frequency = natural / (2 * std::numbers::pi);
  fit.damping = viscous ? sweep.b / (2 * natural) : sweep.b / sweep.a / 2;
  // At resonance the arm is A / (2 b) for mobility and A / (2 i b) for receptance.
  const Complex arm = circle.radius * std::polar(1., std::arg(from) - sweep.gamma);
  fit.residue = 2. * sweep.b * arm * (viscous ? Complex(1, 0) : Complex(0, 1));
  fit.good = true;
  return fit;
}

} // namespace plica
