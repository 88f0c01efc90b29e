// A change of a case file.
#pragma once

#include "model/description/case.hpp"

#include <string>
#include <vector>

namespace plica {

// A path of the file, and what stands there then: YAML, in SI.
struct CaseEdit {
  std::string path, value;
};
using CaseEdits = std::vector<CaseEdit>;

} // namespace plica
