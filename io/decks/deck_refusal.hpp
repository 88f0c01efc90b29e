// What a deck has and a reader has not, and what it passes over: said once, with numbers.
#pragma once

#include "io/decks/deck_error.hpp"
#include "model/description/deck_model.hpp"

namespace plica {

inline constexpr const char* changes_nothing =
    "passed over, since they change neither stiffness nor mass";
inline constexpr const char* loads_of_decks = "loads, which act where the case says static: deck";

// Cards that are passed over, in one note: "passed over, since they change neither stiffness nor
// mass: 12 CDAMP2, PARAM".
class PassedCards {
public:
  void add(const std::string& card) { ++counts_[card]; }
  void finish(DeckModel& deck, const char* why = changes_nothing) const;

private:
  std::map<std::string, int> counts_;
};

// Cards that are not had, each once, most frequent first, with their number and first line. Solids
// are one problem together, with their share of the elements of the deck.
class MissingCards {
public:
  explicit MissingCards(bool listed) : listed_(listed) {}

  void count_element(bool is_one) { elements_ += is_one; } // of any kind but solids
  void add(const std::string& card, const std::string& what, const DeckPosition& at);
  void add_solid(const std::string& card, bool is_element, const DeckPosition& at, int count = 1);
  // As problems, or, where the user wants them listed, as what is left out of the deck.
  void finish(DeckProblems& problems, DeckModel& deck, const std::string& allowed) const;

private:
  struct Missing {
    std::string what;
    DeckPosition at;
    int count = 0;
  };
  bool listed_;
  int elements_ = 0, solid_elements_ = 0;
  std::map<std::string, Missing> missing_, solids_;
};

} // namespace plica
