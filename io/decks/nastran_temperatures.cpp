#include "io/decks/nastran_temperatures.hpp"

#include "io/decks/nastran_load_cards.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

const std::set<std::string> followed{"TEMP", "TEMPD", "TEMPP1", "TEMPRB"};
const std::set<std::string> not_had{"TEMPP2", "TEMPP3", "TEMPN1", "TEMPBC"};

// One set of temperatures.
class Temperatures {
public:
  Temperatures(const NastranReading& r, const CardsByName& loads, int set, DeckLoadCase& into)
      : r_(r), loads_(loads), set_(set), into_(into) {
    each("TEMP", [&](const Card& c) {
      for (std::size_t i = 1; i + 1 < 7; i += 2)
        if (c.has(i)) nodes_[r_.grids.at(c, i)] = c.real(i + 1);
    });
    each_pair("TEMPD", [&](const Card& c, std::size_t at) { everywhere_ = c.real(at + 1); });
    each("TEMPP1", [&](const Card& c) {
      if (c.real(3, 0) != 0) c.wrong("varies through the wall", "one temperature, TPRIME 0");
      take(c, c.real(2), 8);
    });
    each("TEMPRB", [&](const Card& c) {
      for (std::size_t i = 4; i < 16; ++i) // gradients, temperatures of points of the section
        if (c.real(i, 0) != 0 && (i < 8 || c.real(i, 0) != c.real(i < 12 ? 2 : 3)))
          c.wrong("varies over the section", "TA and TB alone");
      take(c, (c.real(2, 0) + c.real(3, 0)) / 2, 16);
    });
    for (const std::string& name : not_had)
      each(name, [](const Card& c) { c.wrong("is not had", "TEMP, TEMPD, TEMPP1, TEMPRB"); });
  }

  bool acts() const { return acts_; }

  // None: nothing says it.
  std::optional<double> of(int element, const std::vector<int>& nodes) const {
    if (const auto own = elements_.find(element); own != elements_.end()) return own->second;
    double sum = 0;
    int count = 0;
    for (int node : nodes) {
      if (r_.deck.labels[std::size_t(node)] == 0) continue; // added in the middle of an element
      const auto own = nodes_.find(node);
      if (own == nodes_.end() && !everywhere_) return std::nullopt;
      sum += own == nodes_.end() ? *everywhere_ : own->second;
      ++count;
    }
    return sum / count;
  }

private:
  template <class F> void each(const std::string& name, F&& f) {
    every(name, [&](const Card& c) {
      if (c.whole(0) != set_) return;
      acts_ = true;
      f(c);
    });
  }
  template <class F> void every(const std::string& name, F&& f) {
    each_load_card(loads_, name, into_, f);
  }
  template <class F> void each_pair(const std::string& name, F&& f) {
    every(name, [&](const Card& c) {
      for (std::size_t i = 0; i + 1 < c.fields.size(); i += 2)
        if (c.has(i) && c.whole(i) == set_) {
          acts_ = true;
          f(c, i);
        }
    });
  }

  // EID1, and the others from a field on.
  void take(const Card& c, double temperature, std::size_t first) {
    elements_[c.whole(1)] = temperature;
    for (int element : c.list(first)) elements_[element] = temperature;
  }

  const NastranReading& r_;
  const CardsByName& loads_;
  int set_;
  DeckLoadCase& into_;
  bool acts_ = false;
  std::map<int, double> nodes_, elements_;
  std::optional<double> everywhere_;
};

} // namespace

bool is_temperature_card(const std::string& name) {
  return followed.contains(name) || not_had.contains(name);
}

void read_temperatures(const NastranReading& r, const CardsByName& loads, int set, int initial,
                       DeckLoadCase& into) {
  const Temperatures now(r, loads, set, into);
  std::optional<Temperatures> before;
  if (initial != 0) before.emplace(r, loads, initial, into);
  const auto none = [&](int number) {
    into.not_had.push_back("there is no temperature of set " + std::to_string(number));
  };
  if (!now.acts()) none(set);
  if (before && !before->acts()) none(initial);
  if (!now.acts() || (before && !before->acts())) return;
  const auto add = [&](DeckStrain::Of of, std::size_t index, const std::string& origin, int element,
                       const std::vector<int>& nodes, const DeckExpansion& expansion) {
    if (expansion.alpha == 0) return;
    const auto T = now.of(element, nodes);
    const auto T0 = before ? before->of(element, nodes) : expansion.reference;
    if (!T || !T0)
      return into.not_had.push_back(origin + " has no temperature in set " +
                                    std::to_string(T ? initial : set));
    if (*T == *T0) return;
    if (std::isnan(expansion.alpha))
      return into.not_had.push_back(origin + " expands by plies, or not in all directions alike");
    into.strains.push_back({of, int(index), expansion.alpha * (*T - *T0)});
  };
  for (std::size_t i = 0; i < r.deck.shells.size(); ++i) {
    const DeckShell& s = r.deck.shells[i];
    add(DeckStrain::Of::shell, i, s.origin, s.element, s.nodes, s.expansion);
  }
  for (const auto& [i, bar] : r.deck.of_beams) {
    const BeamElement& b = r.deck.beams[std::size_t(i)];
    add(DeckStrain::Of::beam, std::size_t(i), bar.origin, bar.element, {b.node1, b.node2},
        bar.expansion);
  }
  for (const auto& [i, bar] : r.deck.of_springs)
    add(DeckStrain::Of::spring, std::size_t(i), bar.origin, bar.element,
        r.deck.springs[std::size_t(i)].nodes, bar.expansion);
}

} // namespace plica
