#include "compare/fit/fit.hpp"

#include "model/description/case_path.hpp"
#include "words/short_text.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double open_effect = 1; // sigmas over the whole box: less is not seen by the data

// Of the sum that is limited, where its terms have one.
std::string unit_of(const FitConstraint& constraint, const Case& data) {
  std::set<std::string> units;
  for (const auto& [quantity, factor] : constraint.of) units.insert(unit_of_goal(quantity, data));
  return units.size() == 1 ? *units.begin() : "";
}

class Fit {
public:
  Fit(const Case& data, const FitRequest& request, const TestData& test,
      const FitSettings& settings)
      : request_(request), problem_(data, request, test, settings.refused) {}

  FitResult result(const FitSettings& settings) {
    const ResidualModel model = [this](const VectorXd& u) { return problem_.residuals(u); };
    const VectorXd start = problem_.start();
    FitResult fit;
    fit.start_cost = cost_of(model(start));
    VectorXd best = start;
    if (settings.search == FitSearch::global) best = global(settings, start, fit);
    for (const VectorXd& other : settings.starts)
      if (const VectorXd u = problem_.box_of(other); cost_of(model(u)) < cost_of(model(best)))
        best = u;
    const LocalSearch local = refined(settings, best);
    fit.converged = local.converged;
    fit.stopped = local.stopped;
    fit.reason = local.reason;
    fit.cost = local.cost;
    describe(start, local.best, fit);
    if (local.stopped)
      fit.warnings.push_back("no uncertainties: the search was stopped before it had converged");
    else if (problem_.aims().empty())
      uncertainty(model, local.best, fit);
    else
      fit.correlation = MatrixXd::Zero(start.size(), start.size());
    warn(fit);
    fit.evaluations = problem_.evaluations();
    fit.samples = problem_.take_samples();
    return fit;
  }

private:
  LocalSearch refined(const FitSettings& settings, const VectorXd& from) {
    LocalSettings local;
    if (!settings.stop()) local.stop = settings.stop; // a global one: its best is still refined
    int steps = 0;
    double cost = cost_of(std::nullopt);
    std::mutex mutex;
    auto said = std::chrono::steady_clock::now();
    const auto say = [&] {
      settings.step(steps, problem_.evaluations(), cost);
      said = std::chrono::steady_clock::now();
    };
    local.step = [&](int step, double) {
      const std::lock_guard lock(mutex);
      steps = step;
      say();
    };
    const bool limited = problem_.is_limited();
    const Index limits = limited ? problem_.limits() : 0;
    const ResidualModel model = [&](const VectorXd& u) {
      auto rows = limited ? problem_.residuals_and_limits(u) : problem_.residuals(u);
      constexpr std::chrono::seconds silence{5};
      const std::lock_guard lock(mutex);
      cost = std::min(cost, cost_of(rows, limits));
      if (std::chrono::steady_clock::now() - said > silence) say();
      return rows;
    };
    return limited ? search_within(model, limits, from, local) : search_locally(model, from, local);
  }

  VectorXd global(const FitSettings& settings, const VectorXd& start, FitResult& fit) {
    GlobalSettings search;
    search.evaluations = settings.evaluations;
    search.seed = settings.seed;
    search.starts = {start};
    for (const VectorXd& other : settings.starts) search.starts.push_back(problem_.box_of(other));
    search.progress = settings.progress;
    search.stop = settings.stop;
    GlobalSearch found =
        search_globally([this](const VectorXd& u) { return cost_of(problem_.residuals(u)); },
                        static_cast<int>(start.size()), search);
    fit.islands = std::move(found.islands);
    return found.best;
  }

