#include "solve/backbone.hpp"

#include "words/short_text.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Unknowns: harmonics of every modal coordinate over the amplitude, omega over that of the stuck
// mode, zeta.
class ModeBalance {
public:
  ModeBalance(const JointedStructure& s, int mode, const BackboneSettings& settings)
      : s_(s), basis_(orders(s, settings.harmonics), settings.samples) {
    const StuckModes stuck = stuck_modes(s);
    omega0_ = std::sqrt(stuck.lambda[mode]);
    shape_ = stuck.shapes.col(mode);
    shape_.cwiseAbs().maxCoeff(&pivot_);
  }

  const HarmonicBasis& basis() const { return basis_; }
  Index modes() const { return s_.lambda.size(); }
  Index size() const { return modes() * basis_.size() + 2; }
  double omega0() const { return omega0_; }

  VectorXd start() const {
    VectorXd y = VectorXd::Zero(size());
    for (Index r = 0; r < modes(); ++r) y[r * basis_.size() + first_harmonic()] = shape_[r];
    y[size() - 2] = 1;
    return y;
  }

  Residual residual(const VectorXd& y, double log10_amplitude) const {
    const Index p = basis_.size(), m = modes(), n = size();
    const double a = std::pow(10, log10_amplitude), omega = omega0_ * y[n - 2], zeta = y[n - 1];
    const double unit = omega0_ * omega0_ * a;
    Residual out{VectorXd::Zero(n), MatrixXd::Zero(n, n), VectorXd::Zero(n)};
    for (Index r = 0; r < m; ++r) add_mode(r, y, omega, zeta, out);
    if (!s_.added.empty()) add_dampers(y, omega, out);
    // Joints: J F(a J' y) over the unit.
    for (Index j = 0; j < s_.joints.cols(); ++j) {
      VectorXd x = VectorXd::Zero(p);
      for (Index r = 0; r < m; ++r) x += a * s_.joints(r, j) * y.segment(r * p, p);
      const HarmonicForce f = harmonic_force(s_.laws[std::size_t(j)], x, omega, basis_);
      const VectorXd by_log = (f.by_motion * x - f.force) / unit * std::log(10.);
      for (Index r = 0; r < m; ++r) {
        const double J = s_.joints(r, j);
        if (J == 0) continue;
        out.value.segment(r * p, p) += J / unit * f.force;
        out.by_motion.col(n - 2).segment(r * p, p) += J * omega0_ / unit * f.by_omega;
        out.by_parameter.segment(r * p, p) += J * by_log;
        for (Index c = 0; c < m; ++c)
          out.by_motion.block(r * p, c * p, p, p) += J * s_.joints(c, j) * a / unit * f.by_motion;
      }
    }
    const Index h = first_harmonic();
    out.value[n - 2] = -1;
    for (Index r = 0; r < m; ++r)
      for (Index i = r * p + h; i < r * p + h + 2; ++i) {
        out.value[n - 2] += y[i] * y[i];
        out.by_motion(n - 2, i) = 2 * y[i];
      }
    out.value[n - 1] = y[pivot_ * p + h + 1]; // phase
    out.by_motion(n - 1, pivot_ * p + h + 1) = 1;
    return out;
  }

  BackbonePoint point(const CurvePoint& c) const {
    const Index p = basis_.size(), n = size();
    BackbonePoint out{std::pow(10, c.p), omega0_ * c.x[n - 2], c.x[n - 1], {}};
    out.modes.resize(Index(basis_.orders.size()), modes());
    for (Index r = 0; r < modes(); ++r)
      for (std::size_t k = 0; k < basis_.orders.size(); ++k)
        out.modes(Index(k), r) = out.amplitude * amplitude(basis_, c.x.segment(r * p, p), k);
    return out;
  }

private:
  static std::vector<int> orders(const JointedStructure& s, int highest) {
    for (const JointLaw& law : s.laws)
      if (!law.is_odd()) return orders_up_to(highest, false);
    return orders_up_to(highest, true);
  }
  Index first_harmonic() const { return basis_.orders[0] == 0 ? 1 : 0; }

