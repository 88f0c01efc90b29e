// All that a beam resists with.
#pragma once

#include "elements/beam_section.hpp"

namespace plica {

inline void scale_stiffness(BeamProperties& b, double factor) {
  for (double* n : {&b.EA, &b.EI_y, &b.EI_z, &b.GJ, &b.GA_y, &b.GA_z}) *n *= factor;
}

} // namespace plica
