#include "lab/identification/output_only.hpp"

#include "lab/identification/covariance_ssi.hpp"
#include "lab/identification/decay_fit.hpp"
#include "lab/identification/mode_correlation.hpp"
#include "lab/identification/mode_of_fit.hpp"
#include "lab/identification/peak_picking.hpp"
#include "lab/identification/state_space.hpp"
#include "lab/identification/time_band.hpp"
#include "lab/signals/decimation.hpp"
#include "lab/signals/harmonics.hpp"
#include "lab/signals/spectrum.hpp"
#include "words/input_error.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr StabilityLimits output_limits{.frequency = 0.01, .damping = 0.3, .participation = 0.95};
constexpr double output_width = 1; // of half a bandwidth
constexpr Index most_references = 8, most_rows = 240, fewest_half = 8, most_half = 80;

struct Output {
  MatrixXd samples; // without their means, each channel over its RMS
  VectorXd scale;
  double rate = 0, low = 0, high = 0;
};

Output output_of(const TimeRecord& record, const IdentifySettings& settings) {
  check_record(record);
  check_band(settings, record.rate);
  Output o{.samples = {}, .scale = {}, .low = settings.low};
  o.high = settings.high > 0 ? settings.high : highest_frequency(record);
  const Decimated d =
      decimated(record.samples.rowwise() - record.samples.colwise().mean(), record.rate, o.high);
  o.rate = d.rate;
  o.samples = d.samples.rowwise() - d.samples.colwise().mean();
  o.scale = (o.samples.colwise().norm() / std::sqrt(double(o.samples.rows()))).transpose();
  o.samples = o.samples * o.scale.cwiseInverse().asDiagonal();
  return o;
}

// Channels that, one after another, hold most of what those before do not.
std::vector<Index> references_of(const MatrixXd& samples) {
  const MatrixXd covariance = samples.transpose() * samples / double(samples.rows());
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(covariance);
  std::vector<Index> chosen;
  for (Index c = 0; c < std::min(most_references, samples.cols()); ++c)
    chosen.push_back(qr.colsPermutation().indices()[c]);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

// Block rows: as many as the model can be made from, fewer where the record is short.
Index half_lags(const Output& o) {
  const Index wanted = std::clamp(most_rows / o.samples.cols(), fewest_half, most_half);
  const Index possible = o.samples.rows() / 160; // forty blocks of twice the lags
  if (possible < fewest_half)
    input_error("file",
                fmt::format("is too short: {} samples at {:.4g} Hz, which the band needs, {} are "
                            "the fewest",
                            o.samples.rows(), o.rate, 160 * fewest_half),
                "a longer record");
  return std::min(wanted, possible);
}

// The correlations as one set of free decays: lags x (channels x references).
MatrixXd as_decays(const Correlations& c) {
  MatrixXd y(Index(c.R.size()), c.R[0].size());
  for (std::size_t i = 0; i < c.R.size(); ++i) y.row(Index(i)) = c.R[i].reshaped().transpose();
  return y;
}

// Shares and misfit: poles held, amplitudes by least squares.
void add_shares(const Output& o, const Correlations& c, const Poles& poles, Identification& found) {
  if (poles.empty()) {
    found.misfit = 1;
    return;
  }
  const MatrixXd y = as_decays(c);
  MatrixXd A(y.rows(), 2 * Index(poles.size()));
  for (Index i = 0; i < A.rows(); ++i)
    for (std::size_t r = 0; r < poles.size(); ++r) {
      const Complex e = std::exp(poles[r] * double(i) / o.rate);
      A(i, 2 * Index(r)) = e.real();
      A(i, 2 * Index(r) + 1) = -e.imag();
    }
  const MatrixXd x = A.colPivHouseholderQr().solve(y);
  found.misfit = (y - A * x).norm() / y.norm();
  for (std::size_t r = 0; r < found.modes.size(); ++r)
    found.modes[r].share =
        (A.middleCols(2 * Index(r), 2) * x.middleRows(2 * Index(r), 2)).norm() / y.norm();
}

IdentifiedMode described_output(const StochasticMode& m) {
  IdentifiedMode mode;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  mode.peak_frequency = mode.peak_damping = mode.circle_frequency = mode.circle_damping = nan;
  mode.frequency = std::abs(m.lambda) / (2 * std::numbers::pi);
  mode.damping = -m.lambda.real() / std::abs(m.lambda);
  mode.sigma_frequency = m.sigma_frequency;
  mode.sigma_damping = m.sigma_damping;
  mode.shape = turned_real(m.shape);
  const double largest = mode.shape.cwiseAbs().maxCoeff();
  mode.shape /= largest;
  mode.sigma_shape = m.sigma_shape / largest;
  mode.participation = VectorXcd::Ones(1);
  mode.collinearity = phase_collinearity(mode.shape);
  return mode;
}

const DiagramPole& best_known(const Subspace& space, const Correlations& c,
                              const StableGroup& group, double rate) {
  const DiagramPole* best = &group.members[0];
  double least = std::numeric_limits<double>::infinity();
  for (const DiagramPole& p : group.members) {
    const StochasticMode m = stochastic_mode(space, c, p.pole, p.order, rate, VectorXd());
    const double size = std::abs(m.lambda) / (2 * std::numbers::pi);
    const double deviation = std::hypot(m.sigma_frequency, m.sigma_damping * size);
    if (deviation < least) {
      least = deviation;
      best = &p;
    }
  }
  return *best;
}

void add_densities(const TimeRecord& record, const Output& o, Identification& found) {
  FrfSet& set = found.set;
  set.responses = record.channels;
  set.references = {"unknown excitation"};
  std::vector<int> all;
  for (int c = 0; c < int(record.channels.size()); ++c) all.push_back(c);
  const Spectra spectra = welch(o.samples * o.scale.asDiagonal(), o.rate, {0}, all,
                                {.block = usual_block(o.samples.rows())});
  std::vector<Index> kept;
  for (Index k = 1; k < spectra.hertz.size(); ++k)
    if (spectra.hertz[k] >= o.low && spectra.hertz[k] <= o.high) kept.push_back(k);
  check_lines(kept.size(), o.low, o.high);
  set.hertz = spectra.hertz(kept);
  set.H = {spectra.yy(kept, Eigen::all).cwiseSqrt().cast<Complex>()};
  set.resolution = spectra.resolution;
  set.warnings = record.warnings;
}

// Sines at the peaks of the densities and at the modes.
void warn_of_sines(const Output& o, Identification& found) {
  const FrfSet& set = found.set;
  const MatrixXd over_rms = set.H[0].cwiseAbs() * o.scale.cwiseInverse().asDiagonal();
  std::vector<double> places;
  for (const PickedPeak& p : pick_peaks(set.hertz, over_rms.rowwise().norm(), 2, 0.1))
    places.push_back(p.frequency);
  for (const IdentifiedMode& m : found.modes) places.push_back(m.frequency);
  std::sort(places.begin(), places.end());
  const double seconds = double(o.samples.rows()) / o.rate;
  const double half = std::max(50 / seconds, set.resolution);
  double last = -half;
  for (const double f : places) {
    Index line = 0, strongest = 0;
    (set.hertz.array() - f).abs().minCoeff(&line);
    over_rms.row(line).maxCoeff(&strongest);
    const BandKurtosis k = band_kurtosis(o.samples.col(strongest), o.rate, f - half, f + half);
    if (f < last + half || !is_sine(k)) continue;
    last = f;
    found.warnings.push_back(fmt::format("at {:.4g} Hz the kurtosis is {:.2f} (noise 3, a sine "
                                         "1.5): a harmonic of a machine, or a mode that rings as "
                                         "long as the record",
                                         f, k.value));
  }
}

void warn_of_output(const Output& o, Identification& found) {
  const double seconds = double(o.samples.rows()) / o.rate;
  for (const IdentifiedMode& m : found.modes) {
    const std::string name = fmt::format("mode at {:.5g} Hz: ", m.frequency);
    if (seconds * m.damping * m.frequency < 10)
      found.warnings.push_back(name + fmt::format("the record of {:.4g} s holds {:.2g} of its "
                                                  "decay times, below ten its damping comes out "
                                                  "high",
                                                  seconds, seconds * m.damping * m.frequency));
    if (m.sigma_damping > 0.3 * m.damping)
      found.warnings.push_back(name + fmt::format("its damping is known to {:.0f} % of itself",
                                                  100 * m.sigma_damping / m.damping));
  }
}

} // namespace

