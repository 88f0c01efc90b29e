#include "io/decks/deck_panels.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

Matrix3d plane_of(const Vector3d& along, const Vector3d& other) {
  Matrix3d axes;
  const Vector3d e1 = along.normalized(), e3 = along.cross(other).normalized();
  axes << e1, e3.cross(e1), e3;
  return axes;
}

MatrixElement empty(const std::vector<int>& nodes) {
  const auto size = static_cast<Index>(6 * nodes.size());
  return {.nodes = nodes, .K = MatrixXd::Zero(size, size), .M = MatrixXd::Zero(size, size)};
}

void add_translation_mass(MatrixElement& element, double diagonal, double beside) {
  const auto n = static_cast<Index>(element.nodes.size());
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b < n; ++b)
      element.M.block<3, 3>(6 * a, 6 * b).diagonal().array() += a == b ? diagonal : beside;
}

// Motion of the ends of a beam's axis by that of its nodes: u + theta x arm.
MatrixXd arms_of(const BeamElement& beam) {
  MatrixXd arm = MatrixXd::Identity(12, 12);
  for (Index n = 0; n < 2; ++n) {
    const Vector3d& o = n == 0 ? beam.offset1 : beam.offset2;
    arm.block<3, 3>(6 * n, 6 * n + 3) << 0, o.z(), -o.y(), -o.z(), 0, o.x(), o.y(), -o.x(), 0;
  }
  return arm;
}

BeamStation station_at(const Taper& taper, double x) {
  std::size_t i = 1;
  while (i + 1 < taper.size() && taper[i].x < x) ++i;
  const BeamStation &a = taper[i - 1], &b = taper[i];
  const double t = (x - a.x) / (b.x - a.x);
  BeamStation s = a;
  for (double BeamProperties::*number :
       {&BeamProperties::EA, &BeamProperties::EI_y, &BeamProperties::EI_z, &BeamProperties::GJ,
        &BeamProperties::GA_y, &BeamProperties::GA_z, &BeamProperties::mass,
        &BeamProperties::inertia_x, &BeamProperties::inertia_y, &BeamProperties::inertia_z})
    if (a.section.*number != b.section.*number)
      s.section.*number += t * (b.section.*number - a.section.*number);
  const Eccentricity &from = a.eccentricity, &to = b.eccentricity;
  s.eccentricity = {from.neutral + t * (to.neutral - from.neutral),
                    from.extra + t * (to.extra - from.extra),
                    from.extra_mass + t * (to.extra_mass - from.extra_mass),
                    from.extra_inertia + t * (to.extra_inertia - from.extra_inertia)};
  return s;
}

// Where the line through two points or, in homogeneous coordinates, the point of two lines is.
Vector3d meet(const Vector3d& a, const Vector3d& b) {
  return a.cross(b);
}

