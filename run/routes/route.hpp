// How a run is solved: on the full mesh, or harmonic by harmonic where the part repeats around its
// axis, which gives the same numbers; or with superelements in place of the parts between caps.
#pragma once

#include "model/shape/build.hpp"
#include "run/results/results.hpp"
#include "run/routes/symmetric_view.hpp"
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
  std::map<std::string, double> timing;
};

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

using StageListener = std::function<void(const std::string&)>;
using Timing = std::map<std::string, double>;

class ReductionMemory; // reduction/substructures.hpp

// `stage` hears what begins; times go into `timing`, which must outlive the route. `memory`:
// reductions of earlier runs. Throws InputError when the case asks for symmetry and the part has
// none, and as assemble() does.
std::unique_ptr<Route> choose_route(const BuiltCase& built, const Analyses& analyses,
                                    const StageListener& stage, Timing& timing,
                                    ReductionMemory* memory = nullptr);

// Independent DOFs of the nodes, increasing.
std::vector<int> node_dofs(const DofMap& map, const std::vector<int>& nodes);

// Throws InputError, which names the motion that is free: loads need a part that is held.
void require_held(bool free_body, const BuiltCase& built);

// The routes, for tests and benchmarks.
std::unique_ptr<Route> full_route(const BuiltCase& built, const std::string& reason,
                                  const StageListener& stage, Timing& timing);
std::unique_ptr<Route> cyclic_route(const BuiltCase& built, CyclicModel model,
                                    const StageListener& stage, Timing& timing);
std::unique_ptr<Route> reduced_route(const BuiltCase& built, double cutoff, Symmetry symmetry,
                                     const StageListener& stage, Timing& timing,
                                     ReductionMemory* memory = nullptr);

} // namespace plica
