// Curves over frequency: drawn as SVG, and with their numbers beside it for the script of the page,
// which puts a plot with a cursor in its place. The ordinate is logarithmic, lines are told apart
// by dashes, not colour.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace plica {

struct PlotCurve {
  Eigen::VectorXd hertz, magnitude;
  std::string name; // in the legend; empty = not there
  int dashes = 0;   // 0 full, 1 dashed, 2 dotted, 3 dash-dotted
  bool faint = false;
};

// A mark at (Hz, share of the height from below); `filled` or open.
struct PlotMark {
  double hertz = 0, height = 0;
  bool filled = true;
};

// Curves, then marks with a second scale of their own at the right ("order", 0 to `mark_top`).
// Lines dropped to the axis at `verticals`. Without curves the marks stand alone.
// `ordinate`: what it is, plain text.
std::string plot_figure(const std::string& label, const std::string& ordinate,
                        const std::vector<PlotCurve>& curves,
                        const std::vector<PlotMark>& marks = {}, double mark_top = 0,
                        const std::vector<double>& verticals = {});

// "<p>mid y (full line), mid x (dashed)</p>"
std::string plot_legend(const std::vector<PlotCurve>& curves);

} // namespace plica
