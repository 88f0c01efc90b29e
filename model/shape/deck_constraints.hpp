// Couplings, equations and supports of a deck as constraints of a model.
#pragma once

#include "model/shape/deck_placing.hpp"
#include "solve/model.hpp"

namespace plica {

// Adds them to a model whose nodes are those of the deck. Rows along axes that are not global
// become rows between the DOFs of their node; supports only if the placing wants the deck held.
void add_deck_constraints(Model& model, const DeckModel& deck, const DeckPlacing& placing);

} // namespace plica
