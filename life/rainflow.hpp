// Rainflow counting by ASTM E1049-85 (2017), section 5.4.4.
//
// Of the last three reversals, X is the range between the last two and Y the one before. While X
// >= Y, Y is counted: as half a cycle when it begins with the first reversal that is left, which
// goes; as a whole cycle otherwise, and both of its reversals go. What is left at the end counts
// as halves. Samples on the way between two reversals, and plateaus, are no reversals; the first
// and the last sample are. Any unit; nothing is filtered or binned.
#pragma once

#include <functional>
#include <vector>

namespace plica {

struct RainflowCycle {
  double range = 0, mean = 0; // in the unit of the history; range > 0
  double count = 0;           // 0.5 or 1
};

// Samples one by one, cycles as they close: memory grows with the reversals that are still open.
class Rainflow {
public:
  using Sink = std::function<void(const RainflowCycle&)>;
  explicit Rainflow(Sink sink);

  // Throws std::invalid_argument for a sample that is not finite, by its number, counted from 1.
  void add(double sample);
  void finish(); // counts what is left as halves; then a new history may begin

private:
  void turn(double reversal);

  Sink sink_;
  std::vector<double> open_; // reversals that are not counted
  double last_ = 0;
  int direction_ = 0; // of the last step; 0 = none yet
  std::size_t samples_ = 0;
};

// Cycles in the order in which they close.
std::vector<RainflowCycle> rainflow(const std::vector<double>& history);

} // namespace plica
