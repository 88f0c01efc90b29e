#include "lab/measured/frf_set.hpp"

#include "words/sample_ranks.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {

Eigen::VectorXcd acceleration_of(const FrfSet& set, int reference, Eigen::Index response) {
  Eigen::VectorXcd H = set.H[std::size_t(reference)].col(response);
  const std::complex<double> i_omega(0, 2 * std::numbers::pi);
  for (int times = derivatives(set.quantity); times < 2; ++times)
    H.array() *= i_omega * set.hertz.array();
  return H;
}

FrfSet within(const FrfSet& set, double low, double high) {
  std::vector<int> lines;
  for (int f = 0; f < set.hertz.size(); ++f)
    if (set.hertz[f] >= low && set.hertz[f] <= high) lines.push_back(f);
  if (lines.empty())
    throw std::invalid_argument("no measured line lies between " + short_text(low, 5) + " and " +
                                short_text(high, 5) + " Hz");
  FrfSet part = set;
  part.hertz = set.hertz(lines).eval();
  for (Eigen::MatrixXcd& H : part.H) H = H(lines, Eigen::all).eval();
  for (Eigen::MatrixXd& s : part.sigma) s = s(lines, Eigen::all).eval();
  return part;
}

namespace {

double noise_of(const Eigen::VectorXd& hertz, const Eigen::VectorXcd& values) {
  std::vector<double> rest;
  for (Eigen::Index i = 1; i + 1 < hertz.size(); ++i) {
    const double a = (hertz[i + 1] - hertz[i]) / (hertz[i + 1] - hertz[i - 1]), b = 1 - a;
    const double square = std::norm(values[i] - a * values[i - 1] - b * values[i + 1]);
    rest.push_back(square / (1 + a * a + b * b));
  }
  if (rest.empty()) return 0;
  return std::sqrt(median(std::move(rest)) / std::log(2.)); // of an exponential distribution
}

} // namespace

Eigen::MatrixXd noise_levels(const FrfSet& set) {
  const auto responses = Eigen::Index(set.responses.size());
  Eigen::MatrixXd noise(responses, Eigen::Index(set.H.size())), rms = noise;
  for (Eigen::Index i = 0; i < noise.cols(); ++i)
    for (Eigen::Index o = 0; o < responses; ++o) {
      const Eigen::VectorXcd h = set.H[i].col(o);
      rms(o, i) = h.norm() / std::sqrt(double(h.size()));
      noise(o, i) = set.sigma.empty() ? noise_of(set.hertz, h) : set.sigma[i].col(o).mean();
    }
  return noise.cwiseMax(1e-3 * rms).cwiseMax(std::max(1e-300, 1e-9 * rms.maxCoeff()));
}

} // namespace plica
