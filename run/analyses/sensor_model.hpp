// The modal model of a run as its sensors see it.
#pragma once

#include "run/analyses/excitations.hpp"
#include "solve/dissipation.hpp"

namespace plica {

// Modes of a run with their damping.
struct DampedModes {
  const ModalSolution& solution;
  Eigen::VectorXd zeta, eta; // of all its columns
  Dissipation dissipation = {};
  // Of the modes, where the dissipation is not empty: their frequencies and damping as they are.
  std::vector<ComplexMode> complex = {};
  Eigen::VectorXd first_order = {}; // fractions of critical of it, where these were not found
};

// Frequency (Hz) and fraction of critical of a mode, with the damping that couples it to others.
double frequency_of(const DampedModes& modes, int mode);
double damping_of(const DampedModes& modes, int mode);

// `output`: rows x columns of the modes.
ModalModel modal_model(const DampedModes& modes, Eigen::MatrixXd output);

// Displacements of some rows of the DOFs under the loads.
class ModalResponse {
public:
  ModalResponse(const DampedModes& modes, Eigen::MatrixXd output);

  // Per unit of the excitation, frequencies x rows.
  Eigen::MatrixXcd operator()(const ExcitedColumns& excited, const Eigen::VectorXd& hertz) const;
  const ModalModel& modal() const { return modal_; }

private:
  ModalModel modal_;
  std::optional<DissipativeResponse> dissipative_;
};

struct SensorModel {
  ModalResponse relative; // three axes of each sensor, against what carries them
  Eigen::MatrixXd rigid;  // channels x loads: what carries them
  std::vector<std::pair<std::string, std::string>> channels; // sensor, axis
};
SensorModel sensor_model(const BuiltCase& built, const DampedModes& modes,
                         const Excitations& excited);

// Absolute acceleration of the sensors, frequencies x channels.
Eigen::MatrixXcd acceleration_of(const SensorModel& model, const ExcitedColumns& excited,
                                 const Eigen::VectorXd& hertz);

// Rows of the three axes of each sensor in a field over all DOFs.
Eigen::MatrixXd at_sensors(const BuiltCase& built, const Eigen::MatrixXd& u);

} // namespace plica
