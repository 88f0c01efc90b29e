// Phase of responses, beside their magnitude.
#pragma once

#include "io/report/plot.hpp"

namespace plica {

// The curve of a magnitude turned into that of its phase, in degrees from -180 to 180. Where the
// phase leaves that range it comes in on the other side: the line is broken there and not drawn
// across. `radians`: one for each point of the magnitude; not finite: a gap.
PlotCurve phase_curve(const PlotCurve& magnitude, const Eigen::VectorXd& radians);

// Below the figure of the magnitudes; empty without curves. `frame` as the figure above has it.
std::string phase_figure(PlotFrame frame, const std::vector<PlotCurve>& phases);

} // namespace plica
