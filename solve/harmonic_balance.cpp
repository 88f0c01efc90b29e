#include "solve/harmonic_balance.hpp"

#include "words/short_text.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::numbers::pi;

std::vector<int> orders_of(const JointedStructure& s, const HarmonicSettings& settings) {
  if (settings.method == JointMethod::describing_function) return {1};
  const bool odd =
      std::all_of(s.laws.begin(), s.laws.end(), [](const JointLaw& l) { return l.is_odd(); });
  return orders_up_to(settings.harmonics, odd);
}

// Static flexibility of each joint.
VectorXd flexibility(const JointedStructure& s) {
  VectorXd g(s.joints.cols());
  for (Index j = 0; j < g.size(); ++j)
    g[j] = std::max(1e-300, (s.joints.col(j).array().square() / s.lambda.array()).sum());
  return g;
}

// The equations over scaled unknowns: motion of a joint over the root of its flexibility.
class Balance {
public:
  Balance(const JointedStructure& s, const HarmonicSettings& settings)
      : s_(s), method_(settings.method), basis_(orders_of(s, settings), settings.samples),
        scale_(flexibility(s).cwiseSqrt()), laws_(s.laws),
        J_(s.joints * scale_.cwiseInverse().asDiagonal()) {}

  const HarmonicBasis& basis() const { return basis_; }
  Index joints() const { return s_.joints.cols(); }
  Index unknowns() const { return joints() * basis_.size(); }

  // x - J' D^-1 (f - J F), harmonic by harmonic; the parameter is omega, or the level.
  Residual residual(const VectorXd& scaled, double omega, double level, bool by_level) const {
    const Index p = basis_.size();
    Residual out{scaled, MatrixXd::Identity(unknowns(), unknowns()), VectorXd::Zero(unknowns())};
    const std::vector<HarmonicForce> forces = joint_forces(scaled, omega);
    for (std::size_t k = 0; k < basis_.orders.size(); ++k) {
      const int n = basis_.orders[k];
      const Index at = basis_.first(k);
      const DynamicStiffness D(s_, n, omega);
      const MatrixXcd DJ = D.solve(J_.cast<Complex>());
      const MatrixXcd G = J_.transpose() * DJ;
      VectorXcd load = VectorXcd::Zero(joints()), load_slope = load; // J' D^-1 of the excitation
      if (n == 1) load = DJ.transpose() * s_.input;
      VectorXcd F(joints()), F_slope(joints());
      for (Index j = 0; j < joints(); ++j) {
        F[j] = amplitude(basis_, forces[std::size_t(j)].force, k);
        F_slope[j] = amplitude(basis_, forces[std::size_t(j)].by_omega, k);
      }
      const VectorXcd moved = level * load - G * F;
      VectorXcd by_parameter = -load;
      if (!by_level) {
        VectorXcd modal = -(DJ * F);
        if (n == 1) modal += level * D.solve(s_.input.cast<Complex>());
        by_parameter = DJ.transpose() * D.by_omega(modal) + G * F_slope;
      }
      for (Index j = 0; j < joints(); ++j) {
        const Index row = j * p + at;
        out.value[row] -= moved[j].real();
        out.by_parameter[row] = by_parameter[j].real();
        if (n > 0) {
          out.value[row + 1] -= moved[j].imag();
          out.by_parameter[row + 1] = by_parameter[j].imag();
        }
        for (Index i = 0; i < joints(); ++i) {
          const MatrixXd& K = forces[std::size_t(i)].by_motion;
          const Complex g = G(j, i);
          auto re = out.by_motion.row(row).segment(i * p, p);
          if (n == 0) {
            re += g.real() * K.row(at);
            continue;
          }
          re += g.real() * K.row(at) - g.imag() * K.row(at + 1);
          out.by_motion.row(row + 1).segment(i * p, p) +=
              g.imag() * K.row(at) + g.real() * K.row(at + 1);
        }
      }
    }
    return out;
  }

