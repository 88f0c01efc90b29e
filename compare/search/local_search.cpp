#include "compare/search/search.hpp"

#include "solve/parallel.hpp"

#include <atomic>
#include <ceres/ceres.h>
#include <mutex>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double step = 1e-4;                              // of the box
constexpr double free_step = 1e-3;                         // where there is none
constexpr double tolerance = 1e-10, free_tolerance = 1e-6; // of the cost

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

enum class Bounds { box, none };

class ModelCost : public ceres::CostFunction {
public:
  ModelCost(const ResidualModel& model, Eigen::Index unknowns, Eigen::Index residuals,
            Bounds bounds)
      : model_(model), bounds_(bounds) {
    mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns));
    set_num_residuals(static_cast<int>(residuals));
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const int n = parameter_block_sizes()[0];
    const VectorXd x = Eigen::Map<const VectorXd>(parameters[0], n);
    const std::optional<VectorXd> r = model_(x);
    if (!r) return false;
    Eigen::Map<VectorXd>(residuals, num_residuals()) = *r;
    if (!jacobians || !jacobians[0]) return true;
    const std::optional<MatrixXd> J =
        bounds_ == Bounds::box ? residual_jacobian(model_, x) : forward(x, *r);
    if (!J) return false;
    Eigen::Map<RowMajor>(jacobians[0], num_residuals(), n) = *J;
    return true;
  }

private:
  // Good enough to step by.
  std::optional<MatrixXd> forward(const VectorXd& x, const VectorXd& r) const {
    MatrixXd J(r.size(), x.size());
    std::atomic<bool> all{true};
    in_parallel(int(x.size()), [&](int i) {
      VectorXd there = x;
      there[i] += free_step;
      if (const auto next = model_(there))
        J.col(i) = (*next - r) / free_step;
      else
        all = false;
    });
    return all ? std::optional(J) : std::nullopt;
  }

  const ResidualModel& model_;
  Bounds bounds_;
};

class AfterStep : public ceres::IterationCallback {
public:
  explicit AfterStep(const LocalSettings& settings) : settings_(settings) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    settings_.step(summary.iteration, summary.cost);
    return settings_.stop() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

private:
  const LocalSettings& settings_;
};

// The best of the designs that a model is asked for; once stopped, it has no results any more.
class BestSoFar {
public:
  BestSoFar(const ResidualModel& model, const std::function<bool()>& stop)
      : model_(model), stop_(stop) {}

  std::optional<VectorXd> operator()(const VectorXd& design) {
    if (stop_()) return std::nullopt;
    std::optional<VectorXd> residuals = model_(design);
    const double cost = cost_of(residuals);
    const std::lock_guard lock(mutex_);
    if (best_.size() == 0 || cost < cost_) {
      best_ = design;
      cost_ = cost;
    }
    return residuals;
  }

  const VectorXd& best() const { return best_; }
  double cost() const { return cost_; }

private:
  const ResidualModel& model_;
  const std::function<bool()>& stop_;
  std::mutex mutex_;
  VectorXd best_;
  double cost_ = 0;
};

