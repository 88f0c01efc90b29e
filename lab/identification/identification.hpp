// What is known of the modes of measured frequency responses.
#pragma once

#include "lab/identification/stabilisation.hpp"
#include "lab/measured/frf_set.hpp"

#include <limits>

namespace plica {

struct IdentifiedMode {
  double frequency = 0, damping = 0;             // Hz, fraction of critical
  double sigma_frequency = 0, sigma_damping = 0; // standard deviations
  Eigen::VectorXcd shape;         // per response; mass-normalised, or its largest component 1
  Eigen::VectorXd sigma_shape;    // of real and imaginary part each
  Eigen::VectorXcd participation; // per reference
  bool mass_normalised = false;   // a reference is also a response of it, per force
  double collinearity = 0;        // of the shape, 1 = real
  double rank = 0;  // second singular value of the residues / first: 0 = one mode, not two
  double share = 0; // RMS of what the mode gives to all responses / RMS of these, in the band
  int orders = 0;   // of the diagram that show it
  double consistency = std::numeric_limits<double>::quiet_NaN(); // of decays: free_decays.hpp
  // The same mode from one response alone, that in which it is largest; NaN where that fails.
  std::string strongest;
  double peak_frequency = 0, peak_damping = 0;     // peak picking
  double circle_frequency = 0, circle_damping = 0; // circle fit
};

// What the modes come from: frequency responses, free decays, or responses to what nobody measured.
enum class IdentifiedFrom { responses, decays, output };

struct Identification {
  IdentifiedFrom source = IdentifiedFrom::responses;
  FrfSet set;                                // the band that was used; of decays their spectra, of
                                             // outputs the roots of their densities, unit/sqrt(Hz)
  std::vector<Eigen::MatrixXcd> synthesised; // its responses from the modes; of outputs empty
  std::vector<IdentifiedMode> modes;         // by frequency
  std::vector<DiagramPole> diagram;
  Eigen::MatrixXd frac; // measured beside synthesised, responses x references; of outputs empty
  Eigen::MatrixXd auto_mac;
  double misfit = 0; // RMS of the difference / RMS of the responses
  std::vector<std::string> warnings;
};

} // namespace plica
