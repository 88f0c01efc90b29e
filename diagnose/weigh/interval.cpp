#include "diagnose/weigh/interval.hpp"

#include "diagnose/weigh/blocks.hpp"
#include "run/results/normal_distribution.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;

constexpr double share = 0.9;

struct Point {
  double z = 0, weight = 0;
};

void add_points(std::vector<Point>& all, const HypothesisFit& fit, Index parameter, double weight) {
  constexpr Index fewest = 20;
  if (fit.draws.cols() > fewest) {
    for (double z : fit.draws.row(parameter)) all.push_back({z, weight / double(fit.draws.cols())});
    return;
  }
  constexpr int points = 200;
  const double sigma = std::sqrt(fit.covariance(parameter, parameter));
  for (int i = 0; i < points; ++i)
    all.push_back(
        {fit.z[parameter] + sigma * normal_quantile((i + 0.5) / points), weight / points});
}

// Coordinates in even steps of their probability, increasing.
std::vector<double> drawn(const std::vector<const HypothesisFit*>& ways, Index parameter) {
  std::vector<Point> all;
  double highest = -1e300;
  for (const HypothesisFit* fit : ways) highest = std::max(highest, fit->log_evidence);
  for (const HypothesisFit* fit : ways)
    add_points(all, *fit, parameter, std::exp(fit->log_evidence - highest));
  std::sort(all.begin(), all.end(), [](const Point& a, const Point& b) { return a.z < b.z; });
  double sum = 0;
  for (const Point& p : all) sum += p.weight;
  constexpr int steps = 400;
  std::vector<double> z;
  double reached = 0;
  for (const Point& p : all) {
    reached += p.weight / sum;
    while (int(z.size()) < steps && (double(z.size()) + 0.5) / steps <= reached) z.push_back(p.z);
  }
  while (int(z.size()) < steps) z.push_back(all.back().z);
  return z;
}

// Of points that stand for even steps of the probability, between them: by rank alone the ends of
// an interval would jump.
double at_probability(const std::vector<double>& values, double p) {
  const double at = p * double(values.size()) - 0.5;
  const auto i = std::size_t(at);
  return values[i] + (at - double(i)) * (values[i + 1] - values[i]);
}

std::array<double, 2> shortest(const std::vector<double>& values, double low, double high) {
  const std::size_t n = values.size(), inside = std::size_t(share * double(n));
  std::size_t best = 0;
  for (std::size_t i = 0; i + inside < n; ++i)
    if (values[i + inside] - values[i] < values[best + inside] - values[best]) best = i;
  const std::size_t at_the_end = n / 50;
  const double near = 0.05 * (values[best + inside] - values[best]); // so close draws crowd at it
  return {best <= at_the_end && values.front() - low < near ? low : values[best],
          best + inside + at_the_end >= n - 1 && high - values.back() < near
              ? high
              : values[best + inside]};
}

} // namespace

Interval interval_of(const std::vector<const HypothesisFit*>& ways, Index parameter,
                     const Prior& prior) {
  std::vector<double> values = drawn(ways, parameter);
  const HypothesisFit& first = *ways.front();
  const bool of_a_law = std::any_of(first.together.begin(), first.together.end(),
                                    [](const Hypothesis* h) { return h->law_error > 0; });
  constexpr double wider = 2;
  if (of_a_law)
    for (double& z : values) z = first.z[parameter] + wider * (z - first.z[parameter]);
  for (double& z : values) z = value_of(prior, z);
  const double middle = at_probability(values, 0.5);
  if (prior.lies_between()) return {shortest(values, prior.centre, prior.width), middle};
  if (prior.bounded()) {
    const auto end = [&](double bound, double z) {
      return std::isfinite(bound) ? bound : value_of(prior, z);
    };
    return {shortest(values, end(prior.low, -5), end(prior.high, 5)), middle};
  }
  return {{at_probability(values, (1 - share) / 2), at_probability(values, (1 + share) / 2)},
          middle};
}

} // namespace plica
