#include "diagnose/account/ledger.hpp"

#include "diagnose/weigh/normal_draws.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int draws_in_all = 60;

// Shares at one draw: of the effects, of the parts of what is left; of the readings.
struct OneDraw {
  VectorXd effects, left, readings;
  double weight = 0;
};

class Accounts {
public:
  Accounts(const FitContext& context, const HypothesisFit& nominal)
      : context_(context), rows_(context.fitted.rows()),
        covariance_(MatrixXd(context.uncertainty.total()(rows_, rows_))),
        nominal_(nominal.deviation), gap_(gap_of(nominal.deviation)) {
    const Uncertainty& u = context.uncertainty;
    for (const MatrixXd& part : {u.measurement, u.reassembly, MatrixXd(u.numeric + u.form)})
      expected_.push_back(covariance_.solve(MatrixXd(part(rows_, rows_))).trace() /
                          double(rows_.size()));
  }

  double gap() const { return gap_; }

  // Of a set at coordinates of its parameters; none where it has no stable structure.
  std::optional<OneDraw> at(const std::vector<const Hypothesis*>& together,
                            const VectorXd& z) const {
    const std::size_t n = together.size(), subsets = std::size_t(1) << n;
    VectorXd closed = VectorXd::Zero(Index(subsets)); // v(S)
    VectorXd deviation = nominal_;
    for (std::size_t subset = 1; subset < subsets; ++subset) {
      const auto left = deviation_of(together, z, subset);
      if (!left) return std::nullopt;
      closed[Index(subset)] = gap_ - gap_of(*left);
      if (subset + 1 == subsets) deviation = *left;
    }
    return account(shapley(closed, n), deviation);
  }

  OneDraw nothing(Index effects = 0) const { return account(VectorXd::Zero(effects), nominal_); }

private:
  double gap_of(const VectorXd& deviation) const {
    return context_.fitted(deviation).squaredNorm() / double(rows_.size());
  }

  // With the members whose bits are set, the others as the nominal case has them.
  std::optional<VectorXd> deviation_of(const std::vector<const Hypothesis*>& together,
                                       const VectorXd& z, std::size_t subset) const {
    std::vector<const Hypothesis*> members;
    VectorXd own(z.size());
    Index first = 0, used = 0;
    for (std::size_t i = 0; i < together.size(); ++i) {
      const auto size = Index(together[i]->parameters.size());
      if (subset >> i & 1) {
        members.push_back(together[i]);
        own.segment(used, size) = z.segment(first, size);
        used += size;
      }
      first += size;
    }
    return Deviation(context_, members).at(own.head(used), Predictor::Which::fitted);
  }

  static VectorXd shapley(const VectorXd& closed, std::size_t n) {
    VectorXd weight(static_cast<Index>(n)); // of a subset of so many others: s! (n - s - 1)! / n!
    for (std::size_t s = 0; s < n; ++s)
      weight[Index(s)] = std::exp(std::lgamma(double(s) + 1) + std::lgamma(double(n - s)) -
                                  std::lgamma(double(n) + 1));
    VectorXd shares = VectorXd::Zero(Index(n));
    for (std::size_t subset = 0; subset < std::size_t(closed.size()); ++subset) {
      std::size_t size = 0;
      for (std::size_t i = 0; i < n; ++i) size += subset >> i & 1;
      for (std::size_t i = 0; i < n; ++i)
        if (!(subset >> i & 1))
          shares[Index(i)] += weight[Index(size)] *
                              (closed[Index(subset | std::size_t(1) << i)] - closed[Index(subset)]);
    }
    return shares;
  }

  OneDraw account(const VectorXd& effects, const VectorXd& deviation) const {
    const double left = gap_of(deviation);
    double expected = 0;
    for (double part : expected_) expected += part;
    const double scale = std::min(1., left / expected);
    OneDraw draw{
        .effects = effects / gap_, .left = VectorXd(Index(expected_.size()) + 1), .readings = {}};
    for (std::size_t k = 0; k < expected_.size(); ++k)
      draw.left[Index(k)] = scale * expected_[k] / gap_;
    draw.left[Index(expected_.size())] = (left - scale * expected) / gap_;
    const VectorXd own = deviation(rows_);
    draw.readings = own.cwiseProduct(covariance_.solve(own)) / (double(rows_.size()) * gap_);
    return draw;
  }

