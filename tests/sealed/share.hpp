// Good ones of some, with one-sided 90 % bounds of Clopper and Pearson.
#pragma once

#include <boost/math/distributions/binomial.hpp>
#include <string>

namespace sealed {

struct Share {
  int good = 0, of = 0;
  void add(bool is_good) {
    good += is_good;
    ++of;
  }
  double value() const { return of ? double(good) / of : 0; }
  double low() const {
    return good == 0 ? 0
                     : boost::math::binomial_distribution<>::find_lower_bound_on_p(of, good, 0.1);
  }
  double high() const {
    return good == of ? 1
                      : boost::math::binomial_distribution<>::find_upper_bound_on_p(of, good, 0.1);
  }
  // A goal is met when the bounds meet it, missed when they rule it out; no word without a goal.
  std::string against(double least, double most) const {
    if (least <= 0 && most >= 1) return "";
    const bool met = low() >= least - 1e-9 && high() <= most + 1e-9;
    const bool missed = high() < least || low() > most;
    return met ? "met" : missed ? "MISSED" : "not shown";
  }
};

} // namespace sealed
