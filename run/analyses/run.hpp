// Runs the analyses of a case.
#pragma once

#include "model/shape/build.hpp"
#include "run/analyses/seen_enough.hpp"
#include "run/results/results.hpp"
#include "run/stages.hpp"

namespace plica {

class ReductionMemory; // reduction/substructures.hpp

// `stage` is told the name of each step as it begins. Throws InputError as build() does, with a
// sentence; TooLarge for what the machine's memory does not hold, before anything is assembled;
// std::runtime_error for numerical trouble that leaves no result. A proof that failed is
// in Results::verification. `memory`: reductions of earlier runs, none of which is repeated.
// `shapes`: where they are left out, Results::mesh is empty, too; all numbers are the same.
Results run(const Case& data, const StageListener& stage, ReductionMemory* memory = nullptr,
            Shapes shapes = Shapes::kept);

} // namespace plica
