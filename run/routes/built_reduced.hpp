// A built case with a superelement in place of every part between caps.
#pragma once

#include "model/shape/build.hpp"
#include "reduction/substructures.hpp"

namespace plica {

// Caps, and, with symmetry, what carries a body, a spring or a beam on a wall and what surrounds a
// dent: where parts meet or symmetry would end.
std::vector<int> interface_nodes(const BuiltCase& built, bool symmetry);

// As a run asks for it.
PartReductionRequest part_reduction_request(const Analyses& analyses);

// Throws InputError for a part that no cap joins.
CutModel cut_between_caps(const BuiltCase& built, bool symmetry);

// Throws InputError for a part that cannot be reduced.
ReducedModel reduced_model(CutModel pieces, const PartReductionRequest& request,
                           const PartReducer& reduce = reduce_here());
ReducedModel reduced_model(const BuiltCase& built, const std::vector<int>& interface_nodes,
                           const PartReductionRequest& request,
                           const PartReducer& reduce = reduce_here());

// "5 superelements of 3 reductions; rotational symmetry, 40 sectors"
std::string route_name(const ReducedModel& reduced);

} // namespace plica
