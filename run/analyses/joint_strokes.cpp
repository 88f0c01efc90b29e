#include "run/analyses/joint_strokes.hpp"

#include <Eigen/LU>
#include <algorithm>
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
    for (const JenkinsSlider& s : law.sliders)
      for (double sign : {1., -1.}) // from the offset, either way
        add((s.slip_force + sign * force_at_offset(law, s)) / s.stiffness);
    for (std::size_t k = 1; k + 1 < law.curve.size(); ++k)
      add(std::abs(law.curve[k][0] - law.offset));
  }
  if (!(last > 0)) return std::nullopt;
  return std::array{first, last};
}

// Motion x and forces F of the joints, x = target - C F(x), on first loading.
void load(const JointedStructure& held, const MatrixXd& C, const VectorXd& target, VectorXd& x,
          VectorXd& F) {
  VectorXd K(x.size());
  for (int newton = 0; newton < 60; ++newton) {
    for (Index j = 0; j < x.size(); ++j) {
      F[j] = first_loading(held.laws[std::size_t(j)], x[j]);
      K[j] = first_loading_slope(held.laws[std::size_t(j)], x[j]);
    }
    const VectorXd r = x - target + C * F;
    if (r.norm() < 1e-12 * x.norm()) return;
    MatrixXd A = C * K.asDiagonal();
    A.diagonal().array() += 1;
    x -= A.partialPivLu().solve(r);
  }
}

using Way = std::vector<std::array<double, 2>>; // [displacement, force], outwards

// One way from where the joints are; `sign`: along the motion or against it.
Way way_out(const JointedStructure& held, const MatrixXd& C, const VectorXd& motion,
            double stiffness, const std::array<double, 2>& range, double sign) {
  Way way;
  const double low = range[0] / 2, high = 10 * range[1];
  constexpr int steps = 160;
  VectorXd x = VectorXd::Zero(motion.size()), F = x;
  for (int k = 0; k <= steps; ++k) {
    const double d = sign * low * std::pow(high / low, double(k) / steps);
    load(held, C, d * motion, x, F);
    way.push_back({d, stiffness * d + motion.dot(F)});
  }
  return way;
}

} // namespace

std::vector<StrokeCurve> joint_strokes(const JointedStructure& held, const MatrixXd& motion,
                                       const Eigen::Vector2d& stiffness) {
  const MatrixXd C =
      held.joints.transpose() * held.lambda.cwiseInverse().asDiagonal() * held.joints;
  const bool odd = std::all_of(held.laws.begin(), held.laws.end(),
                               [](const JointLaw& law) { return law.is_odd(); });
  std::vector<StrokeCurve> curves;
  for (Index c = 0; c < 2; ++c) {
    const auto range = slip_range(held, motion.col(c), 1e-9 * motion.cwiseAbs().maxCoeff());
    if (!range) continue;
    const VectorXd m = motion.col(c);
    const Way ahead = way_out(held, C, m, stiffness[c], *range, 1);
    const Way back = odd ? Way{} : way_out(held, C, m, stiffness[c], *range, -1);
    StrokeCurve curve{c == 0 ? StrokeCurve::along : StrokeCurve::across, {}};
    for (std::size_t k = ahead.size(); k-- > 0;)
      curve.points.push_back(odd ? std::array{-ahead[k][0], -ahead[k][1]} : back[k]);
    curve.points.push_back({0, 0});
    curve.points.insert(curve.points.end(), ahead.begin(), ahead.end());
    curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace plica
