// A model seen by its rotational symmetry.
#pragma once

#include "model/description/case.hpp"
#include "reduction/cyclic_model.hpp"

#include <string>
#include <variant>

namespace plica {

// The model by its rotational symmetry, or why it has none. Throws InputError when it is required.
using SymmetricView = std::variant<CyclicModel, std::string>;
SymmetricView symmetric_view(const Model& model, Symmetry asked);

} // namespace plica
