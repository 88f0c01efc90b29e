#include "run/analyses/dynamics.hpp"

#include "run/analyses/damping.hpp"
#include "run/analyses/dissipation.hpp"
#include "run/analyses/mode_names.hpp"
#include "run/analyses/referee.hpp"
#include "run/analyses/run_ups.hpp"
#include "run/analyses/stress.hpp"
#include "run/analyses/transients.hpp"
#include "run/stages.hpp"
#include "solve/drilling.hpp"
#include "solve/mode_labels.hpp"
#include "solve/stopwatch.hpp"
#include "words/mode_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

using Eigen::MatrixXd;

class Dynamics {
public:
  Dynamics(const Case& data, const BuiltCase& built, Route& route, const StageListener& stage,
           LifeCount* life, Results& results, const DirectSolver& direct)
      : case_(data), built_(built), route_(route), stage_(stage), life_(life), results_(results),
        direct_(direct) {}

  void run() {
    const Modes& asked = *case_.analyses.modes;
    const std::optional<Response>& response = case_.analyses.response;
    std::optional<Excitations> excited;
    if (response) excited = excitations(*response, built_);
    std::vector<int> sensors;
    for (const BuiltSensor& s : built_.sensors) sensors.push_back(s.node);
    const ModalSolution solution =
        route_.modes({.count = asked.count, .band = asked.band, .proof = asked.proof},
                     with_dampers(excited ? excited->loads : Loads{}, built_), sensors);
    for (const auto& [name, seconds] : solution.timing) results_.timing[name] += seconds;
    watch_ = Stopwatch();
    stage_(stages::labels);
    const DampedModes damped = damped_modes(solution, excited ? &*excited : nullptr);
    warn_of_what_does_nothing(damped, excited ? &*excited : nullptr);
    add_modes(damped);
    warn_of_drilling(solution);
    verify(solution.proof, solution.with_mass);
    lap("labels");
    if (excited) respond(*response, damped, *excited);
    if (case_.analyses.stress) {
      stage_(stages::stress);
      add_dynamic_stresses(case_, built_, damped, excited ? &*excited : nullptr, results_);
      lap("stress");
    }
    if (!life_ || !excited) return;
    stage_(stages::life);
    life_->add_dynamic(damped, *excited);
    lap("life");
  }

private:
  void lap(const std::string& name) { watch_.lap(results_.timing, name); }

  DampedModes damped_modes(const ModalSolution& solution, const Excitations* excited) {
    const Damping& asked = case_.analyses.damping;
    ModalDamping modal = modal_damping(
        asked, built_.model, solution.lambda,
        [&](const std::vector<int>& columns) { return strain_energy(solution, built_, columns); },
        solution.modes);
    DampedModes modes{solution,
                      std::move(modal.zeta),
                      std::move(modal.eta),
                      dissipation(asked, built_, solution, excited),
                      {}};
    if (asked.coupled) modes.eta.setZero(); // it is in the dissipation
    if (modes.dissipation.empty()) return modes;
    stage_(stages::complex_modes);
    ComplexModes found = complex_modes(modal_model(modes, {}), modes.dissipation, solution.modes);
    results_.complex_modes = {.complete = found.complete,
                              .oscillating = found.oscillating,
                              .overdamped = found.overdamped,
                              .reason = found.reason,
                              .shapes = {}};
    if (found.modes.size() < std::size_t(solution.modes) || !found.complete) {
      results_.warnings.push_back("complex modes: " + found.reason +
                                  "; damping of the modes is to first order");
      modes.first_order = first_order_damping(modes.dissipation, solution);
      return modes;
    }
    modes.complex = in_order_of_real_modes(std::move(found.modes), solution.modes);
    const MatrixXd output = at_sensors(built_, solution.u);
    for (const ComplexMode& mode : modes.complex)
      results_.complex_modes.shapes.push_back(output.cast<std::complex<double>>() * mode.q);
    return modes;
  }

  // Each real mode's own: the complex one that it is the largest part of.
  static std::vector<ComplexMode> in_order_of_real_modes(std::vector<ComplexMode> found,
                                                         int count) {
    std::vector<ComplexMode> ordered;
    for (int j = 0; j < count; ++j) {
      const auto share = [&](const ComplexMode& m) { return std::abs(m.q[j]) / m.q.norm(); };
      const auto own = std::max_element(
          found.begin(), found.end(),
          [&](const ComplexMode& a, const ComplexMode& b) { return share(a) < share(b); });
      ordered.push_back(std::move(*own));
      found.erase(own);
    }
    return ordered;
  }

  void warn_of_what_does_nothing(const DampedModes& modes, const Excitations* excited) {
    for (const ModeDamping& m : case_.analyses.damping.modes)
      if (m.mode > modes.solution.modes)
        results_.warnings.push_back("damping of mode " + std::to_string(m.mode) + ": only " +
                                    std::to_string(modes.solution.modes) + " modes were found");
    if (!excited) return;
    for (const Excitation& e : excited->list)
      if (std::all_of(e.parts.begin(), e.parts.end(), [&](const ExcitedColumn& part) {
            return modes.solution.input.col(part.column).isZero(0);
          }))
        results_.warnings.push_back(title_of(e) + " moves nothing: what it acts on is held");
  }

