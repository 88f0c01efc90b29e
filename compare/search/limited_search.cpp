#include "compare/search/search.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double first_radius = 0.3, least_radius = 1e-6;  // of the box
constexpr double relative_gain = 1e-7, least_gain = 1e-10; // of the cost; less is not sought
constexpr double noise = 1e-5; // of the cost: what single-precision stresses leave

// What counts: limits that are kept do not.
VectorXd counted(VectorXd values, Index limits) {
  values.tail(limits) = values.tail(limits).cwiseMax(0);
  return values;
}

// A step d of the linear model, values + J d, within lo <= d <= hi; B: what the rows bend by.
class LinearModel {
public:
  LinearModel(const MatrixXd& J, const MatrixXd& B, VectorXd values, Index limits)
      : J_(J), B_(B), values_(std::move(values)), limits_(limits) {}

  VectorXd rows(const VectorXd& d) const { return counted(values_ + J_ * d, limits_); }
  double cost(const VectorXd& d) const { return (rows(d).squaredNorm() + d.dot(B_ * d)) / 2; }

  // The least of a convex function that is quadratic piece by piece: Newton's method, projected
  // onto the bounds (Bertsekas, SIAM J. Control Optim. 20 (1982) 221).
  VectorXd least(const VectorXd& lo, const VectorXd& hi) const {
    constexpr int most = 200;
    constexpr double small = 1e-13;
    VectorXd d = VectorXd::Zero(lo.size());
    for (int k = 0; k < most; ++k) {
      const VectorXd next = improved(d, lo, hi);
      const double moved = (next - d).lpNorm<Eigen::Infinity>();
      d = next;
      if (moved < small) break;
    }
    return d;
  }

private:
  VectorXd improved(const VectorXd& d, const VectorXd& lo, const VectorXd& hi) const {
    const VectorXd w = rows(d);
    MatrixXd active = J_;
    for (Index i = J_.rows() - limits_; i < J_.rows(); ++i)
      if (w[i] == 0) active.row(i).setZero();
    const VectorXd gradient = active.transpose() * w + B_ * d;
    const VectorXd p = newton(active.transpose() * active + B_, gradient, d, lo, hi);
    constexpr double enough = 1e-4;
    for (double t = 1; t > 1e-12; t /= 2) {
      const VectorXd next = (d + t * p).cwiseMax(lo).cwiseMin(hi);
      if (cost(next) <= cost(d) + enough * gradient.dot(next - d)) return next;
    }
    return d;
  }

  // Unknowns that would leave the bounds at which they are stay there.
  static VectorXd newton(MatrixXd H, const VectorXd& gradient, const VectorXd& d,
                         const VectorXd& lo, const VectorXd& hi) {
    constexpr double small = 1e-12;
    H.diagonal().array() += small * std::max(H.diagonal().maxCoeff(), small);
    std::vector<Index> free;
    for (Index i = 0; i < d.size(); ++i)
      if (!(d[i] <= lo[i] && gradient[i] > 0) && !(d[i] >= hi[i] && gradient[i] < 0))
        free.push_back(i);
    VectorXd p = VectorXd::Zero(d.size());
    while (!free.empty()) {
      p.setZero();
      p(free) = -MatrixXd(H(free, free)).ldlt().solve(VectorXd(gradient(free)));
      const auto leaves = [&](Index i) {
        return (d[i] <= lo[i] && p[i] < 0) || (d[i] >= hi[i] && p[i] > 0);
      };
      if (std::erase_if(free, leaves) == 0) return p;
    }
    return VectorXd::Zero(d.size());
  }

  const MatrixXd &J_, &B_;
  VectorXd values_;
  Index limits_;
};

// Symmetric rank one, its negative part left out: the model stays convex.
class Curvature {
public:
  void begin(Index unknowns) { all_ = convex_ = MatrixXd::Zero(unknowns, unknowns); }
  const MatrixXd& convex() const { return convex_; }

  // `turned`: by how much the gradient turned over the step beyond what the linear rows say.
  void learn(const VectorXd& step, const VectorXd& turned) {
    constexpr double small = 1e-8;
    const VectorXd missed = turned - all_ * step;
    const double along = missed.dot(step);
    if (std::abs(along) <= small * missed.norm() * step.norm()) return;
    all_ += missed * missed.transpose() / along;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(all_);
    convex_ = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
              eigen.eigenvectors().transpose();
  }

private:
  MatrixXd all_, convex_;
};

