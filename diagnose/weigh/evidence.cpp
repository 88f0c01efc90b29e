#include "diagnose/weigh/evidence.hpp"

#include "compare/search/search.hpp"
#include "diagnose/weigh/normal_draws.hpp"
#include "diagnose/weigh/spread_point.hpp"
#include "solve/parallel.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double hopeless = 1e6;

constexpr double most_further = 0.5; // of a logarithm

// How far off a change of the structure may put a reading, in terms of what it changes.
double share_of_change(ReadingKind kind) {
  switch (kind) {
  case ReadingKind::cross:
    return 0.3;
  case ReadingKind::amplitude:
    return 0.1;
  case ReadingKind::frequency:
  case ReadingKind::stiffness:
    return 0.02;
  default:
    return 0;
  }
}

// Covariance of errors with these standard deviations that are one and the same within a series.
MatrixXd at_all_levels(const VectorXd& sigma, const std::vector<int>& series) {
  MatrixXd S = MatrixXd::Zero(sigma.size(), sigma.size());
  for (Index i = 0; i < sigma.size(); ++i)
    for (Index j = 0; j < sigma.size(); ++j)
      if (series[std::size_t(i)] == series[std::size_t(j)]) S(i, j) = sigma[i] * sigma[j];
  return S;
}

// ln of the standard normal density.
double log_normal(const VectorXd& z) {
  return -z.squaredNorm() / 2 - double(z.size()) / 2 * std::log(6.283185307179586);
}

// Where the chains begin: nine tenths near the optima, twice as wide as the Gaussian there, the
// rest from the prior, so that nothing the prior allows is out of reach.
class Reference {
public:
  explicit Reference(const HypothesisFit& fit) : centres_(fit.others), root_(4 * fit.covariance) {
    centres_.push_back(fit.z);
    const MatrixXd L = root_.matrixL();
    log_det_ = L.diagonal().array().log().sum();
  }
  VectorXd draw(const VectorXd& white, double u) const {
    if (u >= near) return white;
    const auto which = std::size_t(u / near * double(centres_.size()));
    return centres_[which] + root_.matrixL() * white;
  }
  double log_density(const VectorXd& z) const {
    double all = std::log(1 - near) + log_normal(z);
    for (const VectorXd& centre : centres_) {
      const double own = std::log(near / double(centres_.size())) +
                         log_normal(root_.matrixL().solve(z - centre)) - log_det_;
      all = std::max(all, own) + std::log1p(std::exp(-std::abs(all - own)));
    }
    return all;
  }

private:
  static constexpr double near = 0.9;
  std::vector<VectorXd> centres_;
  Eigen::LLT<MatrixXd> root_;
  double log_det_ = 0;
};

void finish(HypothesisFit& fit) {
  fit.chi2 = fit.error.squaredNorm();
  fit.farthest = fit.z.size() > 0 ? fit.z.cwiseAbs().maxCoeff() : 0;
  fit.log_evidence = log_evidence_at_width(fit, 1);
}

} // namespace

Deviation::Deviation(const FitContext& context, const std::vector<const Hypothesis*>& together)
    : context_(context), predict_(context.predictors.of(together)) {}

std::optional<VectorXd> Deviation::at(const VectorXd& z, Predictor::Which which) const {
  const auto y = predict_(predict_.values_of(z), which);
  return y ? std::optional(left_by(*y)) : std::nullopt;
}

std::optional<Deviation::Widened> Deviation::widened(const VectorXd& z,
                                                     Predictor::Which which) const {
  const VectorXd values = predict_.values_of(z);
  const auto y = predict_(values, which);
  if (!y) return std::nullopt;
  return Widened{.deviation = left_by(*y), .further = further(values, *y, which)};
}

MatrixXd Deviation::further(const VectorXd& values, const VectorXd& y,
                            Predictor::Which which) const {
  if (!predict_.changes_structure()) return MatrixXd();
  const Uncertainty& u = context_.uncertainty;
  VectorXd change = u.expected(y) - u.expected(u.nominal - u.correction);
  for (Index i = 0; i < change.size(); ++i)
    change[i] =
        std::isfinite(change[i])
            ? std::clamp(share_of_change(context_.test.readings[std::size_t(i)].kind) * change[i],
                         -most_further, most_further)
            : 0;
  MatrixXd S = at_all_levels(change, u.series);
  if (const VectorXd law = predict_.law_error(values, y, which); law.size() > 0) {
    S += at_all_levels(law, u.series);
    S.diagonal() += law.cwiseAbs2();
  }
  return S;
}