Identification identify_output(const TimeRecord& record, const IdentifySettings& settings) {
  const Output o = output_of(record, settings);
  const Correlations c = correlations(o.samples, references_of(o.samples), 2 * half_lags(o));
  const Subspace space = subspace(c);
  const int order = settings.highest_order > 0 ? settings.highest_order : 30;
  const Index most =
      std::min<Index>({2 * Index(order), space.S.size(), space.U.rows() - space.channels});
  Identification found;
  found.source = IdentifiedFrom::output;
  found.diagram = stabilisation(
      poles_of_rising_order(space.U.leftCols(most), space.channels, o.rate), output_limits);
  add_densities(record, o, found);
  Poles poles;
  for (const StableGroup& g : stable_groups(found.diagram, output_width)) {
    const double f = g.pole.frequency();
    if (f < o.low || f > o.high) continue;
    const DiagramPole& best = best_known(space, c, g, o.rate);
    const StochasticMode m = stochastic_mode(space, c, best.pole, best.order, o.rate, o.scale);
    IdentifiedMode mode = described_output(m);
    // Known to no better than its own size: of the noise, or half of a pole that split.
    if (mode.sigma_damping > 0.5 * mode.damping ||
        mode.sigma_frequency > 0.5 * mode.damping * mode.frequency)
      continue;
    mode.orders = g.count;
    Index strongest = 0;
    mode.shape.cwiseAbs().maxCoeff(&strongest);
    mode.strongest = record.channels[std::size_t(strongest)];
    poles.push_back(m.lambda);
    found.modes.push_back(std::move(mode));
  }
  add_shares(o, c, poles, found);
  MatrixXcd shapes(space.channels, Index(found.modes.size()));
  for (std::size_t r = 0; r < found.modes.size(); ++r) shapes.col(Index(r)) = found.modes[r].shape;
  found.auto_mac = mac_matrix(shapes, shapes);
  found.warnings = found.set.warnings;
  warn_of_sines(o, found);
  warn_of_output(o, found);
  add_common_warnings(found, "the correlations");
  return found;
}

} // namespace plica
