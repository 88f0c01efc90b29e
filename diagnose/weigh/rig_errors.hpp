// Errors of dynamic stiffness and loss that a rig measured (ReadingKind::dynamic_stiffness, loss).
#pragma once

#include "diagnose/predict/predictor.hpp"

#include <Eigen/Core>
#include <string>

namespace plica {

// "transfer", "driving point, left, right": the motion of a rig, whatever direction and frequency.
std::string rig_motion(const Reading& r);

// Half of the variance of the measurement is common to a direction of a table over frequency and
// amplitude: calibration, alignment.
void add_common_rig_error(const TestReadings& test, Eigen::MatrixXd& measurement);

// Of losses, one and the same within a direction of a table.
Eigen::MatrixXd shared_rig_loss(const TestReadings& test, double sigma);

// Logarithms that the mesh of the case gives more than the coarse one, whose readings are `coarse`;
// zero for all other readings and in states that a known change sets apart. `refused`: of each
// reading, why the part between its ends cannot be solved on that mesh; mostly empty.
struct RigMeshCorrection {
  Eigen::VectorXd log;
  std::vector<std::string> refused;
};
RigMeshCorrection rig_mesh_correction(const Case& data, const Measured& measured,
                                      const TestReadings& test, const Eigen::VectorXd& coarse);

} // namespace plica
