#include "life/rainflow.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace plica {

Rainflow::Rainflow(Sink sink) : sink_(std::move(sink)) {}

void Rainflow::add(double sample) {
  ++samples_;
  if (!std::isfinite(sample))
    throw std::invalid_argument("sample " + std::to_string(samples_) +
                                " of the history is no finite number");
  if (samples_ == 1) {
    open_.push_back(sample);
  } else if (sample != last_) {
    const int direction = sample > last_ ? 1 : -1;
    if (direction_ != 0 && direction != direction_) turn(last_);
    direction_ = direction;
  }
  last_ = sample;
}

void Rainflow::turn(double reversal) {
  open_.push_back(reversal);
  while (open_.size() >= 3) {
    const std::size_t n = open_.size();
    const double X = std::abs(open_[n - 1] - open_[n - 2]);
    const double Y = std::abs(open_[n - 2] - open_[n - 3]);
    if (X < Y) return;
    const double mean = (open_[n - 2] + open_[n - 3]) / 2;
    if (n == 3) {
      sink_({.range = Y, .mean = mean, .count = 0.5});
      open_.erase(open_.begin());
    } else {
      sink_({.range = Y, .mean = mean, .count = 1});
      open_.erase(open_.end() - 3, open_.end() - 1);
    }
  }
}

void Rainflow::finish() {
  if (direction_ != 0) turn(last_);
  for (std::size_t i = 1; i < open_.size(); ++i)
    sink_({.range = std::abs(open_[i] - open_[i - 1]),
           .mean = (open_[i] + open_[i - 1]) / 2,
           .count = 0.5});
  open_.clear();
  direction_ = 0;
  samples_ = 0;
}

std::vector<RainflowCycle> rainflow(const std::vector<double>& history) {
  std::vector<RainflowCycle> cycles;
  Rainflow counter([&](const RainflowCycle& cycle) { cycles.push_back(cycle); });
  for (const double sample : history) counter.add(sample);
  counter.finish();
  return cycles;
}

} // namespace plica
