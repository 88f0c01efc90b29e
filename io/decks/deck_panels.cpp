#include "io/decks/deck_panels.hpp"

#include <Eigen/Dense>

#include <algorithm>
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

BeamProperties section_at(const Taper& taper, double x) {
  std::size_t i = 1;
  while (i + 1 < taper.size() && taper[i].first < x) ++i;
  const auto& [x1, a] = taper[i - 1];
  const auto& [x2, b] = taper[i];
  const double t = (x - x1) / (x2 - x1);
  BeamProperties s = a;
  for (double BeamProperties::*number :
       {&BeamProperties::EA, &BeamProperties::EI_y, &BeamProperties::EI_z, &BeamProperties::GJ,
        &BeamProperties::GA_y, &BeamProperties::GA_z, &BeamProperties::mass,
        &BeamProperties::inertia_x, &BeamProperties::inertia_y, &BeamProperties::inertia_z})
    if (a.*number != b.*number) s.*number += t * (b.*number - a.*number);
  return s;
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
                          double G, double thickness, double mass_per_area) {
  const Vector3d along = x.col(1) - x.col(0), up = x.col(3) - x.col(0);
  const double a = along.norm(), b = up.norm();
  constexpr double square = 1e-3;
  if ((x.col(2) - x.col(1) - up).norm() > square * b || std::abs(along.dot(up)) > square * a * b)
    throw std::invalid_argument("is no rectangle");
  const Vector3d e1 = along / a, e2 = up / b;
  Eigen::VectorXd gamma = Eigen::VectorXd::Zero(24);
  for (int i = 0; i < 4; ++i)
    gamma.segment<3>(6 * i) =
        (i < 2 ? -1 : 1) * e1 / (2 * b) + (i == 1 || i == 2 ? 1 : -1) * e2 / (2 * a);
  MatrixElement element = empty(nodes);
  element.K = G * thickness * a * b * gamma * gamma.transpose();
  add_translation_mass(element, mass_per_area * a * b / 4, 0);
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

MatrixElement released_beam(const std::vector<Vector3d>& nodes, const BeamElement& beam,
                            const Vector3d& up, const std::vector<int>& released) {
  const BeamGeometry ends{
      .node1 = nodes[0] + beam.offset1, .node2 = nodes[1] + beam.offset2, .up = beam.up};
  Matrix3d axes; // x along the beam, z towards `up`
  axes.col(0) = (ends.node2 - ends.node1).normalized();
  axes.col(1) = up.cross(axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  MatrixXd R = MatrixXd::Zero(12, 12);
  for (Index i = 0; i < 12; i += 3) R.block<3, 3>(i, i) = axes;
  const MatrixXd K = R.transpose() * beam_stiffness(ends, beam.section) * R;
  const MatrixXd M = R.transpose() * beam_mass(ends, beam.section) * R;
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
    const BeamProperties section = section_at(taper, (double(p) + 0.5) / double(pieces));
    K.block<12, 12>(6 * p, 6 * p) += beam_stiffness(piece, section);
    M.block<12, 12>(6 * p, 6 * p) += beam_mass(piece, section);
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
