// Auto- and cross-spectral densities by Welch's method.
//
//   S_ab(f) = 2 / (K fs sum w^2) sum_k conj(A_k(f)) B_k(f)     one-sided, unit_a unit_b / Hz
//
// over K blocks that overlap, each without its mean and under a window w. At 0 Hz and at half the
// sampling rate the factor 2 is 1. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70-73; Bendat
// and Piersol, Random Data, ch. 8 and 11.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace plica {

enum class Window { rectangular, hann, hamming, flat_top };

// Periodic: w_n = w(n / N), n = 0 .. N-1.
Eigen::VectorXd window_samples(Window window, int length);

// Of a window, in bins: N sum w^2 / (sum w)^2.
double noise_bandwidth(const Eigen::VectorXd& w);

struct WelchSettings {
  int block = 1024;     // samples; 0 = usual_block()
  double overlap = 0.5; // of a block, 0 <= overlap < 1
  Window window = Window::hann;
};

// The power of two that leaves about twenty overlapping blocks, 256 at least.
int usual_block(Eigen::Index samples);

// Number of blocks that a record holds.
int block_count(Eigen::Index samples, const WelchSettings& settings);

// Independent blocks with the same scatter: K / (1 + 2 sum (1 - q/K) rho_q^2), rho_q the
// correlation of the windows of blocks q apart (Welch's eq. for white noise).
double effective_averages(int blocks, const WelchSettings& settings);

// Densities between references x and responses y.
struct Spectra {
  Eigen::VectorXd hertz;
  std::vector<Eigen::MatrixXcd> xx; // per frequency: references x references
  std::vector<Eigen::MatrixXcd> xy; // references x responses
  Eigen::MatrixXd yy;               // auto densities, frequencies x responses
  int blocks = 0;
  double averages = 0;   // effective
  double resolution = 0; // noise bandwidth, Hz
};

// `samples` one channel a column; references and responses are columns of it. Throws
// std::invalid_argument for less than one block, a block below 8, an overlap out of range, a
// channel that is not there.
Spectra welch(const Eigen::MatrixXd& samples, double rate, const std::vector<int>& references,
              const std::vector<int>& responses, const WelchSettings& settings);

// Root of the area under each density between two frequencies (rectangle rule over whole lines and
// the parts of lines at the ends).
Eigen::VectorXd band_rms(const Eigen::VectorXd& hertz, const Eigen::MatrixXd& density, double low,
                         double high);

} // namespace plica
