// Fatigue under a stationary Gaussian stress of zero mean, from its one-sided density G(f).
//
//   m_n = int f^n G df (f in Hz)        variance m0, up-crossings of zero nu0 = sqrt(m2 / m0),
//   peaks nu_p = sqrt(m4 / m2),         a1 = m1 / sqrt(m0 m2), a2 = m2 / sqrt(m0 m4) = nu0 / nu_p
//
// Each method is a density of cycles per second over their amplitude s, with z = s / sqrt(m0):
//   narrow band          nu0 Rayleigh(m0)                                        (Miles 1954)
//   Dirlik               nu_p / sqrt(m0) [D1/Q e^(-z/Q) + D2 z/R^2 e^(-z^2/2R^2) + D3 z e^(-z^2/2)]
//                        (Dirlik, thesis, Warwick 1985)
//   Tovo and Benasciutti b nu0 Rayleigh(m0) + (1 - b) nu_p Rayleigh(a2^2 m0), their b of 2005
//                        (Int. J. Fatigue 27, 867-877)
//   alpha 0.75           narrow band times a075^2, a075 = m075 / sqrt(m0 m15)    (Lutes et al.
//   1984)
// so that with N = C / s^k the damage per second of the narrow band is
//   nu0 (2 m0)^(k/2) Gamma(1 + k/2) / C.
//
// Limits: Gaussian, stationary; the narrow band is on the safe side, by much for wide bands.
#pragma once

#include "life/curves.hpp"

#include <Eigen/Core>

namespace plica {

enum class SpectralMethod { narrow_band, dirlik, tovo_benasciutti, alpha_075 };

struct SpectralMoments {
  double m0 = 0, m075 = 0, m1 = 0, m15 = 0, m2 = 0, m4 = 0; // Pa^2 Hz^n

  double rms() const;          // Pa
  double up_crossings() const; // nu0, Hz
  double peaks() const;        // nu_p, Hz
  double a075() const;
  double a1() const;
  double a2() const; // irregularity
};

// Weights w_i with which sum w_i G_i is the integral of f^n G, G straight between the lines.
Eigen::VectorXd moment_weights(const Eigen::VectorXd& hertz, double n);

// Exact for a density that is straight between its lines. `hertz` increasing, from 0 on; density in
// Pa^2/Hz, >= 0. For those who have a density; runs weigh shapes of stress (moment_weights). Throws
// std::invalid_argument.
SpectralMoments spectral_moments(const Eigen::VectorXd& hertz, const Eigen::VectorXd& density);

// Cycles per second and Pa of amplitude.
double cycle_density(SpectralMethod method, const SpectralMoments& moments, double amplitude);

// Expected sum of amplitude^k over the cycles of one second, Pa^k / s: over C, the damage by N = C
// / s^k. In closed form, for those whose curve is one power law; runs take damage_rate.
double power_rate(SpectralMethod method, const SpectralMoments& moments, double k);

// Miner's sum of one second, cycles of zero mean, by numerical integration over amplitudes up to 40
// times the RMS (relative error 1e-4 at a knee, far less elsewhere). A share by cycles beyond the
// curve is bounded as in MinerSum: `at_most` where small cycles are below it. An upper end of the
// curve counts as reached when cycles beyond it do a thousandth of the damage.
struct SpectralDamage {
  double per_second = 0;
  bool at_most = false, at_least = false;
};
SpectralDamage damage_rate(SpectralMethod method, const SpectralMoments& moments,
                           const FatigueCurve& curve);

// Expected largest value in a duration (Davenport 1964), Pa: rms (g + 0.5772 / g), g = sqrt(2
// ln(nu0 T)), of one sign. Throws std::invalid_argument unless nu0 T > e^(1/2): too short to have
// one.
double expected_peak(const SpectralMoments& moments, double seconds);

double three_sigma(const SpectralMoments& moments); // Pa

} // namespace plica