VectorXd Deviation::left_by(const VectorXd& y) const {
  const VectorXd d = context_.measured - context_.uncertainty.expected(y);
  constexpr double missing = 10; // where the model gives no number
  return d.array().isFinite().select(d, missing);
}

Whitening::Whitening(const TestReadings& test, const Uncertainty& u, bool held_out) {
  for (std::size_t i = 0; i < test.readings.size(); ++i)
    if (test.readings[i].held_out == held_out) rows_.push_back(Index(i));
  covariance_ = u.total()(rows_, rows_);
  root_.compute(covariance_);
}

Whitening Whitening::widened(const MatrixXd& further) const {
  Whitening wider = *this;
  if (further.size() == 0 || rows_.empty()) return wider;
  wider.covariance_ += further(rows_, rows_);
  wider.root_.compute(wider.covariance_);
  return wider;
}

double Whitening::log_det() const {
  return rows_.empty() ? 0 : MatrixXd(root_.matrixL()).diagonal().array().log().sum();
}

VectorXd Whitening::operator()(const VectorXd& deviation) const {
  if (rows_.empty()) return VectorXd();
  return root_.matrixL().solve(VectorXd(deviation(rows_)));
}

double log_evidence_at_width(const HypothesisFit& fit, double width) {
  double value = -fit.error.squaredNorm() / 2 - fit.penalty;
  if (fit.z.size() == 0) return value;
  value -= fit.z.squaredNorm() / (2 * width * width);
  const MatrixXd A =
      MatrixXd::Identity(fit.z.size(), fit.z.size()) + width * width * fit.J.transpose() * fit.J;
  return value - std::log(A.determinant()) / 2;
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

  // From the best of the starts: optima, the best first, with those nearly as good.
  std::vector<VectorXd> best() {
    std::sort(starts_.begin(), starts_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t refined = p_ > 1 ? 3 : 2;
    constexpr double apart = 0.8, as_good = 3;
    std::vector<std::pair<double, VectorXd>> found;
    std::vector<VectorXd> begun;
    for (const auto& [start_cost, start] : starts_) {
      if (begun.size() == refined) break;
      if (std::any_of(begun.begin(), begun.end(),
                      [&](const VectorXd& other) { return (start - other).norm() < apart; }))
        continue;
      begun.push_back(start);
      VectorXd z = start;
      constexpr int rounds = 2, steps = 15;
      for (int round = 0; round < rounds; ++round) {
        if (!widen(z)) break;
        z = search_freely(residuals(), z, steps).best;
        if (!deviation_.predictor().changes_structure()) break; // the weights stay
      }
      if (const auto cost = cost_at(z)) found.emplace_back(*cost, z);
    }
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<VectorXd> optima;
    for (const auto& [cost, z] : found)
      if (cost < found.front().first + as_good &&
          std::none_of(optima.begin(), optima.end(),
                       [&](const VectorXd& other) { return (z - other).norm() < apart / 2; }))
        optima.push_back(z);
    return optima;
  }

  // All that is known at the optimum.
  HypothesisFit at(const VectorXd& z) {
    HypothesisFit fit;
    const auto there = widen(z);
    const auto J = there ? free_jacobian(residuals(), z) : std::nullopt;
    fit.evaluations = evaluations_;
    if (!J) return fit;
    fit.solved = true;
    fit.complete = n_ == there->deviation.size();
    fit.z = z;
    fit.values = deviation_.predictor().values_of(z);
    fit.deviation = there->deviation;
    fit.further = there->further;
    fit.penalty = penalty_;
    fit.error = white_(there->deviation);
    fit.J = J->topRows(n_);
    fit.covariance = (MatrixXd::Identity(p_, p_) + fit.J.transpose() * fit.J).inverse();
    finish(fit);
    return fit;
  }

private:
  std::optional<Deviation::Widened> widen(const VectorXd& z) {
    ++evaluations_;
    auto there = deviation_.widened(z, Predictor::Which::fitted);
    if (there && there->further.size() > 0) {
      white_ = context_.fitted.widened(there->further);
      penalty_ = white_.log_det() - context_.fitted.log_det();
    }
    return there;
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

} // namespace

HypothesisFit fit_of(const FitContext& context, const std::vector<const Hypothesis*>& together,
                     const VectorXd& start) {
  Search search(context, together);
  const Index p = search.parameters();
  if (start.size() == p) {
    const Index second = Index(together[0]->parameters.size());
    for (double z : {0., -1.5, 1.5}) {
      VectorXd there = start;
      if (second < p) there[second] += z;
      search.try_from(there);
    }
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
  const std::vector<VectorXd> optima = search.best();
  HypothesisFit fit;
  if (!optima.empty()) {
    fit = search.at(optima.front());
    fit.others.assign(optima.begin() + 1, optima.end());
  }
  fit.together = together;
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

void sample(const FitContext& context, HypothesisFit& fit, int particles, unsigned seed) {
  if (fit.together.empty() || !fit.solved) return;
  const Deviation deviation(context, fit.together);
  const Index p = fit.z.size();
  NormalDraws normal(seed);
  const Reference reference(fit);
  const Whitening whitened = context.fitted.widened(fit.further);
  const auto log_target = [&](const VectorXd& z) { // likelihood times prior
    const auto d = deviation.at(z, Predictor::Which::fitted);
    return d ? -whitened(*d).squaredNorm() / 2 + log_normal(z) : -hopeless;
  };
  // All that is random is drawn in one order, whatever the threads.
  MatrixXd z(p, particles);
  VectorXd target(particles), start(particles);
  for (Index k = 0; k < particles; ++k) {
    VectorXd white(p);
    for (double& x : white) x = normal();
    z.col(k) = reference.draw(white, normal.uniform());
  }
  in_parallel(particles, [&](int k) {
    target[k] = log_target(z.col(k));
    start[k] = reference.log_density(z.col(k));
  });
  double power = 0, log_evidence = 0;
  constexpr int most_stages = 40;
  for (int stage = 0; stage < most_stages && power < 1; ++stage) {
    // The next power makes the weights vary by as much as they are on average.
    const VectorXd ratio = target - start;
    const double highest = ratio.maxCoeff();
    const auto weights = [&](double next) {
      return VectorXd(((next - power) * (ratio.array() - highest)).exp());
    };
    double low = power, high = 1;
    const auto varies = [&](double next) {
      const VectorXd w = weights(next);
      return std::sqrt((w.array() - w.mean()).square().mean()) / w.mean();
    };
    if (varies(1) > 1) {
      for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        (varies(middle) > 1 ? high : low) = middle;
      }
    } else {
      low = 1;
    }
    const VectorXd w = weights(low);
    log_evidence += std::log(w.mean()) + (low - power) * highest;
    power = low;
    const VectorXd share = w / w.sum();
    const VectorXd mean = z * share;
    const MatrixXd centred = z.colwise() - mean;
    constexpr double scale = 0.5; // of the covariance, squared
    MatrixXd C = scale * centred * share.asDiagonal() * centred.transpose();
    C.diagonal().array() += 1e-10;
    const MatrixXd root = C.llt().matrixL();
    MatrixXd next(p, particles);
    VectorXd next_target(particles), next_start(particles);
    // Systematic resampling, then a few steps of Metropolis from each.
    constexpr int moves = 2;
    std::vector<Index> origin;
    MatrixXd steps(p, moves * particles);
    VectorXd chance(moves * particles);
    double cumulated = share[0];
    Index from = 0;
    const double offset = normal.uniform();
    for (Index k = 0; k < particles; ++k) {
      const double position = (double(k) + offset) / particles;
      while (cumulated < position && from + 1 < particles) cumulated += share[++from];
      origin.push_back(from);
      for (Index m = moves * k; m < moves * (k + 1); ++m) {
        for (double& x : steps.col(m)) x = normal();
        chance[m] = normal.uniform();
      }
    }
    in_parallel(particles, [&](int k) {
      const Index of = origin[std::size_t(k)];
      VectorXd here = z.col(of);
      double own = target[of], own_start = start[of];
      for (Index m = moves * k; m < moves * (k + 1); ++m) {
        const VectorXd there = here + root * steps.col(m);
        const double value = log_target(there), there_start = reference.log_density(there);
        const double gain = power * (value - own) + (1 - power) * (there_start - own_start);
        if (std::log(chance[m]) < gain) {
          here = there;
          own = value;
          own_start = there_start;
        }
      }
      next.col(k) = here;
      next_target[k] = own;
      next_start[k] = own_start;
    });
    z = std::move(next);
    target = std::move(next_target);
    start = std::move(next_start);
  }
  fit.draws = z;
  if (power >= 1) fit.sampled_log_evidence = log_evidence - fit.penalty;
}

std::string name_of(const HypothesisFit& fit) {
  if (fit.together.empty()) return "nominal case";
  std::string name;
  for (const Hypothesis* h : fit.together) {
    if (!name.empty()) name += " and ";
    name += h->effect + " at " + h->place;
    if (!h->way.empty()) name += " (" + h->way + ")";
  }
  return name;
}

} // namespace plica