  PeriodicPoint point(const VectorXd& scaled, double omega, double level) const {
    const Index p = basis_.size();
    PeriodicPoint out;
    out.omega = omega;
    out.level = level;
    const auto harmonics = Index(basis_.orders.size());
    out.joints.resize(harmonics, joints());
    out.modes.resize(harmonics, s_.lambda.size());
    const std::vector<HarmonicForce> forces = joint_forces(scaled, omega);
    for (Index k = 0; k < harmonics; ++k) {
      const int n = basis_.orders[std::size_t(k)];
      VectorXcd load = VectorXcd::Zero(s_.lambda.size());
      if (n == 1) load = level * s_.input.cast<Complex>();
      for (Index j = 0; j < joints(); ++j) {
        out.joints(k, j) = scale_[j] * amplitude(basis_, scaled.segment(j * p, p), std::size_t(k));
        load -= J_.col(j) * amplitude(basis_, forces[std::size_t(j)].force, std::size_t(k));
      }
      out.modes.row(k) = DynamicStiffness(s_, n, omega).solve(load).transpose();
    }
    return out;
  }

  // Motion with every joint stuck, the linear answer at small levels.
  VectorXd stuck(double omega, double level) const {
    VectorXd motion = VectorXd::Zero(unknowns());
    const Index k = first_harmonic(basis_.orders);
    if (k == long(basis_.orders.size())) return motion;
    const MatrixXcd DJ = DynamicStiffness(s_, 1, omega).solve(J_.cast<Complex>());
    MatrixXcd A = J_.transpose() * DJ;
    for (Index j = 0; j < joints(); ++j)
      A.col(j) *= laws_[std::size_t(j)].stuck_stiffness() * scale_[j] * scale_[j];
    A.diagonal().array() += 1;
    const VectorXcd x = A.partialPivLu().solve(VectorXcd(level * (DJ.transpose() * s_.input)));
    for (Index j = 0; j < joints(); ++j) {
      motion[j * basis_.size() + basis_.first(std::size_t(k))] = x[j].real();
      motion[j * basis_.size() + basis_.first(std::size_t(k)) + 1] = x[j].imag();
    }
    return motion;
  }

  // Motion by the describing function, all higher harmonics at rest.
  VectorXd linearised(double omega, double level, HarmonicSettings settings) const {
    settings.method = JointMethod::describing_function;
    const PeriodicSolution first = periodic_response(s_, omega, level, settings);
    MatrixXcd motion = MatrixXcd::Zero(Index(basis_.orders.size()), joints());
    const Index k = first_harmonic(basis_.orders);
    if (first.converged) motion.row(k) = first.point.joints.row(0);
    return scaled(motion);
  }

  VectorXd scaled(const MatrixXcd& motion) const {
    VectorXd x(unknowns());
    for (Index j = 0; j < joints(); ++j)
      x.segment(j * basis_.size(), basis_.size()) =
          plica::unknowns(basis_, motion.col(j)) / scale_[j];
    return x;
  }

  const VectorXd& scale() const { return scale_; }

private:
  // Work-conjugate to the scaled motion.
  std::vector<HarmonicForce> joint_forces(const VectorXd& scaled, double omega) const {
    const Index p = basis_.size();
    std::vector<HarmonicForce> forces;
    forces.reserve(laws_.size());
    for (Index j = 0; j < joints(); ++j) {
      const VectorXd x = scale_[j] * scaled.segment(j * p, p);
      HarmonicForce f = method_ == JointMethod::describing_function
                            ? linearised_force(laws_[std::size_t(j)], x, omega)
                            : harmonic_force(laws_[std::size_t(j)], x, omega, basis_);
      f.force *= scale_[j];
      f.by_omega *= scale_[j];
      f.by_motion *= scale_[j] * scale_[j];
      forces.push_back(std::move(f));
    }
    return forces;
  }

  const JointedStructure& s_;
  JointMethod method_;
  HarmonicBasis basis_;
  VectorXd scale_;
  const std::vector<JointLaw>& laws_;
  MatrixXd J_;
};

