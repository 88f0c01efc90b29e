#include "diagnose/weigh/evidence.hpp"

#include "compare/search/search.hpp"
#include "diagnose/weigh/ridge.hpp"
#include "diagnose/weigh/spread_point.hpp"
#include "diagnose/weigh/tempered_chains.hpp"
#include "diagnose/weigh/twins.hpp"
#include "run/results/normal_distribution.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double hopeless = 1e6;

bool far_from_all(const std::vector<VectorXd>& others, const VectorXd& z, double apart) {
  return std::none_of(others.begin(), others.end(),
                      [&](const VectorXd& other) { return (z - other).norm() < apart; });
}

// I + s J'J, what a posterior is worth in terms of its prior. By eigenvalues: at a brink, beyond
// which there is no stable structure, J is so steep that the sum is singular to rounding.
class Precision {
public:
  Precision(const MatrixXd& J, double s) : J_(J.transpose() * J) {
    values_ = J_.eigenvalues().cwiseMax(0) * s;
  }
  double log_determinant() const { return values_.array().log1p().sum(); }
  MatrixXd inverse() const {
    const VectorXd variance = (1 + values_.array()).inverse();
    return J_.eigenvectors() * variance.asDiagonal() * J_.eigenvectors().transpose();
  }

private:
  Eigen::SelfAdjointEigenSolver<MatrixXd> J_;
  VectorXd values_;
};

void finish(HypothesisFit& fit) {
  fit.chi2 = fit.error.squaredNorm();
  fit.farthest = fit.z.size() > 0 ? fit.z.cwiseAbs().maxCoeff() : 0;
  fit.log_evidence = log_evidence_at_width(fit, 1);
}

} // namespace

double log_evidence_at_width(const HypothesisFit& fit, double width) {
  double value = -fit.error.squaredNorm() / 2 - fit.penalty;
  if (fit.z.size() == 0) return value;
  return value - fit.z.squaredNorm() / (2 * width * width) -
         Precision(fit.J, width * width).log_determinant() / 2;
}

constexpr double stated_as = 4; // readings that the stated errors are worth, for their size

double dispersion(const HypothesisFit& fit) {
  return std::max(1.,
                  (stated_as + fit.error.squaredNorm()) / (stated_as + double(fit.error.size())));
}

double dispersed_log_evidence(const HypothesisFit& fit) {
  const double n = double(fit.error.size());
  double value =
      -(stated_as + n) / 2 * std::log1p(fit.error.squaredNorm() / stated_as) - fit.penalty;
  if (fit.z.size() == 0) return value;
  return value - fit.z.squaredNorm() / 2 -
         Precision(fit.J, 1 / dispersion(fit)).log_determinant() / 2;
}

MatrixXd dispersed_covariance(const HypothesisFit& fit, double dispersion) {
  return Precision(fit.J, 1 / dispersion).inverse();
}

HypothesisFit nominal_fit(const FitContext& context) {
  HypothesisFit fit;
  fit.solved = fit.complete = true;
  fit.deviation = context.measured - context.uncertainty.nominal - context.uncertainty.bias;
  fit.error = context.fitted(fit.deviation);
  fit.J = MatrixXd(fit.error.size(), 0);
  finish(fit);
  return fit;
}

namespace {

// The search of one fit. What the readings are weighed by is held while a step is made, and renewed
// between searches.
class Search {
public:
  Search(const FitContext& context, const std::vector<const Hypothesis*>& together)
      : context_(context), deviation_(context, together), white_(context.fitted),
        p_(deviation_.predictor().parameters()), n_(Index(context.fitted.rows().size())) {}

  Index parameters() const { return p_; }

  // A point to begin at.
  void try_from(const VectorXd& z) {
    if (const auto cost = cost_at(z)) starts_.emplace_back(*cost, z);
  }

