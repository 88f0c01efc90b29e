#include "lab/signals/time_record.hpp"

#include "lab/signals/fourier.hpp"
#include "words/input_error.hpp"
#include "words/sample_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Runs of three samples or more that stand at exactly `end`, and the longest of them.
struct Runs {
  int count = 0;
  Index longest = 0;
};

Runs runs_at(const VectorXd& x, double end) {
  Runs runs;
  Index length = 0;
  for (Index i = 0; i <= x.size(); ++i) {
    if (i < x.size() && x[i] == end) {
      ++length;
      continue;
    }
    if (length >= 3) ++runs.count;
    runs.longest = std::max(runs.longest, length);
    length = 0;
  }
  return runs;
}

// A range of few steps stands at its ends without being clipped.
bool has_many_steps(const VectorXd& x) {
  std::set<double> values;
  for (const double v : x) {
    values.insert(v);
    if (values.size() > 200) return true;
  }
  return false;
}

bool clipped(const VectorXd& x) {
  for (const double end : {x.maxCoeff(), x.minCoeff()})
    if (const Runs runs = runs_at(x, end); runs.count >= 2 || runs.longest >= 8)
      return has_many_steps(x);
  return false;
}

// Power of all lines, each channel over its own, without 0 Hz.
VectorXd power_of(const TimeRecord& record) {
  Fourier transform(int(record.samples.rows()));
  VectorXd power = VectorXd::Zero(record.samples.rows() / 2 + 1);
  for (Index c = 0; c < record.samples.cols(); ++c) {
    VectorXd own = transform.forward(record.samples.col(c)).cwiseAbs2();
    own[0] = 0;
    if (own.sum() > 0) power += own / own.sum();
  }
  return power;
}

double line_width(const TimeRecord& record) {
  return record.rate / double(record.samples.rows());
}

} // namespace

TimeRecord without(const TimeRecord& record, const std::string& channel) {
  TimeRecord rest = record;
  const auto at = std::find(rest.channels.begin(), rest.channels.end(), channel);
  if (channel.empty() || at == rest.channels.end()) return rest;
  std::vector<Index> kept;
  for (Index c = 0; c < record.samples.cols(); ++c)
    if (c != at - rest.channels.begin()) kept.push_back(c);
  rest.samples = record.samples(Eigen::all, kept).eval();
  rest.channels.erase(at);
  return rest;
}

void check_record(const TimeRecord& record) {
  if (record.samples.cols() < 1)
    input_error("channels", "leave no response", "at least one sensor and axis");
  if (record.samples.rows() < 64)
    input_error("file", fmt::format("has {} samples", record.samples.rows()),
                "64 at least, with the whole decay or a long run in them");
  for (Index c = 0; c < record.samples.cols(); ++c) {
    const VectorXd x = record.samples.col(c);
    const std::string& name = record.channels[std::size_t(c)];
    if (!x.allFinite()) {
      Index row = 0;
      while (std::isfinite(x[row])) ++row;
      input_error("file", fmt::format("{} has no number at row {}", name, row + 1),
                  "a record without gaps; `-` in `channels` leaves a channel out");
    }
    if (x.maxCoeff() == x.minCoeff())
      input_error("channels", name + " never moves",
                  "a channel that was connected; `-` leaves it out");
    if (clipped(x))
      input_error("channels",
                  fmt::format("{} is clipped: it stands at {:g} again and again", name,
                              std::max(std::abs(x.maxCoeff()), std::abs(x.minCoeff()))),
                  "a record within the range of the amplifier; `-` leaves the channel out");
  }
  const VectorXd power = power_of(record);
  const Index last = power.size() / 10;
  if (const double share = power.tail(last).sum() / power.sum(); share > 0.5)
    input_error("rate",
                fmt::format("is too low: {:.0f} % of the power lies above {:.4g} Hz, next to half "
                            "the sampling rate of {:.4g} Hz",
                            100 * share, 0.45 * record.rate, record.rate),
                "a sampling rate of four times the highest mode, behind a filter");
}

double highest_frequency(const TimeRecord& record) {
  VectorXd power = power_of(record);
  const double floor = 4 * median({power.begin(), power.end()}) / std::log(2.);
  power = (power.array() - floor).cwiseMax(0);
  double sum = 0;
  Index line = 0;
  while (line + 1 < power.size() && sum < 0.999 * power.sum()) sum += power[line++];
  return std::min(double(line + 1) * line_width(record), record.rate / 2);
}

} // namespace plica
