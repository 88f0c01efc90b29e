#include "diagnose/weigh/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double most_further = 0.5; // of a logarithm
constexpr double tail_freedom = 4;   // of the t variable
constexpr double far_off = 5;        // variance beyond its own that is worth a word

// How far off a change of the structure may put a reading, in terms of what it changes; `stated`:
// beside a baseline.
double share_of_change(ReadingKind kind, double stated) {
  switch (kind) {
  case ReadingKind::cross:
    return std::max(0.3, stated);
  case ReadingKind::amplitude:
  case ReadingKind::component:
    return std::max(0.1, 2 * stated);
  case ReadingKind::frequency:
  case ReadingKind::stiffness:
  case ReadingKind::dynamic_stiffness:
    return stated > 0 ? stated : 0.02;
  default:
    return 0;
  }
}

// What changes the structure of a real specimen changes its damping too, nobody knows how: in terms
// of the largest change of a frequency, up to a limit.
constexpr double damping_per_change = 5, most_damping = 0.3;
// A mode that a model has at rest at the spot is not quite so: of the largest change of a
// frequency.
constexpr double least_share = 0.2;

// Covariance of errors with these standard deviations that are one and the same within a series.
MatrixXd at_all_levels(const VectorXd& sigma, const std::vector<int>& series) {
  MatrixXd S = MatrixXd::Zero(sigma.size(), sigma.size());
  for (Index i = 0; i < sigma.size(); ++i)
    for (Index j = 0; j < sigma.size(); ++j)
      if (series[std::size_t(i)] == series[std::size_t(j)]) S(i, j) = sigma[i] * sigma[j];
  return S;
}

} // namespace

Deviation::Deviation(const FitContext& context, const std::vector<const Hypothesis*>& together)
    : context_(context), predict_(context.predictors.of(together)) {}

std::optional<VectorXd> Deviation::at(const VectorXd& z, Predictor::Which which) const {
  const auto y = predict_.answered(predict_.values_of(z), which);
  return y ? std::optional(left_by(*y)) : std::nullopt;
}

std::optional<Deviation::Widened> Deviation::widened(const VectorXd& z,
                                                     Predictor::Which which) const {
  const VectorXd values = predict_.values_of(z);
  const auto y = predict_.answered(values, which);
  if (!y) return std::nullopt;
  Widened there{.deviation = left_by(*y), .further = {}};
  if (!predict_.changes_structure()) return there;
  VectorXd error = change_error(*y);
  if (context_.uncertainty.change_error > 0) error = let_off(error, there);
  there.further = covariance(error, predict_.law_error(values, y->log, which));
  return there;
}

MatrixXd Deviation::further(const VectorXd& values, const Answered& y,
                            Predictor::Which which) const {
  if (!predict_.changes_structure()) return MatrixXd();
  return covariance(change_error(y), predict_.law_error(values, y.log, which));
}

MatrixXd Deviation::covariance(const VectorXd& error, const VectorXd& law) const {
  MatrixXd S = at_all_levels(error, context_.uncertainty.series);
  if (law.size() > 0) {
    S += at_all_levels(law, context_.uncertainty.series);
    S.diagonal() += law.cwiseAbs2();
  }
  return S;
}

// Standard deviations of what is changed, with the sign of the change.
VectorXd Deviation::change_error(const Answered& y) const {
  const Uncertainty& u = context_.uncertainty;
  VectorXd change = u.expected(y) - (u.nominal + u.bias);
  double largest = 0;
  for (Index i = 0; i < change.size(); ++i) {
    const ReadingKind kind = context_.test.readings[std::size_t(i)].kind;
    if (!std::isfinite(change[i])) change[i] = 0;
    if (kind == ReadingKind::frequency) largest = std::max(largest, std::abs(change[i]));
    change[i] =
        std::clamp(share_of_change(kind, u.change_error) * change[i], -most_further, most_further);
  }
  const VectorXd across = u.further_cross(y);
  for (Index i = 0; i < change.size(); ++i)
    change[i] = std::copysign(std::hypot(change[i], across[i]), change[i]);
  if (!(u.change_error > 0)) return change;
  for (Index i = 0; i < change.size(); ++i) {
    const ReadingKind kind = context_.test.readings[std::size_t(i)].kind;
    if (kind == ReadingKind::damping || kind == ReadingKind::loss)
      change[i] = std::min(most_damping, damping_per_change * largest);
    if (kind == ReadingKind::frequency)
      change[i] =
          std::copysign(std::hypot(change[i], u.change_error * least_share * largest), change[i]);
  }
  return change;
}

// The error of each series of readings is a t variable: normal with a variance that may be larger
// by a factor w, which costs what its prior says. By expectation and maximisation, over what is
// fitted.
VectorXd Deviation::let_off(const VectorXd& error, Widened& there) const {
  const std::vector<Index>& rows = context_.fitted.rows();
  const std::vector<int>& series = context_.uncertainty.series;
  std::map<int, std::vector<Index>> members; // of a series: places among `rows`
  for (std::size_t k = 0; k < rows.size(); ++k)
    members[series[std::size_t(rows[k])]].push_back(Index(k));
  const VectorXd tau = error(rows), d = there.deviation(rows);
  const MatrixXd base = context_.uncertainty.total()(rows, rows);
  std::map<int, double> factor;
  for (const auto& [number, own] : members) factor[number] = 1;
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    MatrixXd C = base;
    for (const auto& [number, own] : members)
      C(own, own) += factor[number] * tau(own) * tau(own).transpose();
    const Eigen::LLT<MatrixXd> root(C);
    const VectorXd x = root.solve(d);
    for (const auto& [number, own] : members) {
      VectorXd t = VectorXd::Zero(tau.size());
      t(own) = tau(own);
      const double w = factor[number], mean = w * t.dot(x);
      const double variance = w - w * w * root.matrixL().solve(t).squaredNorm();
      factor[number] = (tail_freedom + mean * mean + std::max(0., variance)) / (tail_freedom + 1);
    }
  }
  VectorXd scaled = error;
  for (Index i = 0; i < error.size(); ++i)
    if (const auto own = factor.find(series[std::size_t(i)]); own != factor.end())
      scaled[i] *= std::sqrt(own->second);
  for (const auto& [number, w] : factor) {
    there.penalty += tail_freedom / 2 * (std::log(w) + 1 / w - 1);
    if (w > far_off) there.aside.push_back(rows[std::size_t(members[number].front())]);
  }
  return scaled;
}

VectorXd Deviation::left_by(const Answered& y) const {
  const VectorXd d = context_.measured - context_.uncertainty.expected(y);
  constexpr double missing = 10; // where the model gives no number
  return d.array().isFinite().select(d, missing);
}

} // namespace plica
