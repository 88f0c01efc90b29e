#include "solve/state_shape.hpp"

#include "solve/element_view.hpp"
#include "solve/state_elements.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

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

// What the joints of a spring bear, as its law and preload there.
void bear_joints(const Model& now, BushingElement& b) {
  const Eigen::Matrix<double, 6, 1> motion = state_motion(now, b).value;
  for (const SpringJoint& j : b.joints) {
    const double x = motion[j.dof], slope = first_loading_slope(j.law, x);
    b.bushing.law(j.dof, j.dof) += slope;
    b.bushing.preload[j.dof] += first_loading(j.law, x) - slope * x;
  }
}

} // namespace

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

double largest_move(const VectorXd& u) {
  double largest = 0;
  for (Eigen::Index n = 0; n < u.size(); n += 6)
    largest = std::max(largest, u.segment<3>(n).norm());
  return largest;
}

double largest_turn(const VectorXd& u) {
  double largest = 0;
  for (Eigen::Index n = 3; n < u.size(); n += 6)
    largest = std::max(largest, u.segment<3>(n).norm());
  return largest;
}

Model with_stiff_drilling(Model model) {
  constexpr double factor = 100;
  for (ShellProperties& p : model.shells) p.section.drilling *= factor;
  return model;
}

std::vector<MatrixElement> coupling_stiffness(const Model& now, const Model& at_rest,
                                              const VectorXd& lacking, bool axisymmetric) {
  std::map<int, Matrix3d> turning; // by the node that is followed
  for (const auto& [follower, leader] : rigid_followers(at_rest)) {
    const Vector3d g = lacking.segment<3>(6 * follower);
    const Vector3d a = now.mesh.nodes[std::size_t(follower)] - now.mesh.nodes[std::size_t(leader)];
    turning.try_emplace(leader, Matrix3d::Zero()).first->second +=
        (g * a.transpose() + a * g.transpose()) / 2 - g.dot(a) * Matrix3d::Identity();
  }
  std::vector<MatrixElement> elements;
  for (auto& [leader, H] : turning) {
    if (axisymmetric) {
      const double across = (H(0, 0) + H(2, 2)) / 2;
      H = Vector3d(across, H(1, 1), across).asDiagonal();
    }
    MatrixElement element{.nodes = {leader}, .K = {}, .M = {}};
    element.K = element.M = Eigen::MatrixXd::Zero(6, 6);
    element.K.bottomRightCorner<3, 3>() = H;
    elements.push_back(std::move(element));
  }
  return elements;
}

VectorXd dead_loads(const Model& at_rest, const StateLoads& loads) {
  VectorXd dead = weight(at_rest, loads.gravity);
  if (loads.force.size() > 0) dead += loads.force;
  return dead;
}

StateShape::StateShape(const Model& at_rest, const StateLoads& loads)
    : rest_(&at_rest), loads_(&loads), followers_(rigid_followers(at_rest)),
      nodes_(at_rest.mesh.nodes), turned_(nodes_.size(), Matrix3d::Identity()) {}

Model StateShape::model(double share) const {
  return model_at(*rest_, nodes_, turned_, share);
}

VectorXd StateShape::still_to_go(double share) const {
  VectorXd go(6 * Eigen::Index(loads_->holds.size()));
  for (std::size_t i = 0; i < loads_->holds.size(); ++i) {
    const MovedHold& h = loads_->holds[i];
    const auto node = std::size_t(h.node);
    go.segment<3>(6 * Eigen::Index(i)) = rest_->mesh.nodes[node] + share * h.shift - nodes_[node];
    go.segment<3>(6 * Eigen::Index(i) + 3) =
        vector_of(rotation_of(share * h.turn) * turned_[node].transpose());
  }
  return go;
}

void StateShape::move_by(const VectorXd& u, double share) {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (rest_->scalar_nodes.contains(int(n))) continue;
    nodes_[n] += u.segment<3>(6 * Eigen::Index(n));
    turned_[n] = rotation_of(u.segment<3>(6 * Eigen::Index(n) + 3)) * turned_[n];
  }
  for (const auto& [follower, leader] : followers_) {
    const auto f = std::size_t(follower), l = std::size_t(leader);
    turned_[f] = turned_[l];
    const auto growth = loads_->growth.find(leader);
    const double grown = growth == loads_->growth.end() ? 1 : 1 + share * growth->second;
    nodes_[f] = nodes_[l] + turned_[l] * (grown * (rest_->mesh.nodes[f] - rest_->mesh.nodes[l]));
  }
}

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
    if (b.section.tightened) *b.section.tightened *= share;
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
  for (BushingElement& b : now.bushings)
    if (!b.joints.empty()) bear_joints(now, b);
  return now;
}

} // namespace plica
