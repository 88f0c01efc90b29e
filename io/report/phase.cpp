#include "io/report/phase.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace plica {

PlotCurve phase_curve(const PlotCurve& magnitude, const Eigen::VectorXd& radians) {
  constexpr double half = 180, gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, y;
  const auto add = [&](double at, double degrees) {
    x.push_back(at);
    y.push_back(degrees);
  };
  for (Eigen::Index i = 0; i < radians.size(); ++i) {
    const double here = std::remainder(radians[i] * half / std::numbers::pi, 2 * half);
    if (const double step = i > 0 ? here - y.back() : 0; std::abs(step) > half) {
      // By the shorter way, over the edge that the line before was nearer to.
      const double edge = step < 0 ? half : -half, on = here + 2 * edge;
      const double share = on == y.back() ? 0 : (edge - y.back()) / (on - y.back());
      const double at = magnitude.x[i - 1] + share * (magnitude.x[i] - magnitude.x[i - 1]);
      add(at, edge);
      add(at, gap);
      add(at, -edge);
    }
    add(magnitude.x[i], here);
  }
  PlotCurve curve = magnitude;
  curve.x = Eigen::VectorXd::Map(x.data(), Eigen::Index(x.size()));
  curve.y = Eigen::VectorXd::Map(y.data(), Eigen::Index(y.size()));
  return curve;
}

std::string phase_figure(PlotFrame frame, const std::vector<PlotCurve>& phases) {
  if (phases.empty()) return "";
  frame.label += ", phase";
  frame.ordinate = "phase, °";
  frame.linear = true;
  frame.range = {{-180, 180}};
  frame.step = 90;
  return plot_figure(frame, phases);
}

} // namespace plica
