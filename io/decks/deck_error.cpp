#include "io/decks/deck_error.hpp"

#include <map>

namespace plica {

void DeckProblems::raise() const {
  if (found_.empty()) return;
  constexpr std::size_t said = 2, most = 50;
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> alike;
  std::vector<InputProblem> all;
  for (const InputProblem& p : found_) {
    std::vector<std::size_t>& places = alike[{p.key, p.allowed}];
    places.push_back(all.size());
    if (places.size() <= said) all.push_back(p);
  }
  for (const auto& [kind, places] : alike)
    if (places.size() > said)
      all[places[said - 1]].wrong +=
          " (and " + std::to_string(places.size() - said) + " more of this kind)";
  if (all.size() > most) all.resize(most);
  throw InputError(all);
}

} // namespace plica
