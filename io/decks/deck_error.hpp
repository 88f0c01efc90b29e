// What is wrong in a deck, with the file and line of the card.
#pragma once

#include "model/input_error.hpp"

#include <string>
#include <vector>

namespace plica {

struct DeckPosition {
  std::string file;
  int line = 0;
};

[[noreturn]] inline void deck_error(const DeckPosition& at, const std::string& card,
                                    const std::string& wrong, const std::string& allowed) {
  throw InputError({{at.file, at.line, card, wrong, allowed}});
}

} // namespace plica
