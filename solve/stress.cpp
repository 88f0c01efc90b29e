#include "solve/stress.hpp"

#include "solve/state_elements.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// sigma' A sigma = (von Mises)^2.
Eigen::Matrix<double, 6, 6> von_mises_form() {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  A.topLeftCorner<3, 3>().setConstant(-0.5);
  for (int i = 0; i < 3; ++i) A(i, i) = 1;
  for (int i = 3; i < 6; ++i) A(i, i) = 3;
  return A;
}

// Calls f(element, shell) for every quad, then every triangle.
template <class F> void for_each_shell(const Mesh& mesh, F&& f) {
  std::size_t element = 0;
  for (const ShellQuad& quad : mesh.quads) f(element++, quad);
  for (const ShellTriangle& triangle : mesh.triangles) f(element++, triangle);
}

// Which point each corner of each shell belongs to: corners that meet in a node with one director
// and one thickness share a point.
struct Points {
  std::vector<std::array<int, 4>> of_shell; // quads, then triangles
  std::vector<int> node, section;
  std::vector<Vector3d> director;
  std::vector<double> thickness;
};

Points points_of(const Mesh& mesh) {
  struct Side {
    Vector3d director;
    double thickness = 0;
    int section = 0;
    std::vector<std::pair<std::size_t, int>> corners; // shell, corner
  };
  std::vector<std::vector<Side>> sides(mesh.nodes.size());
  for_each_shell(mesh, [&](std::size_t e, const auto& shell) {
    for (int a = 0; a < static_cast<int>(shell.nodes.size()); ++a) {
      const Eigen::Vector3d V = shell.directors.col(a);
      const double t = shell.thickness[a];
      std::vector<Side>& known = sides[shell.nodes[a]];
      auto side = std::find_if(known.begin(), known.end(), [&](const Side& s) {
        return (s.director - V).norm() < 1e-3 && std::abs(s.thickness - t) < 1e-6 * t;
      });
      if (side == known.end()) side = known.insert(known.end(), {V, t, shell.section, {}});
      side->corners.emplace_back(e, a);
    }
  });
  Points points;
  points.of_shell.resize(mesh.quads.size() + mesh.triangles.size());
  for (std::size_t node = 0; node < sides.size(); ++node)
    for (const Side& side : sides[node]) {
      for (const auto& [e, a] : side.corners)
        points.of_shell[e][a] = static_cast<int>(points.node.size());
      points.node.push_back(static_cast<int>(node));
      points.director.push_back(side.director);
      points.thickness.push_back(side.thickness);
      points.section.push_back(side.section);
    }
  return points;
}

MatrixXd corner_stress(const Model& model, const ShellQuad& quad) {
  const ShellProperties& p = model.shells[quad.section];
  return shell_mitc4_face_stress(shell_geometry(model.mesh, quad), p.section, p.membrane);
}
MatrixXd corner_stress(const Model& model, const ShellTriangle& triangle) {
  return shell_mitc3_face_stress(shell_geometry(model.mesh, triangle),
                                 model.shells[triangle.section].section);
}

// What a turn R does to (xx yy zz xy yz zx).
Eigen::Matrix<double, 6, 6> turned_stress(const Eigen::Matrix3d& R) {
  constexpr std::array<std::array<int, 2>, 6> at{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  Eigen::Matrix<double, 6, 6> T;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) {
      const auto [a, b] = at[std::size_t(i)];
      const auto [c, d] = at[std::size_t(k)];
      T(i, k) = R(a, c) * R(b, d) + (k < 3 ? 0 : R(a, d) * R(b, c));
    }
  return T;
}

// Turns the stress at the corners of a shell from its facet into its surface.
template <class Shell> void turn_into_surface(const Mesh& mesh, const Shell& shell, MatrixXd& s) {
  const auto count = shell.nodes.size();
  const auto at = [&](std::size_t a) { return mesh.nodes[std::size_t(shell.nodes[a % count])]; };
  for (std::size_t a = 0; a < count; ++a) {
    const Vector3d V = shell.directors.col(Eigen::Index(a));
    const Vector3d n = (at(a + 1) - at(a)).cross(at(a + count - 1) - at(a)).normalized();
    if (!(n.dot(V) > 0.5) || (n - V).norm() < 1e-9) continue; // a collapsed corner has no normal
    const Eigen::Matrix<double, 6, 6> T =
        turned_stress(Eigen::Quaterniond::FromTwoVectors(n, V).toRotationMatrix());
    for (int face : {0, 1}) {
      auto rows = s.middleRows<6>(Eigen::Index(12 * a + std::size_t(6 * face)));
      rows = (T * rows).eval();
    }
  }
}

// Stress at the corners of each shell: corners of one, whatever the threads.
template <class Shells, class F>
void add_corner_stresses(const Mesh& mesh, const Shells& shells, const F& stress_of,
                         std::vector<MatrixXd>& corner) {
  const std::size_t first = corner.size();
  corner.resize(first + shells.size());
  const int count = static_cast<int>(shells.size());
#pragma omp parallel for schedule(static) if (count > 64)
  for (int e = 0; e < count; ++e) {
    corner[first + e] = stress_of(shells[e]);
    turn_into_surface(mesh, shells[e], corner[first + e]);
  }
}

