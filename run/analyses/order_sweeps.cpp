#include "run/analyses/order_sweeps.hpp"

#include "run/analyses/coupling_change.hpp"
#include "run/analyses/dissipation.hpp"
#include "run/analyses/order_coupling.hpp"
#include "solve/swept_sine.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Speed and revolutions since the beginning at even steps of time.
struct Course {
  double dt = 0;
  VectorXd speed, turns;
};

Course course(const RunUp& asked, double dt, Index samples) {
  const auto& table = asked.table;
  Course c{dt, VectorXd(samples), VectorXd(samples)};
  std::size_t row = 0;
  double before = 0; // revolutions until that row
  for (Index i = 0; i < samples; ++i) {
    const double t = table.front()[0] + double(i) * dt;
    while (row + 2 < table.size() && t > table[row + 1][0]) {
      before += (table[row + 1][0] - table[row][0]) * (table[row][1] + table[row + 1][1]) / 2;
      ++row;
    }
    const double since = t - table[row][0];
    const double slope = (table[row + 1][1] - table[row][1]) / (table[row + 1][0] - table[row][0]);
    c.speed[i] = table[row][1] + slope * since;
    c.turns[i] = before + since * (table[row][1] + slope * since / 2);
  }
  return c;
}

// The inputs of one order as columns of the modal model, each with its factor and amplitude.
struct Inputs {
  std::vector<int> columns;
  std::vector<std::complex<double>> factors;
  std::vector<const EngineOrder*> amplitudes;
};

Inputs inputs_of(double order, const RunUp& asked, const std::string& key,
                 const Excitations& excited) {
  Inputs inputs;
  for (std::size_t i = 0; i < asked.orders.size(); ++i) {
    const EngineOrder& o = asked.orders[i];
    if (o.order != order) continue;
    const std::string of = key + ".orders[" + std::to_string(i) + "].of";
    for (const ExcitedColumn& part : excitation_named(o.of, of, excited).parts) {
      inputs.columns.push_back(part.column);
      inputs.factors.push_back(std::polar(1., o.phase) * part.factor);
      inputs.amplitudes.push_back(&o);
    }
  }
  return inputs;
}

// Absolute accelerations, `kept` + 1 times x channels. `too_long`: for what couples modes.
MatrixXcd swept(double order, const Inputs& inputs, const RunUp& asked, const std::string& key,
                const SensorModel& model, const DampedModes& modes, ModalModel modal, Index kept,
                bool& too_long) {
  constexpr double per_period = 24, most = 2e7;
  const double step = (asked.table.back()[0] - asked.table.front()[0]) / double(kept);
  const double between = std::ceil(per_period * order * speeds(asked)[1] * step);
  if (between * double(kept) > most)
    input_error(key + ".table", "makes more than 20 million samples of an order", "a shorter time");
  const auto stride = Index(std::max(1., between));
  const Index samples = kept * stride + 1;
  const Course c = course(asked, step / double(stride), samples);
  const auto columns = Index(inputs.columns.size());
  SweptLoad load{.dt = c.dt,
                 .phase = 2 * std::numbers::pi * order * c.turns,
                 .rate = 2 * std::numbers::pi * order * c.speed,
                 .amplitude = MatrixXd(samples, columns)};
  for (Index k = 0; k < columns; ++k)
    load.amplitude.col(k) = c.speed.unaryExpr(
        [own = inputs.amplitudes[std::size_t(k)]](double n) { return amplitude_at(*own, n); });
  const VectorXcd factors = VectorXcd::Map(inputs.factors.data(), columns);
  modal.input = modal.input(Eigen::all, inputs.columns).eval();
  const MatrixXd rigid = model.rigid(Eigen::all, inputs.columns);
  MatrixXcd a = swept_acceleration(modal, factors, load, stride);
  for (Index i = 0; i < a.rows(); ++i)
    a.row(i) +=
        (rigid * factors.cwiseProduct(load.amplitude.row(i * stride).transpose())).transpose();
  if (!modes.dissipation.empty() &&
      !add_order_coupling(a, model, modes, modal, inputs.columns, factors, load, stride))
    too_long = true;
  return a;
}

} // namespace

double amplitude_at(const EngineOrder& order, double speed) {
  if (!order.table.empty()) return table_at(order.table, speed);
  return order.acceleration ? *order.acceleration : *order.force;
}

OrderSweeps order_sweeps(const RunUp& asked, const std::string& key, const SensorModel& model,
                         const DampedModes& modes, const Excitations& excited,
                         std::vector<std::string>& warnings) {
  const Index kept = std::max(2000, asked.points);
  const double step = (asked.table.back()[0] - asked.table.front()[0]) / double(kept);
  const Course c = course(asked, step, kept + 1);
  OrderSweeps r{.time =
                    VectorXd::LinSpaced(kept + 1, asked.table.front()[0], asked.table.back()[0]),
                .speed = c.speed,
                .orders = {},
                .overall = {}};
  ModalModel modal = model.relative.modal();
  modal.zeta += first_order_damping(modes.dissipation, modes.solution);
  std::set<double> orders;
  for (const EngineOrder& o : asked.orders) orders.insert(o.order);
  bool too_long = false;
  MatrixXd squares = MatrixXd::Zero(kept + 1, Index(model.channels.size()));
  for (const double order : orders) {
    r.orders.push_back({order, swept(order, inputs_of(order, asked, key, excited), asked, key,
                                     model, modes, modal, kept, too_long)});
    squares += r.orders.back().acceleration.cwiseAbs2() / 2;
  }
  if (too_long) warnings.push_back(too_long_for_coupling("run-up " + asked.name));
  r.overall = squares.cwiseSqrt();
  return r;
}

double reached(const OrderSweeps& sweeps, const OrderCrossing& crossing,
               const std::vector<OrderCrossing>& all) {
  double low = 0, high = std::numeric_limits<double>::infinity();
  for (const OrderCrossing& other : all) {
    if (other.order != crossing.order) continue;
    const double middle = (other.speed + crossing.speed) / 2;
    if (other.speed < crossing.speed) low = std::max(low, middle);
    if (other.speed > crossing.speed) high = std::min(high, middle);
  }
  double largest = 0;
  for (const OrderCut& cut : sweeps.orders) {
    if (cut.order != crossing.order) continue;
    for (Index i = 0; i < sweeps.speed.size(); ++i)
      if (sweeps.speed[i] >= low && sweeps.speed[i] <= high)
        largest = std::max(largest, std::abs(cut.acceleration(i, crossing.channel)));
  }
  return largest;
}

} // namespace plica
