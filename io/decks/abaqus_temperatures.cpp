// Temperatures of the steps of an Abaqus deck as strains: alpha (T - T0), T0 of *INITIAL CONDITIONS
// or zero, means over the nodes of an element.
#include "io/decks/abaqus_loads.hpp"

#include <cmath>

namespace plica {

void AbaqusLoads::temperature(const Keyword& k) {
  for (const char* parameter : {"FILE", "INPUT", "ESTIMATED", "BSTEP"})
    if (k.has(parameter))
      deck_error(k.at, "*TEMPERATURE", std::string("has ") + parameter,
                 "temperatures that stand in the deck");
  for (const DataLine& line : k.data) {
    const double T = number_in(k, line, 1);
    for (std::size_t i = 2; i < line.fields.size(); ++i)
      if (number_in(k, line, i, 0) != 0)
        deck_error(line.at, "*TEMPERATURE", "varies over a section", "one temperature at a node");
    for (int node : mesh_.nodes(k, line, line.fields[0])) now_.temperatures[node] = T;
  }
}

void AbaqusLoads::initial_conditions(const Keyword& k) {
  try {
    if (k.word_or("TYPE", "") != "TEMPERATURE") return;
    if (k.has("FILE") || k.has("INPUT"))
      deck_error(k.at, "*INITIAL CONDITIONS", "are those of a file", "temperatures in the deck");
    for (const DataLine& line : k.data)
      for (int node : mesh_.nodes(k, line, line.fields.at(0)))
        initial_[node] = number_in(k, line, 1);
  } catch (const InputError& error) {
    for (const InputProblem& p : error.problems()) unknown_initial_.push_back(to_string(p));
  }
}

void AbaqusLoads::add_strains(DeckLoadCase& made) const {
  if (now_.temperatures.empty()) return;
  made.not_had.insert(made.not_had.end(), unknown_initial_.begin(), unknown_initial_.end());
  const auto change = [&](const std::vector<int>& nodes) { // mean T - T0
    double sum = 0;
    int count = 0;
    for (int node : nodes) {
      if (deck_.labels[std::size_t(node)] == 0) continue; // added in the middle of an element
      const auto first = initial_.find(node), now = now_.temperatures.find(node);
      const double T0 = first == initial_.end() ? 0 : first->second;
      sum += now == now_.temperatures.end() ? 0 : now->second - T0;
      ++count;
    }
    return sum / count;
  };
  const auto add = [&](DeckStrain::Of of, int index, const std::string& origin,
                       const std::vector<int>& nodes, const DeckExpansion& expansion) {
    const double dT = change(nodes);
    if (expansion.alpha == 0 || dT == 0) return;
    if (std::isnan(expansion.alpha))
      return made.not_had.push_back(origin +
                                    " expands by plies, or by more than one number (*EXPANSION)");
    made.strains.push_back({of, index, expansion.alpha * dT});
  };
  for (const AbaqusElement& e : mesh_.elements()) {
    for (int i : e.shells) {
      const DeckShell& s = deck_.shells[std::size_t(i)];
      add(DeckStrain::Of::shell, i, e.origin, s.nodes, s.expansion);
    }
    for (int i : e.beams) {
      const BeamElement& b = deck_.beams[std::size_t(i)];
      add(DeckStrain::Of::beam, i, e.origin, {b.node1, b.node2}, deck_.of_beams.at(i).expansion);
    }
    for (int i : e.bars)
      add(DeckStrain::Of::spring, i, e.origin, deck_.springs[std::size_t(i)].nodes,
          deck_.of_springs.at(i).expansion);
  }
}

} // namespace plica
