#include "solve/base_state.hpp"

#include "solve/sparse_factor.hpp"
#include "solve/state_elements.hpp"
#include "solve/state_shape.hpp"
#include "solve/statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace plica {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

class NewtonState {
public:
  NewtonState(const Model& at_rest, const StateLoads& loads, const StateSolver& solver,
              const std::function<void(const StateIteration&)>& progress)
      : rest_(at_rest), loads_(loads), solver_(solver), progress_(progress),
        size_(size_of(at_rest)), dead_(dead_loads(at_rest, loads)), shape_(at_rest, loads) {}

  BaseState find() {
    double reached = 0, step = 1;
    while (reached < 1) {
      const double aim = std::min(1., reached + step);
      const StateShape before = shape_;
      if (converge(reached, aim)) {
        reached = aim;
        ++state_.load_steps;
        step *= 2;
        continue;
      }
      shape_ = before;
      step = (aim - reached) / 2;
      if (step < smallest_step) throw StateError(stopped_at(reached));
    }
    state_.model = shape_.model(1);
    state_.lacking = state_forces(state_.model) - dead_;
    describe();
    return std::move(state_);
  }

private:
  static constexpr double smallest_step = 1. / 128, tolerance = 1e-9, rounding = 1e-12;
  static constexpr const char* unstable =
      "the structure loses its stability there (it buckles or snaps through)";
  static constexpr double most_turn = 0.8; // of a node in one step, rad
  static constexpr int most_iterations = 25;

  std::string stopped_at(double reached) const {
    std::ostringstream text;
    text.precision(3);
    text << "no state of equilibrium was found beyond " << reached << " of the loads: " << trouble_;
    return text.str();
  }

  // Newton's iteration at a share of the loads, from the state of a smaller one. False: it does not
  // settle.
  bool converge(double from, double share) {
    double scale = 0, first_move = 0, last = 0;
    for (int k = 0; k < most_iterations; ++k) {
      // The first step has the stiffness of the state before, and what hot caps grow by is given.
      std::optional<Model> before;
      if (k == 0) {
        before = shape_.model(from);
        shape_.move_by(VectorXd::Zero(dof_count(rest_)), share);
      }
      const Model now = shape_.model(share);
      VectorXd elastic;
      try {
        elastic = solver_.forces(now);
      } catch (const std::invalid_argument& error) { // an element without shape
        trouble_ = error.what();
        return false;
      }
      const VectorXd unbalanced = share * dead_ - elastic;
      const VectorXd go = shape_.still_to_go(share);
      if (!unbalanced.allFinite()) {
        trouble_ = "the forces are no numbers any more";
        return false;
      }
      const StateIncrement increment =
          solver_.step(with_stiff_drilling(before ? *before : now), unbalanced, go);
      if (!increment.stable) {
        trouble_ = unstable;
        return false;
      }
      scale = std::max({scale, increment.residual, norm_of(elastic, size_)});
      const double residual = scale > 0 ? increment.residual / scale : 0;
      const double move = largest_move(increment.u);
      if (k == 0) first_move = move;
      const bool is_linear = from == 0 && share == 1 && k == 0;
      state_.iterations.push_back({.share = share, .residual = residual, .step = move});
      progress_(state_.iterations.back());
      if (k > 0 && go.norm() <= rounding * size_ &&
          (residual < tolerance || move < rounding * size_)) {
        const bool stable = share < 1 || solver_.step(now, unbalanced, go).stable;
        if (!stable) trouble_ = unstable;
        return stable;
      }
      if (k > 2 && move > 4 * first_move + last) {
        trouble_ = "the iteration grows instead of settling";
        return false;
      }
      last = move;
      if (is_linear && loads_.growth.empty()) {
        linear_ = shape_.nodes();
        for (std::size_t n = 0; n < linear_.size(); ++n)
          linear_[n] += increment.u.segment<3>(6 * Eigen::Index(n));
      }
      const double turn = largest_turn(increment.u);
      shape_.move_by(turn > most_turn ? VectorXd(increment.u * most_turn / turn) : increment.u,
                     share);
    }
    trouble_ = std::to_string(most_iterations) + " iterations were not enough";
    return false;
  }

  void describe() {
    double difference = 0, total = 0;
    const std::vector<Vector3d>& nodes = shape_.nodes();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const Vector3d u = nodes[n] - rest_.mesh.nodes[n];
      state_.largest_displacement = std::max(state_.largest_displacement, u.norm());
      total += u.squaredNorm();
      if (!linear_.empty()) difference += (linear_[n] - nodes[n]).squaredNorm();
    }
    state_.linear_error = linear_.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : total > 0     ? std::sqrt(difference / total)
                                          : 0;
  }

  const Model& rest_;
  const StateLoads& loads_;
  const StateSolver& solver_;
  const std::function<void(const StateIteration&)>& progress_;
  double size_;
  VectorXd dead_;
  StateShape shape_;
  std::vector<Vector3d> linear_; // of the first step from rest
  std::string trouble_;
  BaseState state_;
};

} // namespace

StateIncrement solve_increment(const SparseMatrix& K, const VectorXd& lacking,
                               std::vector<int> held, VectorXd& q) {
  std::sort(held.begin(), held.end());
  const std::vector<int> free = complement(int(q.size()), held);
  const VectorXd forced = lacking - symmetric_product(K, q).col(0);
  const SparseMatrix K_free = restrict_to(K, free);
  SparseFactor factor(K_free);
  StateIncrement increment;
  increment.stable = factor.factorise(K_free).ok;
  if (!increment.stable) return increment;
  q(free) = factor.solve(VectorXd(forced(free))).col(0);
  increment.residual = lacking(free).norm();
  return increment;
}

StateSolver full_state_solver(std::vector<int> holds) {
  const auto step = [holds = std::move(holds)](const Model& now, const VectorXd& unbalanced,
                                               const VectorXd& still_to_go) -> StateIncrement {
    const System system = assemble(now);
    VectorXd q = VectorXd::Zero(system.map.size());
    std::vector<int> held;
    for (std::size_t i = 0; i < holds.size(); ++i)
      for (int d = 0; d < 6; ++d)
        if (const int number = system.map.independent[std::size_t(6 * holds[i] + d)]; number >= 0) {
          q[number] = still_to_go[6 * Eigen::Index(i) + d];
          held.push_back(number);
        }
    StateIncrement increment = solve_increment(system.K, gather(system.map, unbalanced), held, q);
    if (increment.stable) increment.u = expand(system.map, q).col(0);
    return increment;
  };
  return {step, [](const Model& now) { return state_forces(now); }};
}

BaseState find_state(const Model& at_rest, const StateLoads& loads, const StateSolver& solver,
                     const std::function<void(const StateIteration&)>& progress) {
  return NewtonState(at_rest, loads, solver, progress).find();
}

} // namespace plica
