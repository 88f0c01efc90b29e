#include "solve/continuation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A change of x by this many times its size is as long as the whole way of p: round a resonance the
// points lie closer.
constexpr double along_motion = 20;

double relative(const Residual& r, const VectorXd& x) {
  return r.value.norm() / std::max(1e-300, x.norm());
}

class Follower {
public:
  Follower(const ResidualFunction& f, const ContinuationSettings& settings)
      : f_(f), settings_(settings), range_(std::abs(settings.to - settings.from)),
        sign_(settings.to >= settings.from ? 1 : -1) {}

  Curve from(const VectorXd& guess) {
    const Solution start = solve_at(f_, guess, settings_.from, settings_);
    if (!start.converged) {
      curve_.reason = "no solution at the start";
      return std::move(curve_);
    }
    x_ = start.x;
    p_ = settings_.from;
    here_ = start.last;
    tangent_ = VectorXd::Zero(x_.size() + 1);
    tangent_[x_.size()] = sign_;
    keep(start.iterations);
    const double largest = settings_.largest_step > 0 ? settings_.largest_step : range_ / 100;
    const double smallest = settings_.smallest_step > 0 ? settings_.smallest_step : 1e-7 * range_;
    double step = largest / 4;
    while (!curve_.complete && curve_.reason.empty()) {
      if (static_cast<int>(curve_.points.size()) >= settings_.most_points) {
        curve_.reason = "more points than allowed";
        break;
      }
      const int iterations = advance(step / range_);
      if (iterations == 0) {
        step /= 2;
        if (step < smallest) curve_.reason = "Newton's method found no next point";
        continue;
      }
      if (iterations <= 3) step = std::min(1.6 * step, largest);
      if (iterations >= 6) step /= 2;
      check_end(iterations);
    }
    return std::move(curve_);
  }

private:
  void keep(int iterations) {
    const Eigen::PartialPivLU<MatrixXd> lu(here_.by_motion);
    // Sign of the determinant: of the permutation, and of U.
    double sign = lu.permutationP().determinant() > 0 ? 1 : -1;
    for (Index i = 0; i < x_.size(); ++i)
      if (lu.matrixLU()(i, i) < 0) sign = -sign;
    if (curve_.points.empty()) first_sign_ = last_sign_ = sign;
    curve_.points.push_back({x_, p_, iterations, sign == first_sign_});
    // Direction of the curve over (x / size, p / range) that goes on as before.
    size_ = along_motion * std::max(1e-300, x_.norm());
    VectorXd next(x_.size() + 1);
    next << -lu.solve(here_.by_parameter) / size_, 1 / range_;
    next.normalize();
    if (!next.allFinite()) return; // at a fold to the last digit: on as before
    // Along one curve p turns where the determinant changes its sign: a fold. Where the tangent
    // itself does not turn, another branch has been passed, and the curve goes on.
    const double turned = sign == last_sign_ ? 1 : -1;
    if (turned < 0 && (next.dot(tangent_) > 0) == (direction_ > 0))
      last_sign_ = sign;
    else if (turned < 0) {
      last_sign_ = sign;
      direction_ = -direction_;
    }
    tangent_ = direction_ * next;
  }

  // Iterations to the next point at a length along the curve; 0 = none found, nothing changed.
  int advance(double length) {
    const Index n = x_.size();
    VectorXd x = x_ + size_ * length * tangent_.head(n);
    double p = p_ + range_ * length * tangent_[n];
    for (int k = 1; k <= settings_.newton_steps; ++k) {
      Residual r = f_(x, p);
      if (!r.value.allFinite()) return 0;
      if (relative(r, x) < settings_.tolerance) {
        // Far off the way along the tangent lies another part of the curve: across a peak, not on
        // it.
        constexpr double near = 4;
        if (std::hypot((x - x_).norm() / size_, (p - p_) / range_) > near * length) return 0;
        x_ = x;
        p_ = p;
        here_ = std::move(r);
        keep(k);
        return k;
      }
      MatrixXd A(n + 1, n + 1);
      A.topLeftCorner(n, n) = r.by_motion * size_;
      A.topRightCorner(n, 1) = r.by_parameter * range_;
      A.bottomRows(1) = tangent_.transpose();
      VectorXd b(n + 1);
      b << r.value,
          ((x - x_) / size_).dot(tangent_.head(n)) + (p - p_) / range_ * tangent_[n] - length;
      const VectorXd d = A.partialPivLu().solve(b);
      if (!d.allFinite()) return 0;
      x -= size_ * d.head(n);
      p -= range_ * d[n];
    }
    return 0;
  }

  // The last point lies at the end, the curve between them.
  void check_end(int iterations) {
    if ((p_ - settings_.from) * sign_ < -0.01 * range_) {
      curve_.reason = "the curve turned back beyond its start";
      return;
    }
    if ((p_ - settings_.to) * sign_ < 0) return;
    curve_.complete = true;
    const Solution end = solve_at(f_, x_, settings_.to, settings_);
    if (!end.converged) return; // a little beyond the end
    CurvePoint& last = curve_.points.back();
    last = {end.x, settings_.to, iterations, last.same_side};
  }

  const ResidualFunction& f_;
  const ContinuationSettings& settings_;
  double range_, sign_, size_ = 1, first_sign_ = 1, last_sign_ = 1;
  double direction_ = sign_; // of p along the curve
  Curve curve_;
  VectorXd x_, tangent_;
  double p_ = 0;
  Residual here_;
};

} // namespace

Solution solve_at(const ResidualFunction& f, const VectorXd& guess, double p,
                  const ContinuationSettings& settings) {
  Solution s;
  s.x = guess;
  for (s.iterations = 1; s.iterations <= 3 * settings.newton_steps; ++s.iterations) {
    s.last = f(s.x, p);
    s.residual = relative(s.last, s.x);
    if (!std::isfinite(s.residual)) return s;
    if (s.residual < settings.tolerance) {
      s.converged = true;
      return s;
    }
    // A step that leads farther off is taken in part: laws with corners cycle otherwise.
    const VectorXd step = s.last.by_motion.partialPivLu().solve(s.last.value);
    if (!step.allFinite()) return s;
    double share = 1;
    for (int k = 0; k < 4 && f(s.x - share * step, p).value.norm() > s.last.value.norm(); ++k)
      share /= 2;
    s.x -= share * step;
  }
  return s;
}

Curve follow(const ResidualFunction& f, const VectorXd& guess,
             const ContinuationSettings& settings) {
  return Follower(f, settings).from(guess);
}

} // namespace plica
