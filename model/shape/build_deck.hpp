// Parts that a deck of another code describes.
#pragma once

#include "model/description/case.hpp"
#include "model/shape/deck_placing.hpp"
#include "solve/model.hpp"

namespace plica {

DeckPlacing placing_of(const DeckPart& part);

// The deck of a part, put where the case says, with its sets and places; of one component. Throws
// std::runtime_error with what is wrong.
Model deck_model(const DeckPart& part);

// Adds all of a model but its components; sets are prefixed with "name.", elements belong to
// `component`.
void append(Model& model, const Model& part, const std::string& name, int component);

} // namespace plica
