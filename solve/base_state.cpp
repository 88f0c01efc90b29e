#include "solve/base_state.hpp"

#include "solve/element_view.hpp"
#include "solve/sparse_factor.hpp"
#include "solve/statics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Matrix3d rotation_of(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Vector3d vector_of(const Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

// The node that a row follows like a rigid body: its terms are u_a + (theta x arm)_a, or theta_a.
std::optional<int> leader_of(const Constraint& row, const std::vector<Vector3d>& nodes) {
  if (row.terms.empty()) return std::nullopt;
  const int leader = row.terms.front().node;
  const Vector3d arm = nodes[std::size_t(row.node)] - nodes[std::size_t(leader)];
  Eigen::Matrix<double, 6, 1> expected = Eigen::Matrix<double, 6, 1>::Zero();
  expected[row.dof] = 1;
  if (row.dof < 3)
    for (int b = 0; b < 3; ++b) expected[3 + b] = Vector3d::Unit(b).cross(arm)[row.dof];
  for (const ConstraintTerm& t : row.terms) {
    if (t.node != leader) return std::nullopt;
    expected[t.dof] -= t.factor;
  }
  return expected.norm() <= 1e-9 * (1 + arm.norm()) ? std::optional(leader) : std::nullopt;
}

// Nodes that follow another rigidly in all six DOFs, with that node.
std::vector<std::pair<int, int>> rigid_followers(const Model& at_rest) {
  std::map<std::pair<int, int>, int> rows;
  for (const Constraint& row : at_rest.constraints)
    if (const auto leader = leader_of(row, at_rest.mesh.nodes)) ++rows[{row.node, *leader}];
  std::vector<std::pair<int, int>> pairs;
  std::map<int, int> leader;
  for (const auto& [pair, count] : rows)
    if (count == 6) leader.insert(pair);
  for (auto [follower, first] : leader) { // one that follows itself passes it on
    while (leader.contains(first)) first = leader.at(first);
    pairs.emplace_back(follower, first);
  }
  return pairs;
}

Constraint at_present(const Constraint& row, const std::vector<Vector3d>& rest,
                      const std::vector<Vector3d>& now) {
  const auto leader = row.dof < 3 ? leader_of(row, rest) : std::nullopt;
  if (!leader) return row;
  Constraint moved{
      .node = row.node, .dof = row.dof, .terms = {{*leader, row.dof, 1}}, .origin = row.origin};
  const Vector3d arm = now[std::size_t(row.node)] - now[std::size_t(*leader)];
  for (int b = 0; b < 3; ++b)
    if (const double factor = Vector3d::Unit(b).cross(arm)[row.dof]; factor != 0)
      moved.terms.push_back({*leader, 3 + b, factor});
  return moved;
}

template <class Shell>
void turn_directors(std::vector<Shell>& shells, const std::vector<Matrix3d>& turned) {
  for (Shell& shell : shells)
    for (std::size_t i = 0; i < shell.nodes.size(); ++i)
      shell.directors.col(Eigen::Index(i)) =
          turned[std::size_t(shell.nodes[i])] * shell.directors.col(Eigen::Index(i));
}

// Forces of gravity on the masses, over all DOFs.
VectorXd weight(const Model& model, const Vector3d& gravity) {
  VectorXd f = VectorXd::Zero(dof_count(model));
  if (gravity.isZero()) return f;
  const ElementView elements{model};
  for (int e = 0; e < elements.size(); ++e)
    elements.visit(e, [&](const auto& nodes, const auto&, const auto& M) {
      VectorXd g = VectorXd::Zero(M.cols());
      for (std::size_t a = 0; a < nodes.size(); ++a) g.segment<3>(6 * Eigen::Index(a)) = gravity;
      const VectorXd own = M * g;
      for (std::size_t a = 0; a < nodes.size(); ++a)
        f.segment<6>(6 * Eigen::Index(nodes[a])) += own.segment<6>(6 * Eigen::Index(a));
    });
  return f;
}

// How long the structure is, to weigh moments with forces.
double size_of(const Model& model) {
  Vector3d low = model.mesh.nodes.front(), high = low;
  for (const Vector3d& x : model.mesh.nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return std::max((high - low).norm(), 1e-6);
}

double norm_of(const VectorXd& force, double size) {
  double sum = 0;
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    const double f = i % 6 < 3 ? force[i] : force[i] / size;
    sum += f * f;
  }
  return std::sqrt(sum);
}