// Energy times two of a panel whose edge 1-2 bears a mean flow of one, times G t. `at`: corners in
// their plane, homogeneous.
double panel_compliance(const Eigen::Matrix<double, 3, 4>& at, double nu) {
  const auto edge = [&](Index i, Index j) {
    return meet(Vector3d(at.col(i)), Vector3d(at.col(j)));
  };
  const Vector3d P = meet(edge(0, 1), edge(2, 3)), Q = meet(edge(1, 2), edge(3, 0));
  const Vector3d base = meet(P, Q);
  const double reference = base.dot(at.col(0)) * base.dot(at.col(1));
  const auto towards = [](const Vector3d& point, const Vector3d& x) {
    return Eigen::Vector2d(point.head<2>() - point[2] * x.head<2>()).normalized();
  };
  constexpr std::array<double, 4> place{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                        0.9305681557970263};
  constexpr std::array<double, 4> weight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                         0.1739274225687269};
  constexpr int pieces = 4; // along either side, four points of Gauss each
  double sum = 0;
  for (int a = 0; a < 4 * pieces; ++a)
    for (int b = 0; b < 4 * pieces; ++b) {
      const int along = a / 4, across = b / 4; // of the pieces
      const double s = (along + place[std::size_t(a % 4)]) / pieces;
      const double t = (across + place[std::size_t(b % 4)]) / pieces;
      const Vector3d x = (1 - t) * ((1 - s) * at.col(0) + s * at.col(1)) +
                         t * (s * at.col(2) + (1 - s) * at.col(3));
      const Vector3d by_s = (1 - t) * (at.col(1) - at.col(0)) + t * (at.col(2) - at.col(3));
      const Vector3d by_t = (1 - s) * (at.col(3) - at.col(0)) + s * (at.col(2) - at.col(1));
      const double area = by_s.cross(by_t)[2] * weight[std::size_t(a % 4)] *
                          weight[std::size_t(b % 4)] / (pieces * pieces);
      const Eigen::Vector2d p = towards(P, x), q = towards(Q, x);
      const double cosine = p.dot(q), flow = reference / std::pow(base.dot(x), 2);
      const double cot2 = cosine * cosine / (1 - cosine * cosine);
      sum += area * flow * flow * (1 + 2 * cot2 / (1 + nu));
    }
  return sum;
}

} // namespace

MatrixElement membrane_triangle(const std::vector<int>& nodes, const Matrix3d& x,
                                const ShellSection& section, double thickness) {
  const Vector3d a = x.col(1) - x.col(0), b = x.col(2) - x.col(0);
  const Matrix3d axes = plane_of(a, b);
  const double area = a.cross(b).norm() / 2;
  const Eigen::Matrix<double, 2, 3> at =
      (axes.transpose() * (x.colwise() - Vector3d(x.col(0)))).topRows<2>();
  MatrixXd B = MatrixXd::Zero(3, 18);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double d1 = (at(1, j) - at(1, k)) / (2 * area), d2 = (at(0, k) - at(0, j)) / (2 * area);
    B.block<1, 3>(0, 6 * i) = d1 * axes.col(0).transpose();
    B.block<1, 3>(1, 6 * i) = d2 * axes.col(1).transpose();
    B.block<1, 3>(2, 6 * i) = (d2 * axes.col(0) + d1 * axes.col(1)).transpose();
  }
  MatrixElement element = empty(nodes);
  element.K = thickness * area * B.transpose() * shell_law(section).in_plane * B;
  const double mass = section.rho * thickness * area;
  add_translation_mass(element, mass / 6, mass / 12);
  return element;
}

MatrixElement plate_alone(const std::vector<int>& nodes, const MatrixXd& x,
                          const ShellSection& section, double thickness) {
  ShellSection full = section;
  full.drilling = 0;
  MatrixElement element = empty(nodes);
  const auto turns_alone = [&] { // what a flat wall has left in its plane is rounding
    for (Index i = 0; i < element.K.rows(); ++i)
      if (element.K.row(i).cwiseAbs().maxCoeff() < 1e-9 * element.K(i, i) || element.K(i, i) <= 0) {
        element.K.row(i).setZero();
        element.K.col(i).setZero();
      }
  };
  if (nodes.size() == 3) {
    TriangleGeometry g{.X = x, .directors = {}, .thickness = Vector3d::Constant(thickness)};
    g.directors.colwise() = plane_of(x.col(1) - x.col(0), x.col(2) - x.col(0)).col(2);
    element.K = shell_mitc3_stiffness(g, full) - membrane_triangle(nodes, x, section, thickness).K;
    element.M = shell_mitc3_mass(g, full);
  } else {
    ShellGeometry g{.X = x, .directors = {}, .thickness = Eigen::Vector4d::Constant(thickness)};
    g.directors.colwise() = plane_of(x.col(2) - x.col(0), x.col(3) - x.col(1)).col(2);
    ShellSection flat = full;
    flat.bending_factor = flat.shear_correction = 0;
    element.K = shell_mitc4_stiffness(g, full, MembraneStrain::displacement) -
                shell_mitc4_stiffness(g, flat, MembraneStrain::displacement);
    element.M = shell_mitc4_mass(g, full);
  }
  turns_alone();
  return element;
}

