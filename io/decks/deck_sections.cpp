#include "io/decks/deck_sections.hpp"

#include <utility>

namespace plica {

BeamProperties general_section(const BeamMaterial& m, double A, double I_y, double I_z, double J) {
  return {.EA = m.E * A,
          .EI_y = m.E * I_y,
          .EI_z = m.E * I_z,
          .GJ = m.E / (2 * (1 + m.nu)) * J,
          .mass = m.rho * A,
          .inertia_x = m.rho * (I_y + I_z),
          .inertia_y = m.rho * I_y,
          .inertia_z = m.rho * I_z,
          .E = m.E};
}

BeamProperties turned(BeamProperties section) {
  std::swap(section.EI_y, section.EI_z);
  std::swap(section.GA_y, section.GA_z);
  std::swap(section.inertia_y, section.inertia_z);
  for (auto& fibre : section.fibres) std::swap(fibre[0], fibre[1]);
  return section;
}

} // namespace plica
