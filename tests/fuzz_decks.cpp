// Decks damaged at random: read and placed, or refused with their line. Nothing but InputError may
// come out of a reader, and of the placing what it says of shells and couplings. The seeds are
// fixed.
#include "io/decks/read_abaqus.hpp"
#include "io/decks/read_nastran.hpp"
#include "io/files/files.hpp"
#include "model/shape/deck.hpp"
#include "tests/fuzz_deck_seeds.hpp"
#include "tests/mutator.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

namespace plica::test {
namespace {

void fuzz_decks(unsigned seed, long rounds) {
  const TemporaryFolder folder("fuzz_decks");
  Mutator mutator(seed);
  int read = 0, refused = 0;
  const std::vector<DeckSeed> seeds = deck_seeds();
  double slowest = 0; // s
  for (long round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    const DeckSeed& own = seeds[mutator.below(seeds.size())];
    std::string text = own.text;
    for (std::size_t k = 0, n = 1 + mutator.below(2); k < n; ++k) mutator.damage(text);
    const auto file = folder.path / (own.nastran ? "model.bdf" : "model.inp");
    const auto unknown = round % 2 == 0 ? UnknownCards::list : UnknownCards::error;
    std::ofstream(file, std::ios::binary) << text;
    const auto start = std::chrono::steady_clock::now();
    try {
      const DeckModel deck = own.nastran ? read_nastran(file, unknown) : read_abaqus(file, unknown);
      ++read;
      try {
        place(deck, {});
      } catch (const std::runtime_error& error) { // of shells
        EXPECT_NE(std::string(error.what()), "");
      } catch (const std::invalid_argument& error) { // of couplings
        EXPECT_NE(std::string(error.what()), "");
      }
    } catch (const InputError& error) {
      ++refused;
      EXPECT_FALSE(error.problems().empty());
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    slowest = std::max(slowest, seconds);
    EXPECT_LT(seconds, 5) << "a deck of a few lines";
    if (testing::Test::HasFailure()) std::fprintf(stderr, "round %ld\n%s\n", round, text.c_str());
  }
  std::printf("%ld decks damaged: %d read, %d refused, the slowest in %.3f s\n", rounds, read,
              refused, slowest);
  EXPECT_GT(read, rounds / 20) << "the damage is so heavy that nothing is tried";
  EXPECT_GT(refused, rounds / 20);
}

TEST(DeckFuzz, seeds_are_read_as_they_are) {
  const TemporaryFolder folder("fuzz_decks");
  for (const DeckSeed& own : deck_seeds()) {
    const auto file = folder.path / (own.nastran ? "model.bdf" : "model.inp");
    write_whole(file, own.text);
    try {
      const DeckModel deck = own.nastran ? read_nastran(file, UnknownCards::error)
                                         : read_abaqus(file, UnknownCards::error);
      EXPECT_GT(place(deck, {}).mesh.nodes.size(), 2U);
    } catch (const std::exception& error) {
      ADD_FAILURE() << own.text << error.what();
    }
  }
}

TEST(DeckFuzz, few_damaged_decks_are_read_or_refused) {
  fuzz_decks(1, 4000);
}

TEST(DeckFuzzSlow, many_damaged_decks_are_read_or_refused) {
  fuzz_decks(2, fuzz_rounds());
}

} // namespace
} // namespace plica::test
