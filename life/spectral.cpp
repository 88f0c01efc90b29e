#include "life/spectral.hpp"

#include "words/short_text.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace plica {
namespace {

double rayleigh(double variance, double s) {
  return s / variance * std::exp(-s * s / (2 * variance));
}

// Expected s^k of a Rayleigh distribution.
double rayleigh_power(double variance, double k) {
  return std::pow(2 * variance, k / 2) * std::tgamma(1 + k / 2);
}

struct DirlikLaw {
  double D1 = 0, D2 = 0, D3 = 0, Q = 1, R = 1;
};

// One line, a1 = a2 = 1, leaves 0/0: the narrow band.
DirlikLaw dirlik(const SpectralMoments& m) {
  const double g = m.a2(), x = m.a1() * g;
  DirlikLaw law;
  law.D1 = 2 * (x - g * g) / (1 + g * g);
  if (1 - g < 1e-9 || law.D1 < 1e-12) return {.D3 = 1};
  const double rest = 1 - g - law.D1 + law.D1 * law.D1;
  law.R = (g - x - law.D1 * law.D1) / rest;
  law.D2 = rest / (1 - law.R);
  law.D3 = 1 - law.D1 - law.D2;
  law.Q = 1.25 * (g - law.D3 - law.D2 * law.R) / law.D1;
  return law;
}

double tovo_benasciutti_weight(const SpectralMoments& m) {
  const double a1 = m.a1(), a2 = m.a2();
  if (1 - a2 < 1e-9) return 1;
  return (a1 - a2) * (1.112 * (1 + a1 * a2 - (a1 + a2)) * std::exp(2.11 * a2) + (a1 - a2)) /
         ((a2 - 1) * (a2 - 1));
}

// int f^n over [a, b] of the straight line from ga to gb.
double line_moment(double n, double a, double b, double ga, double gb) {
  const auto power = [](double f, double p) { return std::pow(f, p) / p; };
  const double slope = (gb - ga) / (b - a);
  return (ga - slope * a) * (power(b, n + 1) - power(a, n + 1)) +
         slope * (power(b, n + 2) - power(a, n + 2));
}

} // namespace

double SpectralMoments::rms() const {
  return std::sqrt(m0);
}
double SpectralMoments::up_crossings() const {
  return std::sqrt(m2 / m0);
}
double SpectralMoments::peaks() const {
  return std::sqrt(m4 / m2);
}
double SpectralMoments::a075() const {
  return m075 / std::sqrt(m0 * m15);
}
double SpectralMoments::a1() const {
  return m1 / std::sqrt(m0 * m2);
}
double SpectralMoments::a2() const {
  return m2 / std::sqrt(m0 * m4);
}

// Three Gauss points between two lines: exact for whole n up to 4, and without the cancellation of
// a difference of powers where lines crowd round a resonance.
Eigen::VectorXd moment_weights(const Eigen::VectorXd& hertz, double n) {
  constexpr double outer = 0.77459666924148337704;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(hertz.size());
  for (Eigen::Index i = 1; i < hertz.size(); ++i) {
    const double a = hertz[i - 1], width = hertz[i] - a;
    for (const auto& [x, w] : {std::pair{-outer, 5. / 18}, {0., 4. / 9}, {outer, 5. / 18}}) {
      const double share = (1 + x) / 2, part = w * width * std::pow(a + share * width, n);
      weights[i - 1] += (1 - share) * part;
      weights[i] += share * part;
    }
  }
  return weights;
}

