// What the probes read when the table moves: linear by all modes, nonlinear by integration in time.
#pragma once

#include "bench.hpp"

#include <complex>
#include <vector>

namespace sealed {

using Eigen::MatrixXcd;
using Eigen::VectorXcd;

// Modes of one assembly on the table, as they are that day.
struct Assembly {
  Modes modes;
  VectorXd zeta;
};

Assembly assemble_anew(const Bench& bench, Draws draws);

// Absolute acceleration at the probes over that of the table, lines x 3 a probe, as the channels
// give them. Without joints' nonlinearity.
MatrixXcd linear_response(const Bench& bench, const Assembly& assembly, int base,
                          const VectorXd& frequencies);

// The same with it, at a level in m/s2, by the first harmonic of the steady state.
MatrixXcd nonlinear_response(const Bench& bench, const Assembly& assembly, int base, double level,
                             const VectorXd& frequencies);

// Pieces of both.
VectorXd table_motion(const Bench& bench, int base);
// Modal amplitudes over the table's acceleration when `drive` is the modal mass times its motion.
VectorXcd modal_motion(const Assembly& a, const VectorXcd& drive, double w);
// The channels of all probes for an absolute acceleration of the unknowns.
VectorXcd read_probes(const Bench& bench, const VectorXcd& acceleration, double frequency);

// Slip, gap and cubic stiffness that the effects state against the largest linear motion at
// 5 m/s2, in the frequencies, made absolute. Returns the largest slip force or 0.
double scale_nonlinear(Bench& bench, const std::vector<int>& bases, const VectorXd& frequencies);

} // namespace sealed
