#include "run/analyses/response.hpp"

#include "lab/signals/peaks.hpp"
#include "solve/frequency_grid.hpp"
#include "words/input_error.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void require_damping(const Response& asked, const DampedModes& modes) {
  for (int j = 0; j < modes.solution.modes; ++j) {
    const double f = frequency_of(modes, j);
    if (f < asked.band[0] || f > asked.band[1] || damping_of(modes, j) > 0) continue;
    input_error("analyses.response",
                "mode " + std::to_string(j + 1) + " at " + short_text(f, 5) +
                    " Hz has no damping, so its peak is infinite",
                "give analyses.damping.modal, a range, a mode or a loss factor that reaches it");
  }
}

// Channels below a thousandth of the largest are rounding, or have no path.
std::vector<int> channels_with_path(const MatrixXcd& acceleration) {
  const Eigen::RowVectorXd highest = acceleration.cwiseAbs().colwise().maxCoeff();
  std::vector<int> channels;
  for (Index c = 0; c < highest.size(); ++c)
    if (highest[c] > 1e-3 * highest.maxCoeff()) channels.push_back(static_cast<int>(c));
  return channels;
}

// A maximum within two half-power bandwidths of a mode; others lie between antiresonances, or above
// the last mode, where the response is that of static terms.
bool is_resonance(double hertz, const DampedModes& modes) {
  for (int j = 0; j < modes.solution.modes; ++j) {
    const double f = frequency_of(modes, j);
    if (std::abs(hertz - f) <= 4 * damping_of(modes, j) * f) return true;
  }
  return false;
}

void add_peaks(ResponseResult& response, const DampedModes& modes) {
  for (int c : response.shown)
    for (const Peak& p : find_peaks(response.hertz, response.acceleration.col(c).cwiseAbs())) {
      if (!is_resonance(p.frequency, modes)) continue;
      Index at = 0;
      (response.hertz.array() - p.frequency).abs().minCoeff(&at);
      response.peaks.push_back({.channel = c,
                                .frequency = p.frequency,
                                .amplitude = p.height,
                                .damping = p.damping,
                                .phase = std::arg(response.acceleration(at, c))});
    }
}

int channel_of(const ResponseResult& response, const std::string& name, const std::string& key) {
  for (std::size_t c = 0; c < response.channels.size(); ++c)
    if (name == response.channels[c].first + "." + response.channels[c].second)
      return static_cast<int>(c);
  input_error(key, "there is no channel \"" + name + "\"", "a sensor and its axis, e.g. mid.y");
}

// The sine at its worst frequency beside the random motion of the whole band.
ToneResult tone_result(const Tone& tone, const ResponseResult& response, const VectorXd& rms) {
  const double amplitude = tone.acceleration ? *tone.acceleration : *tone.force;
  ToneResult result{.band = tone.band,
                    .amplitude = amplitude,
                    .frequency = VectorXd::Zero(rms.size()),
                    .sine = VectorXd::Zero(rms.size()),
                    .rms = rms};
  for (Index i = 0; i < response.hertz.size(); ++i) {
    const double f = response.hertz[i];
    if (f < tone.band[0] || f > tone.band[1]) continue;
    for (Index c = 0; c < rms.size(); ++c)
      if (const double a = amplitude * std::abs(response.acceleration(i, c)); a > result.sine[c]) {
        result.sine[c] = a;
        result.frequency[c] = f;
      }
  }
  result.rms = (rms.array().square() + result.sine.array().square() / 2).sqrt();
  return result;
}