  const FitContext& context_;
  const std::vector<Index>& rows_;
  Eigen::LLT<MatrixXd> covariance_; // before any effect
  VectorXd nominal_;
  double gap_;
  std::vector<double> expected_; // of measurement, mounting, model: in G
};

// Points of the posterior, its mode among them; of a fit with fewer draws as many as it has.
std::vector<VectorXd> points_of(const HypothesisFit& fit, int count) {
  std::vector<VectorXd> points{fit.z};
  if (fit.draws.cols() > 0) {
    count = std::min(count, int(fit.draws.cols()));
    for (int k = 1; k < count; ++k)
      points.emplace_back(fit.draws.col(Index(k) * fit.draws.cols() / count));
    return points;
  }
  const MatrixXd root = dispersed_covariance(fit, dispersion(fit)).llt().matrixL();
  NormalDraws normal(1);
  for (int k = 1; k < count; ++k) {
    VectorXd step(fit.z.size());
    for (double& x : step) x = normal();
    points.emplace_back(fit.z + root * step);
  }
  return points;
}

// The members that are accounted for, with their coordinates at each point.
std::pair<std::vector<const Hypothesis*>, std::vector<VectorXd>>
accounted(const LedgerSet& set, const std::vector<VectorXd>& points) {
  const HypothesisFit& fit = *set.fit;
  if (set.members.empty()) return {fit.together, points};
  std::vector<const Hypothesis*> together;
  std::vector<Index> rows;
  for (std::size_t member : set.members) {
    together.push_back(fit.together[member]);
    for (std::size_t p = 0; p < fit.together[member]->parameters.size(); ++p)
      rows.push_back(fit.first_of(member) + Index(p));
  }
  std::vector<VectorXd> own;
  for (const VectorXd& point : points) own.emplace_back(point(rows));
  return {std::move(together), std::move(own)};
}

// None where the structure is not stable.
std::vector<std::optional<OneDraw>> draws_at(const Accounts& accounts,
                                             const std::vector<const Hypothesis*>& together,
                                             const std::vector<VectorXd>& points) {
  std::vector<std::optional<OneDraw>> draws(points.size());
  in_parallel(int(points.size()), [&](int k) {
    draws[std::size_t(k)] = accounts.at(together, points[std::size_t(k)]);
  });
  return draws;
}

// The shortest interval that holds nine tenths of the draws: an effect cannot close more than all,
// so that its share is not spread to both sides alike.
std::array<double, 2> shortest_of(std::vector<std::pair<double, double>> weighed) {
  constexpr double held = 0.9 - 1e-9;
  std::sort(weighed.begin(), weighed.end());
  double sum = 0;
  for (const auto& [value, weight] : weighed) sum += weight;
  std::array<double, 2> shortest{weighed.front().first, weighed.back().first};
  double within = 0;
  for (std::size_t from = 0, to = 0; from < weighed.size(); ++from) {
    while (to < weighed.size() && within < held * sum) within += weighed[to++].second;
    if (within < held * sum) break;
    if (weighed[to - 1].first - weighed[from].first < shortest[1] - shortest[0])
      shortest = {weighed[from].first, weighed[to - 1].first};
    within -= weighed[from].second;
  }
  return shortest;
}

// An interval that holds its middle, too, which of draws of two kinds may lie outside the shortest,
// in whole percents: nothing is known closer, however narrow the draws are.
std::array<double, 2> stated(std::array<double, 2> interval, double middle) {
  constexpr double steps = 100, rounding = 1e-9;
  constexpr double plain_zero = 0; // -0 + 0 is 0
  return {std::floor(steps * std::min(interval[0], middle) + rounding) / steps + plain_zero,
          std::ceil(steps * std::max(interval[1], middle) - rounding) / steps + plain_zero};
}

// Mean and interval over the draws of a number that each has.
template <class Number>
std::pair<double, std::array<double, 2>> over(const std::vector<OneDraw>& draws, Number number) {
  std::vector<std::pair<double, double>> all;
  double sum = 0, mean = 0;
  for (const OneDraw& d : draws) {
    all.emplace_back(number(d), d.weight);
    sum += d.weight;
    mean += d.weight * number(d);
  }
  mean /= sum;
  return {mean, stated(shortest_of(std::move(all)), mean)};
}

} // namespace