  // (lambda - W^2) + i W (2 zeta_r sqrt(lambda) - 2 zeta omega) + i eta lambda, over omega0^2.
  void add_mode(Index r, const VectorXd& y, double omega, double zeta, Residual& out) const {
    const Index p = basis_.size(), n = size();
    const double lambda = s_.lambda[r], unit = omega0_ * omega0_;
    const double c = 2 * s_.zeta[r] * std::sqrt(lambda);
    for (std::size_t k = 0; k < basis_.orders.size(); ++k) {
      const int order = basis_.orders[k];
      const double W = order * omega;
      const double re = (lambda - W * W) / unit;
      const double im = order == 0 ? 0 : (W * c - 2 * zeta * omega * W + s_.eta[r] * lambda) / unit;
      const double re_slope = -2 * order * W / unit * omega0_;
      const double im_slope = order * (c - 4 * zeta * omega) / unit * omega0_;
      const double im_zeta = -2 * omega * W / unit;
      const Index i = r * p + basis_.first(k);
      out.by_motion(i, i) += re;
      if (order == 0) {
        out.value[i] += re * y[i];
        continue;
      }
      const Complex q(y[i], y[i + 1]);
      const Complex value = Complex(re, im) * q, slope = Complex(re_slope, im_slope) * q,
                    by_zeta = Complex(0, im_zeta) * q;
      out.value[i] += value.real();
      out.value[i + 1] += value.imag();
      out.by_motion(i, i + 1) -= im;
      out.by_motion(i + 1, i) += im;
      out.by_motion(i + 1, i + 1) += re;
      out.by_motion(i, n - 2) += slope.real();
      out.by_motion(i + 1, n - 2) += slope.imag();
      out.by_motion(i, n - 1) += by_zeta.real();
      out.by_motion(i + 1, n - 1) += by_zeta.imag();
    }
  }

  // B G(i W) B' q, over omega0^2.
  void add_dampers(const VectorXd& y, double omega, Residual& out) const {
    const Index p = basis_.size(), n = size();
    const double unit = omega0_ * omega0_;
    for (std::size_t k = 0; k < basis_.orders.size(); ++k) {
      const int order = basis_.orders[k];
      const Index at = basis_.first(k);
      Eigen::VectorXcd q(modes());
      for (Index r = 0; r < modes(); ++r) q[r] = amplitude(basis_, y.segment(r * p, p), k);
      const auto coupling = [&](const Eigen::VectorXcd& added) -> Eigen::MatrixXcd {
        return s_.dampers * (added / unit).asDiagonal() * s_.dampers.transpose();
      };
      const Eigen::MatrixXcd D = coupling(added_at(s_, order, omega));
      const Eigen::VectorXcd value = D * q;
      const Eigen::VectorXcd slope = coupling(added_slope(s_, order, omega)) * q * omega0_;
      for (Index r = 0; r < modes(); ++r) {
        const Index i = r * p + at;
        out.value[i] += value[r].real();
        out.by_motion(i, n - 2) += slope[r].real();
        if (order > 0) {
          out.value[i + 1] += value[r].imag();
          out.by_motion(i + 1, n - 2) += slope[r].imag();
        }
        for (Index c = 0; c < modes(); ++c) {
          const Index j = c * p + at;
          out.by_motion(i, j) += D(r, c).real();
          if (order == 0) continue;
          out.by_motion(i, j + 1) -= D(r, c).imag();
          out.by_motion(i + 1, j) += D(r, c).imag();
          out.by_motion(i + 1, j + 1) += D(r, c).real();
        }
      }
    }
  }

  const JointedStructure& s_;
  HarmonicBasis basis_;
  double omega0_ = 0;
  VectorXd shape_;
  Index pivot_ = 0;
};

} // namespace

StuckModes stuck_modes(const JointedStructure& structure) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(stuck_stiffness(structure));
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Backbone backbone(const JointedStructure& structure, int mode, const BackboneSettings& settings) {
  const ModeBalance balance(structure, mode, settings);
  const ResidualFunction f = [&](const VectorXd& y, double p) { return balance.residual(y, p); };
  const Curve curve = follow(f, balance.start(),
                             {.from = std::log10(settings.from),
                              .to = std::log10(settings.to),
                              .largest_step = settings.largest_step,
                              .tolerance = settings.tolerance});
  Backbone out{balance.basis().orders, {}, curve.complete, ""};
  for (const CurvePoint& c : curve.points) out.points.push_back(balance.point(c));
  if (!curve.complete) {
    out.reason = curve.reason;
    if (!curve.points.empty())
      out.reason += "; reached the amplitude " + short_text(out.points.back().amplitude, 4);
  }
  return out;
}

} // namespace plica
