// Modes of measured frequency responses: pLSCF, automatic reading of the stabilisation diagram, a
// least-squares fit of all responses, and what proves or doubts each mode.
#pragma once

#include "lab/identification/identification.hpp"

namespace plica {

struct IdentifySettings {
  double low = 0, high = 0; // band, Hz; 0 = all lines
  int highest_order = 0;    // of the polynomial; 0 = 40, 30, 24 for one, two, more references
};

// Throws std::invalid_argument for a band without lines or too few of them.
Identification identify(const FrfSet& set, const IdentifySettings& settings);

} // namespace plica
