#include "reduction/dynamic_stiffness.hpp"

#include "solve/joint_balance.hpp"
#include "solve/parallel.hpp"
#include "words/directions.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
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

// The modes eliminated at one frequency: forces of the ends f = S u + H' F, motion of the joints
// x = H u - G F.
struct Condensed {
  Complex1212 S;
  MatrixXcd H, G;
};

// i L and the dampers, over all coordinates; empty where nothing couples the modes.
MatrixXcd coupled_part(const PartBetweenEnds& p, double omega) {
  if (p.loss.size() == 0 && p.dampers.empty()) return {};
  const Index n = 12 + p.lambda.size();
  MatrixXcd A = MatrixXcd::Zero(n, n);
  if (p.loss.size() > 0) A = Complex(0, 1) * p.loss;
  for (const EndDamper& d : p.dampers)
    A += d.added({0, omega}) * (d.stretch * d.stretch.transpose());
  return A;
}

// A constant motion (`mean`) knows no damping.
Condensed condensed(const PartBetweenEnds& p, double omega, bool mean = false) {
  const Index m = p.lambda.size(), joints = p.joints.cols();
  const double w2 = omega * omega;
  MatrixXcd right(m, 12 + joints);
  right << (-w2 * p.M_bq.transpose()).cast<Complex>(), p.joints.bottomRows(m).cast<Complex>();
  VectorXcd diagonal(m);
  for (Index j = 0; j < m; ++j) diagonal[j] = {p.lambda[j] - w2, p.viscous[j] * omega};
  Complex1212 Z_bb = (p.K - w2 * p.M).cast<Complex>();
  const MatrixXcd coupled = mean ? MatrixXcd() : coupled_part(p, omega);
  MatrixXcd solved;
  if (coupled.size() == 0) {
    solved = diagonal.cwiseInverse().asDiagonal() * right;
  } else {
    Z_bb += coupled.topLeftCorner<12, 12>();
    right.leftCols(12) += coupled.bottomLeftCorner(m, 12);
    MatrixXcd Z_qq = coupled.bottomRightCorner(m, m);
    Z_qq.diagonal() += diagonal;
    solved = Z_qq.partialPivLu().solve(right);
  }
  const MatrixXcd at_ends = p.joints.topRows(12).transpose().cast<Complex>();
  Condensed c;
  c.S = Z_bb - right.leftCols(12).transpose() * solved.leftCols(12);
  c.H = at_ends - right.rightCols(joints).transpose() * solved.leftCols(12);
  c.G = right.rightCols(joints).transpose() * solved.rightCols(joints);
  return c;
}

// Joints at rest in themselves: springs, and of smoothed friction the dashpot it begins as.
Complex1212 with_stuck_joints(const PartBetweenEnds& p, const Condensed& c, double omega) {
  if (p.laws.empty()) return c.S;
  VectorXcd k(Index(p.laws.size()));
  for (Index j = 0; j < k.size(); ++j) {
    const JointLaw& law = p.laws[std::size_t(j)];
    const double dashpot = law.coulomb.force > 0 ? law.coulomb.force / law.coulomb.velocity : 0;
    k[j] = {law.stuck_stiffness(), omega * dashpot};
  }
  // F = (1 + k G)^-1 k H u, symmetric in H.
  MatrixXcd A = k.asDiagonal() * c.G;
  A.diagonal().array() += 1;
  return c.S + c.H.transpose() * A.partialPivLu().solve(MatrixXcd(k.asDiagonal() * c.H));
}

// Joints that the motion of one end reaches, by themselves or through others.
std::vector<int> reached(const Condensed& c, const std::vector<JointLaw>& laws, Index column) {
  constexpr double none = 1e-9; // rounding, not a path
  const Index n = c.G.rows();
  VectorXd soft(n);
  for (Index j = 0; j < n; ++j) {
    const double stuck = laws[std::size_t(j)].stuck_stiffness();
    soft[j] = std::sqrt(std::max(std::abs(c.G(j, j)), stuck > 0 ? 1 / stuck : 0.));
  }
  const VectorXd drive = c.H.col(column).cwiseAbs().cwiseQuotient(soft.cwiseMax(1e-300));
  std::vector<char> in(std::size_t(n), 0);
  std::vector<int> open, all;
  const auto take = [&](Index j) {
    if (in[std::size_t(j)]) return;
    in[std::size_t(j)] = 1;
    open.push_back(int(j));
  };
  for (Index j = 0; j < n; ++j)
    if (drive[j] > none * drive.maxCoeff()) take(j);
  while (!open.empty()) {
    const int j = open.back();
    open.pop_back();
    all.push_back(j);
    for (Index i = 0; i < n; ++i)
      if (std::abs(c.G(i, j)) > none * soft[i] * soft[j]) take(i);
  }
  std::sort(all.begin(), all.end());
  return all;
}

