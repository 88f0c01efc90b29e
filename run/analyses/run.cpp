#include "run/analyses/run.hpp"

#include "model/description/connector_curve.hpp"
#include "model/description/end_caps.hpp"
#include "model/shape/doubts.hpp"
#include "run/analyses/deck_statics.hpp"
#include "run/analyses/dynamics.hpp"
#include "run/analyses/joint_strokes.hpp"
#include "run/analyses/levels.hpp"
#include "run/analyses/life.hpp"
#include "run/analyses/run_by_route.hpp"
#include "run/analyses/static_stiffness.hpp"
#include "run/analyses/stress.hpp"
#include "run/routes/operating_state.hpp"
#include "run/routes/ply_slip.hpp"
#include "run/routes/state_joints.hpp"
#include "run/stages.hpp"
#include "solve/base_state.hpp"
#include "solve/model_error.hpp"
#include "solve/stopwatch.hpp"
#include "words/input_error.hpp"
#include "words/short_text.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/printf.h>

namespace plica {
namespace {

using Eigen::MatrixXd;

class Run {
public:
  Run(const Case& data, const StageListener& stage, const Solvers& solvers, Shapes shapes)
      : case_(data), stage_(stage), solvers_(solvers), shapes_(shapes) {}

  Results results() {
    stage_(stages::mesh);
    built_ = build(case_);
    lap("mesh");
    if (case_.state) {
      results_.state = move_into_state(case_, built_, stage_, results_.timing);
      watch_ = Stopwatch();
    }
    if (shapes_ == Shapes::left_out) seen_ = seen_enough(case_, built_);
    route_ =
        solvers_.route(built_, seen_ ? &*seen_ : nullptr, case_.analyses, stage_, results_.timing);
    describe();
    if (has_friction(case_)) let_slip();
    if (case_.state && case_.analyses.stress) add_state_stress(case_, built_, results_);
    if (case_.analyses.life) life_.emplace(case_, built_);
    const bool moved = case_.analyses.life && needs_statics(*case_.analyses.life);
    if (ask_statics() || moved) around_state([this] { statics(); });
    if (case_.analyses.deck_loads) loads_of_decks();
    if (case_.analyses.modes) dynamics();
    if (const auto& asked = case_.analyses.levels;
        asked && !(asked->bases.empty() && asked->forces.empty()))
      levels();
    if (life_) finish_life();
    results_.peak_memory = peak_memory();
    return std::move(results_);
  }

private:
  // What cannot be solved around a state for want of stability: the state lies beyond buckling,
  // which by symmetry shows in other harmonics than that of the state.
  template <class Work> void around_state(const Work& work) const {
    try {
      work();
    } catch (const ModelError& error) {
      if (!case_.state) throw;
      throw StateError(std::string("around the state the part is not stable, it has buckled "
                                   "(state.buckling says at which loads): ") +
                       error.what());
    }
  }

  void dynamics() {
    around_state([this] {
      run_dynamics(case_, seen_ ? seen_->built : built_, *route_, stage_, life_ ? &*life_ : nullptr,
                   results_, solvers_.direct);
    });
    watch_ = Stopwatch();
  }

  void loads_of_decks() {
    watch_ = Stopwatch();
    DeckStatics solved = deck_statics(case_, built_, stage_);
    if (case_.analyses.stress) {
      std::vector<std::string> names;
      for (const DeckLoadResult& r : solved.results) names.push_back(r.name);
      add_static_stresses({.field = recover_stress(built_.model, solved.u), .names = names}, case_,
                          built_, results_);
    }
    for (std::string& note : solved.notes) results_.warnings.push_back(std::move(note));
    results_.deck_loads = std::move(solved.results);
    lap("loads of decks");
  }

  void finish_life() {
    if (slipping_) life_->add_friction_sweeps(*slipping_, *slipping_route_, stage_);
    stage_(stages::life);
    watch_ = Stopwatch();
    results_.life = life_->result();
    results_.places = life_->places();
    for (const std::string& warning : results_.life->warnings) results_.warnings.push_back(warning);
    lap("life");
  }

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
    results_.line_radii = drawn_radii(built_);
    results_.symbols = symbols_of(case_, built_);
    for (const BuiltSensor& s : built_.sensors)
      results_.sensors.push_back({s.name, s.node, s.distance, s.axes});
    results_.model = {.nodes = static_cast<int>(built_.model.mesh.nodes.size()),
                      .elements = element_count(built_.model),
                      .dofs = route_->unknowns(),
                      .mass = route_->mass()};
    if (!std::isfinite(results_.model.mass))
      input_error("parts", "have a mass that is no finite number",
                  "sizes, densities and masses of a structure");
    if (!seen_) results_.mesh = built_.model.mesh;
  }

  // Small motion sticks, a test rig and high levels slip: the second state has its own model.
  void let_slip() {
    stage_(stages::mesh);
    slipping_ = case_.state ? slipping_in_state(built_) : slipping_case(case_);
    slipping_route_ = solvers_.route(*slipping_, nullptr, case_.analyses, stage_, results_.timing);
    results_.slipping.emplace();
    for (const BuiltJoint& j : slipping_->joints)
      if (std::vector<std::string>& all = results_.slipping->joints;
          std::find(all.begin(), all.end(), j.place + " " + j.motion) == all.end())
        all.push_back(j.place + " " + j.motion);
  }

