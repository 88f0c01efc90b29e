#include "line_structures.hpp"

#include <cmath>
#include <numbers>

namespace sealed {

double Change::value(double s) const {
  if (inverse) return 1 / s;
  if (about_one) return std::exp(sign * s);
  return s;
}

std::vector<std::unique_ptr<ChangedStructure>> changed_structures() {
  std::vector<std::unique_ptr<ChangedStructure>> all;
  add_line_structures(all);
  add_frame(all);
  add_plate(all);
  add_bellows(all);
  return all;
}

double smooth_field(std::uint64_t seed, double s) {
  Draws draws(seed, "field");
  double sum = 0;
  for (int k = 1; k <= 3; ++k) {
    const double a = draws.normal(), b = draws.normal();
    sum += (a * std::cos(k * std::numbers::pi * s) + b * std::sin(k * std::numbers::pi * s)) / k;
  }
  return sum / 1.2;
}

} // namespace sealed
