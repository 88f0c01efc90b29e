#include "solve/state_elements.hpp"

#include "elements/beam_state.hpp"
#include "elements/shell_mitc3_state.hpp"
#include "elements/shell_mitc4_state.hpp"
#include "elements/strain_forms.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

template <int count> NodeRotations<count> rotations_of(const Model& model, const int* nodes) {
  NodeRotations<count> turned;
  for (std::size_t i = 0; i < turned.size(); ++i)
    turned[i] = model.rest->turned[std::size_t(nodes[i])];
  return turned;
}

template <class Shell> auto geometry_at_rest(const Model& model, const Shell& shell) {
  auto g = shell_geometry(model.mesh, shell);
  for (std::size_t i = 0; i < shell.nodes.size(); ++i) {
    const auto node = std::size_t(shell.nodes[i]);
    g.X.col(Eigen::Index(i)) = model.rest->nodes[node];
    g.directors.col(Eigen::Index(i)) =
        model.rest->turned[node].transpose() * shell.directors.col(Eigen::Index(i));
  }
  return g;
}

struct QuadPoint {
  Vector4d N, dr, ds;
};

std::array<QuadPoint, 4> quad_points() {
  const double g = 1 / std::sqrt(3.);
  const Vector4d r{-1, 1, 1, -1}, s{-1, -1, 1, 1};
  std::array<QuadPoint, 4> points;
  for (Eigen::Index p = 0; p < 4; ++p) {
    const Eigen::Array4d R = 1 + g * r[p] * r.array(), S = 1 + g * s[p] * s.array();
    points[std::size_t(p)] = {R * S / 4, r.array() * S / 4, s.array() * R / 4};
  }
  return points;
}

// -p V of one quad. The two-point rule is exact: V is cubic in each coordinate at most.
void add_pressure(const Eigen::Matrix<double, 3, 4>& X, double p, ElementTangent<24>& tangent) {
  static const std::array<QuadPoint, 4> points = quad_points();
  for (const QuadPoint& n : points) {
    const Vector3d x = X * n.N, x_r = X * n.dr, x_s = X * n.ds;
    const Vector3d across = x_r.cross(x_s), s_x = x_s.cross(x), x_x_r = x.cross(x_r);
    const Matrix3d by_x = cross_product_matrix(x), by_r = cross_product_matrix(x_r),
                   by_s = cross_product_matrix(x_s);
    for (int i = 0; i < 4; ++i) {
      tangent.force.segment<3>(6 * i) -=
          p / 3 * (n.N[i] * across + n.dr[i] * s_x + n.ds[i] * x_x_r);
      for (int j = 0; j < 4; ++j)
        tangent.K.block<3, 3>(6 * i, 6 * j) -= p / 3 *
                                               ((n.N[i] * n.ds[j] - n.ds[i] * n.N[j]) * by_r +
                                                (n.dr[i] * n.N[j] - n.N[i] * n.dr[j]) * by_s +
                                                (n.ds[i] * n.dr[j] - n.dr[i] * n.ds[j]) * by_x);
    }
  }
}

template <class Nodes, class Force>
void add_forces(const Nodes& nodes, const Force& force, VectorXd& f) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    f.segment<6>(6 * Eigen::Index(nodes[i])) += force.template segment<6>(6 * Eigen::Index(i));
}