MatrixElement shear_panel(const std::vector<int>& nodes, const Eigen::Matrix<double, 3, 4>& x,
                          double G, double nu, double thickness, double mass_per_area) {
  const Vector3d d13 = x.col(2) - x.col(0), d24 = x.col(3) - x.col(1);
  const Matrix3d axes = plane_of(d13, d24);
  Eigen::Matrix<double, 3, 4> at = axes.transpose() * (x.colwise() - Vector3d(x.col(0)));
  at /= d13.norm();
  at.row(2).setOnes();
  const auto twice = [&](Index i, Index j, Index k) { // area of a triangle
    return at.col(i).dot(at.col(j).cross(at.col(k)));
  };
  const double a124 = twice(0, 1, 3), a134 = twice(0, 2, 3);
  const double a123 = twice(0, 1, 2), a234 = twice(1, 2, 3);
  if (!(std::min({a124, a134, a123, a234}) > 1e-6))
    throw std::invalid_argument("has a corner that points inward");
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(24); // under a mean flow of one along edge 1-2
  forces.segment<3>(0) = -d13 * a124 / (2 * a134);
  forces.segment<3>(12) = -forces.segment<3>(0);
  forces.segment<3>(6) = d24 * a123 / (2 * a234);
  forces.segment<3>(18) = -forces.segment<3>(6);
  const double size = d13.squaredNorm(), area = d13.cross(d24).norm() / 2;
  MatrixElement element = empty(nodes);
  element.K = G * thickness / (size * panel_compliance(at, nu)) * forces * forces.transpose();
  add_translation_mass(element, mass_per_area * area / 4, 0);
  return element;
}

MatrixElement truss(const std::vector<int>& nodes, const Vector3d& x1, const Vector3d& x2,
                    double EA, double GJ, double mass_per_length, TrussMass kind) {
  const double L = (x2 - x1).norm();
  const Vector3d e = (x2 - x1) / L;
  Eigen::VectorXd stretch = Eigen::VectorXd::Zero(12), twist = stretch;
  stretch.segment<3>(0) = twist.segment<3>(3) = -e;
  stretch.segment<3>(6) = twist.segment<3>(9) = e;
  MatrixElement element = empty(nodes);
  element.K = EA / L * stretch * stretch.transpose() + GJ / L * twist * twist.transpose();
  const double mass = mass_per_length * L;
  const bool lumped = kind == TrussMass::lumped;
  add_translation_mass(element, lumped ? mass / 2 : mass / 3, lumped ? 0 : mass / 6);
  return element;
}

MatrixElement beam_beside_its_line(const std::vector<Vector3d>& nodes, const BeamElement& beam,
                                   const Eccentricity& eccentricity) {
  const BeamGeometry ends{
      .node1 = nodes[0] + beam.offset1, .node2 = nodes[1] + beam.offset2, .up = beam.up};
  const BeamMatrices own = eccentric_beam(ends, beam.section, eccentricity);
  const MatrixXd arms = arms_of(beam);
  return {.nodes = {beam.node1, beam.node2},
          .K = arms.transpose() * own.K * arms,
          .M = arms.transpose() * own.M * arms};
}