// Away from equilibrium the weak tie of the drilling rotation does not hold against moments that
// are not yet balanced. A stiffer one in the matrix of a step leaves the state as it is.
Model with_stiff_drilling(Model model) {
  constexpr double factor = 100;
  for (ShellProperties& p : model.shells) p.section.drilling *= factor;
  return model;
}

class NewtonState {
public:
  NewtonState(const Model& at_rest, const StateLoads& loads, const StateSolver& solver,
              const std::function<void(const StateIteration&)>& progress)
      : rest_(at_rest), loads_(loads), solver_(solver), progress_(progress),
        followers_(rigid_followers(at_rest)), size_(size_of(at_rest)) {
    dead_ = weight(at_rest, loads.gravity);
    if (loads.force.size() > 0) dead_ += loads.force;
    nodes_ = at_rest.mesh.nodes;
    turned_.assign(nodes_.size(), Matrix3d::Identity());
  }

  BaseState find() {
    double reached = 0, step = 1;
    while (reached < 1) {
      const double aim = std::min(1., reached + step);
      const auto nodes = nodes_;
      const auto turned = turned_;
      if (converge(reached, aim)) {
        reached = aim;
        ++state_.load_steps;
        step *= 2;
        continue;
      }
      nodes_ = nodes;
      turned_ = turned;
      step = (aim - reached) / 2;
      if (step < smallest_step) throw StateError(stopped_at(reached));
    }
    state_.model = model_at(rest_, nodes_, turned_, 1);
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

  VectorXd still_to_go(double share) const {
    VectorXd go(6 * Eigen::Index(loads_.holds.size()));
    for (std::size_t i = 0; i < loads_.holds.size(); ++i) {
      const MovedHold& h = loads_.holds[i];
      const auto node = std::size_t(h.node);
      go.segment<3>(6 * Eigen::Index(i)) = rest_.mesh.nodes[node] + share * h.shift - nodes_[node];
      go.segment<3>(6 * Eigen::Index(i) + 3) =
          vector_of(rotation_of(share * h.turn) * turned_[node].transpose());
    }
    return go;
  }

  void move_by(const VectorXd& u, double share) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (rest_.scalar_nodes.contains(int(n))) continue;
      nodes_[n] += u.segment<3>(6 * Eigen::Index(n));
      turned_[n] = rotation_of(u.segment<3>(6 * Eigen::Index(n) + 3)) * turned_[n];
    }
    for (const auto& [follower, leader] : followers_) {
      const auto f = std::size_t(follower), l = std::size_t(leader);
      turned_[f] = turned_[l];
      const auto growth = loads_.growth.find(leader);
      const double grown = growth == loads_.growth.end() ? 1 : 1 + share * growth->second;
      nodes_[f] = nodes_[l] + turned_[l] * (grown * (rest_.mesh.nodes[f] - rest_.mesh.nodes[l]));
    }
  }

  static double largest_move(const VectorXd& u) {
    double largest = 0;
    for (Eigen::Index n = 0; n < u.size(); n += 6)
      largest = std::max(largest, u.segment<3>(n).norm());
    return largest;
  }

  // Newton's iteration at a share of the loads, from the state of a smaller one. False: it does not
  // settle.
  bool converge(double from, double share) {
    double scale = 0, first_move = 0, last = 0;
    for (int k = 0; k < most_iterations; ++k) {
      // The first step has the stiffness of the state before, and what hot caps grow by is given.
      std::optional<Model> before;
      if (k == 0) {
        before = model_at(rest_, nodes_, turned_, from);
        move_by(VectorXd::Zero(dof_count(rest_)), share);
      }
      const Model now = model_at(rest_, nodes_, turned_, share);
      VectorXd elastic;
      try {
        elastic = solver_.forces(now);
      } catch (const std::invalid_argument& error) { // an element without shape
        trouble_ = error.what();
        return false;
      }
      const VectorXd unbalanced = share * dead_ - elastic;
      const VectorXd go = still_to_go(share);
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
        linear_ = nodes_;
        for (std::size_t n = 0; n < linear_.size(); ++n)
          linear_[n] += increment.u.segment<3>(6 * Eigen::Index(n));
      }
      const double turn = largest_turn(increment.u);
      move_by(turn > most_turn ? VectorXd(increment.u * most_turn / turn) : increment.u, share);
    }
    trouble_ = std::to_string(most_iterations) + " iterations were not enough";
    return false;
  }

  static double largest_turn(const VectorXd& u) {
    double largest = 0;
    for (Eigen::Index n = 3; n < u.size(); n += 6)
      largest = std::max(largest, u.segment<3>(n).norm());
    return largest;
  }

  void describe() {
    double difference = 0, total = 0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const Vector3d u = nodes_[n] - rest_.mesh.nodes[n];
      state_.largest_displacement = std::max(state_.largest_displacement, u.norm());
      total += u.squaredNorm();
      if (!linear_.empty()) difference += (linear_[n] - nodes_[n]).squaredNorm();
    }
    state_.linear_error = linear_.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : total > 0     ? std::sqrt(difference / total)
                                          : 0;
  }

  const Model& rest_;
  const StateLoads& loads_;
  const StateSolver& solver_;
  const std::function<void(const StateIteration&)>& progress_;
  std::vector<std::pair<int, int>> followers_;
  double size_;
  VectorXd dead_;
  std::vector<Vector3d> nodes_, linear_; // linear_: of the first step from rest
  std::vector<Matrix3d> turned_;
  std::string trouble_;
  BaseState state_;
};

} // namespace

