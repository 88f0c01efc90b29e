#include "solve/harmonic_balance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;

// Between the harmonics of one joint and its values over the period.
struct TimeGrid {
  MatrixXd to_time;       // samples x (2H + 1)
  MatrixXd to_harmonics;  // (2H + 1) x samples

  TimeGrid(int harmonics, int samples) {
    if (samples < 2 * (harmonics + 1) + 1)
      throw std::invalid_argument("too few samples of a period for so many harmonics");
    const int p = 2 * harmonics + 1;
    to_time.resize(samples, p);
    to_harmonics.resize(p, samples);
    for (int k = 0; k < samples; ++k) {
      const double tau = 2 * pi * k / samples;
      to_time(k, 0) = 1;
      to_harmonics(0, k) = 1. / samples;
      for (int n = 1; n <= harmonics; ++n) {
        to_time(k, 2 * n - 1) = std::cos(n * tau);
        to_time(k, 2 * n) = -std::sin(n * tau);
        to_harmonics(2 * n - 1, k) = 2. / samples * std::cos(n * tau);
        to_harmonics(2 * n, k) = -2. / samples * std::sin(n * tau);
      }
    }
  }
};

// Complex amplitude of harmonic n among the real unknowns of a joint.
Complex harmonic(const Eigen::Ref<const VectorXd>& p, int n) {
  return n == 0 ? Complex(p[0], 0) : Complex(p[2 * n - 1], p[2 * n]);
}

class Balance {
public:
  Balance(const JointedStructure& s, double level, const HarmonicSettings& settings)
      : s_(s), level_(level), settings_(settings), grid_(settings.harmonics, settings.samples) {}

  Index joints() const { return s_.joints.cols(); }
  Index per_joint() const { return 2 * settings_.harmonics + 1; }
  Index unknowns() const { return joints() * per_joint(); }

  VectorXcd dynamic_stiffness(int n, double omega) const {
    const double W = n * omega;
    VectorXcd D(s_.lambda.size());
    for (Index r = 0; r < D.size(); ++r)
      D[r] = Complex(s_.lambda[r] - W * W,
                     n == 0 ? 0
                            : s_.lambda[r] * s_.eta[r] + 2 * s_.zeta[r] * std::sqrt(s_.lambda[r]) * W);
    return D;
  }

  // Forces of all joints over the harmonics, and their derivatives, one block per joint.
  void joint_forces(const VectorXd& motion, VectorXd& force, std::vector<MatrixXd>& by_motion) const {
    const Index p = per_joint();
    force.resize(unknowns());
    by_motion.resize(std::size_t(joints()));
    for (Index j = 0; j < joints(); ++j) {
      const PeriodForces f = period_forces(s_.laws[std::size_t(j)],
                                           grid_.to_time * motion.segment(j * p, p), grid_.to_time);
      force.segment(j * p, p) = grid_.to_harmonics * f.force;
      by_motion[std::size_t(j)] = grid_.to_harmonics * f.derivative;
    }
  }

  HarmonicResidual residual(const VectorXd& motion, double omega) const {
    const Index p = per_joint();
    VectorXd force;
    std::vector<MatrixXd> stiffness;
    joint_forces(motion, force, stiffness);
    HarmonicResidual out{motion, MatrixXd::Identity(unknowns(), unknowns()),
                         VectorXd::Zero(unknowns())};
    const MatrixXcd J = s_.joints.cast<Complex>();
    for (int n = 0; n <= settings_.harmonics; ++n) {
      const VectorXcd D = dynamic_stiffness(n, omega);
      const MatrixXcd DJ = D.cwiseInverse().asDiagonal() * J;
      const MatrixXcd G = J.transpose() * DJ;
      const VectorXcd modal = modal_motion(n, D, force);
      VectorXcd slope(D.size());
      for (Index r = 0; r < D.size(); ++r)
        slope[r] = Complex(-2. * n * n * omega, 2. * n * s_.zeta[r] * std::sqrt(s_.lambda[r]));
      const VectorXcd by_omega = DJ.transpose() * slope.cwiseProduct(modal);
      const VectorXcd moved = J.transpose() * modal;
      for (Index j = 0; j < joints(); ++j) {
        const Index row = j * p + (n == 0 ? 0 : 2 * n - 1);
        out.value[row] -= moved[j].real();
        out.by_omega[row] = by_omega[j].real();
        if (n > 0) {
          out.value[row + 1] -= moved[j].imag();
          out.by_omega[row + 1] = by_omega[j].imag();
        }
        for (Index i = 0; i < joints(); ++i) {
          const MatrixXd& K = stiffness[std::size_t(i)];
          const Complex g = G(j, i);
          if (n == 0) {
            out.by_motion.row(row).segment(i * p, p) += g.real() * K.row(0);
            continue;
          }
          const auto re = K.row(2 * n - 1), im = K.row(2 * n);
          out.by_motion.row(row).segment(i * p, p) += g.real() * re - g.imag() * im;
          out.by_motion.row(row + 1).segment(i * p, p) += g.imag() * re + g.real() * im;
        }
      }
    }
    return out;
  }

