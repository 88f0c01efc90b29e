// Curves: drawn as SVG, and with their numbers beside it for the script of the page, which puts a
// plot with a cursor in its place. Curves have a colour (Okabe and Ito's, which differ in
// lightness, too) and dashes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plica {

struct PlotCurve {
  Eigen::VectorXd x, y; // the line is broken where y is not finite
  std::string name;     // in the legend; empty = not there
  int colour = -1;      // -1: its own by its place among the curves
  int dashes = 0;       // 0 full, 1 dashed, 2 dotted, 3 dash-dotted
  bool faint = false;
};

// Colours and dashes of channels (sensor, axis) in one picture: each in the colour of its sensor,
// which is the same in all pictures, further ones of that colour dotted and dash-dotted. Dashed are
// tests.
struct ChannelStyle {
  int colour = 0, dashes = 0;
};
std::vector<ChannelStyle>
channel_styles(const std::vector<std::pair<std::string, std::string>>& channels,
               const std::vector<int>& drawn);

// A mark at x and a share of the height from below; `filled` or open.
struct PlotMark {
  double x = 0, height = 0;
  bool filled = true;
};

// Plain text: quantity and unit of each axis.
struct PlotFrame {
  std::string label; // what the picture is
  std::string abscissa = "frequency, Hz";
  std::string ordinate;
  bool linear = false;                             // the ordinate; else logarithmic
  std::optional<std::array<double, 2>> range = {}; // of the ordinate; none = of the curves
  double step = 0; // between the lines of a linear ordinate; 0 = as fits
};

// Curves, then marks with a second scale of their own at the right ("order", 0 to `mark_top`).
// Lines dropped to the axis at `verticals`. Without curves the marks stand alone.
std::string plot_figure(const PlotFrame& frame, const std::vector<PlotCurve>& curves,
                        const std::vector<PlotMark>& marks = {}, double mark_top = 0,
                        const std::vector<double>& verticals = {});

// The lines with their names.
std::string plot_legend(const std::vector<PlotCurve>& curves);

} // namespace plica