ContinuationSettings continuation(const HarmonicSettings& s) {
  return {.from = s.from,
          .to = s.to,
          .largest_step = s.largest_step,
          .tolerance = s.tolerance,
          .most_points = s.most_points};
}

// Motion at a frequency: from all joints stuck, or where that is too far off, from a low level
// upwards.
VectorXd start_of(const Balance& balance, double omega, double level,
                  const HarmonicSettings& settings) {
  const VectorXd stuck = balance.stuck(omega, level);
  ContinuationSettings control = continuation(settings);
  const ResidualFunction at = [&](const VectorXd& x, double w) {
    return balance.residual(x, w, level, false);
  };
  const Solution direct = solve_at(at, stuck, omega, control);
  if (direct.converged) return direct.x;
  if (settings.method == JointMethod::harmonic_balance) {
    const Solution seeded =
        solve_at(at, balance.linearised(omega, level, settings), omega, control);
    if (seeded.converged) return seeded.x;
  }
  control.from = 1e-3 * level;
  control.to = level;
  control.largest_step = 0;
  const ResidualFunction over_level = [&](const VectorXd& x, double l) {
    return balance.residual(x, omega, l, true);
  };
  const Curve curve = follow(over_level, balance.stuck(omega, control.from), control);
  return curve.complete ? curve.points.back().x : stuck;
}

Branch branch_of(const Balance& balance, Curve curve, const std::string& where, double unit,
                 const std::function<PeriodicPoint(const CurvePoint&)>& point) {
  Branch branch{balance.basis().orders, {}, curve.complete, ""};
  for (const CurvePoint& c : curve.points) {
    branch.points.push_back(point(c));
    branch.points.back().stable = c.same_side;
    branch.points.back().iterations = c.iterations;
  }
  if (curve.complete) return branch;
  branch.reason = curve.reason;
  if (!curve.points.empty())
    branch.reason += "; reached " + where + short_text(curve.points.back().p / unit, 6);
  return branch;
}

} // namespace

MatrixXd stuck_stiffness(const JointedStructure& s) {
  MatrixXd K = s.lambda.asDiagonal();
  const VectorXd g = flexibility(s);
  for (Index j = 0; j < s.joints.cols(); ++j) {
    const JointLaw& law = s.laws[std::size_t(j)];
    const double held = law.coulomb.force > 0 ? 1e3 / g[j] : 0;
    K += (law.stuck_stiffness() + held) * s.joints.col(j) * s.joints.col(j).transpose();
  }
  return K;
}

Residual harmonic_residual(const JointedStructure& structure, double omega, double level,
                           const HarmonicSettings& settings, const VectorXd& motion) {
  const Balance balance(structure, settings);
  const Index p = balance.basis().size();
  VectorXd scale(balance.unknowns());
  for (Index j = 0; j < balance.joints(); ++j)
    scale.segment(j * p, p).setConstant(balance.scale()[j]);
  Residual r = balance.residual(motion.cwiseQuotient(scale), omega, level, false);
  r.value = r.value.cwiseProduct(scale);
  r.by_motion = scale.asDiagonal() * r.by_motion * scale.cwiseInverse().asDiagonal();
  r.by_parameter = r.by_parameter.cwiseProduct(scale);
  return r;
}

PeriodicSolution periodic_response(const JointedStructure& structure, double omega, double level,
                                   const HarmonicSettings& settings, const MatrixXcd& guess) {
  const Balance balance(structure, settings);
  const ResidualFunction f = [&](const VectorXd& x, double w) {
    return balance.residual(x, w, level, false);
  };
  const Solution s =
      solve_at(f, guess.size() > 0 ? balance.scaled(guess) : balance.stuck(omega, level), omega,
               continuation(settings));
  PeriodicSolution found{balance.basis().orders, s.converged, balance.point(s.x, omega, level),
                         s.residual};
  found.point.iterations = s.iterations;
  return found;
}