SpectralMoments spectral_moments(const Eigen::VectorXd& hertz, const Eigen::VectorXd& density) {
  if (hertz.size() != density.size() || hertz.size() < 2)
    throw std::invalid_argument("a density of " + std::to_string(density.size()) + " values at " +
                                std::to_string(hertz.size()) +
                                " frequencies; two or more lines, one value each");
  SpectralMoments m;
  for (Eigen::Index i = 0; i < hertz.size(); ++i) {
    if (!std::isfinite(hertz[i]) || hertz[i] < 0 || (i > 0 && hertz[i] <= hertz[i - 1]))
      throw std::invalid_argument("line " + std::to_string(i + 1) +
                                  ": frequencies increase, from 0 on");
    if (!std::isfinite(density[i]) || density[i] < 0)
      throw std::invalid_argument("line " + std::to_string(i + 1) +
                                  ": a density is finite and not below 0");
    if (i == 0) continue;
    const auto add = [&](double& moment, double n) {
      moment += line_moment(n, hertz[i - 1], hertz[i], density[i - 1], density[i]);
    };
    add(m.m0, 0);
    add(m.m075, 0.75);
    add(m.m1, 1);
    add(m.m15, 1.5);
    add(m.m2, 2);
    add(m.m4, 4);
  }
  if (!(m.m0 > 0)) throw std::invalid_argument("a density that is zero everywhere has no cycles");
  return m;
}

double cycle_density(SpectralMethod method, const SpectralMoments& m, double s) {
  if (method == SpectralMethod::narrow_band) return m.up_crossings() * rayleigh(m.m0, s);
  if (method == SpectralMethod::alpha_075)
    return m.a075() * m.a075() * m.up_crossings() * rayleigh(m.m0, s);
  if (method == SpectralMethod::tovo_benasciutti) {
    const double b = tovo_benasciutti_weight(m), a2 = m.a2();
    return b * m.up_crossings() * rayleigh(m.m0, s) +
           (1 - b) * m.peaks() * rayleigh(a2 * a2 * m.m0, s);
  }
  const DirlikLaw law = dirlik(m);
  const double z = s / m.rms(), R2 = law.R * law.R;
  return m.peaks() / m.rms() *
         (law.D1 / law.Q * std::exp(-z / law.Q) + law.D2 * z / R2 * std::exp(-z * z / (2 * R2)) +
          law.D3 * z * std::exp(-z * z / 2));
}

double power_rate(SpectralMethod method, const SpectralMoments& m, double k) {
  const double narrow = m.up_crossings() * rayleigh_power(m.m0, k);
  if (method == SpectralMethod::narrow_band) return narrow;
  if (method == SpectralMethod::alpha_075) return m.a075() * m.a075() * narrow;
  if (method == SpectralMethod::tovo_benasciutti) {
    const double b = tovo_benasciutti_weight(m);
    return narrow * (b + (1 - b) * std::pow(m.a2(), k - 1));
  }
  const DirlikLaw law = dirlik(m);
  return m.peaks() * std::pow(m.rms(), k) *
         (law.D1 * std::pow(law.Q, k) * std::tgamma(1 + k) +
          rayleigh_power(1, k) * (law.D2 * std::pow(std::abs(law.R), k) + law.D3));
}

SpectralDamage damage_rate(SpectralMethod method, const SpectralMoments& m,
                           const FatigueCurve& curve) {
  constexpr int panels = 16000; // even, Simpson's rule
  const double step = 40 * m.rms() / panels;
  SpectralDamage damage;
  double beyond = 0;
  for (int i = 1; i <= panels; ++i) { // none at no amplitude
    const double s = i * step, weight = i == panels ? 1 : i % 2 == 1 ? 4 : 2;
    const CurveLife N = life(curve, {.range = 2 * s, .mean = 0});
    const double part = weight * step / 3 * cycle_density(method, m, s) / N.cycles;
    damage.per_second += part;
    if (part > 0 && N.bound == Bound::at_least) damage.at_most = true;
    if (N.bound == Bound::at_most) beyond += part;
  }
  damage.at_least = beyond > 1e-3 * damage.per_second;
  return damage;
}

double expected_peak(const SpectralMoments& m, double seconds) {
  const double crossings = m.up_crossings() * seconds;
  if (!(crossings > std::exp(0.5)))
    throw std::invalid_argument("in " + short_text(seconds, 4) + " s the stress crosses zero " +
                                short_text(crossings, 4) +
                                " times: too short for an expected peak");
  const double g = std::sqrt(2 * std::log(crossings));
  return m.rms() * (g + 0.57721566490153286 / g);
}

double three_sigma(const SpectralMoments& m) {
  return 3 * m.rms();
}

} // namespace plica
