// Two constraints that determine the same degree of freedom, in words of the case.
#pragma once

#include "solve/constraints.hpp"

namespace plica {

// The constraints of a model from this one on are those that a key of the case asks for.
void asked_at(Model& model, std::size_t first, const std::string& key);

// Throws InputError at the key of the case that took part, with what to do.
[[noreturn]] void refuse_clash(const ConstraintError& error);

// eliminate() with errors in these words.
DofMap eliminate_constraints(const Model& model);

} // namespace plica