Branch follow_frequency(const JointedStructure& structure, double level,
                        const HarmonicSettings& settings) {
  const Balance balance(structure, settings);
  const ResidualFunction f = [&](const VectorXd& x, double w) {
    return balance.residual(x, w, level, false);
  };
  const VectorXd start = start_of(balance, settings.from, level, settings);
  return branch_of(balance, follow(f, start, continuation(settings)), "Hz ", 2 * pi,
                   [&](const CurvePoint& c) { return balance.point(c.x, c.p, level); });
}

Branch follow_level(const JointedStructure& structure, double omega,
                    const HarmonicSettings& settings) {
  const Balance balance(structure, settings);
  const ResidualFunction f = [&](const VectorXd& x, double level) {
    return balance.residual(x, omega, level, true);
  };
  return branch_of(balance, follow(f, balance.stuck(omega, settings.from), continuation(settings)),
                   "level ", 1,
                   [&](const CurvePoint& c) { return balance.point(c.x, omega, c.p); });
}

Sweep sweep_over(const Branch& branch, bool upwards) {
  Sweep sweep;
  const auto count = long(branch.points.size());
  if (count == 0) return sweep;
  const bool rising = branch.points.back().omega >= branch.points.front().omega;
  const double sign = upwards ? 1 : -1;
  const long step = rising == upwards ? 1 : -1;
  long i = step > 0 ? 0 : count - 1;
  sweep.points.push_back(std::size_t(i));
  double reached = branch.points[std::size_t(i)].omega;
  bool turned = false;
  for (i += step; i >= 0 && i < count; i += step) {
    const double omega = branch.points[std::size_t(i)].omega;
    if (sign * (omega - reached) <= 0 || !branch.points[std::size_t(i)].stable) {
      turned = true;
      continue;
    }
    if (turned) sweep.jumps.push_back(reached);
    turned = false;
    reached = omega;
    sweep.points.push_back(std::size_t(i));
  }
  return sweep;
}

VectorXd cycle_energies(const JointedStructure& structure, const PeriodicPoint& point,
                        const std::vector<int>& orders) {
  const HarmonicBasis basis(orders, std::max(512, 64 * (orders.back() + 1)));
  VectorXd energies = VectorXd::Zero(structure.joints.cols());
  for (Index j = 0; j < energies.size(); ++j) {
    const JointLaw& law = structure.laws[std::size_t(j)];
    if (law.sliders.empty() && law.coulomb.force == 0) continue; // elastic: it gives all back
    const VectorXd x = unknowns(basis, point.joints.col(j));
    const VectorXd F = harmonic_force(law, x, point.omega, basis).force;
    for (std::size_t k = 0; k < orders.size(); ++k)
      energies[j] +=
          pi * orders[k] * (amplitude(basis, F, k) * std::conj(amplitude(basis, x, k))).imag();
  }
  return energies;
}

double energy_damping(const JointedStructure& structure, const PeriodicPoint& point,
                      const std::vector<int>& orders) {
  double taken = cycle_energies(structure, point, orders).sum(), kinetic = 0;
  for (std::size_t k = 0; k < orders.size(); ++k) {
    const double W = orders[k] * point.omega;
    for (Index r = 0; r < structure.lambda.size(); ++r) {
      const double a2 = std::norm(point.modes(Index(k), r)), lambda = structure.lambda[r];
      taken +=
          orders[k] == 0
              ? 0
              : pi * a2 *
                    (structure.eta[r] * lambda + 2 * structure.zeta[r] * std::sqrt(lambda) * W);
      if (orders[k] == 1) kinetic += W * W * a2 / 2;
    }
    if (orders[k] == 0 || structure.added.empty()) continue;
    const VectorXcd stretch = structure.dampers.transpose() * point.modes.row(Index(k)).transpose();
    taken += pi * stretch.cwiseAbs2().dot(added_at(structure, orders[k], point.omega).imag());
  }
  return taken / (4 * pi * kinetic);
}

} // namespace plica
