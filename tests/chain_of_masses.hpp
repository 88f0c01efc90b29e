// Chains of equal masses and springs between two walls, whose modes are known in closed form
//
//   f_j = f_0 2 sin(j pi / (2 (n + 1))),   shape_ij = sqrt(2 / (n + 1)) sin(i j pi / (n + 1))
//
// (Meirovitch, Fundamentals of Vibrations, 7.9), let go or shaken by noise on every mass.
#pragma once

#include "lab/signals/time_record.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace plica::test {

struct Chain {
  int masses = 4;
  double f0 = 20; // Hz, of one mass on one spring, over 2 pi
  std::vector<double> damping{0.01, 0.012, 0.008, 0.015};

  double frequency(int j) const { // from 0
    return 2 * f0 * std::sin((j + 1) * std::numbers::pi / (2. * (masses + 1)));
  }
  Eigen::VectorXd shape(int j) const {
    Eigen::VectorXd s(masses);
    for (int i = 0; i < masses; ++i)
      s[i] = std::sqrt(2. / (masses + 1)) *
             std::sin((i + 1) * (j + 1) * std::numbers::pi / (masses + 1));
    return s;
  }
  std::complex<double> pole(int j) const {
    const double w = 2 * std::numbers::pi * frequency(j), z = damping[std::size_t(j)];
    return {-z * w, w * std::sqrt(1 - z * z)};
  }
};

inline TimeRecord record_of(const Chain& chain, double rate, Eigen::MatrixXd samples) {
  TimeRecord record{.name = "record",
                    .rate = rate,
                    .channels = {},
                    .samples = std::move(samples),
                    .warnings = {}};
  for (int i = 0; i < chain.masses; ++i)
    record.channels.push_back("m" + std::to_string(i + 1) + ".x");
  return record;
}

inline void add_white_noise(Eigen::MatrixXd& samples, double sigma, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, sigma);
  for (Eigen::Index k = 0; k < samples.size(); ++k) samples.data()[k] += normal(random);
}

// Velocities after a blow of 1 on one mass at `before` seconds, at rest until then; `stop` seconds
// in all.
inline TimeRecord let_go(const Chain& chain, int struck, double rate, double stop,
                         double before = 0) {
  const auto samples = Eigen::Index(stop * rate);
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(samples, chain.masses);
  for (int j = 0; j < chain.masses; ++j) {
    const std::complex<double> l = chain.pole(j);
    const Eigen::VectorXd shape = chain.shape(j);
    for (Eigen::Index n = 0; n < samples; ++n) {
      const double t = double(n) / rate - before;
      if (t < 0) continue;
      // d/dt of e^(-z w t) sin(w_d t) / w_d
      y.row(n) += shape[struck] * (l * std::exp(l * t)).imag() / l.imag() * shape.transpose();
    }
  }
  return record_of(chain, rate, y);
}

// Velocities under independent white forces on all masses, held over a sample: of such forces the
// sampled modes have exactly the poles of the chain.
inline TimeRecord shaken(const Chain& chain, double rate, Eigen::Index samples, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(samples, chain.masses);
  for (int j = 0; j < chain.masses; ++j) {
    const std::complex<double> l = chain.pole(j), mu = std::exp(l / rate), b = (mu - 1.) / l;
    const Eigen::RowVectorXd shape = chain.shape(j).transpose();
    std::complex<double> z = 0;
    for (Eigen::Index n = -Eigen::Index(10 * rate); n < samples; ++n) {
      if (n >= 0) y.row(n) += (l * z).imag() / l.imag() * shape;
      z = mu * z + b * normal(random); // shapes are orthogonal: forces of modes are independent
    }
  }
  return record_of(chain, rate, y);
}

// Standard deviation of a sample.
inline double deviation(const Eigen::VectorXd& x) {
  return std::sqrt((x.array() - x.mean()).square().sum() / double(x.size() - 1));
}

} // namespace plica::test
