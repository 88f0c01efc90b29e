// Axes of displacements of a universal file: data sets 18 and 2420.
#pragma once

#include "io/universal/file.hpp"

#include <map>
#include <string>

namespace plica {

struct DisplacementAxes {
  bool straight = true; // cylindrical and spherical ones turn from place to place
  Eigen::Matrix3d axes; // rows: its x, y and z in those of the file
};

// By label. Throws InputError for a set that is cut off or whose axes are not orthogonal.
std::map<int, DisplacementAxes> displacement_axes(const UniversalText& set,
                                                  const std::string& file);

} // namespace plica
