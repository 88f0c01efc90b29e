#include "solve/stress.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// sigma' A sigma = (von Mises)^2.
Eigen::Matrix<double, 6, 6> von_mises_form() {
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  A.topLeftCorner<3, 3>().setConstant(-0.5);
  for (int i = 0; i < 3; ++i) A(i, i) = 1;
  for (int i = 3; i < 6; ++i) A(i, i) = 3;
  return A;
}

// Which point each corner of each quad belongs to: corners that meet in a node with one director
// and one thickness share a point.
struct Points {
  std::vector<std::array<int, 4>> of_quad;
  std::vector<int> node;
};

Points stress_points(const Mesh& mesh) {
  struct Side {
    Eigen::Vector3d director;
    double thickness = 0;
    std::vector<std::pair<int, int>> corners; // quad, corner
  };
  std::vector<std::vector<Side>> sides(mesh.nodes.size());
  for (int e = 0; e < static_cast<int>(mesh.quads.size()); ++e)
    for (int a = 0; a < 4; ++a) {
      const ShellQuad& quad = mesh.quads[e];
      const Eigen::Vector3d V = quad.directors.col(a);
      const double t = quad.thickness[a];
      std::vector<Side>& known = sides[quad.nodes[a]];
      auto side = std::find_if(known.begin(), known.end(), [&](const Side& s) {
        return (s.director - V).norm() < 1e-3 && std::abs(s.thickness - t) < 1e-6 * t;
      });
      if (side == known.end()) side = known.insert(known.end(), {V, t, {}});
      side->corners.emplace_back(e, a);
    }
  Points points;
  points.of_quad.resize(mesh.quads.size());
  for (std::size_t node = 0; node < sides.size(); ++node)
    for (const Side& side : sides[node]) {
      for (const auto& [e, a] : side.corners)
        points.of_quad[e][a] = static_cast<int>(points.node.size());
      points.node.push_back(static_cast<int>(node));
    }
  return points;
}

MatrixXd shell_stress(const Model& model, const Points& points, const MatrixXd& u) {
  const std::vector<ShellQuad>& quads = model.mesh.quads;
  const int count = static_cast<int>(quads.size());
  std::vector<MatrixXd> corner(quads.size()); // summed in order afterwards, whatever the threads
#pragma omp parallel for schedule(static) if (count > 64)
  for (int e = 0; e < count; ++e) {
    MatrixXd own(24, u.cols());
    for (int a = 0; a < 4; ++a) own.middleRows<6>(6 * a) = u.middleRows<6>(6 * quads[e].nodes[a]);
    const ShellProperties& p = model.shells[quads[e].section];
    corner[e] =
        shell_mitc4_face_stress(shell_geometry(model.mesh, quads[e]), p.section, p.membrane) * own;
  }
  const auto total = static_cast<Eigen::Index>(points.node.size());
  MatrixXd stress = MatrixXd::Zero(12 * total, u.cols());
  Eigen::VectorXd meeting = Eigen::VectorXd::Zero(total);
  for (int e = 0; e < count; ++e)
    for (int a = 0; a < 4; ++a) {
      const int point = points.of_quad[e][a];
      stress.middleRows<12>(12 * point) += corner[e].middleRows<12>(12 * a);
      meeting[point] += 1;
    }
  for (Eigen::Index point = 0; point < total; ++point)
    stress.middleRows<12>(12 * point) /= meeting[point];
  return stress;
}

} // namespace

StressField recover_stress(const Model& model, const MatrixXd& u) {
  Points points = stress_points(model.mesh);
  StressField field{.shell = shell_stress(model, points, u),
                    .node_of_point = std::move(points.node),
                    .beam = {},
                    .node_of_row = {}};
  const std::size_t fibres =
      std::transform_reduce(model.beams.begin(), model.beams.end(), std::size_t{0}, std::plus<>(),
                            [](const BeamElement& beam) { return 2 * beam.section.fibres.size(); });
  field.beam.resize(Eigen::Index(fibres), u.cols());
  for (const BeamElement& beam : model.beams) {
    const std::size_t count = beam.section.fibres.size();
    if (count == 0) continue;
    MatrixXd own(12, u.cols());
    own << u.middleRows<6>(6 * beam.node1), u.middleRows<6>(6 * beam.node2);
    field.beam.middleRows(Eigen::Index(field.node_of_row.size()), Eigen::Index(2 * count)) =
        beam_end_stress(beam_geometry(model.mesh, beam), beam.section) * own;
    field.node_of_row.insert(field.node_of_row.end(), count, beam.node1);
    field.node_of_row.insert(field.node_of_row.end(), count, beam.node2);
  }
  return field;
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
