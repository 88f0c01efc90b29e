// Decks of other codes, by deck_format().
#pragma once

#include "model/description/case.hpp"
#include "model/description/deck_model.hpp"

#include <filesystem>
#include <memory>

namespace plica {

// A file is read once and kept. Throws InputError with file, line and card.
std::shared_ptr<const DeckModel> read_deck(const std::filesystem::path& file, UnknownCards unknown);

} // namespace plica