  // Amplitudes of the modes in harmonic n under excitation and joint forces.
  VectorXcd modal_motion(int n, const VectorXcd& D, const VectorXd& force) const {
    const Index p = per_joint();
    VectorXcd load = VectorXcd::Zero(s_.lambda.size());
    if (n == 1) load = level_ * s_.input.cast<Complex>();
    for (Index j = 0; j < joints(); ++j)
      load -= s_.joints.col(j) * harmonic(force.segment(j * p, p), n);
    return load.cwiseQuotient(D);
  }

  PeriodicPoint point(const VectorXd& motion, double omega) const {
    const Index p = per_joint();
    PeriodicPoint out;
    out.omega = omega;
    out.joints.resize(settings_.harmonics + 1, joints());
    out.modes.resize(settings_.harmonics + 1, s_.lambda.size());
    VectorXd force;
    std::vector<MatrixXd> unused;
    joint_forces(motion, force, unused);
    for (int n = 0; n <= settings_.harmonics; ++n) {
      for (Index j = 0; j < joints(); ++j)
        out.joints(n, j) = harmonic(motion.segment(j * p, p), n);
      out.modes.row(n) = modal_motion(n, dynamic_stiffness(n, omega), force).transpose();
    }
    return out;
  }

  // Motion with every joint stuck, the linear answer at small levels.
  VectorXd stuck(double omega) const {
    const MatrixXcd J = s_.joints.cast<Complex>();
    const VectorXcd D = dynamic_stiffness(1, omega);
    const MatrixXcd DJ = D.cwiseInverse().asDiagonal() * J;
    MatrixXcd A = MatrixXcd::Identity(joints(), joints());
    const MatrixXcd G = J.transpose() * DJ;
    for (Index j = 0; j < joints(); ++j) A.col(j) += G.col(j) * s_.laws[std::size_t(j)].stuck_stiffness();
    const VectorXcd x =
        A.partialPivLu().solve(VectorXcd(level_ * (DJ.transpose() * s_.input.cast<Complex>())));
    VectorXd motion = VectorXd::Zero(unknowns());
    for (Index j = 0; j < joints(); ++j) {
      motion[j * per_joint() + 1] = x[j].real();
      motion[j * per_joint() + 2] = x[j].imag();
    }
    return motion;
  }

private:
  const JointedStructure& s_;
  double level_;
  HarmonicSettings settings_;
  TimeGrid grid_;
};

VectorXd real_motion(const MatrixXcd& joints, Index per_joint) {
  VectorXd motion(joints.cols() * per_joint);
  for (Index j = 0; j < joints.cols(); ++j) {
    motion[j * per_joint] = joints(0, j).real();
    for (Index n = 1; n < joints.rows(); ++n) {
      motion[j * per_joint + 2 * n - 1] = joints(n, j).real();
      motion[j * per_joint + 2 * n] = joints(n, j).imag();
    }
  }
  return motion;
}

} // namespace

HarmonicResidual harmonic_residual(const JointedStructure& structure, double omega, double level,
                                   const HarmonicSettings& settings, const VectorXd& motion) {
  return Balance(structure, level, settings).residual(motion, omega);
}

