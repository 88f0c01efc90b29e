#include "run/analyses/run.hpp"

#include "model/description/connector_curve.hpp"
#include "model/shape/doubts.hpp"
#include "run/analyses/damping.hpp"
#include "run/analyses/joint_strokes.hpp"
#include "run/analyses/levels.hpp"
#include "run/analyses/mode_names.hpp"
#include "run/analyses/stress.hpp"
#include "run/routes/ply_slip.hpp"
#include "solve/drilling.hpp"
#include "solve/mode_labels.hpp"
#include "solve/stopwatch.hpp"
#include "words/input_error.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/printf.h>

namespace plica {
namespace {

using Eigen::MatrixXd;

class Run {
public:
  Run(const Case& data, const std::function<void(const std::string&)>& stage)
      : case_(data), stage_(stage) {}

  Results results() {
    stage_("mesh");
    built_ = build(case_);
    lap("mesh");
    route_ = choose_route(built_, case_.analyses, stage_, results_.timing);
    describe();
    if (has_friction(case_)) let_slip();
    if (case_.analyses.statics.value_or(true) && case_.caps.size() == 2) statics();
    if (case_.analyses.modes) modes();
    if (case_.analyses.levels) levels();
    results_.peak_memory = peak_memory();
    return std::move(results_);
  }

private:
  void lap(const std::string& name) { watch_.lap(results_.timing, name); }

  void describe() {
    results_.case_name = case_.name;
    results_.title = case_.title;
    results_.modelled_as = case_.model;
    results_.assumptions = case_.assumptions;
    results_.quality = mesh_quality(built_.model.mesh);
    for (std::string& doubt : doubts(case_, built_)) results_.warnings.push_back(std::move(doubt));
    results_.meridian = built_.meridian;
    results_.route = route_->name();
    results_.reduced = route_->reduced();
    for (const BeamElement& b : built_.model.beams) results_.lines.push_back({b.node1, b.node2});
    for (const BuiltSensor& s : built_.sensors)
      results_.sensors.push_back({s.name, s.node, s.distance, s.axes});
    results_.model = {.nodes = static_cast<int>(built_.model.mesh.nodes.size()),
                      .elements = element_count(built_.model),
                      .dofs = route_->unknowns(),
                      .mass = route_->mass()};
    if (!std::isfinite(results_.model.mass))
      input_error("parts", "have a mass that is no finite number",
                  "sizes, densities and masses of a structure");
    results_.mesh = built_.model.mesh;
  }

  // Small motion sticks, a test rig and high levels slip: the second state has its own model.
  void let_slip() {
    stage_("mesh");
    slipping_ = slipping_case(case_);
    slipping_route_ = choose_route(*slipping_, case_.analyses, stage_, results_.timing);
    results_.slipping.emplace();
    for (const BuiltJoint& j : slipping_->joints)
      if (std::vector<std::string>& all = results_.slipping->joints;
          std::find(all.begin(), all.end(), j.place + " " + j.motion) == all.end())
        all.push_back(j.place + " " + j.motion);
  }

  void statics() {
    const BuiltCase& built = slipping_ ? *slipping_ : built_;
    Route& route = slipping_ ? *slipping_route_ : *route_;
    const std::array<int, 2> caps{built.cap_nodes.at(case_.caps[0].name),
                                  built.cap_nodes.at(case_.caps[1].name)};
    const std::optional<Matrix1212> K = route.end_stiffness(caps);
    if (!K) {
      results_.warnings.push_back("static stiffness left out: a support holds a cap");
      return;
    }
    const EndStiffness k = end_stiffness(K->bottomRightCorner<6, 6>());
    results_.statics = {.k_axial = k.axial,
                        .k_transverse_x = k.transverse_x,
                        .k_transverse_z = k.transverse_z,
                        .k_bending_x = k.bending_x,
                        .k_bending_z = k.bending_z,
                        .k_torsion = k.torsion,
                        .end_stiffness = *K};
    const bool tabulated = add_strokes();
    if (slipping_) {
      results_.slipping->k_axial_stuck =
          end_stiffness(route_->end_stiffness(caps)->bottomRightCorner<6, 6>()).axial;
      if (results_.strokes.empty()) add_joint_strokes(caps, *K);
    }
    if (tabulated && results_.strokes.empty())
      results_.warnings.push_back("tabulated forces: with other parts beside the chain the static "
                                  "stiffness is that at rest, also where the test states a stroke");
    if (case_.analyses.stress) static_stress(built.model, route, caps, *K);
  }

