// Stationary random response to one input or several.
//
//   S_ab(f) = sum_kl H_ak(f) S_kl(f) conj(H_bl(f)),   RMS_a^2 = integral of S_aa over the band
//
// Spectral densities are one-sided, per Hz.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace plica {

// Density over frequency, straight lines in a log-log plot (the usual form of a shaker table's
// input); zero outside of its frequencies.
struct SpectralDensity {
  std::vector<std::array<double, 2>> table; // [Hz, unit2/Hz], increasing Hz, both > 0
};

// Cross-spectral matrix of several inputs: their densities with a coherence that is the same at
// every frequency, S_ab = gamma_ab sqrt(S_aa S_bb); or matrices over frequency, straight between
// and zero outside.
struct CrossSpectrum {
  std::vector<SpectralDensity> densities;
  Eigen::MatrixXcd coherence;                             // Hermitian, ones on its diagonal
  std::vector<std::pair<double, Eigen::MatrixXcd>> table; // in place of both
};
CrossSpectrum one_input(SpectralDensity density);
Eigen::MatrixXcd spectrum_at(const CrossSpectrum& inputs, double hertz);

// Neither Hermitian nor positive semidefinite within rounding: why, or empty.
std::string not_a_spectrum(const Eigen::MatrixXcd& S);

// A root L of it, S = L L^H; negative rounding is taken for zero.
Eigen::MatrixXcd root_of_spectrum(const Eigen::MatrixXcd& S);

double density_at(const SpectralDensity& input, double hertz);

// Density S_ab = sum_kl H_ak S_kl conj(H_bl) of two channels, k and l over the inputs;
// responses[k]: frequencies x channels, to input k alone.
Eigen::VectorXcd cross_density(const CrossSpectrum& inputs, const Eigen::VectorXd& hertz,
                               const std::vector<Eigen::MatrixXcd>& responses, int a, int b);

// The same of every channel with itself, frequencies x channels.
Eigen::MatrixXd response_density(const CrossSpectrum& inputs, const Eigen::VectorXd& hertz,
                                 const std::vector<Eigen::MatrixXcd>& responses);

// Root of the area under a density between two frequencies. Exact for a power law between
// neighbouring frequencies, so that a straight line of a log-log plot costs no points.
double rms(const Eigen::VectorXd& hertz, const Eigen::VectorXd& density, double low, double high);

} // namespace plica
