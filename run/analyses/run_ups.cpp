#include "run/analyses/run_ups.hpp"

#include "run/analyses/order_sweeps.hpp"
#include "solve/frequency_grid.hpp"
#include "solve/modes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::set<double> orders_of(const RunUp& asked) {
  std::set<double> orders;
  for (const EngineOrder& o : asked.orders) orders.insert(o.order);
  return orders;
}

// Even steps, the crossings with their surroundings, and the corners of the tables.
VectorXd speed_grid(const RunUp& asked, const DampedModes& modes) {
  const auto [low, high] = speeds(asked);
  VectorXd found(modes.solution.modes), zeta(modes.solution.modes);
  for (int j = 0; j < modes.solution.modes; ++j) {
    found[j] = frequency_of(modes, j);
    zeta[j] = damping_of(modes, j);
  }
  std::vector<double> all;
  for (const double order : orders_of(asked))
    for (const double f : frequency_grid(order * low, order * high, asked.points, found, zeta))
      all.push_back(f / order);
  for (const EngineOrder& o : asked.orders)
    for (const auto& row : o.table)
      if (row[0] > low && row[0] < high) all.push_back(row[0]);
  std::sort(all.begin(), all.end());
  const double close = 1e-9 * high;
  all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a < close; }),
            all.end());
  return VectorXd::Map(all.data(), Index(all.size()));
}

// Largest rate at which the speed runs through this one, 1/s2; none without a table over time.
std::optional<double> rate_at(const RunUp& asked, double speed) {
  std::optional<double> rate;
  for (std::size_t i = 1; i < asked.table.size(); ++i) {
    const auto& [t0, n0] = asked.table[i - 1];
    const auto& [t1, n1] = asked.table[i];
    if (std::min(n0, n1) > speed || std::max(n0, n1) < speed) continue;
    rate = std::max(rate.value_or(0), std::abs(n1 - n0) / (t1 - t0));
  }
  return rate;
}

std::vector<OrderCrossing> crossings(const RunUp& asked, const RunUpResult& r,
                                     const DampedModes& modes) {
  std::vector<OrderCrossing> all;
  for (const OrderCut& cut : r.orders)
    for (int j = 0; j < modes.solution.modes; ++j) {
      const double f = frequency_of(modes, j), speed = f / cut.order;
      if (speed < r.speed[0] || speed > r.speed[r.speed.size() - 1]) continue;
      Index at = 0, channel = 0;
      (r.speed.array() - speed).abs().minCoeff(&at);
      const double amplitude = cut.acceleration.row(at).cwiseAbs().maxCoeff(&channel);
      OrderCrossing crossing{.order = cut.order,
                             .mode = j,
                             .speed = speed,
                             .frequency = f,
                             .channel = int(channel),
                             .amplitude = amplitude,
                             .haste = {}};
      const double width = 2 * damping_of(modes, j) * f; // of half power, Hz
      if (const auto rate = rate_at(asked, speed); rate && width > 0)
        crossing.haste = cut.order * *rate / (0.9 * width * width);
      all.push_back(crossing);
    }
  std::stable_sort(all.begin(), all.end(), [](const OrderCrossing& a, const OrderCrossing& b) {
    return a.speed < b.speed;
  });
  return all;
}

} // namespace

RunUpResult run_up(const RunUp& asked, const std::string& key, const SensorModel& model,
                   const DampedModes& modes, const Excitations& excited,
                   std::vector<std::string>& warnings) {
  RunUpResult r{.name = asked.name,
                .speed = speed_grid(asked, modes),
                .channels = model.channels,
                .shown = {},
                .orders = {},
                .overall = {},
                .crossings = {}};
  const auto channels = Index(r.channels.size());
  MatrixXd squares = MatrixXd::Zero(r.speed.size(), channels);
  for (const double order : orders_of(asked)) {
    OrderCut cut{order, MatrixXcd::Zero(r.speed.size(), channels)};
    for (std::size_t i = 0; i < asked.orders.size(); ++i) {
      const EngineOrder& input = asked.orders[i];
      if (input.order != order) continue;
      const std::string of = key + ".orders[" + std::to_string(i) + "].of";
      const Excitation& e = excitation_named(input.of, of, excited);
      const Eigen::VectorXcd amplitude =
          std::polar(1., input.phase) *
          r.speed.unaryExpr([&](double n) { return amplitude_at(input, n); });
      cut.acceleration += amplitude.asDiagonal() * acceleration_of(model, e.parts, order * r.speed);
    }
    squares += cut.acceleration.cwiseAbs2() / 2;
    r.orders.push_back(std::move(cut));
  }
  r.overall = squares.cwiseSqrt();
  const Eigen::RowVectorXd highest = r.overall.colwise().maxCoeff();
  for (Index c = 0; c < channels; ++c)
    if (highest[c] > 1e-3 * highest.maxCoeff()) r.shown.push_back(int(c));
  r.crossings = crossings(asked, r, modes);
  if (asked.table.empty()) return r;
  r.sweeps = order_sweeps(asked, key, model, modes, excited, warnings);
  for (OrderCrossing& c : r.crossings) c.reached = reached(*r.sweeps, c, r.crossings);
  return r;
}

} // namespace plica