Model model_at(const Model& at_rest, std::vector<Vector3d> nodes, std::vector<Matrix3d> turned,
               double share) {
  Model now = at_rest;
  turn_directors(now.mesh.quads, turned);
  turn_directors(now.mesh.triangles, turned);
  for (ShellProperties& p : now.shells) {
    p.pressure *= share;
    p.section.thermal_strain *= share;
  }
  for (BeamElement& b : now.beams) {
    const Matrix3d &first = turned[std::size_t(b.node1)], &second = turned[std::size_t(b.node2)];
    b.section.thermal_strain *= share;
    b.up = first * b.up;
    b.offset1 = first * b.offset1;
    b.offset2 = second * b.offset2;
  }
  for (MassElement& m : now.masses) {
    const Matrix3d& R = turned[std::size_t(m.node)];
    m.body.offset = R * m.body.offset;
    m.body.inertia = R * m.body.inertia * R.transpose();
  }
  for (BushingElement& b : now.bushings) {
    if (b.node2 < 0) {
      b.ground_shift *= share;
      b.ground_turn = rotation_of(share * vector_of(b.ground_turn));
    }
    b.bushing.axes = (b.node2 < 0 ? b.ground_turn : turned[std::size_t(b.node1)]) * b.bushing.axes;
  }
  for (PressedEnd& end : now.pressed_ends) {
    end.area = turned[std::size_t(end.node)] * end.area;
    end.pressure *= share;
  }
  for (Constraint& row : now.constraints) row = at_present(row, at_rest.mesh.nodes, nodes);
  for (Ring& ring : now.mesh.rings) {
    const Vector3d& first = nodes[std::size_t(ring.nodes.front())];
    ring.y = first.y();
    ring.radius = std::hypot(first.x(), first.z());
  }
  now.mesh.nodes = nodes;
  now.rest = std::make_shared<Rest>(Rest{at_rest.mesh.nodes, std::move(turned)});
  return now;
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
    std::sort(held.begin(), held.end());
    const std::vector<int> free = complement(system.map.size(), held);
    const VectorXd lacking = gather(system.map, unbalanced);
    const VectorXd forced = lacking - symmetric_product(system.K, q).col(0);
    const SparseMatrix K = restrict_to(system.K, free);
    SparseFactor factor(K);
    StateIncrement increment;
    increment.stable = factor.factorise(K).ok;
    if (!increment.stable) return increment;
    const VectorXd right = forced(free);
    q(free) = factor.solve(right).col(0);
    increment.u = expand(system.map, q).col(0);
    increment.residual = lacking(free).norm();
    return increment;
  };
  return {step, [](const Model& now) { return state_forces(now); }};
}

BaseState find_state(const Model& at_rest, const StateLoads& loads, const StateSolver& solver,
                     const std::function<void(const StateIteration&)>& progress) {
  return NewtonState(at_rest, loads, solver, progress).find();
}

} // namespace plica
