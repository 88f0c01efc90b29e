// The numbers of a certificate with their names, for text, JSON and report alike.
#pragma once

#include "reduction/certificate.hpp"

#include <cmath>

namespace plica {

struct CertificateLine {
  const char* key;
  const char* text;
  double value;
};

inline std::vector<CertificateLine> certificate_lines(const Certificate& c) {
  std::vector<CertificateLine> lines{
      {"asymmetry", "asymmetry of K and M", c.asymmetry},
      {"smallest_mass", "smallest eigenvalue of M / largest", c.smallest_mass},
      {"negative_stiffness", "most negative eigenvalue of K / largest", c.negative_stiffness},
      {"grounding", "force of a rigid motion / stiffness", c.grounding},
      {"rigid_modes", "lowest six modes off the rigid motions", c.rigid_modes},
      {"coordinates", "coordinates found from K off the drawn ones, m", c.coordinates},
      {"mass", "mass off that of the part", c.mass},
      {"centre", "centre of mass off that of the part, m", c.centre},
      {"inertia", "inertia off that of the part", c.inertia}};
  if (std::isfinite(c.statics))
    lines.push_back({"statics", "static stiffness off that of the part", c.statics});
  if (c.statics_known_to > 0)
    lines.push_back({"statics_known_to", "the part's own is known to", c.statics_known_to});
  return lines;
}

} // namespace plica
