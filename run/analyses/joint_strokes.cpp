#include "run/analyses/joint_strokes.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Displacements between which the joints begin to slip or bend and all have; none: nothing of the
// kind moves. `least`: motion of a joint that is none.
std::optional<std::array<double, 2>> slip_range(const JointedStructure& held,
                                                const VectorXd& motion, double least) {
  double first = std::numeric_limits<double>::infinity(), last = 0;
  for (Index j = 0; j < motion.size(); ++j) {
    if (std::abs(motion[j]) <= least) continue;
    const auto add = [&](double own) {
      if (own == 0) return;
      first = std::min(first, own / std::abs(motion[j]));
      last = std::max(last, own / std::abs(motion[j]));
    };
    const JointLaw& law = held.laws[std::size_t(j)];
    for (const JenkinsSlider& s : law.sliders) add(s.slip_force / s.stiffness);
    for (std::size_t k = 1; k + 1 < law.curve.size(); ++k) add(std::abs(law.curve[k][0]));
  }
  if (!(last > 0)) return std::nullopt;
  return std::array{first, last};
}

// Motion x and forces F of the joints, x = target - C F(x), loaded from rest.
void load(const JointedStructure& held, const MatrixXd& C, const VectorXd& target, VectorXd& x,
          VectorXd& F) {
  VectorXd K(x.size());
  for (int newton = 0; newton < 60; ++newton) {
    for (Index j = 0; j < x.size(); ++j) {
      const JointLaw& law = held.laws[std::size_t(j)];
      F[j] = first_loading(law, x[j]);
      K[j] = elastic_force(law, x[j], 0).by_motion;
      for (const JenkinsSlider& s : law.sliders)
        if (std::abs(s.stiffness * x[j]) < s.slip_force) K[j] += s.stiffness;
    }
    const VectorXd r = x - target + C * F;
    if (r.norm() < 1e-12 * x.norm()) return;
    MatrixXd A = C * K.asDiagonal();
    A.diagonal().array() += 1;
    x -= A.partialPivLu().solve(r);
  }
}

} // namespace

std::vector<StrokeCurve> joint_strokes(const JointedStructure& held, const MatrixXd& motion,
                                       const Eigen::Vector2d& stiffness) {
  const MatrixXd C =
      held.joints.transpose() * held.lambda.cwiseInverse().asDiagonal() * held.joints;
  std::vector<StrokeCurve> curves;
  for (Index c = 0; c < 2; ++c) {
    const auto range = slip_range(held, motion.col(c), 1e-9 * motion.cwiseAbs().maxCoeff());
    if (!range) continue;
    std::vector<std::array<double, 2>> way{{0, 0}};
    const double low = (*range)[0] / 2, high = 10 * (*range)[1];
    constexpr int steps = 160;
    VectorXd x = VectorXd::Zero(motion.rows()), F = x;
    for (int k = 0; k <= steps; ++k) {
      const double d = low * std::pow(high / low, double(k) / steps);
      load(held, C, d * motion.col(c), x, F);
      way.push_back({d, stiffness[c] * d + motion.col(c).dot(F)});
    }
    StrokeCurve curve{c == 0 ? "axial" : "transverse", {}};
    for (std::size_t k = way.size(); k-- > 1;) curve.points.push_back({-way[k][0], -way[k][1]});
    curve.points.insert(curve.points.end(), way.begin(), way.end()); // the other way the same
    curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace plica