struct Point {
  VectorXd u, values;
  double cost = 0;
};

class LimitedSearch {
public:
  LimitedSearch(const ResidualModel& model, Index limits, const LocalSettings& settings)
      : model_([&](const VectorXd& u) { return settings.stop() ? std::nullopt : model(u); }),
        limits_(limits), settings_(settings) {}

  LocalSearch from(const VectorXd& start) {
    std::optional<Point> first = at(start);
    if (!first) throw std::invalid_argument("the model has no result at the start");
    here_ = std::move(*first);
    curvature_.begin(start.size());
    LocalSearch found;
    for (int k = 0; k < settings_.steps && found.reason.empty(); ++k) {
      settings_.step(k, here_.cost);
      found.reason = step();
    }
    found.stopped = settings_.stop();
    found.converged = !found.stopped && found.reason == good;
    if (found.stopped) found.reason = "it was stopped";
    if (found.reason.empty()) found.reason = "it took more steps than are allowed";
    found.best = here_.u;
    found.cost = here_.cost;
    return found;
  }

private:
  static constexpr const char* good = "no step makes it better";

  std::optional<Point> at(const VectorXd& u) const {
    std::optional<VectorXd> values = model_(u);
    if (!values || !values->allFinite()) return std::nullopt;
    const double cost = counted(*values, limits_).squaredNorm() / 2;
    return Point{u, std::move(*values), cost};
  }

  // Goes on to a better design; otherwise says why the search ends.
  std::string step() {
    const std::optional<MatrixXd> J = residual_jacobian(model_, here_.u);
    if (!J) return "the model has no result beside the best design";
    if (weights_.size() > 0) curvature_.learn(last_, (*J - slopes_).transpose() * weights_);
    double promised = 0;
    for (bool first = true; radius_ > least_radius && !settings_.stop(); first = false) {
      const VectorXd lo = (-here_.u).cwiseMax(-radius_);
      const VectorXd hi = (1 - here_.u.array()).matrix().cwiseMin(radius_);
      const LinearModel linear(*J, curvature_.convex(), here_.values, limits_);
      const VectorXd d = linear.least(lo, hi);
      const double gain = here_.cost - linear.cost(d);
      if (first) promised = gain;
      if (gain <= relative_gain * here_.cost + least_gain) return good;
      const double length = d.lpNorm<Eigen::Infinity>();
      std::optional<Point> there = at(here_.u + d);
      constexpr double poor = 0.25, fair = 0.75, growth = 2.5;
      if (there && here_.cost - there->cost < fair * gain)
        if (std::optional<Point> other = corrected(*J, d, there->values, lo, hi);
            other && other->cost < there->cost)
          there = std::move(other);
      const double share = there ? (here_.cost - there->cost) / gain : -1;
      if (share < poor) radius_ = poor * length;
      if (share > fair && length > fair * radius_) radius_ *= growth;
      if (share <= 0) continue;
      last_ = there->u - here_.u;
      weights_ = linear.rows(d);
      slopes_ = *J;
      here_ = std::move(*there);
      return "";
    }
    return promised < noise * here_.cost ? good : "no step along the slopes makes it better";
  }

  // Limits bend: the same slopes through what they are at the end of a step.
  std::optional<Point> corrected(const MatrixXd& J, const VectorXd& d, const VectorXd& there,
                                 const VectorXd& lo, const VectorXd& hi) const {
    if (limits_ == 0) return std::nullopt;
    VectorXd values = here_.values;
    values.tail(limits_) = (there - J * d).tail(limits_);
    const VectorXd other =
        LinearModel(J, curvature_.convex(), std::move(values), limits_).least(lo, hi);
    if ((other - d).lpNorm<Eigen::Infinity>() < least_radius * radius_) return std::nullopt;
    return at(here_.u + other);
  }

  ResidualModel model_;
  Index limits_;
  const LocalSettings& settings_;
  Point here_;
  Curvature curvature_;
  VectorXd last_, weights_; // of the last step
  MatrixXd slopes_;
  double radius_ = first_radius;
};

} // namespace

LocalSearch search_within(const ResidualModel& model, Index limits, const VectorXd& start,
                          const LocalSettings& settings) {
  return LimitedSearch(model, limits, settings).from(start);
}

} // namespace plica
