#include "lab/signals/sine_tracking.hpp"

#include "lab/signals/fourier.hpp"
#include "words/sample_ranks.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// phase: of the fundamental at every sample.
SineLine fit(const MatrixXd& samples, const VectorXd& phase, double hertz, int harmonics) {
  const Index n = samples.rows();
  MatrixXd basis(n, 2 + 2 * harmonics);
  basis.col(0).setOnes();
  basis.col(1).setLinSpaced(n, -1, 1);
  for (int k = 1; k <= harmonics; ++k) {
    basis.col(2 * k) = (k * phase.array()).cos();
    basis.col(2 * k + 1) = -(k * phase.array()).sin(); // Re(A e^{i phi}) = A_r cos - A_i sin
  }
  const MatrixXd c = basis.colPivHouseholderQr().solve(samples);
  SineLine line{.hertz = hertz,
                .sweep_rate = 0,
                .amplitude = MatrixXcd::Zero(harmonics, samples.cols()),
                .distortion = VectorXd::Zero(samples.cols()),
                .residual = VectorXd::Zero(samples.cols())};
  for (int k = 1; k <= harmonics; ++k)
    for (Index j = 0; j < samples.cols(); ++j)
      line.amplitude(k - 1, j) = {c(2 * k, j), c(2 * k + 1, j)};
  const MatrixXd rest = samples - basis * c;
  for (Index j = 0; j < samples.cols(); ++j) {
    const double first = std::abs(line.amplitude(0, j)), all = samples.col(j).norm();
    if (first > 0) line.distortion[j] = line.amplitude.col(j).tail(harmonics - 1).norm() / first;
    if (all > 0) line.residual[j] = rest.col(j).norm() / all;
  }
  return line;
}

// Continuous phase of the fundamental along the record.
VectorXd unwrapped_phase(const VectorXd& x) {
  const Eigen::VectorXcd z = analytic_signal((x.array() - x.mean()).matrix());
  VectorXd phase(z.size());
  double turns = 0, before = 0;
  for (Index i = 0; i < z.size(); ++i) {
    const double angle = std::arg(z[i]);
    if (i > 0 && angle - before > std::numbers::pi) turns -= 1;
    if (i > 0 && angle - before < -std::numbers::pi) turns += 1;
    before = angle;
    phase[i] = angle + 2 * pi * turns;
  }
  return phase;
}

// Frequency at sample i from the phase over about one window.
double frequency_at(const VectorXd& phase, Index i, Index half, double rate) {
  const Index first = std::max<Index>(0, i - half);
  const Index last = std::min<Index>(phase.size() - 1, i + half);
  return (phase[last] - phase[first]) / double(last - first) * rate / (2 * pi);
}

int orders_below_nyquist(int harmonics, double hertz, double rate) {
  return std::clamp(static_cast<int>(0.49 * rate / hertz), 0, harmonics);
}

SineLine padded(SineLine line, int harmonics) {
  const Index have = line.amplitude.rows();
  line.amplitude.conservativeResize(harmonics, Eigen::NoChange);
  line.amplitude.bottomRows(harmonics - have).setZero();
  return line;
}

struct Dwell {
  Index first = 0, last = 0;
};

// Stretches over which the frequency keeps within a thousandth for ten periods and more. A sweep
// has none that stand apart: the steps between them must be ten times as large.
std::vector<Dwell> dwells_of(const VectorXd& hertz, Index guard, double rate) {
  std::vector<Dwell> dwells;
  for (Index i = guard; i < hertz.size() - guard;) {
    Index j = i;
    while (j + 1 < hertz.size() - guard && std::abs(hertz[j + 1] / hertz[i] - 1) < 1e-3) ++j;
    if (double(j - i) > 10 * rate / std::abs(hertz[i])) dwells.push_back({i, j});
    i = j + 1;
  }
  std::vector<double> steps;
  for (std::size_t k = 1; k < dwells.size(); ++k)
    steps.push_back(std::abs(hertz[dwells[k].first] / hertz[dwells[k - 1].first] - 1));
  if (steps.size() < 2) return {};
  return median(std::move(steps)) > 0.01 ? dwells : std::vector<Dwell>{};
}

} // namespace

