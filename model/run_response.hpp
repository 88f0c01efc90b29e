// The response analyses of a run: motion of the mount and forces, each on its own.
#pragma once

#include "model/build.hpp"
#include "model/results.hpp"
#include "solve/frequency_response.hpp"
#include "solve/modes.hpp"
#include "solve/random_response.hpp"

namespace plica {

// A direction of the base or a force of the case.
struct Excitation {
  std::string name; // x y z rx ry rz, or the name of the force
  bool is_force = false;
  double amplitude = 1;   // m/s2 or rad/s2; N or Nm
  SpectralDensity random; // empty table = none
};

// Everything that must be solved while the factor is that of K, before the modes are.
struct Excitations {
  std::vector<Excitation> list;
  Eigen::MatrixXd force;            // free DOFs x excitations, per unit amplitude
  Eigen::MatrixXd rigid;            // all DOFs x excitations: motion of the base; 0 for a force
  Eigen::MatrixXd static_solutions; // K^-1 force
};

// Throws InputError when the factor is shifted: a free part has no static solution.
Excitations excitations(const Response& asked, const BuiltCase& built, const System& system,
                        const std::vector<int>& free, const BaseFactor& factor);

// Modes and pseudo-modes, the shapes over all DOFs, and their damping.
struct DampedModes {
  ModalBasis basis;
  Eigen::MatrixXd u; // all DOFs x columns of the basis
  Eigen::VectorXd zeta, eta;
};

// Frequencies of the response: the band of the case, refined around its modes.
Eigen::VectorXd response_grid(const Response& asked, const DampedModes& modes);

// Modal coordinates per unit amplitude: frequencies x columns of the basis.
Eigen::MatrixXcd modal_coordinates(const DampedModes& modes, const Excitations& excited, int which,
                                   const Eigen::VectorXd& hertz);

// One response per excitation. Throws InputError for a mode of the band without any damping and for
// a cross density of a channel that is not there.
std::vector<ResponseResult> responses(const Response& asked, const BuiltCase& built,
                                      const DampedModes& modes, const Excitations& excited);

} // namespace plica
