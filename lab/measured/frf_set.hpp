// Measured or computed frequency responses of one setup.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace plica {

// What the response is over what the reference is: displacement, velocity or acceleration per
// force; acceleration per acceleration of the base.
enum class FrfQuantity { receptance, mobility, accelerance, transmissibility };

// Power of i w by which the quantity differs from displacement: 0, 1, 2, 2.
constexpr int derivatives(FrfQuantity quantity) {
  return quantity == FrfQuantity::receptance ? 0 : quantity == FrfQuantity::mobility ? 1 : 2;
}

struct FrfSet {
  FrfQuantity quantity = FrfQuantity::accelerance;
  Eigen::VectorXd hertz;               // increasing
  std::vector<std::string> responses;  // "mid.y": sensor and axis
  std::vector<std::string> references; // "base.y", or the driven channel
  std::vector<Eigen::MatrixXcd> H;     // per reference: frequencies x responses
  std::vector<Eigen::MatrixXd> sigma;  // standard deviation of |H|, same shapes; empty = unknown
  std::optional<double> level;         // of the excitation, m/s2 or N
  double resolution = 0;               // noise bandwidth of a line, Hz; 0 = not known
  double sweep_rate = 0;               // largest of a sine test, per s: (df/dt) / f; 0 = none
  std::vector<std::string> warnings;   // of the files it comes from
};

// A response as acceleration per unit of the reference: frequencies.
Eigen::VectorXcd acceleration_of(const FrfSet& set, int reference, Eigen::Index response);

// The lines between two frequencies. Throws std::invalid_argument when none is left.
FrfSet within(const FrfSet& set, double low, double high);

// Standard deviation of the noise of each response, responses x references: the stated one (mean
// over the lines), else what no straight line between the neighbours of a line explains (median
// over the lines, so that resonances do not count). Never below 1e-3 of the response's RMS, which
// no test is free of, and 1e-9 of the largest.
Eigen::MatrixXd noise_levels(const FrfSet& set);

} // namespace plica
