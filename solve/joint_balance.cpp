#include "solve/joint_balance.hpp"

#include "solve/continuation.hpp"

#include <Eigen/LU>
#include <cmath>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

class JointBalance {
public:
  JointBalance(const MovedJoints& joints, const HarmonicBasis& basis)
      : joints_(joints), basis_(basis), first_(first_harmonic(basis.orders)), scale_(count()) {
    // Motion of a unit energy: of the structure, or where nothing gives way of the joint itself.
    for (Index j = 0; j < count(); ++j) {
      const double stuck = joints.laws[std::size_t(j)].stuck_stiffness();
      double soft = stuck > 0 ? 1 / stuck : 0;
      for (const MatrixXcd& G : joints.receptance) soft = std::max(soft, std::abs(G(j, j)));
      scale_[j] = soft > 0 ? std::sqrt(soft) : 1;
    }
  }

  Index count() const { return Index(joints_.laws.size()); }
  Index unknowns() const { return count() * basis_.size(); }

  Residual residual(const VectorXd& scaled, double share) const {
    const Index p = basis_.size();
    Residual out{scaled, MatrixXd::Identity(unknowns(), unknowns()), VectorXd::Zero(unknowns())};
    std::vector<HarmonicForce> forces;
    forces.reserve(std::size_t(count()));
    for (Index j = 0; j < count(); ++j) forces.push_back(force(j, scaled));
    for (std::size_t k = 0; k < basis_.orders.size(); ++k) {
      const MatrixXcd& G = joints_.receptance[k];
      const Index at = basis_.first(k);
      const bool mean = basis_.orders[k] == 0;
      VectorXcd F(count());
      for (Index j = 0; j < count(); ++j) F[j] = amplitude(basis_, forces[std::size_t(j)].force, k);
      for (Index j = 0; j < count(); ++j) {
        Complex free = 0;
        if (basis_.orders[k] == 1) free = joints_.free_motion[j] / scale_[j];
        const Complex less = (G.row(j) * F).value() / scale_[j] - share * free;
        const Index row = j * p + at;
        out.value[row] += less.real();
        out.by_parameter[row] = -free.real();
        if (!mean) {
          out.value[row + 1] += less.imag();
          out.by_parameter[row + 1] = -free.imag();
        }
        for (Index i = 0; i < count(); ++i) {
          const MatrixXd& K = forces[std::size_t(i)].by_motion;
          const Complex g = G(j, i) * scale_[i] / scale_[j];
          auto own = out.by_motion.row(row).segment(i * p, p);
          own += g.real() * K.row(at);
          if (mean) continue;
          own -= g.imag() * K.row(at + 1);
          out.by_motion.row(row + 1).segment(i * p, p) +=
              g.imag() * K.row(at) + g.real() * K.row(at + 1);
        }
      }
    }
    return out;
  }

  // All joints stuck, with a share of the motion.
  VectorXd stuck(double share) const {
    MatrixXcd A = joints_.receptance[std::size_t(first_)];
    for (Index j = 0; j < count(); ++j) A.col(j) *= joints_.laws[std::size_t(j)].stuck_stiffness();
    A.diagonal().array() += 1;
    const VectorXcd x = A.partialPivLu().solve(share * joints_.free_motion);
    VectorXd motion = VectorXd::Zero(unknowns());
    for (Index j = 0; j < count(); ++j) {
      const Index at = j * basis_.size() + basis_.first(std::size_t(first_));
      motion[at] = x[j].real() / scale_[j];
      motion[at + 1] = x[j].imag() / scale_[j];
    }
    return motion;
  }

  VectorXd times_scale(VectorXd x, bool inverse) const {
    for (Index j = 0; j < count(); ++j)
      x.segment(j * basis_.size(), basis_.size()) *= inverse ? 1 / scale_[j] : scale_[j];
    return x;
  }

  BalancedJoints found(const VectorXd& scaled, double residual) const {
    BalancedJoints out{true, residual, times_scale(scaled, false), VectorXcd(count())};
    for (Index j = 0; j < count(); ++j)
      out.force[j] = amplitude(basis_, force(j, scaled).force, std::size_t(first_));
    return out;
  }

private:
  HarmonicForce force(Index j, const VectorXd& scaled) const {
    return harmonic_force(joints_.laws[std::size_t(j)],
                          scale_[j] * scaled.segment(j * basis_.size(), basis_.size()),
                          joints_.omega, basis_);
  }

  const MovedJoints& joints_;
  const HarmonicBasis& basis_;
  Index first_;
  VectorXd scale_;
};

} // namespace

BalancedJoints balance_joints(const MovedJoints& joints, const HarmonicBasis& basis,
                              const VectorXd& guess, double tolerance) {
  const JointBalance balance(joints, basis);
  const ResidualFunction f = [&](const VectorXd& x, double share) {
    return balance.residual(x, share);
  };
  const ContinuationSettings settings{.from = 1e-3, .to = 1, .tolerance = tolerance};
  if (guess.size() > 0) {
    const Solution near = solve_at(f, balance.times_scale(guess, true), 1, settings);
    if (near.converged) return balance.found(near.x, near.residual);
  }
  const Solution direct = solve_at(f, balance.stuck(1), 1, settings);
  if (direct.converged) return balance.found(direct.x, direct.residual);
  const Curve curve = follow(f, balance.stuck(settings.from), settings);
  if (!curve.complete) return {};
  const Solution end = solve_at(f, curve.points.back().x, 1, settings);
  return end.converged ? balance.found(end.x, end.residual) : BalancedJoints{};
}

} // namespace plica
