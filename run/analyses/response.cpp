#include "run/analyses/response.hpp"

#include "lab/signals/peaks.hpp"
#include "solve/frequency_grid.hpp"
#include "words/input_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace plica {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr std::array axis_names{"x", "y", "z", "rx", "ry", "rz"};

SpectralDensity spectral_density(const Noise& noise, const std::array<double, 2>& band) {
  if (noise.table.empty()) return {{{band[0], noise.level}, {band[1], noise.level}}};
  return {noise.table};
}

// Over all DOFs, spread evenly over the nodes of the set.
VectorXd nodal_force(const Force& force, const std::string& key, const Model& model) {
  const auto set = model.mesh.sets.find(force.at);
  if (set == model.mesh.sets.end())
    input_error(key, "there is no set \"" + force.at + "\" on the mesh", "the sets of the parts");
  VectorXd F = VectorXd::Zero(dof_count(model));
  for (int node : set->second) F[6 * node + force.direction] += 1. / double(set->second.size());
  return F;
}

void require_damping(const Response& asked, const DampedModes& modes) {
  for (int j = 0; j < modes.solution.modes; ++j) {
    const double f = frequency(modes.solution.lambda[j]);
    if (f < asked.band[0] || f > asked.band[1] || modes.zeta[j] + modes.eta[j] / 2 > 0) continue;
    input_error("analyses.response",
                "mode " + std::to_string(j + 1) + " at " + std::to_string(f) +
                    " Hz has no damping, so its peak is infinite",
                "give analyses.damping.modal, a range, a mode or a loss factor that reaches it");
  }
}

// Channels below a thousandth of the largest are rounding, or have no path.
std::vector<int> channels_with_path(const MatrixXcd& acceleration) {
  const Eigen::RowVectorXd highest = acceleration.cwiseAbs().colwise().maxCoeff();
  std::vector<int> channels;
  for (Eigen::Index c = 0; c < highest.size(); ++c)
    if (highest[c] > 1e-3 * highest.maxCoeff()) channels.push_back(static_cast<int>(c));
  return channels;
}

// Above the last mode the response is that of static terms, whose own maxima are no resonances.
void add_peaks(ResponseResult& response, double last_mode) {
  for (int c : response.shown)
    for (const Peak& p : find_peaks(response.hertz, response.acceleration.col(c).cwiseAbs()))
      if (p.frequency < (1 + p.damping) * last_mode)
        response.peaks.push_back(
            {.channel = c, .frequency = p.frequency, .amplitude = p.height, .damping = p.damping});
}

int channel_of(const ResponseResult& response, const std::string& name, const std::string& key) {
  for (std::size_t c = 0; c < response.channels.size(); ++c)
    if (name == response.channels[c].first + "." + response.channels[c].second)
      return static_cast<int>(c);
  input_error(key, "there is no channel \"" + name + "\"", "a sensor and its axis, e.g. mid.y");
}

RandomResult random_result(const Response& asked, const SpectralDensity& input,
                           const ResponseResult& response) {
  RandomResult random;
  const VectorXd& f = response.hertz;
  random.input = f.unaryExpr([&](double hertz) { return density_at(input, hertz); });
  random.density = response_density(input, f, response.acceleration);
  std::vector<std::array<double, 2>> bands{asked.band};
  bands.insert(bands.end(), asked.rms_bands.begin(), asked.rms_bands.end());
  for (const auto& band : bands) {
    BandRms rms_of{.band = band, .input = rms(f, random.input, band[0], band[1]), .rms = {}};
    rms_of.rms.resize(random.density.cols());
    for (Eigen::Index c = 0; c < random.density.cols(); ++c)
      rms_of.rms[c] = rms(f, random.density.col(c), band[0], band[1]);
    random.bands.push_back(std::move(rms_of));
  }
  for (std::size_t i = 0; i < asked.cross.size(); ++i) {
    const std::string key = "analyses.response.cross[" + std::to_string(i) + "].";
    const int a = channel_of(response, asked.cross[i].a, key + "a");
    const int b = channel_of(response, asked.cross[i].b, key + "b");
    random.cross.push_back(
        {.a = a, .b = b, .density = cross_density(input, f, response.acceleration, a, b)});
  }
  return random;
}

} // namespace

MatrixXd at_sensors(const BuiltCase& built, const MatrixXd& u) {
  MatrixXd rows(3 * built.sensors.size(), u.cols());
  for (std::size_t s = 0; s < built.sensors.size(); ++s)
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = built.sensors[s].axes[k];
      rows.row(Eigen::Index(3 * s + k)) =
          (axis < 0 ? -1. : 1.) * u.row(6 * built.sensors[s].node + std::abs(axis) - 1);
    }
  return rows;
}

