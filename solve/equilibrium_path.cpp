#include "solve/equilibrium_path.hpp"

#include "solve/sparse_factor.hpp"
#include "solve/state_elements.hpp"
#include "solve/state_shape.hpp"
#include "solve/statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Increments for two right sides at once.
struct Increments {
  MatrixXd u;
  double residual = 0; // of the first
  int negative = 0;
};

// Columns: unbalanced forces over all DOFs, and how far each hold has to go.
Increments solve_step(const Model& now, const std::vector<MovedHold>& holds,
                      const MatrixXd& unbalanced, const MatrixXd& go) {
  const System system = assemble(now);
  MatrixXd q = MatrixXd::Zero(system.map.size(), unbalanced.cols());
  std::vector<int> held;
  for (std::size_t i = 0; i < holds.size(); ++i)
    for (int d = 0; d < 6; ++d) {
      const int number = system.map.independent[std::size_t(6 * holds[i].node + d)];
      if (number < 0) continue;
      q.row(number) = go.row(6 * Index(i) + d);
      held.push_back(number);
    }
  std::sort(held.begin(), held.end());
  const std::vector<int> free = complement(system.map.size(), held);
  MatrixXd lacking(system.map.size(), unbalanced.cols());
  for (Index c = 0; c < unbalanced.cols(); ++c)
    lacking.col(c) = gather(system.map, unbalanced.col(c));
  const MatrixXd right = (lacking - symmetric_product(system.K, q))(free, Eigen::all);
  const SparseMatrix K = restrict_to(system.K, free);
  Increments increments;
  SparseFactor factor(K);
  if (factor.factorise(K).ok) {
    q(free, Eigen::all) = factor.solve(right);
  } else {
    SparseFactor indefinite(K, Factorisation::ldlt);
    if (!indefinite.factorise(K).ok) throw StateError("the stiffness cannot be factored");
    increments.negative = indefinite.negative_pivots();
    q(free, Eigen::all) = indefinite.solve(right);
  }
  increments.u = expand(system.map, q);
  increments.residual = lacking.col(0)(free).norm();
  return increments;
}

class Path {
public:
  Path(const Model& at_rest, const StateLoads& loads,
       const std::function<void(const PathPoint&)>& at_point, const PathSettings& settings)
      : rest_(at_rest), loads_(loads), at_point_(at_point), settings_(settings),
        size_(size_of(at_rest)), dead_(dead_loads(at_rest, loads)), shape_(at_rest, loads) {
    translations_ = VectorXd::Zero(dof_count(at_rest));
    for (Index n = 0; n < translations_.size(); n += 6)
      if (!at_rest.scalar_nodes.contains(int(n / 6))) translations_.segment<3>(n).setOnes();
    only_dead_ = loads.growth.empty() && at_rest.pressed_ends.empty() && at_rest.bushings.empty();
    for (const ShellProperties& p : at_rest.shells)
      only_dead_ = only_dead_ && p.pressure == 0 && p.section.thermal_strain == 0;
    for (const BeamElement& b : at_rest.beams)
      only_dead_ = only_dead_ && b.section.thermal_strain == 0 && !b.section.tightened;
  }

  PathResult follow() {
    int refused = 0;
    while (result_.points < settings_.most_points) {
      const StateShape before = shape_;
      const double share = share_;
      const VectorXd direction = direction_;
      if (!arc_step()) {
        shape_ = before;
        share_ = share;
        direction_ = direction;
        length_ /= 4;
        if (++refused > 12) throw StateError(stopped("its iteration does not settle"));
        continue;
      }
      refused = 0;
      ++result_.points;
      at_point_({share_, negative_, &shape_.nodes()});
      if (share_ < share && result_.turned_at == 0) result_.turned_at = share;
      if (share < 1 && share_ >= 1 && arrive()) return finish();
    }
    throw StateError(stopped(std::to_string(settings_.most_points) + " points were not enough"));
  }

private:
  static constexpr double tolerance = 1e-8, rounding = 1e-12, most_turn = 0.3;
  static constexpr int most_iterations = 15, aimed_iterations = 5;

  std::string stopped(const std::string& why) const {
    std::ostringstream text;
    text.precision(3);
    text << "the path of equilibrium was followed over " << result_.points << " points to "
         << share_ << " of the loads";
    if (result_.turned_at > 0) text << ", which turn back at " << result_.turned_at;
    text << ": " << why;
    return text.str();
  }

  // What a change of the share does: forces, and how far the holds go.
  void by_share(VectorXd& force, VectorXd& go) const {
    constexpr double step = 1e-4;
    force = dead_;
    go = (shape_.still_to_go(share_ + step) - shape_.still_to_go(share_)) / step;
    if (only_dead_) return;
    StateShape later = shape_, now = shape_;
    const VectorXd nothing = VectorXd::Zero(dead_.size());
    later.move_by(nothing, share_ + step);
    now.move_by(nothing, share_);
    force =
        dead_ - (state_forces(later.model(share_ + step)) - state_forces(now.model(share_))) / step;
  }

