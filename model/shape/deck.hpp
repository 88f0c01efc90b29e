// The model of a deck as a part of a case.
#pragma once

#include "model/shape/deck_placing.hpp"
#include "solve/model.hpp"

namespace plica {

// The deck as a model of one component. Normals that are not given are the mean of those of the
// facets that meet at less than 20 degrees, as in Abaqus. A wall beside its nodes has nodes of its
// own, which follow them rigidly. Single DOFs along axes that are not global become rows between
// the DOFs of their node. Nodes that nothing uses are left away; DOFs that no element and no
// constraint reaches are held. Throws std::runtime_error for a shell without area, or folded, and
// std::invalid_argument for a coupling whose nodes determine no motion.
// `numbers`: of each node of the deck in the model, -1 where it is left away.
Model place(const DeckModel& deck, const DeckPlacing& placing, std::vector<int>* numbers = nullptr);

} // namespace plica
