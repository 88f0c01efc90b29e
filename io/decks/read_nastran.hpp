// Reads a Nastran deck (.bdf, .dat, .nas, .fem). What it follows, card by card: docs/decks.md.
#pragma once

#include "io/decks/deck_error.hpp"
#include "model/description/case.hpp"
#include "model/description/deck_model.hpp"

#include <filesystem>

namespace plica {

// Throws InputError with file, line and card.
DeckModel read_nastran(const std::filesystem::path& file, UnknownCards unknown);

} // namespace plica
