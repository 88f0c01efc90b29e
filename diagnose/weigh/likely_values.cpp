#include "diagnose/weigh/likely_values.hpp"

#include "diagnose/weigh/nearest_rank.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double quantile(VectorXd values, double share) {
  double* middle = values.data() + nearest_rank(std::size_t(values.size()), share);
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

// Silverman's width of a kernel for points that spread like these.
double kernel_width(const VectorXd& at) {
  const double spread = std::sqrt((at.array() - at.mean()).square().mean());
  const double quartiles = (quantile(at, 0.75) - quantile(at, 0.25)) / 1.34;
  return 0.9 * std::min(spread, quartiles) * std::pow(double(at.size()), -0.2);
}

double densest(const VectorXd& at, double width) {
  Index best = 0;
  double most = -1;
  for (Index i = 0; i < at.size(); ++i) {
    const double density = (-0.5 * ((at.array() - at[i]) / width).square()).exp().sum();
    if (density > most) {
      most = density;
      best = i;
    }
  }
  return at[best];
}

std::vector<Index> within(const VectorXd& at, double place, double reach) {
  std::vector<Index> near;
  for (Index i = 0; i < at.size(); ++i)
    if (std::abs(at[i] - place) <= reach) near.push_back(i);
  return near;
}

} // namespace

VectorXd likely_values(const HypothesisFit& fit, std::size_t member) {
  const Hypothesis& h = *fit.together[member];
  const Index first = fit.first_of(member), count = Index(h.parameters.size());
  const VectorXd optimum = fit.values.segment(first, count);
  constexpr Index fewest = 20;
  if (!h.along || fit.draws.cols() < fewest) return optimum;
  const auto drawn = [&](Index parameter) {
    return VectorXd(fit.draws.row(first + parameter).transpose().unaryExpr([&](double z) {
      return value_of(h.parameters[std::size_t(parameter)].prior, z);
    }));
  };
  const VectorXd at = drawn(Index(*h.along));
  double width = kernel_width(at);
  if (!(width > 0)) return optimum;
  double place = 0;
  constexpr int times = 5;
  constexpr double reach = 4; // widths of the kernel: two places lie farther apart
  for (int i = 0; i < times; ++i) {
    place = densest(at, width);
    const std::vector<Index> near = within(at, place, reach * width);
    if (Index(near.size()) < fewest) break;
    const double narrower = kernel_width(at(near));
    if (!(narrower > 0 && narrower < width)) break;
    width = narrower;
  }
  const std::vector<Index> near = within(at, place, width);
  VectorXd likely = optimum;
  for (Index k = 0; k < count; ++k) likely[k] = quantile(VectorXd(drawn(k)(near)), 0.5);
  likely[Index(*h.along)] = place;
  return likely;
}

} // namespace plica