  // Of a chain with tabulated forces that has neither friction nor anything beside it but masses.
  // True when there are such forces at all.
  bool add_strokes() {
    std::size_t masses = 0;
    std::vector<StrokeCurve> curves;
    for (const Part& part : case_.parts) {
      masses += std::holds_alternative<PointMass>(part.body);
      if (const auto* chain = std::get_if<ConnectorChain>(&part.body); chain && !chain->friction)
        for (StrokeCurve& c : stroke_curves(*chain)) curves.push_back(std::move(c));
    }
    const bool tabulated = !curves.empty();
    if (masses + 1 == case_.parts.size()) results_.strokes = std::move(curves);
    return tabulated;
  }

  // Motion of both caps: the second by a unit along and across x and z, kept parallel.
  static MatrixXd parallel_motion(const Matrix1212& K) {
    MatrixXd motion = MatrixXd::Zero(12, 3);
    const Eigen::Matrix3d parallel = K.block<3, 3>(6, 6).inverse();
    for (const auto& [column, axis] : {std::pair{0, 1}, std::pair{1, 0}, std::pair{2, 2}})
      motion.block<3, 1>(6, column) = parallel.col(axis) / parallel(axis, axis);
    return motion;
  }

  void static_stress(const Model& model, Route& route, const std::array<int, 2>& caps,
                     const Matrix1212& K) {
    results_.stresses =
        static_stresses({.u = route.follow(caps, 1e-3 * parallel_motion(K)),
                         .names = {"1 mm axial", "1 mm transverse x", "1 mm transverse z"}},
                        model);
  }

  // Between caps that the mount holds both: what joints bear while they stick, and until they slip.
  void add_joint_strokes(const std::array<int, 2>& caps, const Matrix1212& K) {
    const BuiltCase& built = *slipping_;
    for (int cap : caps)
      if (std::find(built.held_nodes.begin(), built.held_nodes.end(), cap) ==
          built.held_nodes.end())
        return;
    const auto joints = Eigen::Index(built.joints.size());
    Loads loads{.base = std::vector<int>(built.joints.size(), -1),
                .force = unit_forces(built.model, built.joints),
                .rigid = MatrixXd::Zero(dof_count(built.model), joints)};
    const MatrixXd motion =
        loads.force.transpose() * slipping_route_->follow(caps, parallel_motion(K).leftCols(2));
    const ModalSolution held =
        slipping_route_->modes({.count = 1, .band = {}, .proof = false}, loads, {});
    const EndStiffness slipping = end_stiffness(K.bottomRightCorner<6, 6>());
    for (StrokeCurve& c : joint_strokes({.lambda = held.lambda,
                          .zeta = {},
                          .eta = {},
                          .joints = held.input,
                          .input = {},
                          .laws = laws_of(built.joints)},
                                        motion, {slipping.axial, slipping.transverse_x}))
      results_.strokes.push_back(std::move(c));
  }

  void levels() {
    const BuiltCase& built = slipping_ ? *slipping_ : built_;
    Route& route = slipping_ ? *slipping_route_ : *route_;
    stage_("reduced model of the joints");
    watch_ = Stopwatch();
    const JointedModel model = jointed_model(case_, built, route);
    lap("reduced model of the joints");
    results_.families = level_families(model, *case_.analyses.levels, stage_);
    for (const LevelFamily& family : results_.families) warn_of_levels(family);
    lap("levels");
  }

  void warn_of_levels(const LevelFamily& family) {
    const auto warn = [&](double level, const std::string& what) {
      const std::string text = fmt::sprintf("%g ", level);
      results_.warnings.push_back("levels, excitation " + family.excitation + ", " + text +
                                  family.unit + ": " + what);
    };
    for (const LevelCurve& curve : family.curves) {
      if (!curve.complete)
        warn(curve.level, "the branch was not followed to its end: " + curve.reason);
      else if (curve.peaks_up.empty())
        warn(curve.level, "no peak in the band");
    }
    constexpr double far_off = 0.05;
    for (const RefereeCheck& r : family.referee)
      if (!r.settled || !(r.difference < far_off))
        warn(r.level,
             "integration in time at " + std::to_string(r.frequency) + " Hz " +
                 (r.settled ? "differs by " + std::to_string(std::lround(100 * r.difference)) +
                                  " %: more harmonics or samples"
                            : "does not settle to the motion of the harmonic balance"));
  }