Excitations excitations(const Response& asked, const Model& model) {
  const auto count = static_cast<Eigen::Index>(asked.bases.size() + asked.forces.size());
  const MatrixXd none = MatrixXd::Zero(dof_count(model), count);
  Excitations all{.list = {}, .loads = {.base = {}, .force = none, .rigid = none}};
  for (int direction : asked.bases) {
    const auto column = static_cast<Eigen::Index>(all.list.size());
    for (std::size_t node = 0; node < model.mesh.nodes.size(); ++node) {
      auto u = all.loads.rigid.col(column).segment<6>(6 * Eigen::Index(node));
      u[direction] = 1;
      if (direction >= 3)
        u.head<3>() = Vector3d(Vector3d::Unit(direction - 3)).cross(model.mesh.nodes[node]);
    }
    all.loads.base.push_back(direction);
    all.list.push_back({.name = axis_names[direction],
                        .amplitude = asked.level,
                        .unit = direction < 3 ? "m/s2" : "rad/s2",
                        .random = {}});
    if (asked.random) all.list.back().random = spectral_density(*asked.random, asked.band);
  }
  for (std::size_t i = 0; i < asked.forces.size(); ++i) {
    const Force& force = asked.forces[i];
    const std::string key = "analyses.response.forces[" + std::to_string(i) + "].at";
    all.loads.force.col(Eigen::Index(all.list.size())) = nodal_force(force, key, model);
    all.loads.base.push_back(-1);
    all.list.push_back({.name = force.name,
                        .is_force = true,
                        .amplitude = force.amplitude,
                        .unit = force.direction < 3 ? "N" : "Nm",
                        .random = {}});
    if (force.random) all.list.back().random = spectral_density(*force.random, asked.band);
  }
  return all;
}

VectorXd response_grid(const Response& asked, const DampedModes& modes) {
  const VectorXd found = modes.solution.lambda.head(modes.solution.modes).unaryExpr(&frequency);
  const VectorXd grid = frequency_grid(asked.band[0], asked.band[1], asked.points, found,
                                       (modes.zeta + modes.eta / 2).head(modes.solution.modes));
  std::vector<double> all(grid.begin(), grid.end());
  const auto add_corners = [&](const Noise& noise) {
    for (const auto& [hertz, density] : noise.table)
      for (const double side : {1 - 1e-9, 1., 1 + 1e-9})
        if (hertz * side > asked.band[0] && hertz * side < asked.band[1])
          all.push_back(hertz * side);
  };
  if (asked.random) add_corners(*asked.random);
  for (const Force& force : asked.forces)
    if (force.random) add_corners(*force.random);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return VectorXd::Map(all.data(), Eigen::Index(all.size()));
}

MatrixXcd modal_coordinates(const DampedModes& modes, int which, const VectorXd& hertz) {
  const Eigen::Index n = modes.solution.lambda.size();
  const ModalModel modal{.lambda = modes.solution.lambda,
                         .zeta = modes.zeta,
                         .eta = modes.eta,
                         .output = MatrixXd::Identity(n, n),
                         .input = modes.solution.input.col(which)};
  return frequency_response(modal, 0, 2 * pi * hertz);
}

std::vector<ResponseResult> responses(const Response& asked, const BuiltCase& built,
                                      const DampedModes& modes, const Excitations& excited) {
  require_damping(asked, modes);
  const ModalModel modal{.lambda = modes.solution.lambda,
                         .zeta = modes.zeta,
                         .eta = modes.eta,
                         .output = at_sensors(built, modes.solution.u),
                         .input = modes.solution.input};
  const MatrixXd rigid = at_sensors(built, excited.loads.rigid);
  const VectorXd hertz = response_grid(asked, modes), omega = 2 * pi * hertz;
  std::vector<ResponseResult> results;
  for (std::size_t k = 0; k < excited.list.size(); ++k) {
    const Excitation& e = excited.list[k];
    ResponseResult response{.excitation = e.name,
                            .is_force = e.is_force,
                            .level = e.amplitude,
                            .unit = e.unit,
                            .hertz = hertz,
                            .channels = {},
                            .acceleration = {},
                            .shown = {},
                            .peaks = {},
                            .random = {},
                            .test = {}};
    for (const BuiltSensor& s : built.sensors)
      for (int axis : {0, 1, 2}) response.channels.push_back({s.name, axis_names[axis]});
    const MatrixXcd relative = frequency_response(modal, static_cast<int>(k), omega);
    response.acceleration = -(omega.cwiseAbs2().asDiagonal() * relative);
    response.acceleration.rowwise() += rigid.col(Eigen::Index(k)).transpose();
    response.shown = channels_with_path(response.acceleration);
    add_peaks(response, frequency(modes.solution.lambda[modes.solution.modes - 1]));
    if (!e.random.table.empty()) response.random = random_result(asked, e.random, response);
    results.push_back(std::move(response));
  }
  return results;
}

} // namespace plica