Vector3d rotation_vector(const Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

VectorXd motion_of(const Model& model, const std::vector<int>& nodes) {
  VectorXd q(6 * Eigen::Index(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto node = std::size_t(nodes[i]);
    q.segment<3>(6 * Eigen::Index(i)) = model.mesh.nodes[node] - model.rest->nodes[node];
    q.segment<3>(6 * Eigen::Index(i) + 3) = rotation_vector(model.rest->turned[node]);
  }
  return q;
}

// A spring with its axes at rest, and where it acts; to the ground, that is its first node.
struct SpringPlace {
  Bushing at_rest;
  MovedNode first, second;
  Vector3d point;
};

SpringPlace place_of(const Model& model, const BushingElement& b) {
  const auto moved = [&](int node) -> MovedNode {
    return {model.rest->nodes[std::size_t(node)], model.mesh.nodes[std::size_t(node)],
            model.rest->turned[std::size_t(node)]};
  };
  SpringPlace p{b.bushing, moved(b.node1), {}, {}};
  if (b.node2 >= 0) {
    p.second = moved(b.node2);
    p.point = (p.first.rest + p.second.rest) / 2;
  } else {
    p.second = p.first;
    p.point = p.second.rest;
    p.first = {p.point, p.point + b.ground_shift, b.ground_turn};
  }
  p.at_rest.axes = p.first.turned.transpose() * b.bushing.axes;
  return p;
}

} // namespace

ElementTangent<24> state_tangent(const Model& model, const ShellQuad& quad) {
  const ShellProperties& p = model.shells[std::size_t(quad.section)];
  ElementTangent<24> tangent = shell_mitc4_tangent(
      geometry_at_rest(model, quad), shell_geometry(model.mesh, quad),
      rotations_of<4>(model, quad.nodes.data()), p.section, p.membrane, model.rest->part);
  if (p.pressure != 0) add_pressure(shell_geometry(model.mesh, quad).X, p.pressure, tangent);
  return tangent;
}

ElementTangent<18> state_tangent(const Model& model, const ShellTriangle& triangle) {
  return shell_mitc3_tangent(geometry_at_rest(model, triangle),
                             shell_geometry(model.mesh, triangle),
                             rotations_of<3>(model, triangle.nodes.data()),
                             model.shells[std::size_t(triangle.section)].section, model.rest->part);
}

ElementTangent<12> state_tangent(const Model& model, const BeamElement& b) {
  const std::array nodes{b.node1, b.node2};
  const NodeRotations<2> turned = rotations_of<2>(model, nodes.data());
  const BeamGeometry rest = beam_at_rest(model, b);
  return beam_tangent(rest, b.section, model.mesh.nodes[std::size_t(b.node1)],
                      model.mesh.nodes[std::size_t(b.node2)], turned, model.rest->part);
}

double axial_strain(const Model& model, const BeamElement& b) {
  const std::array nodes{b.node1, b.node2};
  return beam_axial_strain(
      beam_at_rest(model, b), b.section, model.mesh.nodes[std::size_t(b.node1)],
      model.mesh.nodes[std::size_t(b.node2)], rotations_of<2>(model, nodes.data()));
}

SpringMotion state_motion(const Model& model, const BushingElement& b) {
  const SpringPlace p = place_of(model, b);
  const BushingMotion m = bushing_motion(p.at_rest, p.first, p.second, p.point);
  if (b.node2 < 0) return {m.value, m.by_nodes.rightCols<6>()};
  return {m.value, m.by_nodes};
}

ElementTangent<Eigen::Dynamic> state_tangent(const Model& model, const BushingElement& b) {
  const SpringPlace p = place_of(model, b);
  const auto t = bushing_tangent(p.at_rest, p.first, p.second, p.point, model.rest->part);
  if (b.node2 < 0) return {t.K.bottomRightCorner<6, 6>(), t.force.tail<6>()};
  return {t.K, t.force};
}

ElementTangent<6> state_tangent(const Model& model, const PressedEnd& end) {
  const Vector3d &x = model.mesh.nodes[std::size_t(end.node)], &a = end.area;
  const double p = end.pressure / 3;
  ElementTangent<6> t{Matrix6::Zero(), {}};
  t.force << -p * a, -p * a.cross(x);
  t.K.topRightCorner<3, 3>() = p * cross_product_matrix(a); // -p du . (theta x a)
  t.K.bottomLeftCorner<3, 3>() = t.K.topRightCorner<3, 3>().transpose();
  t.K.bottomRightCorner<3, 3>() = -p * (a * x.transpose() + x * a.transpose()) / 2;
  t.K.bottomRightCorner<3, 3>().diagonal().array() += p * a.dot(x);
  return t;
}

VectorXd state_stress(const Model& model, const ShellQuad& quad) {
  const ShellProperties& p = model.shells[std::size_t(quad.section)];
  return shell_mitc4_state_stress(geometry_at_rest(model, quad), shell_geometry(model.mesh, quad),
                                  p.section, p.membrane);
}

VectorXd state_stress(const Model& model, const ShellTriangle& triangle) {
  return shell_mitc3_state_stress(geometry_at_rest(model, triangle),
                                  shell_geometry(model.mesh, triangle),
                                  model.shells[std::size_t(triangle.section)].section);
}

VectorXd state_stress(const Model& model, const BeamElement& b) {
  const std::array nodes{b.node1, b.node2};
  return beam_state_stress(
      beam_at_rest(model, b), b.section, model.mesh.nodes[std::size_t(b.node1)],
      model.mesh.nodes[std::size_t(b.node2)], rotations_of<2>(model, nodes.data()));
}

VectorXd state_forces(const Model& model) {
  std::vector<int> quads(model.mesh.quads.size());
  std::iota(quads.begin(), quads.end(), 0);
  return state_forces(model, quads, 1);
}

VectorXd state_forces(const Model& model, const std::vector<int>& quads, double times) {
  const auto count = static_cast<int>(quads.size());
  std::vector<Eigen::Matrix<double, 24, 1>> of_quad(quads.size());
#pragma omp parallel for schedule(static) if (count > 64)
  for (int k = 0; k < count; ++k)
    of_quad[std::size_t(k)] =
        state_tangent(model, model.mesh.quads[std::size_t(quads[std::size_t(k)])]).force;
  VectorXd f = VectorXd::Zero(dof_count(model));
  for (std::size_t k = 0; k < quads.size(); ++k)
    add_forces(model.mesh.quads[std::size_t(quads[k])].nodes, VectorXd(times * of_quad[k]), f);
  for (const ShellTriangle& t : model.mesh.triangles)
    add_forces(t.nodes, state_tangent(model, t).force, f);
  for (const BeamElement& b : model.beams)
    add_forces(std::array{b.node1, b.node2}, state_tangent(model, b).force, f);
  for (const BushingElement& b : model.bushings) {
    const VectorXd force = state_tangent(model, b).force;
    f.segment<6>(6 * b.node1) += force.head<6>();
    if (b.node2 >= 0) f.segment<6>(6 * b.node2) += force.tail<6>();
  }
  for (const MatrixElement& m : model.matrices)
    add_forces(m.nodes, VectorXd(m.K * motion_of(model, m.nodes)), f);
  for (const PressedEnd& end : model.pressed_ends)
    f.segment<6>(6 * end.node) += state_tangent(model, end).force;
  return f;
}

} // namespace plica
