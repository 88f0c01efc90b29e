// Decks of other codes, by the suffix of the file.
#pragma once

#include "model/deck.hpp"

#include <filesystem>
#include <memory>

namespace plica {

// .inp is Abaqus, .bdf .dat .nas .fem Nastran, in any case.
bool is_deck_file(const std::filesystem::path& file);

// A file is read once and kept. Throws InputError with file, line and card.
std::shared_ptr<const DeckModel> read_deck(const std::filesystem::path& file, UnknownCards unknown);

} // namespace plica