MatrixElement released_beam(const std::vector<Vector3d>& nodes, const BeamElement& beam,
                            const Vector3d& up, const std::vector<int>& released,
                            const Eccentricity& eccentricity) {
  const BeamGeometry ends{
      .node1 = nodes[0] + beam.offset1, .node2 = nodes[1] + beam.offset2, .up = beam.up};
  Matrix3d axes; // x along the beam, z towards `up`
  axes.col(0) = (ends.node2 - ends.node1).normalized();
  axes.col(1) = up.cross(axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  MatrixXd R = MatrixXd::Zero(12, 12);
  for (Index i = 0; i < 12; i += 3) R.block<3, 3>(i, i) = axes;
  const BeamMatrices own = eccentric_beam(ends, beam.section, eccentricity);
  const MatrixXd K = R.transpose() * own.K * R, M = R.transpose() * own.M * R;
  const auto n = static_cast<Index>(released.size());
  MatrixXd free = MatrixXd::Zero(12, n), follow = MatrixXd::Identity(12, 12);
  for (Index i = 0; i < n; ++i) {
    free(released[std::size_t(i)], i) = 1;
    follow(released[std::size_t(i)], released[std::size_t(i)]) = 0;
  }
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> inner;
  inner.setThreshold(1e-10);
  inner.compute(free.transpose() * K * free);
  const MatrixXd T = follow - free * inner.solve(free.transpose() * K * follow);
  const MatrixXd whole = T * R.transpose() * arms_of(beam);
  return {.nodes = {beam.node1, beam.node2},
          .K = whole.transpose() * K * whole,
          .M = whole.transpose() * M * whole};
}

MatrixElement tapered_beam(const std::vector<Vector3d>& nodes, const BeamElement& beam,
                           const Taper& taper) {
  constexpr Index pieces = 16, size = 6 * (pieces + 1);
  const Vector3d first = nodes[0] + beam.offset1, last = nodes[1] + beam.offset2;
  MatrixXd K = MatrixXd::Zero(size, size), M = K;
  for (Index p = 0; p < pieces; ++p) {
    const auto place = [&](Index i) {
      return Vector3d(first + double(i) / double(pieces) * (last - first));
    };
    const BeamGeometry piece{.node1 = place(p), .node2 = place(p + 1), .up = beam.up};
    const BeamStation here = station_at(taper, (double(p) + 0.5) / double(pieces));
    const BeamMatrices own = eccentric_beam(piece, here.section, here.eccentricity);
    K.block<12, 12>(6 * p, 6 * p) += own.K;
    M.block<12, 12>(6 * p, 6 * p) += own.M;
  }
  MatrixXd shapes = MatrixXd::Zero(size, 12);
  shapes.topLeftCorner<6, 6>().setIdentity();
  shapes.bottomRightCorner<6, 6>().setIdentity();
  const Index inner = size - 12;
  const Eigen::LLT<MatrixXd> inside(MatrixXd(K.block(6, 6, inner, inner)));
  shapes.middleRows(6, inner) = -inside.solve(MatrixXd((K * shapes).middleRows(6, inner)));
  const MatrixXd whole = shapes * arms_of(beam);
  return {.nodes = {beam.node1, beam.node2},
          .K = whole.transpose() * K * whole,
          .M = whole.transpose() * M * whole};
}

void note_laminates(DeckModel& deck) {
  const auto all = std::count_if(deck.shells.begin(), deck.shells.end(),
                                 [](const DeckShell& shell) { return shell.laminate >= 0; });
  if (all > 0)
    deck.notes.push_back("shells with a wall that is not isotropic: " + std::to_string(all) +
                         ", solved by their matrices, and neither drawn nor part of stresses");
}

MatrixXd spring_matrix(const std::vector<SpringEnd>& ends, double k) {
  Eigen::VectorXd b(6 * static_cast<Index>(ends.size()));
  for (std::size_t i = 0; i < ends.size(); ++i)
    b.segment<6>(6 * Index(i)) = (i == 0 ? 1 : -1) * ends[i].direction;
  return k * b * b.transpose();
}

Eigen::Matrix<double, 6, 1> along(const Matrix3d& axes, int dof) {
  Eigen::Matrix<double, 6, 1> direction = Eigen::Matrix<double, 6, 1>::Zero();
  direction.segment<3>(dof / 3 * 3) = axes.col(dof % 3);
  return direction;
}

} // namespace plica
