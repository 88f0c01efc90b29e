// Cards of loads, one by one.
#pragma once

#include "io/decks/keywords.hpp"
#include "io/decks/nastran_grids.hpp"

namespace plica {

// f(card) for each of a name. What is wrong with a card stands against the loads that it is of, and
// concerns who asks for them alone.
template <class F>
void each_load_card(const CardsByName& loads, const std::string& name, DeckLoadCase& into, F&& f) {
  const auto found = loads.find(name);
  if (found == loads.end()) return;
  for (const Card* card : found->second) try {
      f(*card);
    } catch (const InputError& error) {
      for (const InputProblem& p : error.problems()) into.not_had.push_back(to_string(p));
    }
}

} // namespace plica
