#include "solve/stress.hpp"

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

MatrixXd shell_stress(const Model& model, const MatrixXd& u) {
  const std::vector<ShellQuad>& quads = model.mesh.quads;
  const auto nodes = static_cast<Eigen::Index>(model.mesh.nodes.size());
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
  MatrixXd stress = MatrixXd::Zero(12 * nodes, u.cols());
  Eigen::VectorXd meeting = Eigen::VectorXd::Zero(nodes);
  for (int e = 0; e < count; ++e)
    for (int a = 0; a < 4; ++a) {
      stress.middleRows<12>(12 * quads[e].nodes[a]) += corner[e].middleRows<12>(12 * a);
      meeting[quads[e].nodes[a]] += 1;
    }
  for (Eigen::Index node = 0; node < nodes; ++node)
    if (meeting[node] > 1) stress.middleRows<12>(12 * node) /= meeting[node];
  return stress;
}

} // namespace

StressField recover_stress(const Model& model, const MatrixXd& u) {
  StressField field{.shell = shell_stress(model, u), .beam = {}, .node_of_row = {}};
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
