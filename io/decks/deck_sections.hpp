// Sections of beams that decks name by their shape.
#pragma once

#include "elements/beam_section.hpp"

namespace plica {

// A section of stiffness: area, second moments about the local y and z, torsion constant. Rotary
// inertia with the same second moments. Rigid in shear until told otherwise.
BeamProperties general_section(const BeamMaterial& material, double A, double I_y, double I_z,
                               double J);

// Exchanges the local y and z.
BeamProperties turned(BeamProperties section);

} // namespace plica
