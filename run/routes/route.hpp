// How a run is solved: on the full mesh, or harmonic by harmonic where the part repeats around its
// axis, which gives the same numbers; or with superelements in place of the parts between caps.
#pragma once

#include "model/shape/build.hpp"
#include "reduction/substructures.hpp"
#include "run/results/results.hpp"
#include "run/routes/seen_case.hpp"
#include "run/routes/symmetric_view.hpp"
#include "run/stages.hpp"
#include "solve/modes.hpp"
#include "solve/statics.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace plica {

using Matrix1212 = Eigen::Matrix<double, 12, 12>;

// What excites a modal model, one column each.
struct Loads {
  std::vector<int> base; // per load: direction of the base motion 0..5, -1 = a force
  Eigen::MatrixXd force; // all DOFs x loads; zero for base motion
  Eigen::MatrixXd rigid; // all DOFs x loads: motion of the base about the origin; zero for a force
};

// Modes and, for loads, pseudo-modes of their static solutions (solve/static_correction.hpp).
struct ModalSolution {
  Eigen::VectorXd lambda; // modes, then pseudo-modes
  int modes = 0;
  Eigen::MatrixXd u;                  // all DOFs x columns, mass-normalised
  Eigen::MatrixXd input;              // columns x loads: phi' F, base motion per unit acceleration
  Eigen::VectorXd residual, rounding; // of each mode; rounding as in solve/modes.hpp
  ModesProof proof;
  int with_mass = 0;      // free degrees of freedom with mass: there are no more modes than these
  bool free_body = false; // nothing holds it: rigid modes are among the modes
  // Free part: phi' M r about its centre (modes x 6), its mass and r' M r (effective_mass.hpp).
  Eigen::MatrixXd participation;
  double mass = 0;
  Eigen::Matrix<double, 6, 1> free_mass;
  // u' K_c u by component (rows) of these columns, while the route lives; none: u is asked.
  std::function<Eigen::MatrixXd(const std::vector<int>& columns)> energy;
  std::map<std::string, double> timing;
};

// u' K_c u by component (rows) of these columns; `built`: what the solution is of.
Eigen::MatrixXd strain_energy(const ModalSolution& solution, const BuiltCase& built,
                              const std::vector<int>& columns);

class Route {
public:
  virtual ~Route() = default;

  // "rotational symmetry, 38 sectors" or "full mesh: ..." with the reason.
  virtual std::string name() const = 0;
  virtual double mass() const = 0;  // held nodes included
  virtual int unknowns() const = 0; // of the full mesh, before the mount holds any
  virtual std::optional<Reduced> reduced() const { return std::nullopt; }

  // Stiffness between the two reference nodes without spring mounts, in the order given. Empty when
  // a support holds one of them. Throws std::runtime_error for a mechanism.
  virtual std::optional<Matrix1212> end_stiffness(const std::array<int, 2>& caps) = 0;
  // All DOFs when these nodes move by the columns (12 rows) and nothing else acts. Needs
  // end_stiffness() of the same caps, which it takes itself where it was not the last one asked
  // for; throws std::logic_error where that is empty.
  virtual Eigen::MatrixXd follow(const std::array<int, 2>& caps, const Eigen::MatrixXd& motion) = 0;

  // Throws InputError for loads on a part that nothing holds.
  virtual ModalSolution modes(const ModesRequest& request, const Loads& loads,
                              const std::vector<int>& sensor_nodes) = 0;
};

using Timing = std::map<std::string, double>;

// What a route gives of the fields, and by whom substructures are reduced.
struct RouteSettings {
  // Fields and forces are those of its nodes, in place of all: superelements alone can leave the
  // others out. Outlives the route.
  const SeenCase* seen = nullptr;
  PartReducer reduce = reduce_here();
};

// `stage` hears what begins; times go into `timing`, which must outlive the route. Throws
// InputError when the case asks for symmetry and the part has none, and as assemble() does.
std::unique_ptr<Route> choose_route(const BuiltCase& built, const Analyses& analyses,
                                    const StageListener& stage, Timing& timing,
                                    const RouteSettings& settings = {});

// Independent DOFs of the nodes, increasing.
std::vector<int> node_dofs(const DofMap& map, const std::vector<int>& nodes);

// Throws InputError, which names the motion that is free: loads need a part that is held.
void require_held(bool free_body, const BuiltCase& built);

// The routes, for tests and benchmarks.
std::unique_ptr<Route> full_route(const BuiltCase& built, const std::string& reason,
                                  const StageListener& stage, Timing& timing);
std::unique_ptr<Route> cyclic_route(const BuiltCase& built, CyclicModel model,
                                    const StageListener& stage, Timing& timing);
// `pieces`: of cut_between_caps() (built_reduced.hpp).
std::unique_ptr<Route> reduced_route(const BuiltCase& built, CutModel pieces,
                                     const Analyses& analyses, const StageListener& stage,
                                     Timing& timing, const RouteSettings& settings = {});

} // namespace plica
