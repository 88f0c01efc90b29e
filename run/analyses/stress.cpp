#include "run/analyses/stress.hpp"

#include "solve/stress.hpp"

#include <fmt/printf.h>
namespace plica {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::string text(double value) { // four significant digits
  return fmt::sprintf("%.4g", value);
}

int nodes_of(const Mesh& mesh) {
  return static_cast<int>(mesh.nodes.size());
}

StressResult result(const std::string& kind, const std::string& name, StressPeaks peaks,
                    const Mesh& mesh) {
  StressResult r{.kind = kind,
                 .name = name,
                 .largest = peaks.largest,
                 .at = {},
                 .face = peaks.node < 0              ? ""
                         : peaks.face == Face::above ? "above"
                                                     : "below",
                 .largest_beam = peaks.largest_beam,
                 .beam_at = {},
                 .below = std::move(peaks.below),
                 .above = std::move(peaks.above)};
  if (peaks.node >= 0) Eigen::Vector3d::Map(r.at.data()) = mesh.nodes[peaks.node];
  if (peaks.beam_node >= 0) Eigen::Vector3d::Map(r.beam_at.data()) = mesh.nodes[peaks.beam_node];
  return r;
}

// Of one column, times `scale`.
StressResult column_stress(const std::string& kind, const std::string& name,
                           const StressField& field, Eigen::Index column, double scale,
                           const Mesh& mesh) {
  return result(kind, name,
                stress_peaks(
                    field, nodes_of(mesh),
                    [&](const auto& s) { return scale * von_mises(s.col(column)); },
                    [&](const auto& s) { return scale * std::abs(s[column]); }),
                mesh);
}

// "base y, 10 m/s2" or "force tap, 1 N"
std::string name_of(const Excitation& e) {
  return title_of(e) + (e.unit.empty() ? "" : ", " + text(e.amplitude) + " " + e.unit);
}

double largest_displacement(const MatrixXd& u, Eigen::Index column) {
  double largest = 0;
  for (Eigen::Index node = 0; node < u.rows() / 6; ++node)
    largest = std::max(largest, u.col(column).segment<3>(6 * node).norm());
  return largest;
}

StressResult harmonic(const Excitation& e, double hertz, const Eigen::VectorXcd& q,
                      const StressField& field, const Mesh& mesh) {
  return result("harmonic", name_of(e) + ", " + text(hertz) + " Hz",
                stress_peaks(
                    field, nodes_of(mesh), [&](const auto& s) { return von_mises_of_cycle(s * q); },
                    [&](const auto& s) { return std::abs((s * q).value()); }),
                mesh);
}

// Integral of Re(q_j conj q_k) over the frequencies, q = Q L of what the inputs move and a root of
// their spectrum.
MatrixXd covariance(const Excitation& e, const ModalResponse& response, const VectorXd& hertz) {
  std::vector<MatrixXcd> unit;
  for (const ExcitedColumns& input : e.random_inputs) unit.push_back(response(input, hertz));
  const auto inputs = Eigen::Index(unit.size()), modes = unit[0].cols();
  MatrixXcd q = MatrixXcd::Zero(hertz.size() * inputs, modes), Q(inputs, modes);
  for (Eigen::Index i = 0; i < hertz.size(); ++i) {
    const double before = i > 0 ? hertz[i] - hertz[i - 1] : 0;
    const double after = i + 1 < hertz.size() ? hertz[i + 1] - hertz[i] : 0;
    for (Eigen::Index k = 0; k < inputs; ++k) Q.row(k) = unit[std::size_t(k)].row(i);
    q.middleRows(i * inputs, inputs) =
        std::sqrt((before + after) / 2) *
        (root_of_spectrum(spectrum_at(e.random, hertz[i])).transpose() * Q);
  }
  return q.real().transpose() * q.real() + q.imag().transpose() * q.imag();
}

StressResult random_stress(const Excitation& e, const MatrixXd& C, const StressField& field,
                           const Mesh& mesh) {
  return result("rms", title_of(e) + ", RMS",
                stress_peaks(
                    field, nodes_of(mesh), [&](const auto& s) { return von_mises_rms(s, C); },
                    [&](const auto& s) { return std::sqrt((s * C * s.transpose()).value()); }),
                mesh);
}

} // namespace

std::string mode_stress_name(int mode) {
  return "mode " + std::to_string(mode + 1) + ", 1 mm at most";
}

StressResult state_stress_result(const Model& model) {
  return column_stress("state", "the state", stress_of_state(model), 0, 1, model.mesh);
}

std::vector<StressResult> static_stresses(const StaticShapes& shapes, const Model& model) {
  const StressField field = recover_stress(model, shapes.u);
  std::vector<StressResult> results;
  for (Eigen::Index k = 0; k < shapes.u.cols(); ++k)
    results.push_back(column_stress("static", shapes.names[k], field, k, 1, model.mesh));
  return results;
}

std::vector<StressResult> dynamic_stresses(const Stress& asked, const Response* response,
                                           const Model& model, const DampedModes& modes,
                                           const Excitations* excited) {
  const StressField field = recover_stress(model, modes.solution.u);
  std::vector<StressResult> results;
  for (Eigen::Index j = 0; j < modes.solution.modes; ++j)
    if (const double largest = largest_displacement(modes.solution.u, j); largest > 0)
      results.push_back(
          column_stress("mode", mode_stress_name(int(j)), field, j, 1e-3 / largest, model.mesh));
  if (!excited || !response) return results;
  const VectorXd at =
      VectorXd::Map(asked.frequencies.data(), Eigen::Index(asked.frequencies.size()));
  const VectorXd grid = response_grid(*response, modes);
  const auto columns = modes.solution.u.cols();
  const ModalResponse response_of(modes, MatrixXd::Identity(columns, columns));
  for (const Excitation& e : excited->list) {
    const MatrixXcd q = e.amplitude * response_of(e.parts, at);
    for (Eigen::Index i = 0; i < at.size(); ++i)
      results.push_back(harmonic(e, at[i], q.row(i).transpose(), field, model.mesh));
    if (!e.random_inputs.empty())
      results.push_back(random_stress(e, covariance(e, response_of, grid), field, model.mesh));
  }
  return results;
}

} // namespace plica
