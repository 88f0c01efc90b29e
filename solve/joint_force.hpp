// Force of a joint in periodic motion, harmonic by harmonic: alternating frequency and time (AFT),
// or its first harmonic alone by the describing function.
//
//   x(t) = x_0 + Re sum_n x_n e^{i n w t};   real unknowns, in the order of the harmonics:
//   x_0, or Re x_n, Im x_n
#pragma once

#include "elements/joint_law.hpp"

namespace plica {

// Harmonics of a joint and its values at equal steps of a period.
struct HarmonicBasis {
  std::vector<int> orders;      // increasing
  Eigen::MatrixXd to_time;      // samples x unknowns
  Eigen::MatrixXd to_rate;      // the same for the derivative by w t
  Eigen::MatrixXd to_harmonics; // unknowns x samples
  Eigen::MatrixXd sums;         // unknowns x (samples + 1): running sums of to_harmonics

  // Throws std::invalid_argument for fewer samples than 2 (highest order + 1) + 1.
  HarmonicBasis(std::vector<int> harmonics, int samples);

  Eigen::Index size() const { return to_time.cols(); }
  // Where harmonic number k begins among the unknowns; the constant has one, the others two.
  Eigen::Index first(std::size_t k) const {
    return orders[0] == 0 ? 2 * Eigen::Index(k) - (k > 0) : 2 * Eigen::Index(k);
  }
};

std::complex<double> amplitude(const HarmonicBasis& basis,
                               const Eigen::Ref<const Eigen::VectorXd>& unknowns, std::size_t k);

Eigen::VectorXd unknowns(const HarmonicBasis& basis,
                         const Eigen::Ref<const Eigen::VectorXcd>& amplitudes);

// Place of harmonic 1 among the orders; their number if it is not there.
Eigen::Index first_harmonic(const std::vector<int>& orders);

// 1, 3, 5 .. or, for laws that are not odd, 0, 1, 2 ..
std::vector<int> orders_up_to(int highest, bool odd);

// Force with its derivatives by the motion (unknowns x unknowns) and by omega.
struct HarmonicForce {
  Eigen::VectorXd force;
  Eigen::MatrixXd by_motion;
  Eigen::VectorXd by_omega;
};

// By AFT. The derivatives are those of the sampled law: a slider that sticks has kept the force it
// had when it slipped last.
HarmonicForce harmonic_force(const JointLaw& law, const Eigen::VectorXd& motion, double omega,
                             const HarmonicBasis& basis);

// By the describing function; the basis holds harmonic 1 alone.
HarmonicForce linearised_force(const JointLaw& law, const Eigen::VectorXd& motion, double omega);

} // namespace plica
