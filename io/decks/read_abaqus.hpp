// Reads an Abaqus deck (.inp), flat: without parts and instances. What it follows, keyword by
// keyword: docs/decks.md. Steps are read for what they hold alone; what is computed says the case.
#pragma once

#include "io/decks/deck_error.hpp"
#include "model/description/case.hpp"
#include "model/description/deck_model.hpp"

#include <filesystem>

namespace plica {

// Throws InputError with file, line and keyword.
DeckModel read_abaqus(const std::filesystem::path& file, UnknownCards unknown);

} // namespace plica