  // From the best of the starts, so many of them and so far from each other: optima, the best
  // first, with those nearly as good.
  std::vector<VectorXd> best(std::size_t refined, double apart) {
    std::sort(starts_.begin(), starts_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr double as_good = 3;
    std::vector<std::pair<double, VectorXd>> found;
    std::vector<VectorXd> begun;
    for (const auto& [start_cost, start] : starts_) {
      if (begun.size() == refined) break;
      if (!far_from_all(begun, start, apart)) continue;
      begun.push_back(start);
      refine(start, found);
    }
    const auto cheaper = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::sort(found.begin(), found.end(), cheaper);
    if (deviation_.predictor().changes_structure()) { // else the weights stay as they are
      constexpr double within_reach = 10;
      const std::vector<std::pair<double, VectorXd>> once = std::move(found);
      found.clear();
      for (const auto& [cost, z] : once)
        if (cost < once.front().first + within_reach) refine(z, found);
      std::sort(found.begin(), found.end(), cheaper);
    }
    std::vector<VectorXd> optima;
    for (const auto& [cost, z] : found)
      if (cost < found.front().first + as_good && far_from_all(optima, z, apart / 2))
        optima.push_back(z);
    return optima;
  }

  // All that is known at the optimum.
  HypothesisFit at(const VectorXd& z) {
    HypothesisFit fit;
    const auto there = widen(z);
    const auto J = there ? free_jacobian(residuals(), z) : std::nullopt;
    fit.evaluations = evaluations_;
    if (!J || !J->allFinite()) return fit;
    fit.solved = true;
    fit.complete = n_ == there->deviation.size();
    fit.z = z;
    fit.values = deviation_.predictor().values_of(z);
    fit.deviation = there->deviation;
    fit.further = there->further;
    fit.penalty = penalty_;
    fit.aside = there->aside;
    fit.error = white_(there->deviation);
    fit.J = J->topRows(n_);
    fit.covariance = Precision(fit.J, 1).inverse();
    finish(fit);
    return fit;
  }

private:
  std::optional<Deviation::Widened> widen(const VectorXd& z) {
    ++evaluations_;
    auto there = deviation_.widened(z, Predictor::Which::fitted);
    if (there && there->further.size() > 0) {
      white_ = context_.fitted.widened(there->further);
      penalty_ = white_.log_det() - context_.fitted.log_det() + there->penalty;
    }
    return there;
  }

  // Searches on with the weights of where it begins.
  void refine(const VectorXd& from, std::vector<std::pair<double, VectorXd>>& found) {
    constexpr int steps = 15;
    if (!widen(from)) return;
    const VectorXd z = search_freely(residuals(), from, steps).best;
    if (const auto cost = cost_at(z)) found.emplace_back(*cost, z);
  }

  // Weighed by its own covariance.
  std::optional<double> cost_at(const VectorXd& z) {
    const auto there = widen(z);
    if (!there) return std::nullopt;
    return (white_(there->deviation).squaredNorm() + z.squaredNorm()) / 2 + penalty_;
  }

  ResidualModel residuals() {
    return [this](const VectorXd& z) -> std::optional<VectorXd> {
      ++evaluations_;
      const auto d = deviation_.at(z, Predictor::Which::fitted);
      VectorXd r(n_ + p_);
      r.tail(p_) = z;
      r.head(n_) = d ? white_(*d) : VectorXd::Constant(n_, hopeless);
      return r;
    };
  }

  const FitContext& context_;
  Deviation deviation_;
  Whitening white_;
  double penalty_ = 0;
  Index p_, n_;
  std::atomic<int> evaluations_{0};
  std::vector<std::pair<double, VectorXd>> starts_;
};

// Puts a hypothesis, whose coordinates begin at `first`, at one of as many places along each way of
// its part.
void put_at(const Hypothesis& h, int place, int stations, Index first, VectorXd& z) {
  for (const std::size_t parameter : h.along) {
    z[first + Index(parameter)] = normal_quantile((place % stations + 0.5) / stations);
    place /= stations;
  }
}

// Places on a part that answer alike lie anywhere: all of it is looked at, at several sizes, and
// where more than a size goes with the place at values that differ from place to place.
std::vector<VectorXd> throughout(const Hypothesis& h) {
  std::vector<VectorXd> all;
  const bool on_line = h.along.size() == 1;
  const int stations = on_line ? 40 : 9, places = on_line ? stations : stations * stations;
  const Index parameters = Index(h.parameters.size());
  const bool only_size = parameters == Index(h.along.size()) + 1;
  for (int i = 0; i < places; ++i)
    for (double size : {-1.2, -0.6, 0., 0.6, 1.2}) {
      VectorXd there = only_size ? VectorXd::Constant(parameters, size)
                                 : spread_point(int(all.size()), parameters, 1.5);
      put_at(h, i, stations, 0, there);
      all.push_back(std::move(there));
    }
  return all;
}

// Places for two of one effect on one part: where one of them lies best alone is where neither need
// be, so both are tried throughout, at sizes of either. `start`: of the other members.
void try_pairs(const VectorXd& start, const std::vector<const Hypothesis*>& together,
               Search& search) {
  const Hypothesis& h = *together.back();
  const Index size = Index(h.parameters.size()), last = start.size() - size;
  Index first = 0;
  for (std::size_t member = 0; together[member] != &h; ++member)
    first += Index(together[member]->parameters.size());
  const int stations = h.along.size() == 1 ? 12 : 4;
  const int places = h.along.size() == 1 ? stations : stations * stations;
  for (int i = 0; i < places; ++i)
    for (int j = 0; j < places; ++j) {
      if (i == j) continue;
      for (const auto& [one, other] : {std::pair{-0.5, -0.5}, {-0.5, 0.7}, {0.7, 0.7}}) {
        VectorXd there = start;
        there.segment(first, size).setConstant(one);
        there.segment(last, size).setConstant(other);
        put_at(h, i, stations, first, there);
        put_at(h, j, stations, last, there);
        search.try_from(there);
      }
    }
}

// A start, and others with the last of its hypotheses larger, smaller and elsewhere on its part.
void try_around(const VectorXd& start, const Hypothesis& last, Search& search) {
  const Index first = start.size() - Index(last.parameters.size());
  constexpr std::array away{0., -1.5, 1.5};
  for (double z : away) {
    VectorXd there = start;
    if (first < start.size()) there[first] += z;
    search.try_from(there);
  }
  const std::size_t each = last.along.empty() ? 1 : away.size();
  for (std::size_t i = 1; i < (last.along.size() == 2 ? each * each : each); ++i) {
    VectorXd there = start;
    std::size_t left = i;
    for (const std::size_t parameter : last.along) {
      there[first + Index(parameter)] += away[left % each];
      left /= each;
    }
    search.try_from(there);
  }
}

} // namespace

HypothesisFit fit_of(const FitContext& context, const std::vector<const Hypothesis*>& together,
                     const VectorXd& start) {
  Search search(context, together);
  const Index p = search.parameters();
  std::size_t refined = p > 1 ? 3 : 2;
  double apart = 0.8; // in standard deviations of the priors
  if (start.size() == p) {
    try_around(start, *together.back(), search);
    if (ends_with_twin(together)) {
      try_pairs(start, together, search);
      refined = 8;
    }
  } else if (together.size() == 1 && !together[0]->along.empty()) {
    for (const VectorXd& there : throughout(*together[0])) search.try_from(there);
    refined = 10;
    apart = 0.2;
  } else if (together.size() == 1 && together[0]->softening && p == 6) {
    // Ratio, share, slip, exponent, across, loss: the slip distance decides, so it is tried
    // throughout.
    for (double slip = -2.5; slip <= 2.6; slip += 0.5)
      for (double share : {-0.8, 0.4})
        for (double exponent : {-0.7, 0.7})
          search.try_from((VectorXd(6) << 0, share, slip, exponent, 0, 0).finished());
  } else {
    const int tried = p == 1 ? 7 : p == 2 ? 16 : 28;
    for (int i = 0; i < tried; ++i) search.try_from(spread_point(i, p, 2.5));
  }
  const std::vector<VectorXd> optima = search.best(refined, apart);
  HypothesisFit fit;
  if (!optima.empty()) {
    fit = search.at(optima.front());
    fit.others.assign(optima.begin() + 1, optima.end());
  }
  fit.together = together;
  for (VectorXd& other : fit.others) other = in_order_of(fit, std::move(other));
  return fit;
}

void complete(const FitContext& context, HypothesisFit& fit) {
  if (fit.complete || !fit.solved) return;
  const Deviation deviation(context, fit.together);
  if (auto there = deviation.widened(fit.z, Predictor::Which::all)) {
    fit.deviation = std::move(there->deviation);
    fit.further = std::move(there->further);
  }
  fit.complete = true;
}

namespace {

bool acts_along(const Hypothesis* h) {
  return !h->along.empty();
}

// Where the chains of a fit begin: at its optima and on the ridges of its places.
std::vector<ChainStart> starts_of(const HypothesisFit& fit, const ResidualModel& residuals,
                                  double dispersion) {
  const MatrixXd covariance = dispersed_covariance(fit, dispersion);
  std::vector<ChainStart> starts{{fit.z, covariance}};
  for (const VectorXd& other : fit.others) starts.push_back({other, covariance});
  for (std::size_t member = 0; member < fit.together.size(); ++member)
    for (const std::size_t along : fit.together[member]->along)
      for (ChainStart& start : ridge_from(residuals, fit.z, fit.first_of(member) + Index(along)))
        starts.push_back(std::move(start));
  return starts;
}

} // namespace

void sample(const FitContext& context, HypothesisFit& fit, int particles, unsigned seed,
            double dispersion) {
  if (fit.together.empty() || !fit.solved) return;
  const Deviation deviation(context, fit.together);
  const Whitening whitened = context.fitted.widened(fit.further);
  const auto error = [&](const VectorXd& z) -> std::optional<VectorXd> {
    const auto d = deviation.at(z, Predictor::Which::fitted);
    return d ? std::optional(VectorXd(whitened(*d) / std::sqrt(dispersion))) : std::nullopt;
  };
  const ResidualModel residuals = [&](const VectorXd& z) -> std::optional<VectorXd> {
    const auto own = error(z);
    if (!own) return std::nullopt;
    VectorXd r(own->size() + z.size());
    r << *own, z;
    return r;
  };
  const auto log_likelihood = [&](const VectorXd& z) -> std::optional<double> {
    const auto own = error(z);
    return own ? std::optional(-own->squaredNorm() / 2) : std::nullopt;
  };
  constexpr int of_a_place = 4; // as many, where what is told is their density (likely_values.hpp)
  if (std::any_of(fit.together.begin(), fit.together.end(), acts_along)) particles *= of_a_place;
  ChainDraws drawn =
      tempered_chains(starts_of(fit, residuals, dispersion), log_likelihood, particles, seed);
  fit.draws = std::move(drawn.z);
  for (auto draw : fit.draws.colwise()) draw = in_order_of(fit, draw);
  if (drawn.log_evidence && dispersion == 1)
    fit.sampled_log_evidence = *drawn.log_evidence - fit.penalty;
}

} // namespace plica
