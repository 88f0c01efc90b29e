// How a force grows with the displacement, for static tests that state a tangent.
#pragma once

namespace plica {

// d f / d x by a hundredth either way.
template <class Force> double slope_at(const Force& f, double x) {
  constexpr double step = 0.01;
  return (f((1 + step) * x) - f((1 - step) * x)) / (2 * step * x);
}

} // namespace plica
