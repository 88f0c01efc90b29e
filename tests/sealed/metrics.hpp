// Metrics 1 to 16 with their bounds.
#pragma once

#include "verdicts.hpp"

#include <functional>

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

using Test = std::function<bool(const Scored&)>;

// A share with Wilson's bounds, or the rule of three (3 / n) where there is no failure or no
// success.
Metric share(int number, const std::string& name, int good, int of, double accept, bool at_most);
Metric share_of(int number, const std::string& name, const std::vector<Scored>& all,
                const Test& counts, const Test& good, double accept, bool at_most = false);
// NaN is left out.
Metric median_of(int number, const std::string& name, std::vector<double> values, double accept,
                 bool at_most);

std::vector<Metric> metrics_of(const std::vector<Scored>& all);

} // namespace sealed
