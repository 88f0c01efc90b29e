// Standard normal numbers in a fixed order, the same with every library.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

namespace plica {

class NormalDraws {
public:
  explicit NormalDraws(unsigned seed) : random_(seed) {}
  double uniform() { return (double(random_() >> 11) + 0.5) * 0x1p-53; } // in (0, 1)
  double operator()() {                                                  // Box and Muller
    const double u = uniform(), v = uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }

private:
  std::mt19937_64 random_;
};

} // namespace plica
