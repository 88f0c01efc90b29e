// Decks that are damaged at random.
#pragma once

#include "tests/fuzz_abaqus_seeds.hpp"
#include "tests/fuzz_nastran_seeds.hpp"

#include <vector>

namespace plica::test {

struct DeckSeed {
  const char* text;
  bool nastran;
};

inline std::vector<DeckSeed> deck_seeds() {
  std::vector<DeckSeed> seeds;
  for (const char* text : abaqus_seeds) seeds.push_back({text, false});
  for (const char* text : nastran_seeds) seeds.push_back({text, true});
  return seeds;
}

} // namespace plica::test
