// Supports: constraints without terms, which hold their DOF at zero.
#pragma once

#include "solve/model.hpp"

#include <algorithm>

namespace plica {

inline bool has_supports(const Model& model) {
  return std::any_of(model.constraints.begin(), model.constraints.end(),
                     [](const Constraint& row) { return row.terms.empty(); });
}

} // namespace plica
