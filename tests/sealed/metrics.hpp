// Metrics 1 to 16 with their bounds.
#pragma once

#include "verdicts.hpp"

namespace sealed {

struct Metric {
  int number = 0;
  std::string name;
  double value = 0, low = 0, high = 0; // Wilson's 95 %; both 0 for a median
  int good = 0, of = 0;
  double accept = 0;
  bool at_most = false; // the limit is an upper one
  double most = 1e9;    // a share above this is missed too: intervals that are too wide
  std::string note = {};
  bool known() const { return of > 0; }
  bool passes() const { return at_most ? value <= accept : value >= accept && value <= most; }
};

std::vector<Metric> metrics_of(const std::vector<Scored>& all);

} // namespace sealed