SineLine fit_sine(const MatrixXd& samples, double rate, double hertz, int harmonics) {
  if (harmonics < 1 || !(hertz > 0) || !(rate > 0))
    throw std::invalid_argument(
        "a sine needs a frequency, a sampling rate and an order above zero");
  if (orders_below_nyquist(harmonics, hertz, rate) < harmonics)
    throw std::invalid_argument("the highest harmonic lies above half the sampling rate");
  if (samples.rows() < 3 * (2 + 2 * harmonics))
    throw std::invalid_argument("too few samples for " + std::to_string(harmonics) + " harmonics");
  const VectorXd phase =
      VectorXd::LinSpaced(samples.rows(), 0, double(samples.rows() - 1)) * 2 * pi * hertz / rate;
  return fit(samples, phase, hertz, harmonics);
}

std::vector<SineLine> track_sine(const MatrixXd& samples, double rate, int reference,
                                 const SineTracking& s) {
  if (reference < 0 || reference >= samples.cols())
    throw std::invalid_argument("there is no channel " + std::to_string(reference + 1));
  if (s.harmonics < 1 || s.lines < 2 || !(s.cycles >= 1) || !(rate > 0))
    throw std::invalid_argument("tracking needs an order, two lines, a cycle and a sampling rate");
  const VectorXd phase = unwrapped_phase(samples.col(reference));
  const Index n = samples.rows(), guard = std::min<Index>(n / 20, 200);
  if (n < 100) throw std::invalid_argument("the record is too short to track a sine");
  VectorXd hertz(n); // smoothed over a hundredth of the record, or 200 samples
  for (Index i = 0; i < n; ++i) hertz[i] = frequency_at(phase, i, guard / 2 + 1, rate);
  const auto inner = hertz.segment(guard, n - 2 * guard);
  const double low = s.low > 0 ? s.low : inner.minCoeff();
  const double high = s.high > 0 ? s.high : inner.maxCoeff();
  if (!(low > 0 && high >= low))
    throw std::invalid_argument("the reference channel carries no sine to follow");
  std::vector<SineLine> lines;
  for (const Dwell& d : dwells_of(hertz, guard, rate)) {
    const Index first = (d.first + d.last) / 2, count = d.last - first + 1; // settled
    const double f = (phase[d.last] - phase[first]) / double(d.last - first) * rate / (2 * pi);
    const int orders = orders_below_nyquist(s.harmonics, f, rate);
    if (orders < 1 || count < 3 * (2 + 2 * orders)) continue;
    lines.push_back(
        padded(fit(samples.middleRows(first, count), phase.segment(first, count), f, orders),
               s.harmonics));
  }
  if (lines.size() > 2) {
    std::sort(lines.begin(), lines.end(),
              [](const SineLine& a, const SineLine& b) { return a.hertz < b.hertz; });
    return lines;
  }
  lines.clear();
  for (int l = 0; l < s.lines; ++l) {
    const double wanted = low * std::pow(high / low, l / double(s.lines - 1));
    Index at = -1;
    for (Index i = guard; i + 1 < n - guard && at < 0; ++i)
      if ((hertz[i] - wanted) * (hertz[i + 1] - wanted) <= 0) at = i;
    if (at < 0) continue;
    const int orders = orders_below_nyquist(s.harmonics, wanted, rate);
    const Index half = Index(0.5 * s.cycles * rate / wanted);
    const Index first = std::max<Index>(0, at - half), last = std::min<Index>(n - 1, at + half);
    if (orders < 1 || last - first + 1 < 3 * (2 + 2 * orders)) continue;
    const Index count = last - first + 1;
    SineLine line =
        fit(samples.middleRows(first, count), phase.segment(first, count), wanted, orders);
    line.sweep_rate = std::abs(hertz[last] - hertz[first]) / double(last - first) * rate / wanted;
    lines.push_back(padded(line, s.harmonics));
  }
  return lines;
}

} // namespace plica
