#include "io/decks/nastran_joints.hpp"

#include "io/decks/deck_average.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_loads.hpp"

#include <algorithm>
#include <stdexcept>

namespace plica {
namespace {

const std::vector<int> six_dofs{0, 1, 2, 3, 4, 5};

template <class F> void for_each(const CardsByName& cards, const char* name, F&& f) {
  if (const auto found = cards.find(name); found != cards.end())
    for (const Card* card : found->second) f(*card);
}

std::string origin(const Card& card) {
  return card.name + " " + card.text(0);
}

// Fields of a list, "1 THRU 9" spelt out, that end before a real number or another word.
std::vector<int> list_before_reals(const Card& card, std::size_t& field) {
  std::vector<int> labels;
  for (; field < card.fields.size(); ++field) {
    if (!card.has(field)) continue;
    if (in_capitals(card.text(field)) == "THRU" && !labels.empty()) {
      const int last = card.whole(++field);
      if (last < labels.back() || last - labels.back() > 10000000)
        card.wrong("THRU leads to " + std::to_string(last), "a number above the first");
      for (int label = labels.back() + 1; label <= last; ++label) labels.push_back(label);
      continue;
    }
    if (card.is_real(field) || std::isalpha(static_cast<unsigned char>(card.text(field)[0]))) break;
    labels.push_back(card.whole(field));
  }
  return labels;
}

void rbe2(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  std::size_t field = 3;
  const std::vector<int> follow = list_before_reals(card, field);
  if (field < card.fields.size() && !card.is_real(field))
    card.wrong("has \"" + card.text(field) + "\" amid its grid points", "numbers of grid points");
  const std::vector<int> dofs = card.dofs(2);
  if (follow.empty() || dofs.empty()) card.wrong("ties nothing", "CM and grid points");
  const int reference = grids.at(card, 1);
  deck.couplings.push_back({.reference = reference,
                            .nodes = grids.find(card, follow),
                            .weights = {},
                            .dofs = dofs,
                            .origin = origin(card)});
  deck.sets["RBE2[" + card.text(0) + "]"] = {reference};
}

void crigd1(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  std::size_t field = 2;
  const std::vector<int> follow = list_before_reals(card, field);
  if (follow.empty()) card.wrong("ties nothing", "grid points");
  deck.couplings.push_back({.reference = grids.at(card, 1),
                            .nodes = grids.find(card, follow),
                            .weights = {},
                            .dofs = six_dofs,
                            .origin = origin(card)});
}

// EID, IG, G1, C1, G2, C2 ...: each with the components that follow.
void crigd2(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  const int reference = grids.at(card, 1);
  for (std::size_t field = 2; field < card.fields.size(); field += 2) {
    if (!card.has(field)) continue;
    const std::vector<int> dofs = card.dofs(field + 1);
    if (dofs.empty()) card.wrong("ties nothing of point " + card.text(field), "components");
    deck.couplings.push_back({.reference = reference,
                              .nodes = {grids.at(card, field)},
                              .weights = {},
                              .dofs = dofs,
                              .origin = origin(card)});
  }
}

// UM, G1, C1, G2, C2 ...: what follows in place of REFC.
std::vector<NodeDof> followers(const Card& card, std::size_t field, const NastranGrids& grids) {
  std::vector<NodeDof> all;
  for (; field < card.fields.size(); ++field) {
    if (!card.has(field)) continue;
    if (in_capitals(card.text(field)) == "ALPHA") break;
    const int node = grids.at(card, field);
    do ++field;
    while (field < card.fields.size() && !card.has(field));
    const std::vector<int> dofs = card.dofs(field);
    if (dofs.empty()) card.wrong("has no component of " + card.text(field - 1), "UM, G1, C1 ...");
    for (int dof : dofs) all.push_back({node, dof});
  }
  return all;
}

// Of translations alone, to a point with all its DOFs or translations: a coupling. Of any
// components: rows.
void rbe3(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  std::vector<AveragedNode> averaged;
  std::vector<NodeDof> following; // UM
  bool translations = true;
  DeckCoupling c{.distributing = true,
                 .reference = grids.at(card, 2),
                 .nodes = {},
                 .weights = {},
                 .dofs = card.dofs(3),
                 .origin = origin(card)};
  std::sort(c.dofs.begin(), c.dofs.end());
  if (c.dofs.empty()) card.wrong("has no REFC", "components of its point, such as 123456");
  for (std::size_t field = 4; field < card.fields.size();) {
    if (!card.has(field)) {
      ++field;
      continue;
    }
    if (in_capitals(card.text(field)) == "ALPHA") break; // expansion
    if (in_capitals(card.text(field)) == "UM") {
      following = followers(card, field + 1, grids);
      break;
    }
    if (std::isalpha(static_cast<unsigned char>(card.text(field)[0])))
      card.wrong("has " + card.text(field), "weights, components 123 and grid points");
    const double weight = card.real(field++);
    const std::vector<int> components = card.dofs(field);
    if (components.empty()) card.wrong("averages no components", "components such as 123");
    translations = translations && components == std::vector{0, 1, 2};
    for (int node : grids.find(card, list_before_reals(card, ++field))) {
      c.nodes.push_back(node);
      c.weights.push_back(weight);
      averaged.push_back({node, weight, components});
    }
  }
  deck.sets["RBE3[" + card.text(0) + "]"] = {c.reference};
  if (following.empty() && translations && (c.dofs == six_dofs || c.dofs == std::vector{0, 1, 2}))
    return deck.couplings.push_back(std::move(c));
  try {
    std::vector<Constraint> rows = average_rows(deck, c.reference, c.dofs, averaged, c.origin);
    if (!following.empty()) rows = solved_for(following, rows);
    for (Constraint& row : rows) deck.equations.push_back(std::move(row));
  } catch (const std::invalid_argument& error) {
    card.wrong("averages what does not suffice: " + std::string(error.what()),
               "more grid points, components 123456, other components in UM");
  }
}

void rbar(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  const bool from_a = card.dofs(3) == six_dofs && !card.has(4);
  const bool from_b = card.dofs(4) == six_dofs && !card.has(3);
  if (!from_a && !from_b)
    card.wrong("has independent degrees of freedom at both ends", "123456 at one end");
  const std::size_t dependent = from_a ? 6 : 5;
  deck.couplings.push_back({.reference = grids.at(card, from_a ? 1 : 2),
                            .nodes = {grids.at(card, from_a ? 2 : 1)},
                            .weights = {},
                            .dofs = card.has(dependent) ? card.dofs(dependent) : six_dofs,
                            .origin = origin(card)});
}

void mpc(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  std::vector<ConstraintTerm> terms;
  for (std::size_t row = 0; row < card.fields.size(); row += 8)
    for (std::size_t at : {row + 1, row + 4}) {
      if (!card.has(at)) continue;
      const int node = grids.at(card, at);
      terms.push_back({node, grids.dof(card, node, at + 1), card.real(at + 2)});
    }
  if (terms.empty() || terms.front().factor == 0)
    card.wrong("has no first term that follows the others", "grid point, component, factor");
  Constraint row{terms.front().node, terms.front().dof, {}, origin(card)};
  for (std::size_t t = 1; t < terms.size(); ++t)
    row.terms.push_back({terms[t].node, terms[t].dof, -terms[t].factor / terms.front().factor});
  (row.terms.empty() ? deck.supports : deck.equations).push_back(std::move(row));
}

// Numbers of the sets that are in force, sums of sets spelt out.
std::set<int> in_force(const CardsByName& cards, const BulkData& bulk, const std::string& kind,
                       const std::vector<const char*>& names, DeckModel& deck) {
  std::set<int> there;
  const Card* any = nullptr;
  for (const char* name : names)
    for_each(cards, name, [&](const Card& card) {
      there.insert(card.whole(0));
      any = &card;
    });
  if (any == nullptr) return {};
  const auto choice = bulk.chosen.find(kind);
  const std::vector<int> chosen = choice == bulk.chosen.end() ? std::vector<int>{} : choice->second;
  if (chosen.empty() && !bulk.has_control && there.size() > 1)
    any->wrong("belongs to one of " + std::to_string(there.size()) +
                   " sets, and no case control chooses one",
               kind + " = number before BEGIN BULK");
  if (chosen.empty() && bulk.has_control)
    deck.notes.push_back("case control chooses no set of " + kind +
                         ": none of the deck's is in force");
  if (chosen.empty()) return bulk.has_control ? std::set<int>{} : there;
  std::set<int> sets{chosen.front()};
  if (std::set<int>(chosen.begin(), chosen.end()).size() > 1)
    deck.notes.push_back("the subcases choose different sets of " + kind + ": that of the first, " +
                         std::to_string(chosen.front()) + ", is in force");
  for_each(cards, (kind + "ADD").c_str(), [&](const Card& card) {
    if (!sets.contains(card.whole(0))) return;
    for (int set : card.list(1)) sets.insert(set);
  });
  if (std::none_of(sets.begin(), sets.end(), [&](int set) { return there.contains(set); }) &&
      chosen.front() != 0) {
    if (cards.contains("SEBULK")) { // case control is that of its superelements as well
      deck.notes.push_back(kind + " = " + std::to_string(chosen.front()) +
                           " of case control is not in the deck: taken for that of a superelement");
      return {};
    }
    std::string known;
    for (int set : there) known += (known.empty() ? "" : ", ") + std::to_string(set);
    any->wrong("is not of set " + std::to_string(*sets.begin()) + ", which case control chooses",
               kind + " = one of " + known + " there, or none");
  }
  return sets;
}

} // namespace

void read_rigid_elements(const NastranReading& r) {
  r.each("RBE2", [&](const Card& card) { rbe2(card, r.grids, r.deck); });
  r.each("RBE3", [&](const Card& card) { rbe3(card, r.grids, r.deck); });
  r.each("RBAR", [&](const Card& card) { rbar(card, r.grids, r.deck); });
  r.each("CRIGD2", [&](const Card& card) { crigd2(card, r.grids, r.deck); });
  r.each("CRIGD1", [&](const Card& card) { crigd1(card, r.grids, r.deck); });
  read_rigid_bodies(r);
}

std::vector<Constraint> read_constraints(const NastranReading& r, const BulkData& bulk) {
  DeckModel& deck = r.deck;
  std::set<int> mpcs, spcs;
  r.problems.collect([&] { mpcs = in_force(r.cards, bulk, "MPC", {"MPC"}, deck); });
  r.each("MPC", [&](const Card& card) {
    if (mpcs.contains(card.whole(0))) mpc(card, r.grids, deck);
  });
  r.problems.collect([&] { spcs = in_force(r.cards, bulk, "SPC", {"SPC", "SPC1"}, deck); });
  std::vector<Constraint> without = deck.supports;
  HeldBySets held = held_by(r, spcs, without);
  deck.supports = std::move(held.supports);
  deck.sets.merge(held.sets);
  if (held.moved_cards > 0)
    deck.notes.push_back(std::to_string(held.moved_cards) +
                         " SPC prescribe a displacement other than zero: they hold, and move "
                         "where the case says static: deck");
  return without;
}

} // namespace plica
