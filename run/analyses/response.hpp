// The response analyses of a run: motion of the mount and forces, each on its own.
#pragma once

#include "run/results/results.hpp"
#include "run/routes/route.hpp"
#include "solve/frequency_response.hpp"
#include "solve/random_response.hpp"

namespace plica {

// A direction of the base or a force of the case.
struct Excitation {
  std::string name; // x y z rx ry rz, or the name of the force
  bool is_force = false;
  double amplitude = 1;
  std::string unit;       // m/s2 rad/s2 N Nm
  SpectralDensity random; // empty table = none
};

struct Excitations {
  std::vector<Excitation> list;
  Loads loads; // one column each
};

// Throws InputError for a force on a set that is not on the mesh.
Excitations excitations(const Response& asked, const Model& model);

// Rows of the three axes of each sensor in a field over all DOFs.
Eigen::MatrixXd at_sensors(const BuiltCase& built, const Eigen::MatrixXd& u);

struct DampedModes {
  const ModalSolution& solution;
  Eigen::VectorXd zeta, eta; // of all its columns
};

// Frequencies of the response: the band of the case, refined around its modes, with the corners of
// the random inputs and both sides of their ends.
Eigen::VectorXd response_grid(const Response& asked, const DampedModes& modes);

// Modal coordinates per unit amplitude of one load: frequencies x columns.
Eigen::MatrixXcd modal_coordinates(const DampedModes& modes, int which,
                                   const Eigen::VectorXd& hertz);

// One response per excitation. Throws InputError for a mode of the band without any damping and for
// a cross density of a channel that is not there.
std::vector<ResponseResult> responses(const Response& asked, const BuiltCase& built,
                                      const DampedModes& modes, const Excitations& excited);

} // namespace plica
