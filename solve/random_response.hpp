// Stationary random response to one input.
//
//   S_ab(f) = H_a(f) S_in(f) conj(H_b(f)),   RMS_a^2 = integral of S_aa over the band
//
// Spectral densities are one-sided, per Hz.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace plica {

// Density over frequency, straight lines in a log-log plot (the usual form of a shaker table's
// input); zero outside of its frequencies.
struct SpectralDensity {
  std::vector<std::array<double, 2>> table; // [Hz, unit2/Hz], increasing Hz, both > 0
};

double density_at(const SpectralDensity& input, double hertz);

// Auto densities, frequencies x channels, from responses to a unit input.
Eigen::MatrixXd response_density(const SpectralDensity& input, const Eigen::VectorXd& hertz,
                                 const Eigen::MatrixXcd& response);

// Cross density of two channels.
Eigen::VectorXcd cross_density(const SpectralDensity& input, const Eigen::VectorXd& hertz,
                               const Eigen::MatrixXcd& response, int a, int b);

// Root of the area under a density between two frequencies. Exact for a power law between
// neighbouring frequencies, so that a straight line of a log-log plot costs no points.
double rms(const Eigen::VectorXd& hertz, const Eigen::VectorXd& density, double low, double high);

} // namespace plica
