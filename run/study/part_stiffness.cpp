#include "run/study/part_stiffness.hpp"

#include "model/description/place_keys.hpp"
#include "run/analyses/damping.hpp"
#include "run/routes/operating_state.hpp"
#include "run/routes/ply_slip.hpp"
#include "run/routes/route.hpp"
#include "run/routes/state_joints.hpp"
#include "solve/base_state.hpp"
#include "solve/effective_mass.hpp"
#include "solve/strain_energy.hpp"
#include "words/did_you_mean.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

std::array<std::string, 2> ends_of(const Case& data, const std::vector<std::string>& asked) {
  std::vector<std::string> caps;
  std::string list;
  for (const Cap& cap : data.caps) {
    caps.push_back(cap.name);
    list += (list.empty() ? "" : ", ") + cap.name;
  }
  if (asked.empty()) {
    if (caps.size() != 2)
      input_error("caps",
                  fmt::format("are {}, and the stiffness is that between two of them", caps.size()),
                  "--ends NAME,NAME of " + list);
    return {caps[0], caps[1]};
  }
  for (const std::string& name : asked)
    if (std::find(caps.begin(), caps.end(), name) == caps.end())
      input_error("ends", "there is no cap '" + name + "'", suggestion(name, caps));
  if (asked.size() != 2 || asked[0] == asked[1])
    input_error("ends", "are not two caps", "two different ones of " + list);
  return {asked[0], asked[1]};
}

// The case with its two ends held, and nothing else.
Case between_ends(const Case& data, const std::array<std::string, 2>& ends) {
  Case own = data;
  own.mount.clear();
  for (const Mount& mount : data.mount) {
    const bool is_end = mount.cap == ends[0] || mount.cap == ends[1];
    if (!is_end && mount.kind != MountKind::free)
      input_error(mount_key(mount.cap), "holds the part besides its two ends",
                  "mounts at the two ends alone");
    if (is_end && data.state && mount.kind != MountKind::rigid)
      input_error(mount_key(mount.cap),
                  "is not rigid, and the state is that of the mount of the case",
                  "rigid ends where the case has a state");
  }
  for (const std::string& end : ends) own.mount.push_back({.cap = end, .kind = MountKind::rigid});
  return own;
}

void shift(Case& data, const std::string& end, const OffsetOfEnd& by) {
  if (by.value == 0) return;
  if (!data.state) data.state.emplace();
  auto& offsets = data.state->offset;
  auto own = std::find_if(offsets.begin(), offsets.end(),
                          [&](const EndOffset& o) { return o.cap == end; });
  if (own == offsets.end()) own = offsets.insert(own, EndOffset{.cap = end});
  (by.direction < 3 ? own->move : own->turn)[std::size_t(by.direction % 3)] += by.value;
}

std::string name_of(const Case& data, const OffsetOfEnd& by, const std::string& end) {
  const std::string named = data.state ? data.state->name : "";
  if (by.value == 0)
    return !data.state ? "at rest" : named.empty() ? "the state of the case" : named;
  const bool length = by.direction < 3;
  return fmt::format("{}{} moved by {:.6g} {} in {}", named.empty() ? "" : named + ", ", end,
                     by.value * (length ? 1e3 : 180 / pi), length ? "mm" : "deg",
                     direction_names[std::size_t(by.direction)]);
}

// Loads of the inertia of every motion of an end, of joints and of dampers.
Loads loads_of(const BuiltCase& built, const MatrixXd& inertia) {
  const Index joints = Index(built.joints.size()), dampers = Index(built.dampers.size());
  const Index dofs = dof_count(built.model), count = inertia.cols() + joints + dampers;
  Loads loads{std::vector<int>(std::size_t(count), -1), MatrixXd(dofs, count),
              MatrixXd::Zero(dofs, count)};
  loads.force.leftCols(inertia.cols()) = -inertia;
  if (joints > 0)
    loads.force.middleCols(inertia.cols(), joints) = unit_forces(built.model, built.joints);
  for (Index k = 0; k < dampers; ++k) {
    const BuiltDamper& d = built.dampers[std::size_t(k)];
    loads.force.col(count - dampers + k) = unit_force(built.model, d.node1, d.node2, d.dof);
  }
  return loads;
}

// Ratios hold for small motion, as in the reduced model of the joints: each mode keeps the viscous
// damping that it has with all joints stuck.
VectorXd viscous_damping(const Damping& damping, const Model& model, const PartBetweenEnds& part) {
  VectorXd stuck = part.lambda;
  const MatrixXd J = part.joints.bottomRows(part.lambda.size());
  for (Index j = 0; j < J.cols(); ++j)
    stuck += part.laws[std::size_t(j)].stuck_stiffness() * J.col(j).cwiseAbs2();
  const VectorXd zeta = modal_damping({.modal = damping.modal, .ranges = damping.ranges}, model,
                                      stuck, Eigen::MatrixXd(), 0)
                            .zeta;
  return 2 * zeta.cwiseProduct(stuck.cwiseSqrt());
}

// Loss of the components over the motion of the ends and the modes; empty without any.
MatrixXd loss_of(const Damping& damping, const BuiltCase& built, const MatrixXd& fields) {
  const bool any = std::any_of(damping.loss_factors.begin(), damping.loss_factors.end(),
                               [](const LossFactor& l) { return !is_at_mount(l.of); });
  if (!any) return {};
  MatrixXd L = MatrixXd::Zero(fields.cols(), fields.cols());
  const std::vector<MatrixXd> parts = component_stiffness(built.model, fields);
  for (const LossFactor& loss : damping.loss_factors)
    for (std::size_t c = 0; c < parts.size(); ++c)
      if (built.model.components[c] == loss.of && !(damping.coupled && is_springs(loss.of)))
        L += loss.value / 2 * (parts[c] + parts[c].transpose());
  return L;
}

