#include "diagnose/readings/response_peaks.hpp"

#include "lab/identification/peak_picking.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

// With w in units of the peak.
struct OneMode {
  double lambda = 1, c = 0.02;
  Complex a, b;
  Complex at(double w) const { return (a + b * w * w) / denominator(w); }
  Complex denominator(double w) const { return {lambda - w * w, w * c}; }
  double natural() const { return std::sqrt(lambda); }
  double damping() const { return c / (2 * natural()); }
};

// Where the response of a mode is highest, and how high.
std::pair<double, double> summit_of(const OneMode& mode) {
  constexpr int steps = 60;
  std::pair<double, double> summit;
  for (int i = -steps; i <= steps; ++i) {
    const double w = mode.natural() * (1 + mode.damping() * i / steps);
    if (const double height = std::abs(mode.at(w)); height > summit.second) summit = {w, height};
  }
  return summit;
}

// Whether a mode is as high as the highest line: three tenths more or less, and more where lines
// lie so far apart that they may miss the top.
bool believable(double height, double line, const VectorXd& w, const OneMode& mode) {
  constexpr double off = 0.3;
  const double step = (w[w.size() - 1] - w[0]) / double(w.size() - 1);
  const double missed = std::hypot(1, step / mode.c);
  return height > (1 - off) * line && height < (1 + off) * missed * line;
}

// One step of the weighted linear problem.
OneMode refit(const VectorXd& w, const VectorXcd& H, const OneMode& last) {
  const Index n = w.size();
  MatrixXd A(2 * n, 6);
  VectorXd rhs(2 * n);
  for (Index k = 0; k < n; ++k) {
    const double weight = 1 / std::abs(last.denominator(w[k]));
    const double w2 = w[k] * w[k];
    const Complex h = weight * H[k], ih = Complex(0, w[k]) * h;
    A.row(2 * k) << h.real(), ih.real(), -weight, 0, -weight * w2, 0;
    A.row(2 * k + 1) << h.imag(), ih.imag(), 0, -weight, 0, -weight * w2;
    rhs[2 * k] = w2 * h.real();
    rhs[2 * k + 1] = w2 * h.imag();
  }
  const VectorXd x = A.colPivHouseholderQr().solve(rhs);
  return {x[0], x[1], {x[2], x[3]}, {x[4], x[5]}};
}

OneMode fitted(const VectorXd& w, const VectorXcd& H, double guess) {
  OneMode mode{.lambda = 1, .c = 2 * guess, .a = {}, .b = {}};
  constexpr int rounds = 6;
  for (int i = 0; i < rounds; ++i) {
    const OneMode next = refit(w, H, mode);
    if (!(next.lambda > 0.5 && next.lambda < 2 && next.c > 1e-5)) break;
    mode = next;
  }
  return mode;
}

// What the fit leaves of a line, over the highest.
double left_by(const OneMode& mode, const VectorXd& w, const VectorXcd& H) {
  double left = 0, level = 0;
  for (Index k = 0; k < w.size(); ++k) {
    left += std::norm(H[k] - mode.at(w[k]));
    level = std::max(level, std::abs(mode.at(w[k])));
  }
  return std::sqrt(left / std::max<double>(1, 2 * double(w.size()) - 6)) / level;
}

} // namespace

std::vector<FittedPeak> response_peaks(const VectorXd& hertz, const VectorXcd& H, double share) {
  constexpr double prominence = 1.5;
  constexpr Index fewest = 9;
  std::vector<FittedPeak> found;
  const VectorXd magnitude = H.cwiseAbs();
  for (const PickedPeak& picked : pick_peaks(hertz, magnitude, prominence, share)) {
    const double guess =
        std::isfinite(picked.damping) ? std::clamp(picked.damping, 2e-3, 0.15) : 0.02;
    Index first = 0, last = hertz.size() - 1;
    Index middle = 0;
    (hertz.array() - picked.frequency).abs().minCoeff(&middle);
    const double reach = fitted_reach * guess * picked.frequency;
    while (first + 1 < middle && hertz[first] < picked.frequency - reach) ++first;
    while (last > middle + 1 && hertz[last] > picked.frequency + reach) --last;
    first = std::max<Index>(0, std::min(first, middle - fewest / 2));
    last = std::min<Index>(hertz.size() - 1, std::max(last, middle + fewest / 2));
    if (last - first + 1 < 6) continue;
    const VectorXd w = hertz.segment(first, last - first + 1) / picked.frequency;
    const VectorXcd h = H.segment(first, last - first + 1);
    const OneMode mode = fitted(w, h, guess);
    const auto [at, highest] = summit_of(mode);
    if (believable(highest, picked.amplitude, w, mode))
      found.push_back({.frequency = at * picked.frequency,
                       .amplitude = highest,
                       .damping = mode.damping(),
                       .noise = left_by(mode, w, h),
                       .natural = mode.natural() * picked.frequency,
                       .first = int(first),
                       .lines = int(w.size())});
  }
  return found;
}

double apparent_damping(const VectorXd& hertz, const VectorXcd& H, double frequency, double guess) {
  return fitted(hertz / frequency, H, guess).damping();
}

double height_at(const FittedPeak& peak, const VectorXd& hertz, const VectorXcd& H) {
  const VectorXd w = hertz.segment(peak.first, peak.lines) / peak.natural;
  const VectorXcd h = H.segment(peak.first, peak.lines);
  OneMode mode{.lambda = 1, .c = 2 * peak.damping, .a = {}, .b = {}};
  Eigen::MatrixX2cd A(w.size(), 2); // of a + b and b
  for (Index k = 0; k < w.size(); ++k)
    A.row(k) << 1. / mode.denominator(w[k]), (w[k] * w[k] - 1) / mode.denominator(w[k]);
  const Eigen::Matrix2cd normal = A.adjoint() * A;
  const Eigen::Vector2cd x = normal.inverse() * (A.adjoint() * h);
  mode.a = x[0] - x[1];
  mode.b = x[1];
  const double line = h.cwiseAbs().maxCoeff(), height = summit_of(mode).second;
  return believable(height, line, w, mode) ? height : line;
}

} // namespace plica