  // One point further; false: not settled.
  bool arc_step() {
    VectorXd advance = VectorXd::Zero(dead_.size()); // since the point before
    double settled_at = 0;
    for (int k = 0; k < most_iterations; ++k) {
      const Model now = shape_.model(share_);
      const VectorXd elastic = state_forces(now);
      if (!elastic.allFinite()) return false;
      MatrixXd unbalanced(dead_.size(), 2), go(6 * Index(loads_.holds.size()), 2);
      unbalanced.col(0) = share_ * dead_ - elastic;
      go.col(0) = shape_.still_to_go(share_);
      VectorXd force, way;
      by_share(force, way);
      unbalanced.col(1) = force;
      go.col(1) = way;
      const Increments step =
          solve_step(k == 0 ? with_stiff_drilling(now) : now, loads_.holds, unbalanced, go);
      negative_ = step.negative;
      const VectorXd by_load = step.u.col(1);
      const double scale =
          std::max(norm_of(elastic, size_), std::abs(share_) * norm_of(force, size_));
      settled_at = scale > 0 ? step.residual / scale : 0;
      if (k > 0 && (settled_at < tolerance || largest_move(step.u.col(0)) < rounding * size_)) {
        direction_ = advance;
        length_ *= std::clamp(std::sqrt(double(aimed_iterations) / k), 0.5, 1.5);
        return true;
      }
      const double along = translations_.cwiseProduct(by_load).norm();
      if (!(along > 0)) throw StateError(stopped("the loads move nothing"));
      double change = 0;
      if (k == 0) {
        if (length_ == 0) first_length_ = length_ = settings_.first_share * along;
        length_ = std::min(length_, settings_.longest * first_length_);
        double towards =
            direction_.size() > 0 ? direction_.cwiseProduct(translations_).dot(by_load) : 1;
        change = std::copysign(length_ / along, towards);
        const double turn = largest_turn(change * by_load);
        if (turn > most_turn) {
          change *= most_turn / turn;
          length_ *= most_turn / turn;
        }
      } else {
        const VectorXd weight = translations_.cwiseProduct(advance);
        const double with = weight.dot(by_load);
        if (with == 0) return false;
        change = -weight.dot(step.u.col(0)) / with;
      }
      const VectorXd u = step.u.col(0) + change * by_load;
      if (largest_turn(u) > 2 * most_turn || largest_move(u) > 2 * size_) return false;
      share_ += change;
      shape_.move_by(u, share_);
      advance += u;
    }
    return false;
  }

  // To all of the loads exactly, near there; false: no stable state.
  bool arrive() {
    const StateShape beyond = shape_;
    for (int k = 0; k < most_iterations; ++k) {
      const Model now = shape_.model(1);
      const VectorXd elastic = state_forces(now);
      const Increments step = solve_step(now, loads_.holds, dead_ - elastic, shape_.still_to_go(1));
      const double residual = step.residual / std::max(norm_of(elastic, size_), 1e-300);
      const double move = largest_move(step.u);
      if (k > 0 && (residual < tolerance || move < rounding * size_)) {
        if (step.negative == 0) {
          result_.state.iterations.push_back({.share = 1, .residual = residual, .step = move});
          return true;
        }
        break;
      }
      if (largest_turn(step.u) > 2 * most_turn) break;
      shape_.move_by(step.u, 1);
    }
    shape_ = beyond;
    return false;
  }

  PathResult finish() {
    BaseState& state = result_.state;
    state.model = shape_.model(1);
    state.lacking = state_forces(state.model) - dead_;
    state.load_steps = result_.points;
    for (std::size_t n = 0; n < rest_.mesh.nodes.size(); ++n)
      state.largest_displacement =
          std::max(state.largest_displacement, (shape_.nodes()[n] - rest_.mesh.nodes[n]).norm());
    state.linear_error = std::numeric_limits<double>::quiet_NaN();
    return std::move(result_);
  }

  const Model& rest_;
  const StateLoads& loads_;
  const std::function<void(const PathPoint&)>& at_point_;
  const PathSettings& settings_;
  double size_;
  VectorXd dead_;
  StateShape shape_;
  VectorXd translations_;  // 1 where a DOF moves a node, else 0
  VectorXd direction_;     // of the step before
  bool only_dead_ = false; // nothing but forces of constant direction and holds
  double share_ = 0, length_ = 0, first_length_ = 0;
  int negative_ = 0;
  PathResult result_;
};

} // namespace

PathResult follow_state(const Model& at_rest, const StateLoads& loads,
                        const std::function<void(const PathPoint&)>& at_point,
                        const PathSettings& settings) {
  return Path(at_rest, loads, at_point, settings).follow();
}

} // namespace plica