  void describe(const VectorXd& start, const VectorXd& best, FitResult& fit) const {
    const std::optional<FitProblem::Outcome> before = problem_.evaluate(start),
                                             after = problem_.evaluate(best);
    if (!before || !after) throw std::invalid_argument("the model has no result at the start");
    for (std::size_t i = 0; i < problem_.targets().size(); ++i) {
      const FitProblem::Target& t = problem_.targets()[i];
      fit.targets.push_back({t.quantity, t.unit, t.measured, t.sigma * t.measured,
                             before->targets[Index(i)], after->targets[Index(i)], t.held_out,
                             t.goal});
    }
    const auto decibels = [](const VectorXd& ratios) {
      return 20 / std::log(10.) * ratios.norm() / std::sqrt(double(ratios.size()));
    };
    for (std::size_t i = 0; i < problem_.curves().size(); ++i)
      fit.responses.push_back({problem_.curves()[i].name,
                               static_cast<int>(problem_.curves()[i].hertz.size()),
                               decibels(before->responses[i]), decibels(after->responses[i])});
    const auto share = [](const VectorXd& off) {
      return off.norm() / std::sqrt(double(off.size()));
    };
    for (std::size_t i = 0; i < problem_.stiffness().size(); ++i) {
      const FitStiffness& s = problem_.stiffness()[i];
      fit.stiffness.push_back({s.name, static_cast<int>(s.numbers.size()), s.sigma,
                               share(before->stiffness[i]), share(after->stiffness[i]),
                               s.held_out});
    }
    for (std::size_t i = 0; i < problem_.aims().size(); ++i) {
      const FitProblem::Aim& aim = problem_.aims()[i];
      fit.aims.push_back({aim.quantity, aim.least, before->aims[Index(i)], after->aims[Index(i)],
                          unit_of_goal(aim.quantity, problem_.data())});
    }
    for (std::size_t i = 0; i < request_.constraints.size(); ++i) {
      const FitConstraint& c = request_.constraints[i];
      fit.constraints.push_back(
          {c.name, after->constraints[Index(i)], c.min, c.max, unit_of(c, problem_.data())});
    }
    const VectorXd from = problem_.values_of(start), to = problem_.values_of(best);
    for (std::size_t i = 0; i < request_.parameters.size(); ++i) {
      const std::vector<std::string>& paths = request_.parameters[i].paths;
      const double u = best[Index(i)]; // the search puts onto a bound what is pushed against it
      fit.parameters.push_back(
          {.path = paths.front(),
           .also = {paths.begin() + 1, paths.end()},
           .start = from[Index(i)],
           .value = to[Index(i)],
           .sigma = {},
           .at_bound = (u == 0 || u == 1) && to[Index(i)] == problem_.unsettled(best)[Index(i)],
           .unit = unit_of_goal(paths.front(), problem_.data())});
    }
    Case design = with_design(problem_.data(), request_, to);
    for (const FitTie& t : request_.ties)
      fit.ties.push_back({t.path, *number_at(design, t.path), unit_of_goal(t.path, design)});
  }