// One frequency at all levels.
class AtFrequency {
public:
  AtFrequency(const PartBetweenEnds& part, double hertz, const HarmonicBasis& basis)
      : part_(part), omega_(2 * pi * hertz), basis_(basis) {
    for (int n : basis.orders) by_order_.push_back(condensed(part, n * omega_, n == 0));
    first_ = std::size_t(first_harmonic(basis.orders));
  }

  // `not_found` counts columns without a solution.
  std::vector<Complex1212> levels(const std::vector<MotionLevel>& levels, int& not_found) const {
    const Condensed& c = by_order_[first_];
    std::vector<Complex1212> all(levels.size(), with_stuck_joints(part_, c, omega_));
    if (part_.laws.empty()) return all;
    for (Index column = 0; column < 12; ++column) {
      const std::vector<int> joints = reached(c, part_.laws, column);
      if (joints.empty()) continue;
      MovedJoints moved = moved_joints(joints);
      VectorXd guess;
      double before = 0;
      for (std::size_t l = 0; l < levels.size(); ++l) {
        const double X = column % 6 < 3 ? levels[l].translation : levels[l].rotation;
        if (X == 0) continue;
        moved.free_motion = X * c.H.col(column)(joints);
        if (guess.size() > 0) guess *= X / before;
        const BalancedJoints b = balance_joints(moved, basis_, guess, 1e-9);
        auto Z = all[l].col(column);
        if (b.converged) {
          Z = c.S.col(column) + c.H(joints, Eigen::all).transpose() * b.force / X;
          guess = b.motion;
          before = X;
        } else {
          Z.setConstant(std::numeric_limits<double>::quiet_NaN());
          guess = VectorXd();
          ++not_found;
        }
      }
    }
    return all;
  }

private:
  MovedJoints moved_joints(const std::vector<int>& joints) const {
    MovedJoints moved;
    moved.omega = omega_;
    for (int j : joints) moved.laws.push_back(part_.laws[std::size_t(j)]);
    for (const Condensed& c : by_order_) moved.receptance.emplace_back(c.G(joints, joints));
    return moved;
  }

  const PartBetweenEnds& part_;
  double omega_;
  const HarmonicBasis& basis_;
  std::vector<Condensed> by_order_;
  std::size_t first_ = 0;
};

} // namespace

Complex1212 dynamic_stiffness(const PartBetweenEnds& part, double hertz) {
  const double omega = 2 * pi * hertz;
  return with_stuck_joints(part, condensed(part, omega), omega);
}

StiffnessOverFrequency dynamic_stiffness(const PartBetweenEnds& part, const VectorXd& hertz,
                                         const std::vector<MotionLevel>& levels, int harmonics,
                                         int samples) {
  const bool odd =
      std::all_of(part.laws.begin(), part.laws.end(), [](const auto& l) { return l.is_odd(); });
  const HarmonicBasis basis(part.laws.empty() ? std::vector<int>{1} : orders_up_to(harmonics, odd),
                            samples);
  StiffnessOverFrequency out{hertz, levels, {}, 0};
  const auto count = std::size_t(hertz.size());
  out.at.assign(levels.size(), std::vector<Complex1212>(count));
  std::vector<int> not_found(count, 0);
  in_parallel(int(count), [&](int i) {
    const AtFrequency at(part, hertz[i], basis);
    const std::vector<Complex1212> all = at.levels(levels, not_found[std::size_t(i)]);
    for (std::size_t l = 0; l < levels.size(); ++l) out.at[l][std::size_t(i)] = all[l];
  });
  for (int n : not_found) out.not_found += n;
  return out;
}

Eigen::Matrix<Complex, 6, 6> connector_in_middle(const Complex1212& Z, const Eigen::Vector3d& end_1,
                                                 const Eigen::Vector3d& end_2) {
  const Eigen::Vector3d middle = (end_1 + end_2) / 2;
  // Back from the middle to an end: u_end = u_m + r_m x (end - middle).
  const auto back = [&](const Eigen::Vector3d& end) {
    Eigen::Matrix<double, 6, 6> B = Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::Vector3d d = end - middle;
    B.topRightCorner<3, 3>() << 0, d.z(), -d.y(), -d.z(), 0, d.x(), d.y(), -d.x(), 0;
    return B;
  };
  return -back(end_2).transpose() * Z.bottomLeftCorner<6, 6>() * back(end_1);
}

std::vector<std::string> end_coordinate_names(const std::array<std::string, 2>& ends) {
  std::vector<std::string> names;
  for (const std::string& end : ends)
    for (const char* dof : direction_names) names.push_back(end + "." + dof);
  return names;
}

} // namespace plica