class StiffnessStudy {
public:
  StiffnessStudy(const Case& data, const StiffnessRequest& request, const StageListener& stage)
      : request_(request), stage_(stage), ends_(ends_of(data, request.ends)) {
    const std::vector<std::string> own{""};
    for (const std::string& name : request.states.empty() ? own : request.states)
      cases_.push_back(between_ends(name.empty() ? data : in_state(data, name), ends_));
    friction_ = has_friction(cases_.front());
  }

  EndDynamicStiffness all() {
    result_.case_name = cases_.front().name;
    result_.friction = friction_;
    reach_ = 3 * std::max({1., request_.hertz.maxCoeff(), request_.highest});
    result_.highest_mode = reach_;
    levels_ = std::vector<MotionLevel>(1);
    levels_.insert(levels_.end(), request_.levels.begin(), request_.levels.end());
    if (!friction_ && levels_.size() > 1) {
      levels_.resize(1);
      result_.notes.push_back("nothing in the case depends on the amplitude: one table is that of "
                              "every amplitude");
    }
    const std::vector<OffsetOfEnd> at_rest{OffsetOfEnd{}};
    for (const Case& own : cases_)
      for (const OffsetOfEnd& by : request_.shifts.empty() ? at_rest : request_.shifts)
        result_.states.push_back(at(own, by));
    return std::move(result_);
  }

private:
  StateStiffness at(Case own, const OffsetOfEnd& by) {
    StateStiffness state;
    state.name = name_of(own, by, ends_[0]);
    shift(own, ends_[0], by);
    stage_({"", state.name});
    BuiltCase built = friction_ && !own.state ? slipping_case(own) : build(own);
    std::map<std::string, double> timing;
    if (own.state) {
      move_into(state.name, own, built, timing);
      if (friction_) built = slipping_in_state(std::move(built));
    }
    const auto route = choose_route(built, own.analyses, stage_, timing);
    state.route = route->name();
    state.part = between(built, own.analyses.damping, *route, state.modes);
    stage_("dynamic stiffness");
    state.over = dynamic_stiffness(state.part, request_.hertz, levels_, request_.harmonics,
                                   request_.samples);
    if (state.over.not_found > 0)
      result_.notes.push_back(fmt::format(
          "{}: harmonic balance found no motion for {} of {} columns; they are left empty",
          state.name, state.over.not_found,
          12 * request_.hertz.size() * Index(levels_.size() - 1)));
    return state;
  }

  void move_into(const std::string& name, const Case& own, BuiltCase& built,
                 std::map<std::string, double>& timing) const {
    try {
      move_into_state(own, built, stage_, timing);
    } catch (const StateError& error) {
      throw StateError(name + ": " + error.what());
    }
  }

  PartBetweenEnds between(const BuiltCase& built, const Damping& damping, Route& route,
                          int& modes) const {
    PartBetweenEnds part;
    part.names = ends_;
    const std::array<int, 2> caps{built.cap_nodes.at(ends_[0]), built.cap_nodes.at(ends_[1])};
    for (std::size_t k = 0; k < 2; ++k)
      part.places[k] = built.model.mesh.nodes[std::size_t(caps[k])];
    const std::optional<Matrix1212> K = route.end_stiffness(caps);
    if (!K) input_error("supports", "hold an end", "ends that the mount alone holds");
    part.K = *K;
    const MatrixXd Psi = route.follow(caps, Matrix1212::Identity());
    const MatrixXd inertia = mass_product(built.model, Psi);
    part.M = Psi.transpose() * inertia;
    part.M = ((part.M + part.M.transpose()) / 2).eval();
    const ModalSolution solution = route.modes({.count = 0, .band = {0, reach_}, .proof = false},
                                               loads_of(built, inertia), {});
    modes = solution.modes;
    part.lambda = solution.lambda;
    part.M_bq = -solution.input.leftCols(12).transpose();
    const Index m = part.lambda.size(), joints = Index(built.joints.size());
    const auto over_all = [&](Index column, const VectorXd& force) {
      VectorXd stretch(12 + m);
      stretch << Psi.transpose() * force, solution.input.col(column);
      return stretch;
    };
    part.joints.resize(12 + m, joints);
    for (Index j = 0; j < joints; ++j) {
      const BuiltJoint& joint = built.joints[std::size_t(j)];
      part.joints.col(j) = over_all(12 + j, unit_force(built.model, joint));
      part.laws.push_back(joint.law);
    }
    for (std::size_t k = 0; k < built.dampers.size(); ++k) {
      const BuiltDamper& d = built.dampers[k];
      part.dampers.push_back(
          {over_all(12 + joints + Index(k), unit_force(built.model, d.node1, d.node2, d.dof)),
           [d](std::complex<double> s) { return added_stiffness(d.law, d.dof, d.stiffness, s); }});
    }
    part.viscous = viscous_damping(damping, built.model, part);
    MatrixXd fields(Psi.rows(), 12 + m);
    fields << Psi, solution.u;
    part.loss = loss_of(damping, built, fields);
    return part;
  }

  const StiffnessRequest& request_;
  const StageListener& stage_;
  std::array<std::string, 2> ends_;
  bool friction_ = false;
  std::vector<Case> cases_; // with their ends held, one per state that is asked for
  double reach_ = 0;
  std::vector<MotionLevel> levels_;
  EndDynamicStiffness result_;
};

} // namespace

EndDynamicStiffness part_stiffness(const Case& data, const StiffnessRequest& request,
                                   const StageListener& stage) {
  return StiffnessStudy(data, request, stage).all();
}

} // namespace plica
