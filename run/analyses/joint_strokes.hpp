// Static force over displacement of a part whose joints slip one after the other.
#pragma once

#include "run/results/results.hpp"
#include "solve/harmonic_balance.hpp"

namespace plica {

// Force over displacement between two caps when the second moves along, or across and is kept
// parallel, from rest: joints slip one after the other. `held`: the model with both caps held;
// `motion`: joints x directions (axial, transverse x), their motion per displacement while they
// bear no force; `stiffness`: of the structure without its joints. Up to a displacement at which
// hardly anything sticks.
std::vector<StrokeCurve> joint_strokes(const JointedStructure& held, const Eigen::MatrixXd& motion,
                                       const Eigen::Vector2d& stiffness);

} // namespace plica
