// Tables of stress by place and face, and stress along the meridian.
#pragma once

#include "run/analyses/shell_points.hpp"

namespace plica {

// Points of a part one by one along its meridian, ring by ring, on the half plane through the axis
// and a point `at` (m); fewer than two: it is no wall of revolution.
struct MeridianPoints {
  std::vector<Eigen::Index> points; // in ShellPoints::points
  Eigen::VectorXd along;            // length of the meridian from its left end, m
};
MeridianPoints meridian_points(const ShellPoints& points, const Mesh& mesh, const std::string& part,
                               const std::array<double, 3>& at);

// Of one real load case: `plane` as plane_stress() has it, one column.
StressTable stress_table(const ShellPoints& points, const Mesh& mesh, StressKind kind,
                         const std::string& name, const Eigen::Ref<const Eigen::VectorXd>& plane);

// Of a harmonic one: at each point the phase where von Mises on that face is largest.
StressTable harmonic_table(const ShellPoints& points, const Mesh& mesh, const std::string& name,
                           const Eigen::VectorXcd& plane);

// RMS under coordinates with the covariance C: `plane` has their columns.
StressTable rms_table(const ShellPoints& points, const Mesh& mesh, const std::string& name,
                      const Eigen::MatrixXd& plane, const Eigen::MatrixXd& C);

} // namespace plica
