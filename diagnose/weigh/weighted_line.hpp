// A straight line through points of known errors.
#pragma once

#include <cmath>
#include <optional>

namespace plica {

class WeightedLine {
public:
  struct Slope {
    double value = 0, sigma = 0;
  };

  void add(double x, double y, double sigma) {
    const double weight = 1 / (sigma * sigma);
    w_ += weight;
    wx_ += weight * x;
    wy_ += weight * y;
    wxx_ += weight * x * x;
    wxy_ += weight * x * y;
  }

  // None where all points have one x.
  std::optional<Slope> slope() const {
    const double spread = w_ * wxx_ - wx_ * wx_;
    if (!(spread > 1e-9 * w_ * wxx_)) return std::nullopt;
    return Slope{(w_ * wxy_ - wx_ * wy_) / spread, std::sqrt(w_ / spread)};
  }

private:
  double w_ = 0, wx_ = 0, wy_ = 0, wxx_ = 0, wxy_ = 0;
};

} // namespace plica
