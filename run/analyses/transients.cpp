#include "run/analyses/transients.hpp"

#include "run/analyses/coupling_change.hpp"
#include "run/analyses/dissipation.hpp"
#include "solve/modes.hpp"
#include "solve/shock_spectrum.hpp"
#include "solve/transient_response.hpp"
#include "words/input_error.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

struct Samples {
  double step = 0;
  VectorXd values;
};

// Share of the peak of a shock at a share of its duration.
double pulse_at(PulseShape shape, double x) {
  switch (shape) {
  case PulseShape::half_sine:
    return std::sin(std::numbers::pi * x);
  case PulseShape::sawtooth:
    return x;
  case PulseShape::trapezoid:
    return std::min({1., 10 * x, 10 * (1 - x)});
  }
  return 0;
}

// Until the slowest mode has decayed to a twentieth, a hundred of its periods at most.
double ring_down(const DampedModes& modes) {
  const double omega = 2 * std::numbers::pi * frequency_of(modes, 0);
  const double zeta = damping_of(modes, 0);
  const double period = 2 * std::numbers::pi / omega;
  return zeta > 0 ? std::min(3 / (zeta * omega), 100 * period) : 100 * period;
}

Samples pulse_samples(const Pulse& pulse, const DampedModes& modes) {
  constexpr int least = 260, steps = 24; // in the pulse, in a period of the fastest mode
  const double fastest = frequency(modes.solution.lambda[modes.solution.modes - 1]);
  const double wanted = std::max<double>(least, std::ceil(pulse.duration * steps * fastest));
  const auto count = Index(20 * std::ceil(wanted / 20)); // corners of a trapezoid are samples
  const double peak = pulse.acceleration ? *pulse.acceleration : *pulse.force;
  Samples samples{pulse.duration / double(count), VectorXd(count + 1)};
  for (Index i = 0; i <= count; ++i)
    samples.values[i] = peak * pulse_at(pulse.shape, double(i) / double(count));
  return samples;
}

Samples samples_of(const Transient& asked, const std::string& key, const DampedModes& modes) {
  constexpr double most = 2e7;
  Samples samples = asked.pulse ? pulse_samples(*asked.pulse, modes)
                                : Samples{asked.signal->step, asked.signal->samples};
  const double after = asked.pulse && asked.after == 0 ? ring_down(modes) : asked.after;
  const double more = std::ceil(after / samples.step);
  if (double(samples.values.size()) + more > most)
    input_error(key + ".after", "makes more than 20 million samples", "a shorter time");
  const Index before = samples.values.size();
  samples.values.conservativeResize(before + Index(more));
  samples.values.tail(Index(more)).setZero();
  return samples;
}

ShockSpectra spectra_of(const SpectrumRequest& asked, const TransientResult& r, bool moved) {
  const double octaves = std::log2(asked.band[1] / asked.band[0]);
  const auto count = Index(std::floor(octaves * asked.per_octave + 1e-9)) + 1;
  ShockSpectra s{.quality = asked.quality, .hertz = VectorXd(count), .input = {}, .channels = {}};
  for (Index i = 0; i < count; ++i)
    s.hertz[i] = asked.band[0] * std::exp2(double(i) / asked.per_octave);
  const double zeta = 1 / (2 * asked.quality);
  if (moved) s.input = shock_spectrum(r.input, r.step, s.hertz, zeta).maximax();
  s.channels.resize(count, r.acceleration.cols());
  for (Index c = 0; c < r.acceleration.cols(); ++c)
    s.channels.col(c) = shock_spectrum(r.acceleration.col(c), r.step, s.hertz, zeta).maximax();
  return s;
}

// Adds what couples the modes by Fourier transforms of the signal, straight between its samples.
// False: they would be too long.
bool add_coupling(TransientResult& r, const SensorModel& model, const ModalModel& by_mode,
                  const VectorXd& carried, const ExcitedColumns& parts, const DampedModes& modes) {
  constexpr double room = 3e7; // numbers
  const Index channels = r.acceleration.cols();
  const auto lines = transform_lines(double(r.input.size()) + ringing_samples(modes, r.step),
                                     r.step, by_mode, channels, room);
  if (!lines) return false;
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  VectorXd padded = VectorXd::Zero(lines->length);
  padded.head(r.input.size()) = r.input;
  VectorXcd input;
  transform.fwd(input, padded);
  MatrixXcd difference = MatrixXcd::Zero(lines->length / 2 + 1, channels);
  for_each_change(*lines, model, parts, by_mode, carried.transpose(),
                  [&](Index first, const VectorXd& omega, const MatrixXcd& change) {
                    for (Index i = 0; i < omega.size(); ++i) {
                      const double half = omega[i] * r.step / 2, straight = std::sin(half) / half;
                      difference.row(first + i) =
                          straight * straight * input[first + i] * change.row(i);
                    }
                  });
  for (Index c = 0; c < channels; ++c) {
    VectorXd motion;
    transform.inv(motion, VectorXcd(difference.col(c)), lines->length);
    r.acceleration.col(c) += motion.head(r.input.size());
  }
  return true;
}

} // namespace

TransientResult transient(const Transient& asked, const std::string& key, const SensorModel& model,
                          const DampedModes& modes, const Excitations& excited,
                          std::vector<std::string>& warnings) {
  const Excitation& e = excitation_named(asked.of, key + ".of", excited);
  for (const ExcitedColumn& part : e.parts)
    if (part.factor.imag() != 0)
      input_error(key + ".of", "\"" + asked.of + "\" has phases, which a transient has not",
                  "a motion of ends that are in phase");
  Samples samples = samples_of(asked, key, modes);
  TransientResult r{.name = asked.name,
                    .input_title = title_of(e),
                    .unit = e.unit,
                    .step = samples.step,
                    .input = std::move(samples.values),
                    .channels = model.channels,
                    .acceleration = {},
                    .shown = {},
                    .extremes = {},
                    .rms = {},
                    .spectra = {}};
  ModalModel modal = model.relative.modal();
  modal.zeta += first_order_damping(modes.dissipation, modes.solution);
  modal.input = MatrixXd::Zero(modal.lambda.size(), 1);
  VectorXd carried = VectorXd::Zero(modal.output.rows());
  for (const ExcitedColumn& part : e.parts) {
    modal.input += part.factor.real() * model.relative.modal().input.col(part.column);
    carried += part.factor.real() * model.rigid.col(part.column);
  }
  r.acceleration = transient_acceleration(modal, r.input, r.step);
  r.acceleration += r.input * carried.transpose();
  if (!modes.dissipation.empty() && !add_coupling(r, model, modal, carried, e.parts, modes))
    warnings.push_back(too_long_for_coupling("transient " + r.name));
  const double largest = r.acceleration.cwiseAbs().maxCoeff();
  for (Index c = 0; c < r.acceleration.cols(); ++c) {
    Index at = 0;
    const double highest = r.acceleration.col(c).cwiseAbs().maxCoeff(&at);
    r.extremes.push_back({r.acceleration(at, c), double(at) * r.step});
    if (highest > 1e-3 * largest) r.shown.push_back(int(c));
  }
  r.rms = (r.acceleration.colwise().squaredNorm() / double(r.input.size())).cwiseSqrt();
  if (asked.spectrum) r.spectra = spectra_of(*asked.spectrum, r, e.source != Source::force);
  return r;
}

} // namespace plica
