#include "io/decks/read_nastran.hpp"

#include "io/decks/deck_refusal.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_joints.hpp"
#include "io/decks/nastran_known.hpp"
#include "io/decks/nastran_loads.hpp"
#include "words/did_you_mean.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

class NastranReader {
public:
  NastranReader(const BulkData& bulk, UnknownCards unknown)
      : missing_(unknown == UnknownCards::list) {
    deck.holds_what_has_no_stiffness = true; // AUTOSPC
    deck.lumped_mass = true;                 // but for PARAM COUPMASS
    deck.notes = bulk.notes;
    for (const DirectMatrices& line : bulk.matrices) {
      for (const auto& [factor, name] : line.chosen) added_.insert(name);
      if (line.card != "K2GG" && line.card != "M2GG")
        missing_.add(line.card, "adds matrices of the deck (DMIG)", line.at);
    }
    for (const Card& card : bulk.cards)
      if (card.name == "SEBULK" && in_capitals(card.text(1)) == "EXTOP4")
        external_.insert(card.whole(0));
    for (const Card& card : bulk.cards) problems_.collect([&] { sort(card); });
    for_each("PARAM", [&](const Card& card) { parameter(card); });
    missing_.finish(problems_, deck, "cards of docs/decks.md, or unknown_cards: list");
    passed_.finish(deck);
    acting_.finish(deck, loads_of_decks);
    read(bulk);
  }

  DeckModel deck;

private:
  template <class F> void for_each(const char* name, F&& f) {
    if (const auto found = cards_.find(name); found != cards_.end())
      for (const Card* card : found->second) problems_.collect([&] { f(*card); });
  }

  void sort(const Card& card) {
    if (card.name == "DMIG" && !added_.contains(in_capitals(card.text(0))))
      return passed_.add("DMIG");                                       // nothing adds it
    if (card.name == "BEGIN" && card.super == 0) return;                // BEGIN BULK once more
    if (external_.contains(card.super) && card.name != "EXTRN") return; // its matrices say it all
    CardKind kind = kind_of(card.name);
    if ((card.name == "SEBULK" || card.name == "SECONCT") && !external_.contains(card.whole(0)))
      kind = CardKind::structural;
    if (card.name == "EXTRN" && !external_.contains(card.super)) kind = CardKind::structural;
    if (kind == CardKind::followed) missing_.count_element(is_element(card.name));
    switch (kind) {
    case CardKind::passed:
      if (is_analysis_set(card.name)) cards_[card.name].push_back(&card); // rows of an OP4
      if (!is_load_card(card.name)) return passed_.add(card.name);
      loads_[card.name].push_back(&card);
      return acting_.add(card.name);
    case CardKind::solid:
      return missing_.add_solid(card.name, is_element(card.name), card.at);
    case CardKind::structural:
      missing_.count_element(is_element(card.name));
      return missing_.add(card.name, "is not had", card.at);
    case CardKind::unknown:
      return missing_.add(card.name, "is not known" + near(card.name), card.at);
    case CardKind::followed:
      break;
    }
    check_length(card);
    const auto same = [&](const Card* known) { return known->fields == card.fields; };
    std::vector<const Card*>& all = cards_[card.name];
    if (const std::string group = group_of_numbers(card.name); !group.empty()) {
      const auto [known, is_new] = numbers_.try_emplace({group, card.whole(0)}, &card);
      if (!is_new && same(known->second) && !is_element(card.name)) return; // the same once more
      if (!is_new && is_element(card.name))
        card.wrong("element " + card.text(0) + " is there twice", "a number once");
      if (!is_new)
        card.wrong(card.text(0) + " is there already in line " +
                       std::to_string(known->second->at.line),
                   "a number once");
    }
    all.push_back(&card);
  }

  // Lines that continue another card than the one they stand behind make it too long.
  static void check_length(const Card& card) {
    const std::size_t most = longest_card(card.name);
    for (std::size_t i = most == 0 ? card.fields.size() : most; i < card.fields.size(); ++i)
      if (card.has(i))
        card.wrong("goes on beyond its last field with \"" + card.text(i) + "\"",
                   "at most " + std::to_string(most) + " fields");
  }

  static std::string near(const std::string& name) {
    const std::string word = nearest_word(name, {followed_cards().begin(), followed_cards().end()});
    return word.empty() ? "" : ", did you mean " + word + "?";
  }

  void parameter(const Card& card) {
    const std::string name = in_capitals(card.text(0));
    if (name == "WTMASS") {
      if (wtmass_line_ > 0 && card.real(1) != mass_factor_)
        card.wrong("WTMASS is there already in line " + std::to_string(wtmass_line_), "once");
      wtmass_line_ = card.at.line;
      mass_factor_ = card.real(1);
      if (!(mass_factor_ > 0)) card.wrong("WTMASS is " + card.text(1), "above 0");
    } else if (name == "COUPMASS") {
      coupled_mass_ = card.has(1) && (in_capitals(card.text(1)) == "YES" ||
                                      (in_capitals(card.text(1)) != "NO" && card.whole(1) > 0));
      deck.lumped_mass = !coupled_mass_;
    } else if (name == "AUTOSPC") {
      deck.holds_what_has_no_stiffness = !in_capitals(card.text(1)).starts_with("N");
    } else if (is_structural_parameter(name) && (!card.has(1) || card.real(1) != 1))
      missing_.add("PARAM," + name, "scales what is solved", card.at);
    else
      passed_.add("PARAM");
  }

  void read(const BulkData& bulk) {
    problems_.raise_unless_few();
    std::optional<NastranGrids> grids;
    problems_.collect([&] { grids.emplace(cards_, deck); });
    if (!grids) problems_.raise();
    const NastranProperties properties(cards_, mass_factor_, problems_, deck.notes);
    problems_.raise();
    const NastranReading reading{cards_, *grids, properties, deck, problems_, coupled_mass_};
    read_shells(reading);
    read_bars(reading);
    read_points(reading);
    read_general_elements(reading);
    read_matrices(reading, bulk);
    read_rigid_elements(reading);
    const std::vector<Constraint> without_spc = read_constraints(reading, bulk);
    problems_.raise();
    read_loads(reading, loads_, bulk, without_spc);
  }

  DeckProblems problems_;
  MissingCards missing_;
  PassedCards passed_, acting_;
  CardsByName cards_, loads_;                                  // followed; that act in static: deck
  std::map<std::pair<std::string, int>, const Card*> numbers_; // by group
  std::set<std::string> added_; // matrices of the deck, by case control
  std::set<int> external_;      // superelements whose matrices stand in a file
  double mass_factor_ = 1;
  bool coupled_mass_ = false;
  int wtmass_line_ = 0;
};

} // namespace

DeckModel read_nastran(const std::filesystem::path& file, UnknownCards unknown) {
  const BulkData bulk = read_bulk_data(file);
  DeckModel deck = NastranReader(bulk, unknown).deck;
  for (const Card& card : bulk.cards) deck.files.insert(card.at.file);
  return deck;
}

} // namespace plica