  // Modes whose frequency is that of the mesh.
  void warn_of_drilling(const ModalSolution& s) {
    constexpr double physics = 0.05; // of the strain energy: more is no rounding of the tie
    std::map<int, std::string> modes_at;
    const auto shares =
        drilling_shares(built_.model, s.u.leftCols(s.modes), s.lambda.head(s.modes));
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (shares[i].share > physics && results_.modes[i].shape != mode_kind::rigid)
        modes_at[shares[i].node] +=
            (modes_at[shares[i].node].empty() ? "" : ", ") + std::to_string(i + 1);
    for (const auto& [node, modes] : modes_at) {
      const Eigen::Vector3d& x = built_.model.mesh.nodes[std::size_t(node)];
      const std::string at = fmt::format("[{:.4g}, {:.4g}, {:.4g}] m", x[0], x[1], x[2]);
      results_.warnings.push_back(
          "mode " + modes + ": what sits on the one shell node at " + at +
          " turns about the normal of the wall, where a shell has no stiffness: the frequency is "
          "that of the mesh and has no limit. Put it on a set of nodes (a cap or a mass on a set "
          "of several nodes, such as an edge), or take the lever in the plane of the wall away");
    }
  }

  void respond(const Response& asked, const DampedModes& modes, const Excitations& excited) {
    stage_(stages::response);
    const SensorModel model = sensor_model(built_, modes, excited);
    results_.responses = responses(asked, model, modes, excited);
    const double last = frequency_of(modes, modes.solution.modes - 1);
    if (last < asked.band[1])
      results_.warnings.push_back("the modes end at " + std::to_string(std::lround(last)) +
                                  " Hz: above, the response holds only their static part and no "
                                  "peak is listed; ask for modes up to twice the band");
    lap("response");
    if (asked.referee > 0) check_directly(asked, model, modes, excited);
    over_time(model, modes, excited);
  }

  void check_directly(const Response& asked, const SensorModel& model, const DampedModes& modes,
                      const Excitations& excited) {
    stage_(stages::direct_solution);
    try {
      hold_against_direct_solution(asked, model, {built_, case_.analyses.damping, modes, excited},
                                   direct_, results_.responses);
    } catch (const std::runtime_error& error) { // the response itself is good
      results_.warnings.push_back(std::string("direct solution left out: ") + error.what());
    }
    constexpr double far_off = 0.01;
    for (const ResponseResult& r : results_.responses)
      for (const DirectCheck& check : r.direct)
        if (!(check.difference < far_off))
          results_.warnings.push_back(
              fmt::format("response {}: the direct solution at {:.4g} Hz differs by {:.2g} %; {}",
                          r.excitation, check.frequency, 100 * check.difference,
                          results_.reduced ? "raise the cut-off of analyses.reduction, or ask for "
                                             "more modes"
                                           : "ask for more modes"));
    lap("direct solution");
  }

  void over_time(const SensorModel& model, const DampedModes& modes, const Excitations& excited) {
    const Analyses& a = case_.analyses;
    if (a.transients.empty() && a.run_ups.empty()) return;
    stage_(stages::dynamics);
    for (std::size_t i = 0; i < a.transients.size(); ++i)
      results_.transients.push_back(transient(a.transients[i],
                                              "analyses.transients[" + std::to_string(i) + "]",
                                              model, modes, excited, results_.warnings));
    for (std::size_t i = 0; i < a.run_ups.size(); ++i)
      results_.run_ups.push_back(run_up(a.run_ups[i], "analyses.run_ups[" + std::to_string(i) + "]",
                                        model, modes, excited, results_.warnings));
    lap("transients and run-ups");
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
                      .damping = damping_of(damped, int(i)),
                      .effective_mass = {},
                      .shape = label.shape,
                      .direction = label.direction,
                      .order = label.order,
                      .harmonic = label.harmonic,
                      .place = "",
                      .residual = s.residual[i]};
      if (!damped.complex.empty()) mode.damped_frequency = frequency_of(damped, int(i));
      std::copy(m.begin(), m.end(), mode.effective_mass.begin());
      results_.modes.push_back(mode);
      if (results_.mesh.nodes.empty()) continue; // all nodes are not seen
      Eigen::MatrixXd shape =
          Eigen::Map<const MatrixXd>(s.u.col(i).data(), 6, s.u.rows() / 6).transpose();
      results_.shapes.push_back(std::move(shape));
    }
    tell_apart(results_.modes, built_.model.components,
               [&](const std::vector<int>& columns) { return strain_energy(s, built_, columns); });
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
  const BuiltCase& built_;
  Route& route_;
  const StageListener& stage_;
  LifeCount* life_;
  Results& results_;
  const DirectSolver& direct_;
  Stopwatch watch_;
};

} // namespace

void run_dynamics(const Case& data, const BuiltCase& built, Route& route,
                  const StageListener& stage, LifeCount* life, Results& results,
                  const DirectSolver& direct) {
  Dynamics(data, built, route, stage, life, results, direct).run();
}

} // namespace plica
