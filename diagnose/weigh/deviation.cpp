#include "diagnose/weigh/deviation.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

} // namespace plica