std::vector<LedgerSet> sets_beside(const JudgedFit& lead, const std::vector<JudgedFit>& beside,
                                   const Inclusion& inclusion) {
  constexpr double counts = 0.03;
  std::vector<LedgerSet> sets;
  for (const JudgedFit& j : beside) {
    LedgerSet set{.fit = &j.fit,
                  .weight = std::exp(inclusion.log_weight(j) - inclusion.log_weight(lead))};
    if (set.weight < counts) continue;
    for (std::size_t i = 0; i + 1 < j.fit.together.size(); ++i) set.members.push_back(i);
    sets.push_back(std::move(set));
  }
  return sets;
}

Ledger ledger_of(const FitContext& context, const HypothesisFit& nominal,
                 const std::vector<LedgerSet>& sets, double none) {
  const Accounts accounts(context, nominal);
  Ledger ledger;
  ledger.gap = accounts.gap();
  ledger.readings = int(context.fitted.rows().size());
  if (!(ledger.gap > 0)) return ledger;
  std::vector<OneDraw> draws;
  double weights = 0;
  for (const LedgerSet& set : sets) weights += set.weight;
  for (const LedgerSet& set : sets) {
    constexpr int fewest = 20;
    const std::vector<VectorXd> points = points_of(
        *set.fit, std::max(fewest, int(std::lround(draws_in_all * set.weight / weights))));
    const auto [together, own] = accounted(set, points);
    for (auto& draw : draws_at(accounts, together, own))
      if (draw) {
        draw->weight = set.weight / double(points.size());
        draws.push_back(std::move(*draw));
      }
  }
  if (none > 0 || draws.empty()) {
    draws.push_back(accounts.nothing(draws.empty() ? 0 : draws.front().effects.size()));
    draws.back().weight = none > 0 ? none : 1;
  }
  for (Index i = 0; i < draws.front().effects.size(); ++i) {
    const auto [share, interval] = over(draws, [&](const OneDraw& d) { return d.effects[i]; });
    ledger.rows.push_back({.share = share, .interval = interval});
  }
  constexpr std::array kinds{Remainder::measurement, Remainder::mounting, Remainder::model,
                             Remainder::unexplained};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto [share, interval] = over(draws, [&](const OneDraw& d) { return d.left[Index(k)]; });
    ledger.rows.push_back({.left = kinds[k], .share = share, .interval = interval});
  }
  std::tie(ledger.explained, ledger.explained_interval) =
      over(draws, [](const OneDraw& d) { return d.effects.sum(); });
  for (std::size_t i = 0; i < context.fitted.rows().size(); ++i) {
    const Reading& reading = context.test.readings[std::size_t(context.fitted.rows()[i])];
    ledger.left_in.emplace_back(
        reading.name, over(draws, [&](const OneDraw& d) { return d.readings[Index(i)]; }).first);
  }
  std::stable_sort(ledger.left_in.begin(), ledger.left_in.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return ledger;
}

ShareDraws share_draws(const FitContext& context, const HypothesisFit& nominal,
                       const HypothesisFit& fit, int count) {
  const Accounts accounts(context, nominal);
  const auto rows = Index(fit.together.size()) + 1;
  if (fit.together.empty()) {
    const OneDraw nothing = accounts.nothing();
    return {MatrixXd(0, 1), MatrixXd::Constant(1, 1, nothing.left[nothing.left.size() - 1])};
  }
  const std::vector<VectorXd> points = points_of(fit, count);
  const auto all = draws_at(accounts, fit.together, points);
  ShareDraws draws{MatrixXd(fit.z.size(), Index(points.size())),
                   MatrixXd(rows, Index(points.size()))};
  Index kept = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!all[k]) continue;
    draws.z.col(kept) = points[k];
    draws.shares.col(kept) << all[k]->effects, all[k]->left[all[k]->left.size() - 1];
    ++kept;
  }
  draws.z.conservativeResize(Eigen::NoChange, kept);
  draws.shares.conservativeResize(Eigen::NoChange, kept);
  return draws;
}

} // namespace plica
