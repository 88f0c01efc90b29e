#include "run/analyses/stress.hpp"

#include "run/analyses/place_stress.hpp"
#include "run/analyses/stress_coordinates.hpp"
#include "solve/stress.hpp"
#include "words/short_text.hpp"

namespace plica {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

int nodes_of(const Mesh& mesh) {
  return static_cast<int>(mesh.nodes.size());
}

StressResult result(StressKind kind, const std::string& name, StressPeaks peaks, const Mesh& mesh) {
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

// "base y, 10 m/s2" or "force tap, 1 N"
std::string name_of(const Excitation& e) {
  return title_of(e) + (e.unit.empty() ? "" : ", " + short_text(e.amplitude, 4) + " " + e.unit);
}

double largest_displacement(const MatrixXd& u, Eigen::Index column) {
  double largest = 0;
  for (Eigen::Index node = 0; node < u.rows() / 6; ++node)
    largest = std::max(largest, u.col(column).segment<3>(6 * node).norm());
  return largest;
}

// Adds what follows from one field to the results.
class StressLists {
public:
  StressLists(const Case& data, const BuiltCase& built, StressField field, Results& results)
      : mesh_(built.model.mesh), field_(std::move(field)),
        points_(shell_points(data, built, field_)), plane_(plane_stress(points_, field_.shell)),
        results_(results) {
    results_.places = points_.places;
  }

  // Of one column, times `scale`.
  void add_column(StressKind kind, const std::string& name, Eigen::Index column, double scale) {
    add(result(kind, name,
               stress_peaks(
                   field_, nodes_of(mesh_),
                   [&](const auto& s) { return scale * von_mises(s.col(column)); },
                   [&](const auto& s) { return scale * std::abs(s[column]); }),
               mesh_),
        stress_table(points_, mesh_, kind, name, VectorXd(scale * plane_.col(column))));
  }

  void add_harmonic(const Excitation& e, double hertz, const VectorXcd& q) {
    const std::string name = name_of(e) + ", " + short_text(hertz, 4) + " Hz";
    add(result(StressKind::harmonic, name,
               stress_peaks(
                   field_, nodes_of(mesh_),
                   [&](const auto& s) { return von_mises_of_cycle(s * q); },
                   [&](const auto& s) { return std::abs((s * q).value()); }),
               mesh_),
        harmonic_table(points_, mesh_, name, plane_ * q));
  }

  void add_random(const Excitation& e, const MatrixXd& C) {
    const std::string name = title_of(e) + ", RMS";
    add(result(StressKind::rms, name,
               stress_peaks(
                   field_, nodes_of(mesh_), [&](const auto& s) { return von_mises_rms(s, C); },
                   [&](const auto& s) { return std::sqrt((s * C * s.transpose()).value()); }),
               mesh_),
        rms_table(points_, mesh_, name, plane_, C));
  }

private:
  void add(StressResult result, StressTable table) {
    results_.stresses.push_back(std::move(result));
    results_.stress_tables.push_back(std::move(table));
  }

  const Mesh& mesh_;
  StressField field_;
  ShellPoints points_;
  MatrixXd plane_;
  Results& results_;
};

} // namespace

std::string mode_stress_name(int mode) {
  return "mode " + std::to_string(mode + 1) + ", 1 mm at most";
}

void add_state_stress(const Case& data, const BuiltCase& built, Results& results) {
  StressLists(data, built, stress_of_state(built.model), results)
      .add_column(StressKind::state, "the state", 0, 1);
}

void add_static_stresses(StaticStress stress, const Case& data, const BuiltCase& built,
                         Results& results) {
  StressLists lists(data, built, std::move(stress.field), results);
  for (std::size_t k = 0; k < stress.names.size(); ++k)
    lists.add_column(stress.kind, stress.names[k], Eigen::Index(k), 1);
}

void add_dynamic_stresses(const Case& data, const BuiltCase& built, const DampedModes& modes,
                          const Excitations* excited, Results& results) {
  const Stress& asked = *data.analyses.stress;
  const std::optional<Response>& response = data.analyses.response;
  const StressCoordinates coordinates(modes, excited);
  StressLists lists(data, built, recover_stress(built.model, coordinates.fields()), results);
  for (Eigen::Index j = 0; j < modes.solution.modes; ++j)
    if (const double largest = largest_displacement(modes.solution.u, j); largest > 0)
      lists.add_column(StressKind::mode, mode_stress_name(int(j)), j, 1e-3 / largest);
  if (!excited || !response) return;
  const VectorXd at =
      VectorXd::Map(asked.frequencies.data(), Eigen::Index(asked.frequencies.size()));
  const VectorXd grid = response_grid(*response, modes);
  for (const Excitation& e : excited->list) {
    const MatrixXcd q = e.amplitude * coordinates(e.parts, at);
    for (Eigen::Index i = 0; i < at.size(); ++i) lists.add_harmonic(e, at[i], q.row(i).transpose());
    if (!e.random_inputs.empty())
      lists.add_random(e, covariance(spectral_rows(e, coordinates, grid), grid, 0));
  }
}

} // namespace plica
