#include "lab/signals/frf_of_signals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;

int column_of(const std::vector<std::string>& channels, const std::string& name) {
  const auto found = std::find(channels.begin(), channels.end(), name);
  if (found == channels.end())
    throw std::invalid_argument("there is no channel " + name + " for the reference");
  return static_cast<int>(found - channels.begin());
}

FrfSet empty_set(const std::vector<std::string>& channels, int reference, FrfQuantity quantity) {
  FrfSet set;
  set.quantity = quantity;
  set.references = {channels[reference]};
  for (std::size_t c = 0; c < channels.size(); ++c)
    if (static_cast<int>(c) != reference) set.responses.push_back(channels[c]);
  if (set.responses.empty())
    throw std::invalid_argument("there is no channel beside the reference");
  return set;
}

} // namespace

SignalFrf frf_of_noise(const Eigen::MatrixXd& samples, double rate,
                       const std::vector<std::string>& channels, const std::string& reference,
                       FrfQuantity quantity, const WelchSettings& settings,
                       FrfEstimator estimator) {
  const int input = column_of(channels, reference);
  SignalFrf result;
  result.set = empty_set(channels, input, quantity);
  result.channels = channels;
  std::vector<int> responses;
  for (int c = 0; c < static_cast<int>(channels.size()); ++c)
    if (c != input) responses.push_back(c);
  WelchSettings used = settings;
  if (used.block == 0) used.block = usual_block(samples.rows());
  const Spectra spectra = welch(samples, rate, {input}, responses, used);
  const FrfEstimate e = estimate_frf(spectra, estimator);
  result.set.hertz = e.hertz;
  result.set.H = e.H;
  result.set.resolution = spectra.resolution;
  result.coherence = e.coherence;
  result.density.resize(e.hertz.size(), samples.cols());
  for (Index f = 0; f < e.hertz.size(); ++f) result.density(f, input) = spectra.xx[f](0, 0).real();
  for (std::size_t c = 0; c < responses.size(); ++c)
    result.density.col(responses[c]) = spectra.yy.col(Index(c));
  result.rms = band_rms(e.hertz, result.density, 0, rate / 2);
  Eigen::MatrixXd sigma = e.H[0].cwiseAbs();
  for (Index f = 0; f < sigma.rows(); ++f)
    for (Index c = 0; c < sigma.cols(); ++c)
      if (e.coherence(f, c) > 0) sigma(f, c) *= frf_random_error(e.coherence(f, c), e.averages);
  result.set.sigma = {sigma};
  return result;
}

SignalFrf frf_of_sine(const Eigen::MatrixXd& samples, double rate,
                      const std::vector<std::string>& channels, const std::string& reference,
                      FrfQuantity quantity, const SineTracking& settings) {
  const int input = column_of(channels, reference);
  SignalFrf result;
  result.set = empty_set(channels, input, quantity);
  result.channels = channels;
  const std::vector<SineLine> lines = track_sine(samples, rate, input, settings);
  if (lines.empty()) throw std::invalid_argument("the sweep passes none of the wanted frequencies");
  const Index count = Index(lines.size()), responses = Index(result.set.responses.size());
  result.set.hertz.resize(count);
  result.set.H.assign(1, Eigen::MatrixXcd::Zero(count, responses));
  result.distortion = Eigen::MatrixXd::Zero(count, responses);
  for (Index f = 0; f < count; ++f) {
    const SineLine& line = lines[f];
    result.set.hertz[f] = line.hertz;
    result.set.sweep_rate = std::max(result.set.sweep_rate, line.sweep_rate);
    for (Index c = 0, column = 0; column < samples.cols(); ++column) {
      if (column == input) continue;
      result.set.H[0](f, c) = line.amplitude(0, column) / line.amplitude(0, input);
      result.distortion(f, c++) = line.distortion[column];
    }
  }
  return result;
}

} // namespace plica
