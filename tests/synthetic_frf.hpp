// Frequency responses of known modes, with noise on request.
#pragma once

#include "lab/measured/frf_set.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace plica::test {

struct TrueMode {
  double frequency, damping;
  Eigen::VectorXd shape; // mass-normalised
};

// H = (i w)^d sum phi_o phi_i / (w_r^2 - w^2 + 2 i zeta w_r w); channels p1.x, p2.x, ...;
// references the first ones.
inline FrfSet synthetic(const std::vector<TrueMode>& modes, FrfQuantity quantity, double low,
                        double high, int lines, int references) {
  constexpr double two_pi = 2 * std::numbers::pi;
  FrfSet set;
  set.quantity = quantity;
  set.hertz = Eigen::VectorXd::LinSpaced(lines, low, high);
  const Eigen::Index n = modes[0].shape.size();
  for (Eigen::Index o = 0; o < n; ++o) set.responses.push_back("p" + std::to_string(o + 1) + ".x");
  for (int i = 0; i < references; ++i) {
    set.references.push_back("p" + std::to_string(i + 1) + ".x");
    Eigen::MatrixXcd H = Eigen::MatrixXcd::Zero(lines, n);
    for (int f = 0; f < lines; ++f) {
      const double w = two_pi * set.hertz[f];
      for (const TrueMode& m : modes) {
        const double wr = two_pi * m.frequency;
        const std::complex<double> below(wr * wr - w * w, 2 * m.damping * wr * w);
        H.row(f) +=
            (m.shape[i] / below * std::pow(std::complex<double>(0, w), derivatives(quantity)) *
             m.shape.cast<std::complex<double>>())
                .transpose();
      }
    }
    set.H.push_back(H);
  }
  return set;
}

// Complex noise, `part` of the RMS of the largest reference.
inline void add_noise(FrfSet& set, double part, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  double largest = 0;
  for (const Eigen::MatrixXcd& H : set.H)
    largest = std::max(largest, H.norm() / std::sqrt(double(H.size())));
  for (Eigen::MatrixXcd& H : set.H)
    for (Eigen::Index k = 0; k < H.size(); ++k)
      H.data()[k] += part * largest / std::numbers::sqrt2 *
                     std::complex<double>(normal(random), normal(random));
}

// Modes of the benchmark: 12 to 58 Hz, four channels.
inline std::vector<TrueMode> four_dof() {
  const auto v = [](double a, double b, double c, double d) {
    return (Eigen::VectorXd(4) << a, b, c, d).finished();
  };
  return {{12, 0.008, v(0.4, 0.7, 0.9, 1)},
          {31, 0.012, v(0.9, 0.8, -0.1, -1)},
          {47, 0.006, v(1, -0.5, -0.8, 0.7)},
          {58, 0.015, v(0.6, -1, 0.9, -0.4)}};
}

} // namespace plica::test