  // Where a case says nothing, between the caps of those that have two.
  bool ask_statics() {
    if (!case_.analyses.statics) return case_.caps.size() == 2;
    if (!*case_.analyses.statics || !end_caps(case_).empty()) return *case_.analyses.statics;
    results_.warnings.push_back("static stiffness left out: it is that between two ends, the caps "
                                "of a case that has two, or the two that are mounted");
    return false;
  }

  void statics() {
    const BuiltCase& built = slipping_ ? *slipping_ : built_;
    Route& route = slipping_ ? *slipping_route_ : *route_;
    const std::vector<std::string> ends = end_caps(case_);
    const std::array<int, 2> caps{built.cap_nodes.at(ends[0]), built.cap_nodes.at(ends[1])};
    const std::optional<Matrix1212> K = route.end_stiffness(caps);
    if (!K && life_ && needs_statics(*case_.analyses.life))
      input_error("analyses.life", "moves an end that a support holds", "ends that are free to");
    if (!K) {
      results_.warnings.push_back("static stiffness left out: a support holds a cap");
      return;
    }
    results_.statics = static_stiffness(*K, case_.state.has_value());
    if (results_.statics->k_bending_x < 0 || results_.statics->k_bending_z < 0)
      results_.warnings.push_back(
          "static stiffness in bending is below zero: under the loads of the state the end would "
          "not stay where it is if it were free");
    const bool tabulated = add_strokes();
    if (slipping_) {
      results_.slipping->k_axial_stuck =
          end_stiffness(route_->end_stiffness(caps)->bottomRightCorner<6, 6>()).axial;
      if (results_.strokes.empty()) add_joint_strokes(caps, *K);
    }
    if (tabulated && results_.strokes.empty())
      results_.warnings.push_back("tabulated forces: with other parts beside the chain the static "
                                  "stiffness is that at rest, also where the test states a stroke");
    if (case_.analyses.stress) static_stress(built, route, caps, *K);
    if (life_ && needs_statics(*case_.analyses.life)) {
      watch_ = Stopwatch();
      stage_(stages::life);
      add_static_stresses(life_->add_movements(built, route, caps, *K), case_, built, results_);
      lap("life");
    }
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

  void static_stress(const BuiltCase& built, Route& route, const std::array<int, 2>& caps,
                     const Matrix1212& K) {
    add_static_stresses(
        {.field = recover_stress(built.model, route.follow(caps, 1e-3 * parallel_motion(K))),
         .names = {"1 mm axial", "1 mm transverse x", "1 mm transverse z"}},
        case_, built, results_);
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
    stage_(stages::joints);
    watch_ = Stopwatch();
    const JointedModel model = jointed_model(case_, built, route);
    lap("reduced model of the joints");
    results_.level_responses = level_responses(model, *case_.analyses.levels, stage_);
    for (const LevelResponses& responses : results_.level_responses) warn_of_levels(responses);
    lap("levels");
  }

  void warn_of_levels(const LevelResponses& responses) {
    const auto warn = [&](double level, const std::string& what) {
      const std::string text = fmt::sprintf("%g ", level);
      results_.warnings.push_back("levels, excitation " + responses.excitation + ", " + text +
                                  responses.unit + ": " + what);
    };
    for (const LevelCurve& curve : responses.curves) {
      if (!curve.complete)
        warn(curve.level, "the branch was not followed to its end: " + curve.reason);
      else if (curve.peaks_up.empty())
        warn(curve.level, "no peak in the band");
    }
    constexpr double far_off = 0.05;
    for (const RefereeCheck& r : responses.referee)
      if (!r.settled || !(r.difference < far_off))
        warn(r.level,
             "integration in time at " + short_text(r.frequency, 6) + " Hz " +
                 (r.settled ? "differs by " + std::to_string(std::lround(100 * r.difference)) +
                                  " %: more harmonics or samples"
                            : "does not settle to the motion of the harmonic balance"));
  }

  const Case& case_;
  const StageListener& stage_;
  const Solvers& solvers_;
  Shapes shapes_;
  Stopwatch watch_;
  BuiltCase built_;
  std::optional<SeenCase> seen_; // none: all nodes are
  std::unique_ptr<Route> route_;
  // With joints that slip; none: the case has no friction.
  std::optional<BuiltCase> slipping_;
  std::unique_ptr<Route> slipping_route_;
  std::optional<LifeCount> life_;
  Results results_;
};

} // namespace

Results run(const Case& data, const std::function<void(const std::string&)>& stage,
            ReductionMemory* memory, Shapes shapes) {
  return run_by_route(
      data, stage,
      {.route =
           [memory](const BuiltCase& built, const SeenCase* seen, const Analyses& analyses,
                    const StageListener& listener, Timing& timing) {
             return choose_route(built, analyses, listener, timing,
                                 {.seen = seen, .reduce = reduce_here(memory)});
           }},
      shapes);
}

Results run_by_route(const Case& data, const StageListener& stage, const Solvers& solvers,
                     Shapes shapes) {
  if (!data.state || acts(*data.state)) return Run(data, stage, solvers, shapes).results();
  Case at_rest = data;
  at_rest.state.reset();
  Results results = Run(at_rest, stage, solvers, Shapes::kept).results();
  StateResult& idle = results.state.emplace();
  idle.name = data.state->name;
  idle.route = "at rest";
  idle.displacement = Eigen::MatrixXd::Zero(Eigen::Index(results.mesh.nodes.size()), 3);
  return results;
}

} // namespace plica