// Minimum over some of the unknowns, the others held. Ceres creeps where a bound holds an unknown
// that the residuals would push further, so such an unknown is held and the others go on.
void solve(const ResidualModel& model, const std::vector<Eigen::Index>& free,
           Eigen::Index residuals, Bounds bounds, const LocalSettings& settings,
           LocalSearch& found) {
  const VectorXd held = found.best;
  const ResidualModel reduced = [&](const VectorXd& u) {
    VectorXd all = held;
    all(free) = u;
    return model(all);
  };
  VectorXd u = held(free);
  ceres::Problem problem;
  problem.AddResidualBlock(new ModelCost(reduced, u.size(), residuals, bounds), nullptr, u.data());
  for (int i = 0; i < u.size() && bounds == Bounds::box; ++i) {
    problem.SetParameterLowerBound(u.data(), i, 0);
    problem.SetParameterUpperBound(u.data(), i, 1);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = settings.steps;
  options.function_tolerance = bounds == Bounds::box ? tolerance : free_tolerance;
  options.parameter_tolerance = 1e-8;
  options.gradient_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  AfterStep callback(settings);
  options.callbacks = {&callback};
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  found.best(free) = u;
  found.cost = summary.final_cost;
  found.converged = summary.termination_type == ceres::CONVERGENCE;
  found.reason = summary.message;
}

// Unknowns but for those at a bound that the cost pushes further out; these are put onto it.
std::vector<Eigen::Index> free_to_move(const ResidualModel& model, VectorXd& u) {
  constexpr double near = 1e-5;
  std::vector<Eigen::Index> free;
  const std::optional<VectorXd> r = model(u);
  const std::optional<MatrixXd> J = residual_jacobian(model, u);
  const VectorXd gradient = r && J ? VectorXd(J->transpose() * *r) : VectorXd::Zero(u.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const bool low = u[i] < near && gradient[i] > 0, high = u[i] > 1 - near && gradient[i] < 0;
    if (low || high)
      u[i] = low ? 0 : 1;
    else
      free.push_back(i);
  }
  return free;
}

// Differences of the residuals, each unknown moved from one end to the other while the others stay;
// from the design itself where there is no result at one of the ends.
std::optional<MatrixXd> between(const ResidualModel& model, const VectorXd& design,
                                const VectorXd& low, const VectorXd& high) {
  const auto n = static_cast<int>(design.size());
  std::vector<std::optional<VectorXd>> at(2 * std::size_t(n));
  in_parallel(2 * n, [&](int k) {
    VectorXd x = design;
    x[k / 2] = k % 2 == 0 ? low[k / 2] : high[k / 2];
    at[std::size_t(k)] = model(x);
  });
  MatrixXd J;
  std::optional<VectorXd> middle;
  for (int i = 0; i < n; ++i) {
    auto &a = at[2 * std::size_t(i)], &b = at[2 * std::size_t(i) + 1];
    if (!a && !b) return std::nullopt;
    double width = high[i] - low[i];
    if (!a || !b) {
      if (!middle) middle = model(design);
      if (!middle) return std::nullopt;
      width = a ? design[i] - low[i] : high[i] - design[i];
      if (!(width > 0)) return std::nullopt;
      (a ? b : a) = middle;
    }
    if (J.size() == 0) J.resize(a->size(), n);
    J.col(i) = (*b - *a) / width;
    for (Eigen::Index k = 0; k < J.rows(); ++k) {
      if (((*a)[k] == 0) == ((*b)[k] == 0)) continue;
      // A limit that is kept on one side: its slope is that of the side where the design lies.
      if (!middle) middle = model(design);
      if (!middle) return std::nullopt;
      const double own = (*middle)[k], right = high[i] - design[i], left = design[i] - low[i];
      if (own == 0)
        J(k, i) = 0;
      else if ((*a)[k] == 0 && right > 0)
        J(k, i) = ((*b)[k] - own) / right;
      else if ((*b)[k] == 0 && left > 0)
        J(k, i) = (own - (*a)[k]) / left;
    }
  }
  return J;
}

} // namespace

double cost_of(const std::optional<VectorXd>& residuals, Eigen::Index limits) {
  constexpr double none = 1e30;
  if (!residuals || !residuals->allFinite()) return none;
  const double kept = residuals->tail(limits).cwiseMin(0).squaredNorm();
  return std::min(none, (residuals->squaredNorm() - kept) / 2);
}

std::optional<MatrixXd> residual_jacobian(const ResidualModel& model, const VectorXd& design) {
  VectorXd low = design, high = design;
  for (Eigen::Index i = 0; i < design.size(); ++i) {
    // Near a bound, as wide boxes have it, a tenth of the way to it.
    const double room = std::min(design[i], 1 - design[i]);
    const double own = room > 0 ? std::clamp(0.1 * room, 1e-8, step) : step;
    low[i] = std::max(0., design[i] - own);
    high[i] = std::min(1., design[i] + own);
  }
  return between(model, design, low, high);
}

std::optional<MatrixXd> free_jacobian(const ResidualModel& model, const VectorXd& design) {
  return between(model, design, design.array() - free_step, design.array() + free_step);
}

LocalSearch search_freely(const ResidualModel& model, const VectorXd& start, int steps) {
  const std::optional<VectorXd> first = model(start);
  if (!first) throw std::invalid_argument("the model has no result at the start");
  LocalSearch found{.best = start, .cost = cost_of(first), .converged = true, .reason = {}};
  std::vector<Eigen::Index> all(std::size_t(start.size()));
  std::iota(all.begin(), all.end(), 0);
  if (!all.empty()) solve(model, all, first->size(), Bounds::none, {.steps = steps}, found);
  return found;
}

LocalSearch search_locally(const ResidualModel& model, const VectorXd& start,
                           const LocalSettings& settings) {
  const std::optional<VectorXd> first = model(start);
  if (!first) throw std::invalid_argument("the model has no result at the start");
  LocalSearch found{.best = start, .cost = cost_of(first), .converged = true, .reason = {}};
  std::vector<Eigen::Index> free(std::size_t(start.size()));
  std::iota(free.begin(), free.end(), 0);
  BestSoFar so_far(model, settings.stop);
  const ResidualModel watched = [&](const VectorXd& u) { return so_far(u); };
  constexpr int rounds = 5;
  for (int round = 0; round < rounds && !free.empty() && !settings.stop(); ++round) {
    solve(watched, free, first->size(), Bounds::box, settings, found);
    std::vector<Eigen::Index> next = free_to_move(watched, found.best);
    if (next == free) break;
    free = std::move(next);
  }
  if (!settings.stop()) return found;
  found.stopped = true;
  found.converged = false;
  found.reason = "it was stopped";
  // Ceres leaves where it began.
  if (so_far.best().size() > 0 && so_far.cost() < found.cost) {
    found.best = so_far.best();
    found.cost = so_far.cost();
  }
  return found;
}

} // namespace plica
