// Components of measured mode shapes as readings.
//
// A shape has no size of its own: the largest component is one, and a model's shape is scaled to it
// by least squares (StateAnswers::component), so that a shape of n channels says n - 1 things. It
// tells apart what frequencies do not: a place from its mirror image, mass from a loss of
// stiffness.
#pragma once

#include "diagnose/readings/reading_list.hpp"

namespace plica {

// One reading per channel of the mode's vector, of two channels or more; of more than eight, eight.
// Complex ones are turned to where they are most real; one that stays complex is left out with a
// warning. `frequency`: the reading of the mode's frequency, whose mode the components are of.
void add_shape_readings(const MeasuredMode& mode, const Reading& frequency, ReadingList& list);

// Leaves out shapes that the modes they are paired with do not look like, with a warning: the mode
// may be another one, or the shape that of a pair of modes that lie close. `nominal`: what the
// model gives for each.
void leave_out_unlike_shapes(const Eigen::VectorXd& nominal, TestReadings& test);

} // namespace plica
