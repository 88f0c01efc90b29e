// The reduced model of a case with friction: modes of the structure with its joints slipping,
// completed by its static answers to a force in every joint (solve/static_correction.hpp), so that
// what the joints feel is exact in statics, as in a Craig-Bampton reduction with the joints on its
// boundary. Damping ratios of the case hold while the joints stick.
#pragma once

#include "run/analyses/response.hpp"
#include "run/routes/route.hpp"
#include "solve/harmonic_balance.hpp"

namespace plica {

struct JointedModel {
  JointedStructure structure; // its input is that of the first excitation
  Eigen::MatrixXd input;      // modes x excitations
  Eigen::MatrixXd output;     // channels x modes: displacement
  Eigen::MatrixXd shapes;     // all DOFs x modes
  Eigen::MatrixXd rigid;      // channels x excitations: motion of the base itself
  std::vector<std::pair<std::string, std::string>> channels; // sensor, axis
  std::vector<Excitation> excitations;
  std::vector<std::string> joints; // names
};

// `slipping`: the case built with its joints slipping, its route. Throws InputError where nothing
// holds the part.
JointedModel jointed_model(const Case& data, const BuiltCase& slipping, Route& route);

// What one excitation moves: modes and joints that no path leads to are left out.
struct ExcitedPart {
  JointedStructure structure;
  Eigen::MatrixXd output; // channels x its modes
  Eigen::VectorXd rigid;
  std::vector<int> joints, modes; // of the whole
};
ExcitedPart excited_part(const JointedModel& model, int excitation);

std::vector<JointLaw> laws_of(const std::vector<BuiltJoint>& joints);

} // namespace plica
