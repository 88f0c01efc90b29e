// Dynamic stiffness beside what a rig measured.
#pragma once

#include "lab/measured/measured_stiffness.hpp"
#include "reduction/dynamic_stiffness.hpp"

namespace plica {

struct StiffnessComparison {
  MeasuredStiffness measured;
  double computed = 0; // as measured.value; NaN = not found
};

// k_21 (blocked transfer) or k_11 of one direction: Z of the first end by the first, less the rows
// of the second.
std::complex<double> transfer_stiffness(const Complex1212& Z, int direction);
std::complex<double> driving_point_stiffness(const Complex1212& Z, int direction, int end = 0);

// "y storage", "rx driving point loss".
std::string measured_name(const MeasuredStiffness& m);

// At the very frequencies and amplitudes of the test, in the first state.
std::vector<StiffnessComparison> compare_stiffness(const EndDynamicStiffness& computed,
                                                   const std::vector<MeasuredStiffness>& measured,
                                                   int harmonics, int samples);

} // namespace plica
