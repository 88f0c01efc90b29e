#include "io/tables/time_csv.hpp"

#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <complex>
#include <iterator>
#include <numbers>

namespace plica {
namespace {

using Channels = std::vector<std::pair<std::string, std::string>>;
using Eigen::Index;

void add_heads(std::string& text, const Channels& channels, const std::string& before,
               const std::string& after) {
  for (const auto& [sensor, direction] : channels)
    text += "," + csv_cell(fmt::format("{}{} {}{}", before, sensor, direction, after));
}

} // namespace

std::string transient_file(const std::string& name) {
  return "transient_" + name + ".csv";
}
std::string shock_file(const std::string& name) {
  return "shock_" + name + ".csv";
}
std::string run_up_file(const std::string& name) {
  return "run_up_" + name + ".csv";
}
std::string run_up_time_file(const std::string& name) {
  return "run_up_" + name + "_in_time.csv";
}

std::string transient_csv(const TransientResult& t) {
  std::string text = fmt::format("time [s],input [{}]", t.unit);
  add_heads(text, t.channels, "", " [m/s2]");
  text += '\n';
  const auto out = std::back_inserter(text);
  for (Index i = 0; i < t.input.size(); ++i) {
    fmt::format_to(out, FMT_COMPILE("{:.9g},{:.9g}"), double(i) * t.step, t.input[i]);
    for (const double a : t.acceleration.row(i)) fmt::format_to(out, FMT_COMPILE(",{:.9g}"), a);
    text += '\n';
  }
  return text;
}

std::string shock_csv(const TransientResult& t) {
  const ShockSpectra& s = *t.spectra;
  std::string text = "frequency [Hz]";
  if (s.input.size() > 0) text += fmt::format(",input maximax [{}]", t.unit);
  add_heads(text, t.channels, "", " maximax [m/s2]");
  text += '\n';
  for (Index i = 0; i < s.hertz.size(); ++i) {
    text += csv_number(s.hertz[i]);
    if (s.input.size() > 0) text += "," + csv_number(s.input[i]);
    for (const double a : s.channels.row(i)) text += "," + csv_number(a);
    text += '\n';
  }
  return text;
}

namespace {

void add_order_heads(std::string& text, const RunUpResult& r) {
  for (const OrderCut& cut : r.orders) {
    const std::string order = fmt::format("order {:g} ", cut.order);
    for (const auto& [sensor, direction] : r.channels)
      for (const char* part : {"amplitude [m/s2]", "phase [deg]"})
        text += "," + csv_cell(fmt::format("{}{} {} {}", order, sensor, direction, part));
  }
  add_heads(text, r.channels, "overall ", " RMS [m/s2]");
  text += '\n';
}

void add_orders(std::string& text, const std::vector<OrderCut>& orders,
                const Eigen::MatrixXd& overall, Index i) {
  for (const OrderCut& cut : orders)
    for (const std::complex<double> a : cut.acceleration.row(i))
      text +=
          "," + csv_number(std::abs(a)) + "," + csv_number(std::arg(a) * 180 / std::numbers::pi);
  for (const double a : overall.row(i)) text += "," + csv_number(a);
  text += '\n';
}

} // namespace

std::string run_up_csv(const RunUpResult& r) {
  std::string text = "speed [rpm]";
  add_order_heads(text, r);
  for (Index i = 0; i < r.speed.size(); ++i) {
    text += csv_number(60 * r.speed[i]);
    add_orders(text, r.orders, r.overall, i);
  }
  return text;
}

std::string run_up_time_csv(const RunUpResult& r) {
  const OrderSweeps& s = *r.sweeps;
  std::string text = "time [s],speed [rpm]";
  add_order_heads(text, r);
  for (Index i = 0; i < s.time.size(); ++i) {
    text += csv_number(s.time[i]) + "," + csv_number(60 * s.speed[i]);
    add_orders(text, s.orders, s.overall, i);
  }
  return text;
}

std::string crossings_csv(const Results& results) {
  std::string text = "run-up,speed [rpm],order,mode,label,frequency [Hz],channel,"
                     "amplitude [m/s2],sweep over steady limit,in time [m/s2]\n";
  for (const RunUpResult& r : results.run_ups)
    for (const OrderCrossing& c : r.crossings) {
      const auto& [sensor, direction] = r.channels[std::size_t(c.channel)];
      text += fmt::format("{},{},{:g},{},{},{},{},{},{},{}\n", csv_cell(r.name),
                          csv_number(60 * c.speed), c.order, c.mode + 1,
                          csv_cell(mode_label(results.modes[std::size_t(c.mode)])),
                          csv_number(c.frequency), csv_cell(sensor + " " + direction),
                          csv_number(c.amplitude), csv_number(c.haste), csv_number(c.reached));
    }
  return text;
}

} // namespace plica