// Means of the corners that meet in a point, summed in order.
template <class F>
MatrixXd shell_stress(const Model& model, const Points& points, Eigen::Index columns,
                      const F& stress_of) {
  std::vector<MatrixXd> corner;
  add_corner_stresses(model.mesh, model.mesh.quads, stress_of, corner);
  add_corner_stresses(model.mesh, model.mesh.triangles, stress_of, corner);
  const auto total = static_cast<Eigen::Index>(points.node.size());
  MatrixXd stress = MatrixXd::Zero(12 * total, columns);
  Eigen::VectorXd meeting = Eigen::VectorXd::Zero(total);
  for (std::size_t e = 0; e < corner.size(); ++e)
    for (int a = 0; a < corner[e].rows() / 12; ++a) {
      const int point = points.of_shell[e][a];
      stress.middleRows<12>(12 * point) += corner[e].middleRows<12>(12 * a);
      meeting[point] += 1;
    }
  for (Eigen::Index point = 0; point < total; ++point)
    stress.middleRows<12>(12 * point) /= meeting[point];
  return stress;
}

// Of no beams.
StressField field_of_shells(Points points, MatrixXd shell) {
  return {.shell = std::move(shell),
          .node_of_point = std::move(points.node),
          .director = std::move(points.director),
          .thickness = std::move(points.thickness),
          .section = std::move(points.section),
          .beam = {},
          .node_of_row = {}};
}

// stress_of(shell): rows of its corners; beam_stress(beam): rows of its fibres.
template <class ShellStress, class BeamStress>
StressField recovered(const Model& model, Eigen::Index columns, const ShellStress& stress_of,
                      const BeamStress& beam_stress) {
  Points points = points_of(model.mesh);
  MatrixXd shell = shell_stress(model, points, columns, stress_of);
  StressField field = field_of_shells(std::move(points), std::move(shell));
  const std::size_t fibres =
      std::transform_reduce(model.beams.begin(), model.beams.end(), std::size_t{0}, std::plus<>(),
                            [](const BeamElement& beam) { return 2 * beam.section.fibres.size(); });
  field.beam.resize(Eigen::Index(fibres), columns);
  for (const BeamElement& beam : model.beams) {
    const std::size_t count = beam.section.fibres.size();
    if (count == 0) continue;
    field.beam.middleRows(Eigen::Index(field.node_of_row.size()), Eigen::Index(2 * count)) =
        beam_stress(beam);
    field.node_of_row.insert(field.node_of_row.end(), count, beam.node1);
    field.node_of_row.insert(field.node_of_row.end(), count, beam.node2);
  }
  return field;
}

} // namespace

StressField recover_stress(const Model& model, const MatrixXd& u) {
  return recovered(
      model, u.cols(),
      [&](const auto& shell) {
        MatrixXd own(6 * shell.nodes.size(), u.cols());
        for (std::size_t a = 0; a < shell.nodes.size(); ++a)
          own.middleRows<6>(Eigen::Index(6 * a)) = u.middleRows<6>(6 * shell.nodes[a]);
        return MatrixXd(corner_stress(model, shell) * own);
      },
      [&](const BeamElement& beam) {
        MatrixXd own(12, u.cols());
        own << u.middleRows<6>(6 * beam.node1), u.middleRows<6>(6 * beam.node2);
        return MatrixXd(beam_end_stress(beam_geometry(model.mesh, beam), beam.section) * own);
      });
}

StressField stress_points(const Model& model) {
  Points points = points_of(model.mesh);
  MatrixXd shell(12 * Eigen::Index(points.node.size()), 0);
  return field_of_shells(std::move(points), std::move(shell));
}

StressField combined(const StressField& field, const MatrixXd& Q) {
  StressField other = field;
  other.shell = field.shell * Q;
  other.beam = field.beam * Q;
  return other;
}

StressField stress_of_state(const Model& model) {
  return recovered(
      model, 1, [&](const auto& shell) { return MatrixXd(state_stress(model, shell)); },
      [&](const BeamElement& beam) { return MatrixXd(state_stress(model, beam)); });
}

double von_mises(const Eigen::Ref<const Vector6>& stress) {
  static const Eigen::Matrix<double, 6, 6> A = von_mises_form();
  return std::sqrt(std::max(0., stress.dot(A * stress)));
}

double von_mises_of_cycle(const Eigen::Ref<const Eigen::Matrix<std::complex<double>, 6, 1>>& s) {
  static const Eigen::Matrix<double, 6, 6> A = von_mises_form();
  const Vector6 c = s.real(), d = s.imag();
  const double cc = c.dot(A * c), dd = d.dot(A * d), cd = c.dot(A * d);
  const double largest = (cc + dd) / 2 + std::hypot((cc - dd) / 2, cd);
  return std::sqrt(std::max(0., largest));
}

double von_mises_rms(const Eigen::Ref<const MatrixXd>& stress, const MatrixXd& C) {
  static const Eigen::Matrix<double, 6, 6> A = von_mises_form();
  return std::sqrt(std::max(0., (A * stress * C).cwiseProduct(stress).sum()));
}

} // namespace plica
