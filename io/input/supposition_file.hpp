// Reads effects that somebody supposes (YAML), strictly.
//
//   effects:
//     - {effect: added_mass, place: sensor.mid, value: {mass: 20 g}}
#pragma once

#include "model/description/diagnosis_request.hpp"

#include <map>
#include <string>

namespace plica {

struct SuppositionFile {
  Supposition data;
  std::string path;                 // as given
  std::map<std::string, int> lines; // key path -> line
};

// Throws InputError with all problems of the file.
SuppositionFile read_supposition(const std::string& path);

} // namespace plica
