#include "diagnose/weigh/ridge.hpp"

#include "run/results/normal_distribution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int places_tried = 24; // in even shares of the prior of the place
constexpr double reach = 6;      // nats below the best
constexpr double widest = 0.2;   // of the place, in its coordinate

std::vector<Index> all_but(Index row, Index count) {
  std::vector<Index> others;
  for (Index i = 0; i < count; ++i)
    if (i != row) others.push_back(i);
  return others;
}

// With coordinate `row` held, the best of the others from there on; none where that cannot be.
std::optional<VectorXd> best_at(const ResidualModel& residuals, VectorXd z, Index row,
                                double place) {
  constexpr int steps = 8;
  z[row] = place;
  if (!residuals(z)) return std::nullopt;
  const std::vector<Index> others = all_but(row, z.size());
  const ResidualModel held = [&](const VectorXd& own) {
    VectorXd there = z;
    there(others) = own;
    return residuals(there);
  };
  z(others) = search_freely(held, z(others), steps).best;
  return z;
}

// The Gaussian of a linearised fit whose coordinate `row` reaches its neighbours at most: what the
// others are beside it, and how they follow it.
MatrixXd gaussian_at(const MatrixXd& J, Index row) {
  const MatrixXd H = J.transpose() * J;
  const std::vector<Index> others = all_but(row, H.rows());
  const MatrixXd beside = MatrixXd(H(others, others)).inverse();
  VectorXd follows = VectorXd::Unit(H.rows(), row);
  follows(others) = -beside * VectorXd(H(others, row));
  const double stiffness = H(row, row) + H(others, row).dot(follows(others));
  MatrixXd covariance = std::min(widest * widest, 1 / stiffness) * follows * follows.transpose();
  covariance(others, others) += beside;
  return covariance;
}

} // namespace

std::vector<ChainStart> ridge_from(const ResidualModel& residuals, const VectorXd& top, Index row) {
  std::array<double, places_tried> places;
  for (int i = 0; i < places_tried; ++i)
    places[std::size_t(i)] = normal_quantile((i + 0.5) / places_tried);
  const auto above = std::lower_bound(places.begin(), places.end(), top[row]);
  std::vector<std::pair<double, VectorXd>> found;
  const auto gets_to = [&](VectorXd& z, double place) {
    const auto there = best_at(residuals, z, row, place);
    if (!there) return false;
    z = *there;
    found.emplace_back(cost_of(residuals(z)), z);
    return true;
  };
  VectorXd z = top;
  for (auto place = above; place != places.end() && gets_to(z, *place);) ++place;
  z = top;
  for (auto place = above; place != places.begin() && gets_to(z, *(place - 1));) --place;

  double best = cost_of(residuals(top));
  for (const auto& [cost, at] : found) best = std::min(best, cost);
  std::vector<ChainStart> ridge;
  for (const auto& [cost, at] : found) {
    if (cost > best + reach) continue;
    if (const auto J = free_jacobian(residuals, at)) ridge.push_back({at, gaussian_at(*J, row)});
  }
  return ridge;
}

} // namespace plica
