#include "run/analyses/jointed_model.hpp"

#include "run/analyses/damping.hpp"
#include "run/analyses/dissipation.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The request of the linear response with the same excitations.
Response as_response(const Levels& levels) {
  Response response;
  response.bases = levels.bases;
  response.band = levels.band;
  for (const LevelForce& f : levels.forces)
    response.forces.push_back(
        {.name = f.name, .at = f.at, .direction = f.direction, .amplitude = 1, .random = {}});
  return response;
}

// Loads of the excitations and after them a unit force in every joint.
Loads with_joint_forces(const Loads& excited, const BuiltCase& built) {
  const Index before = Index(excited.base.size()), joints = Index(built.joints.size());
  const Index dofs = dof_count(built.model);
  Loads all{excited.base, MatrixXd::Zero(dofs, before + joints),
            MatrixXd::Zero(dofs, before + joints)};
  if (before > 0) {
    all.force.leftCols(before) = excited.force;
    all.rigid.leftCols(before) = excited.rigid;
  }
  all.base.resize(std::size_t(before + joints), -1);
  all.force.rightCols(joints) = unit_forces(built.model, built.joints);
  return all;
}

// Ratios hold for small motion: each mode has that of its frequency with the joints stuck (by
// Rayleigh's quotient), and keeps this viscous damping while they slip.
void add_damping(const Damping& damping, const Model& model, const ModalSolution& solution,
                 JointedStructure& s) {
  const VectorXd stuck = stuck_stiffness(s).diagonal();
  s.zeta = modal_damping(damping, model, stuck, solution.u, solution.modes)
               .zeta.cwiseProduct(stuck.cwiseQuotient(s.lambda).cwiseSqrt());
  s.eta = modal_damping(damping, model, s.lambda, solution.u, solution.modes).eta;
}

} // namespace

std::vector<JointLaw> laws_of(const std::vector<BuiltJoint>& joints) {
  std::vector<JointLaw> laws;
  laws.reserve(joints.size());
  for (const BuiltJoint& j : joints) laws.push_back(j.law);
  return laws;
}

JointedModel jointed_model(const Case& data, const BuiltCase& slipping, Route& route) {
  const Levels& levels = *data.analyses.levels;
  const Excitations excited = excitations(as_response(levels), slipping);
  const Index count = Index(excited.list.size()), joints = Index(slipping.joints.size());
  // Modes beyond the band as far as the third harmonic; static answers to all forces stand for the
  // rest.
  const bool balance = levels.method == JointMethod::harmonic_balance;
  const double reach = balance ? std::clamp(levels.harmonics, 2, 3) : 1.5;
  const ModalSolution solution =
      route.modes({.count = 0, .band = {0, reach * levels.band[1]}, .proof = false},
                  with_dampers(with_joint_forces(excited.loads, slipping), slipping), {});
  JointedModel model;
  model.structure = {.lambda = solution.lambda,
                     .zeta = VectorXd::Zero(solution.lambda.size()),
                     .eta = VectorXd::Zero(solution.lambda.size()),
                     .joints = solution.input.middleCols(count, joints),
                     .input = solution.input.col(0),
                     .laws = laws_of(slipping.joints),
                     .dampers = solution.input.rightCols(Index(slipping.dampers.size())),
                     .added = {}};
  for (const BuiltDamper& d : slipping.dampers) model.structure.added.push_back(added_by(d));
  add_damping(data.analyses.damping, slipping.model, solution, model.structure);
  model.input = solution.input.leftCols(count);
  model.output = at_sensors(slipping, solution.u);
  model.shapes = solution.u;
  model.rigid = at_sensors(slipping, excited.loads.rigid);
  for (const BuiltSensor& s : slipping.sensors)
    for (const char* axis : axis_names) model.channels.emplace_back(s.name, axis);
  model.excitations = excited.list;
  for (const BuiltJoint& j : slipping.joints) model.joints.push_back(joint_name(j));
  return model;
}

ExcitedPart excited_part(const JointedModel& model, int excitation) {
  constexpr double none = 1e-7; // of the largest: rounding, not a path
  const JointedStructure& s = model.structure;
  const VectorXd input = model.input.col(excitation);
  // Joints and damped springs in the scale of their own largest motion by a mode of unit stiffness
  // energy.
  const Index joints = s.joints.cols();
  MatrixXd J(s.joints.rows(), joints + s.dampers.cols());
  J << s.joints, s.dampers;
  J = s.lambda.cwiseSqrt().cwiseInverse().asDiagonal() * J;
  const VectorXd f = s.lambda.cwiseSqrt().cwiseInverse().cwiseProduct(input);
  std::vector<char> mode(std::size_t(J.rows()), 0), link(std::size_t(J.cols()), 0);
  for (Index r = 0; r < f.size(); ++r)
    mode[std::size_t(r)] = std::abs(f[r]) > none * f.cwiseAbs().maxCoeff();
  for (bool grown = true; grown;) {
    grown = false;
    for (Index j = 0; j < J.cols(); ++j) {
      const double largest = J.col(j).cwiseAbs().maxCoeff();
      for (Index r = 0; r < J.rows(); ++r) {
        if (std::abs(J(r, j)) <= none * largest) continue;
        char& m = mode[std::size_t(r)];
        char& own = link[std::size_t(j)];
        if (m == own) continue;
        m = own = 1;
        grown = true;
      }
    }
  }
  std::vector<int> modes, dampers;
  ExcitedPart part;
  for (Index r = 0; r < f.size(); ++r)
    if (mode[std::size_t(r)]) modes.push_back(int(r));
  for (Index j = 0; j < J.cols(); ++j)
    if (link[std::size_t(j)])
      (j < joints ? part.joints : dampers).push_back(int(j < joints ? j : j - joints));
  part.structure = {.lambda = s.lambda(modes),
                    .zeta = s.zeta(modes),
                    .eta = s.eta(modes),
                    .joints = s.joints(modes, part.joints),
                    .input = input(modes),
                    .laws = {},
                    .dampers = s.dampers(modes, dampers),
                    .added = {}};
  for (int j : part.joints) part.structure.laws.push_back(s.laws[std::size_t(j)]);
  for (int k : dampers) part.structure.added.push_back(s.added[std::size_t(k)]);
  part.output = model.output(Eigen::all, modes);
  part.rigid = model.rigid.col(excitation);
  part.modes = std::move(modes);
  return part;
}

} // namespace plica