  void modes() {
    const Modes& asked = *case_.analyses.modes;
    const std::optional<Response>& response = case_.analyses.response;
    std::optional<Excitations> excited;
    if (response) excited = excitations(*response, built_.model);
    std::vector<int> sensors;
    for (const BuiltSensor& s : built_.sensors) sensors.push_back(s.node);
    const ModalSolution solution =
        route_->modes({.count = asked.count, .band = asked.band, .proof = asked.proof},
                      excited ? excited->loads : Loads{}, sensors);
    for (const auto& [name, seconds] : solution.timing) results_.timing[name] += seconds;
    watch_ = Stopwatch();
    stage_("labels");
    const ModalDamping damping = modal_damping(case_.analyses.damping, built_.model,
                                               solution.lambda, solution.u, solution.modes);
    const DampedModes damped{solution, damping.zeta, damping.eta};
    warn_of_what_does_nothing(damped, excited ? &*excited : nullptr);
    add_modes(damped);
    warn_of_drilling(solution);
    verify(solution.proof, solution.with_mass);
    lap("labels");
    if (excited) respond(*response, damped, *excited);
    if (!case_.analyses.stress) return;
    stage_("stress");
    for (StressResult& s : dynamic_stresses(*case_.analyses.stress, response ? &*response : nullptr,
                                            built_.model, damped, excited ? &*excited : nullptr))
      results_.stresses.push_back(std::move(s));
    lap("stress");
  }

  void warn_of_what_does_nothing(const DampedModes& modes, const Excitations* excited) {
    for (const ModeDamping& m : case_.analyses.damping.modes)
      if (m.mode > modes.solution.modes)
        results_.warnings.push_back("damping of mode " + std::to_string(m.mode) + ": only " +
                                    std::to_string(modes.solution.modes) + " modes were found");
    if (!excited) return;
    for (std::size_t k = 0; k < excited->list.size(); ++k)
      if (modes.solution.input.col(Eigen::Index(k)).cwiseAbs().maxCoeff() == 0)
        results_.warnings.push_back(
            (excited->list[k].is_force ? "force " : "motion of the base in ") +
            excited->list[k].name + " moves nothing: what it acts on is held");
  }

  // Modes whose frequency is that of the mesh.
  void warn_of_drilling(const ModalSolution& s) {
    constexpr double physics = 0.05; // of the strain energy: more is no rounding of the tie
    std::map<int, std::string> modes_at;
    const auto shares =
        drilling_shares(built_.model, s.u.leftCols(s.modes), s.lambda.head(s.modes));
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (shares[i].share > physics && results_.modes[i].shape != "rigid")
        modes_at[shares[i].node] +=
            (modes_at[shares[i].node].empty() ? "" : ", ") + std::to_string(i + 1);
    for (const auto& [node, modes] : modes_at) {
      const Eigen::Vector3d& x = built_.model.mesh.nodes[std::size_t(node)];
      const std::string at = fmt::sprintf("[%.4g, %.4g, %.4g] m", x[0], x[1], x[2]);
      results_.warnings.push_back(
          "mode " + modes + ": what sits on the one shell node at " + at +
          " turns about the normal of the wall, where a shell has no stiffness: the frequency is "
          "that of the mesh and has no limit. Put it on a set of nodes (a cap or a mass on a set "
          "of several nodes, such as an edge), or take the lever in the plane of the wall away");
    }
  }

  void respond(const Response& asked, const DampedModes& modes, const Excitations& excited) {
    stage_("response");
    results_.responses = responses(asked, built_, modes, excited);
    const double last = frequency(modes.solution.lambda[modes.solution.modes - 1]);
    if (last < asked.band[1])
      results_.warnings.push_back("the modes end at " + std::to_string(std::lround(last)) +
                                  " Hz: above, the response holds only their static part and no "
                                  "peak is listed; ask for modes up to twice the band");
    lap("response");
  }

  // A free body's modes that are not told from zero, by the lowest that is, or for rounding. Where
  // all are rigid, sigma lies above them.
  static std::vector<bool> rigid_modes(const ModalSolution& s) {
    const double scale = std::max(s.modes > 0 ? s.lambda[s.modes - 1] : 0, s.proof.sigma);
    double elastic = scale;
    for (Eigen::Index i = s.modes - 1; i >= 0; --i)
      if (s.lambda[i] > 1e-6 * scale && s.lambda[i] > s.rounding[i]) elastic = s.lambda[i];
    std::vector<bool> rigid;
    for (Eigen::Index i = 0; i < s.modes; ++i)
      rigid.push_back(s.free_body && s.lambda[i] < std::max(1e-6 * elastic, s.rounding[i]));
    return rigid;
  }

