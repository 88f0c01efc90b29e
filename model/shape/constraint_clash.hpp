// Two constraints that determine the same degree of freedom, in words of the case.
#pragma once

#include "solve/constraints.hpp"

namespace plica {

// Throws InputError at the key of a cap, a mass or an interlock that took part, with what to do.
[[noreturn]] void refuse_clash(const ConstraintError& error);

// eliminate() with errors in these words.
DofMap eliminate_constraints(const Model& model);

} // namespace plica