RandomResult random_result(const Response& asked, const Excitation& e,
                           const std::vector<MatrixXcd>& unit, const ResponseResult& response) {
  RandomResult random;
  const VectorXd& f = response.hertz;
  const bool alone = unit.size() == 1;
  if (alone)
    random.input =
        f.unaryExpr([&](double hertz) { return spectrum_at(e.random, hertz)(0, 0).real(); });
  random.density = response_density(e.random, f, unit);
  std::vector<std::array<double, 2>> bands{asked.band};
  bands.insert(bands.end(), asked.rms_bands.begin(), asked.rms_bands.end());
  for (const auto& band : bands) {
    BandRms rms_of{.band = band,
                   .input = alone ? rms(f, random.input, band[0], band[1]) : std::nan(""),
                   .rms = {}};
    rms_of.rms.resize(random.density.cols());
    for (Index c = 0; c < random.density.cols(); ++c)
      rms_of.rms[c] = rms(f, random.density.col(c), band[0], band[1]);
    random.bands.push_back(std::move(rms_of));
  }
  for (std::size_t i = 0; i < asked.cross.size(); ++i) {
    const std::string key = "analyses.response.cross[" + std::to_string(i) + "].";
    const int a = channel_of(response, asked.cross[i].a, key + "a");
    const int b = channel_of(response, asked.cross[i].b, key + "b");
    random.cross.push_back({.a = a, .b = b, .density = cross_density(e.random, f, unit, a, b)});
  }
  for (const Tone& tone : asked.tones)
    if (tone.of == e.name) random.tones.push_back(tone_result(tone, response, random.bands[0].rms));
  return random;
}

void add_corners(const std::vector<double>& corners, const std::array<double, 2>& band,
                 std::vector<double>& all) {
  for (const double hertz : corners)
    for (const double side : {1 - 1e-9, 1., 1 + 1e-9})
      if (hertz * side > band[0] && hertz * side < band[1]) all.push_back(hertz * side);
}

} // namespace

VectorXd response_grid(const Response& asked, const DampedModes& modes) {
  VectorXd found(modes.solution.modes), damping(modes.solution.modes);
  for (int j = 0; j < modes.solution.modes; ++j) {
    found[j] = frequency_of(modes, j);
    damping[j] = damping_of(modes, j);
  }
  const VectorXd grid = frequency_grid(asked.band[0], asked.band[1], asked.points, found, damping);
  std::vector<double> all(grid.begin(), grid.end()), corners;
  const auto add_table = [&](const auto& noise) {
    if (!noise) return;
    for (const auto& row : noise->table) corners.push_back(row[0]);
  };
  add_table(asked.random);
  for (const Motion& motion : asked.motions) add_table(motion.random);
  for (const Force& force : asked.forces) add_table(force.random);
  for (const Together& t : asked.together)
    for (const SpectrumMatrix& row : t.spectra) corners.push_back(row.frequency);
  for (const Tone& tone : asked.tones)
    corners.insert(corners.end(), tone.band.begin(), tone.band.end());
  add_corners(corners, asked.band, all);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return VectorXd::Map(all.data(), Index(all.size()));
}

std::vector<ResponseResult> responses(const Response& asked, const SensorModel& model,
                                      const DampedModes& modes, const Excitations& excited) {
  require_damping(asked, modes);
  const VectorXd hertz = response_grid(asked, modes);
  std::vector<ResponseResult> results;
  for (const Excitation& e : excited.list) {
    ResponseResult response{.excitation = e.name,
                            .source = e.source,
                            .direction = e.direction,
                            .level = e.amplitude,
                            .unit = e.unit,
                            .hertz = hertz,
                            .channels = model.channels,
                            .acceleration = acceleration_of(model, e.parts, hertz),
                            .shown = {},
                            .peaks = {},
                            .random = {},
                            .test = {}};
    response.shown = channels_with_path(response.acceleration);
    add_peaks(response, modes);
    if (!e.random_inputs.empty()) {
      std::vector<MatrixXcd> unit;
      if (e.source == Source::together)
        for (const ExcitedColumns& input : e.random_inputs)
          unit.push_back(acceleration_of(model, input, hertz));
      else
        unit.push_back(response.acceleration);
      response.random = random_result(asked, e, unit, response);
    }
    results.push_back(std::move(response));
  }
  return results;
}

} // namespace plica