  void add_modes(const DampedModes& damped) {
    const ModalSolution& s = damped.solution;
    const std::vector<bool> rigid = rigid_modes(s);
    const MatrixXd effective = s.participation.array().square();
    for (Eigen::Index i = 0; i < s.modes; ++i) {
      const Eigen::Matrix<double, 6, 1> m = effective.row(i).transpose();
      const ModeLabel label = label_mode(built_.model, s.u.col(i), rigid[std::size_t(i)],
                                         m.cwiseQuotient(s.free_mass.cwiseMax(1e-300)));
      ModeResult mode{.frequency = frequency(s.lambda[i]),
                      .damping = damped.zeta[i] + damped.eta[i] / 2,
                      .effective_mass = {},
                      .shape = label.shape,
                      .direction = label.direction,
                      .order = label.order,
                      .harmonic = label.harmonic,
                      .place = "",
                      .residual = s.residual[i]};
      std::copy(m.begin(), m.end(), mode.effective_mass.begin());
      results_.modes.push_back(mode);
      Eigen::MatrixXd shape =
          Eigen::Map<const MatrixXd>(s.u.col(i).data(), 6, s.u.rows() / 6).transpose();
      results_.shapes.push_back(std::move(shape));
    }
    tell_apart(results_.modes, built_.model, s.u);
    std::copy(s.free_mass.begin(), s.free_mass.end(), results_.free_mass.begin());
    const Eigen::RowVectorXd sum = effective.colwise().sum();
    std::copy(sum.begin(), sum.end(), results_.effective_mass_sum.begin());
  }

  void warn_of_the_cutoff(const Modes& asked) {
    const double cutoff = results_.reduced->cutoff;
    const auto above = std::count_if(results_.modes.begin(), results_.modes.end(),
                                     [&](const ModeResult& m) { return m.frequency > cutoff; });
    const std::string hertz = std::to_string(std::lround(cutoff)) + " Hz";
    if (above > 0)
      results_.warnings.push_back(std::to_string(above) + " modes lie above the cut-off of " +
                                  hertz +
                                  " of analyses.reduction and are not those of the whole model");
    if (asked.band[1] == 0 && static_cast<int>(results_.modes.size()) < asked.count)
      results_.warnings.push_back("the reduced model has " + std::to_string(results_.modes.size()) +
                                  " modes, fewer than asked for: raise the cut-off of " + hertz +
                                  " of analyses.reduction");
  }

  void verify(const ModesProof& proof, int with_mass) {
    results_.verification = {.made = proof.made,
                             .sigma_frequency = frequency(proof.sigma),
                             .inertia_count = proof.inertia_count,
                             .found = proof.found,
                             .max_residual = proof.max_residual,
                             .orthogonality = proof.orthogonality,
                             .rounding = proof.rounding,
                             .passed = proof.passed,
                             .reason = proof.reason,
                             .of = results_.reduced ? "the reduced model" : ""};
    const Modes& asked = *case_.analyses.modes;
    if (results_.reduced)
      warn_of_the_cutoff(asked);
    else if (static_cast<int>(results_.modes.size()) < asked.count)
      results_.warnings.push_back("there are " + std::to_string(results_.modes.size()) +
                                  " modes, fewer than asked for: " +
                                  (static_cast<int>(results_.modes.size()) >= with_mass
                                       ? "no more degrees of freedom have mass"
                                       : "the others lie so far above them that rounding hides "
                                         "them (a mass or a stiffness is beyond 1e13 times "
                                         "another)"));
  }

  const Case& case_;
  const std::function<void(const std::string&)>& stage_;
  Stopwatch watch_;
  BuiltCase built_;
  std::unique_ptr<Route> route_;
  // With joints that slip; none: the case has no friction.
  std::optional<BuiltCase> slipping_;
  std::unique_ptr<Route> slipping_route_;
  Results results_;
};

} // namespace

Results run(const Case& data, const std::function<void(const std::string&)>& stage) {
  return Run(data, stage).results();
}

} // namespace plica