PeriodicSolution periodic_response(const JointedStructure& structure, double omega, double level,
                                   const HarmonicSettings& settings, const MatrixXcd& guess) {
  const Balance balance(structure, level, settings);
  VectorXd x = guess.size() > 0 ? real_motion(guess, balance.per_joint()) : balance.stuck(omega);
  PeriodicSolution found;
  for (int k = 1; k <= settings.newton_steps; ++k) {
    const HarmonicResidual r = balance.residual(x, omega);
    found.residual = r.value.norm() / std::max(1e-300, x.norm());
    found.point.iterations = k;
    if (found.residual < settings.tolerance) {
      found.converged = true;
      break;
    }
    x -= r.by_motion.partialPivLu().solve(r.value);
    if (!x.allFinite()) break;
  }
  const int iterations = found.point.iterations;
  found.point = balance.point(x, omega);
  found.point.iterations = iterations;
  return found;
}

Branch follow_frequency(const JointedStructure& structure, double level,
                        const HarmonicSettings& settings) {
  Branch branch;
  const Balance balance(structure, level, settings);
  const double range = std::abs(settings.to - settings.from);
  const double sign = settings.to > settings.from ? 1 : -1;
  const double largest = settings.largest_step > 0 ? settings.largest_step : range / 50;
  double step = settings.first_step > 0 ? settings.first_step : range / 100;
  const PeriodicSolution start = periodic_response(structure, settings.from, level, settings);
  if (!start.converged) {
    branch.reason = "no periodic response at the start";
    return branch;
  }
  branch.points.push_back(start.point);
  const Index n = balance.unknowns();
  VectorXd x = real_motion(start.point.joints, balance.per_joint());
  double omega = settings.from;
  // Tangent of the curve over (x / size, omega / range); the size follows the motion.
  double size = std::max(1e-300, x.norm());
  VectorXd tangent = VectorXd::Zero(n + 1);
  tangent[n] = sign;
  while (static_cast<int>(branch.points.size()) < settings.most_points) {
    size = std::max(1e-300, x.norm());
    const HarmonicResidual here = balance.residual(x, omega);
    // dx/dw, and the direction that goes on as before.
    const VectorXd slope = -here.by_motion.partialPivLu().solve(here.by_omega);
    VectorXd next(n + 1);
    next << slope / size, 1 / range;
    next.normalize();
    if (settings.around_folds ? next.dot(tangent) < 0 : next[n] * sign < 0) next = -next;
    tangent = next;
    bool accepted = false;
    while (!accepted) {
      const double length = step / range; // along the curve
      VectorXd xs = x + size * length * tangent.head(n);
      double ws = omega + range * length * tangent[n];
      int k = 1;
      for (; k <= settings.newton_steps; ++k) {
        const HarmonicResidual r = balance.residual(xs, ws);
        if (r.value.norm() < settings.tolerance * std::max(1e-300, xs.norm())) break;
        MatrixXd A(n + 1, n + 1);
        A.topLeftCorner(n, n) = r.by_motion * size;
        A.topRightCorner(n, 1) = r.by_omega * range;
        A.bottomRows(1) = tangent.transpose();
        VectorXd b(n + 1);
        b << r.value, ((xs - x) / size).dot(tangent.head(n)) +
                          (ws - omega) / range * tangent[n] - length;
        const VectorXd d = A.partialPivLu().solve(b);
        if (!d.allFinite()) {
          k = settings.newton_steps + 1;
          break;
        }
        xs -= size * d.head(n);
        ws -= range * d[n];
      }
      accepted = k <= settings.newton_steps;
      if (accepted) {
        x = xs;
        omega = ws;
        branch.points.push_back(balance.point(x, omega));
        branch.points.back().iterations = k;
        if (k <= 4) step = std::min(1.5 * step, largest);
        if (k >= 8) step /= 1.5;
        continue;
      }
      step /= 2;
      if (step < 1e-7 * range) {
        branch.reason = "the branch could not be followed beyond " +
                        std::to_string(omega / (2 * pi)) + " Hz";
        return branch;
      }
    }
    if ((omega - settings.to) * sign >= 0) {
      branch.complete = true;
      return branch;
    }
    if ((omega - settings.from) * sign < -0.01 * range) {
      branch.reason = "the branch turned back to its start";
      return branch;
    }
  }
  branch.reason = "more points than allowed";
  return branch;
}

} // namespace plica