  // Of the parameters within their bounds. A box direction that data and priors leave open gets no
  // standard deviation: half its width would be made up.
  void uncertainty(const ResidualModel& model, const VectorXd& best, FitResult& fit) const {
    const Index n = best.size();
    fit.correlation = MatrixXd::Zero(n, n);
    const std::optional<MatrixXd> J = residual_jacobian(model, best);
    if (!J) {
      fit.warnings.push_back("no uncertainties: the model has no result beside the best design");
      return;
    }
    std::vector<Index> inside;
    for (Index i = 0; i < n; ++i)
      if (!fit.parameters[std::size_t(i)].at_bound) inside.push_back(i);
    if (inside.empty()) return;
    // A constraint is no measurement: its rows come last and stay out.
    const Index rows = J->rows() - Index(request_.constraints.size());
    const MatrixXd own = J->topRows(rows)(Eigen::all, inside);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(MatrixXd(own.transpose() * own));
    const VectorXd& values = eigen.eigenvalues();
    const MatrixXd& vectors = eigen.eigenvectors();
    VectorXd closed(values.size()); // 1 / eigenvalue; the box itself bounds the open ones
    for (Index k = 0; k < values.size(); ++k) {
      const double effect = std::sqrt(std::max(0., values[k]));
      closed[k] = 1 / std::max(values[k], open_effect * open_effect);
      if (effect >= open_effect) continue;
      OpenDirection open{.parts = {}, .effect = effect};
      for (std::size_t i = 0; i < inside.size(); ++i)
        if (const double weight = vectors(Index(i), k); std::abs(weight) > 0.1)
          open.parts.emplace_back(fit.parameters[std::size_t(inside[i])].path, weight);
      fit.open.push_back(std::move(open));
    }
    const MatrixXd covariance = vectors * closed.asDiagonal() * vectors.transpose();
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const double sigma = std::sqrt(covariance(Index(i), Index(i)));
      FittedParameter& p = fit.parameters[std::size_t(inside[i])];
      const double width = 1 / std::sqrt(12.); // of an even distribution over the box
      p.known = std::clamp(1 - sigma / width, 0., 1.);
      if (sigma < width) p.sigma = sigma * problem_.slope(inside[i], best[inside[i]]);
      for (std::size_t j = 0; j < inside.size(); ++j)
        fit.correlation(inside[i], inside[j]) =
            covariance(Index(i), Index(j)) / sigma / std::sqrt(covariance(Index(j), Index(j)));
    }
  }

  void warn(FitResult& fit) const {
    const auto number = [](double v) { return short_text(v, 4); };
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
      const FittedParameter& p = fit.parameters[i];
      const FitParameter& asked = request_.parameters[i];
      if (p.at_bound)
        fit.warnings.push_back(p.path + " sits at its " +
                               (p.value == asked.bounds[0] ? "lower" : "upper") + " bound, " +
                               number(p.value) + ": the data would push it further");
      if (asked.physical && (p.value < (*asked.physical)[0] || p.value > (*asked.physical)[1]))
        fit.warnings.push_back(p.path + " left its physical range: " + number(p.value) +
                               " is outside of " + number((*asked.physical)[0]) + " to " +
                               number((*asked.physical)[1]) +
                               ". This fit compensates for something else.");
      if (asked.prior && std::abs(prior_residual(asked, p.value)) > 3)
        fit.warnings.push_back(p.path + " lies " +
                               number(std::abs(prior_residual(asked, p.value))) +
                               " standard deviations from what was known of it");
    }
    for (std::size_t i = 0; i < fit.constraints.size(); ++i) {
      const FittedConstraint& c = fit.constraints[i];
      const double sigmas = std::abs(problem_.broken(i, c.value));
      if (sigmas > 2)
        fit.warnings.push_back("constraint '" + c.name + "' is broken: " + number(c.value));
      else if (sigmas > 0)
        fit.warnings.push_back(
            "constraint '" + c.name + "' holds the design" +
            (fit.aims.empty() ? "; the uncertainties are those without it" : ""));
    }
    for (const FittedTarget& t : fit.targets)
      if (!t.held_out && std::abs(std::log(t.value / t.measured)) > 3 * t.sigma / t.measured)
        fit.warnings.push_back(
            t.quantity + " is missed by " + number(100 * (t.value / t.measured - 1)) + " %, " +
            number(std::abs(std::log(t.value / t.measured)) * t.measured / t.sigma) +
            " standard deviations: the model cannot meet all targets");
    for (const FittedStiffness& s : fit.stiffness)
      if (!s.held_out && s.value > 3 * s.sigma)
        fit.warnings.push_back(s.name + " is missed by " + number(100 * s.value) +
                               " % of its magnitude, " + number(s.value / s.sigma) +
                               " standard deviations: the model cannot meet all targets");
    if (!fit.converged && !fit.stopped)
      fit.warnings.push_back("the search did not converge: " + fit.reason);
  }

  const FitRequest& request_;
  FitProblem problem_;
};

// Place of each value in the order of all, equal ones sharing the mean of their places.
VectorXd ranks(const VectorXd& values) {
  std::vector<Index> order(std::size_t(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return values[a] < values[b]; });
  VectorXd rank(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) rank[order[k]] = double(i + end - 1) / 2;
    i = end;
  }
  return rank;
}

} // namespace

MatrixXd rank_correlation(const FitResult& fit) {
  const auto n = Index(fit.parameters.size()), m = Index(fit.targets.size()) + 1;
  const auto count = Index(fit.samples.size());
  MatrixXd columns(count, n + m);
  for (Index s = 0; s < count; ++s) {
    const FitSample& sample = fit.samples[std::size_t(s)];
    columns.row(s) << sample.design.transpose(), sample.targets.transpose(), sample.cost;
  }
  for (Index c = 0; c < n + m; ++c) {
    columns.col(c) = ranks(columns.col(c));
    columns.col(c).array() -= columns.col(c).mean();
    columns.col(c).normalize();
  }
  MatrixXd correlation = columns.leftCols(n).transpose() * columns.rightCols(m);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
      if (!(columns.col(i).norm() > 0.5) || !(columns.col(n + j).norm() > 0.5))
        correlation(i, j) = std::numeric_limits<double>::quiet_NaN();
  return correlation;
}

FitResult fit_case(const Case& data, const FitRequest& request, const TestData& test,
                   const FitSettings& settings) {
  return Fit(data, request, test, settings).result(settings);
}

} // namespace plica
