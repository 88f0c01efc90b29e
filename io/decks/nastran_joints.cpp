#include "io/decks/nastran_joints.hpp"

#include "io/decks/keywords.hpp"

#include <algorithm>

namespace plica {
namespace {

const std::vector<int> all_six{0, 1, 2, 3, 4, 5};

template <class F> void for_each(const CardsByName& cards, const char* name, F&& f) {
  if (const auto found = cards.find(name); found != cards.end())
    for (const Card* card : found->second) f(*card);
}

std::string origin(const Card& card) {
  return card.name + " " + card.text(0);
}

// Fields of a list that end before a real number or a word.
std::vector<int> list_before_reals(const Card& card, std::size_t& field) {
  std::vector<int> labels;
  for (; field < card.fields.size(); ++field) {
    if (!card.has(field)) continue;
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

void rbe3(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  DeckCoupling c{.distributing = true,
                 .reference = grids.at(card, 2),
                 .nodes = {},
                 .weights = {},
                 .dofs = card.dofs(3),
                 .origin = origin(card)};
  if (c.dofs != all_six && c.dofs != std::vector{0, 1, 2})
    card.wrong("has REFC " + card.text(3), "123456 or 123");
  for (std::size_t field = 4; field < card.fields.size();) {
    if (!card.has(field)) {
      ++field;
      continue;
    }
    if (std::isalpha(static_cast<unsigned char>(card.text(field)[0])))
      card.wrong("has " + card.text(field), "weights, components 123 and grid points");
    const double weight = card.real(field++);
    if (card.dofs(field) != std::vector{0, 1, 2})
      card.wrong("averages components " + card.text(field), "123");
    for (int node : grids.find(card, list_before_reals(card, ++field))) {
      c.nodes.push_back(node);
      c.weights.push_back(weight);
    }
  }
  deck.sets["RBE3[" + card.text(0) + "]"] = {c.reference};
  deck.couplings.push_back(std::move(c));
}

void rbar(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  const bool from_a = card.dofs(3) == all_six && !card.has(4);
  const bool from_b = card.dofs(4) == all_six && !card.has(3);
  if (!from_a && !from_b)
    card.wrong("has independent degrees of freedom at both ends", "123456 at one end");
  const std::size_t dependent = from_a ? 6 : 5;
  deck.couplings.push_back({.reference = grids.at(card, from_a ? 1 : 2),
                            .nodes = {grids.at(card, from_a ? 2 : 1)},
                            .weights = {},
                            .dofs = card.has(dependent) ? card.dofs(dependent) : all_six,
                            .origin = origin(card)});
}

void mpc(const Card& card, const NastranGrids& grids, DeckModel& deck) {
  std::vector<ConstraintTerm> terms;
  for (std::size_t row = 0; row < card.fields.size(); row += 8)
    for (std::size_t at : {row + 1, row + 4}) {
      if (!card.has(at)) continue;
      const std::vector<int> dofs = card.dofs(at + 1);
      if (dofs.size() != 1)
        card.wrong("has a term with components \"" + card.text(at + 1) + "\"", "one component");
      terms.push_back({grids.at(card, at), dofs[0], card.real(at + 2)});
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
                       const std::vector<const char*>& names) {
  std::set<int> there;
  const Card* any = nullptr;
  for (const char* name : names)
    for_each(cards, name, [&](const Card& card) {
      there.insert(card.whole(0));
      any = &card;
    });
  if (any == nullptr) return {};
  const auto choice = bulk.chosen.find(kind);
  std::set<int> sets = choice == bulk.chosen.end() ? std::set<int>{} : choice->second;
  if (sets.empty() && (bulk.has_control || there.size() > 1))
    any->wrong("belongs to one of " + std::to_string(there.size()) +
                   " sets, and no case control chooses one",
               kind + " = number before BEGIN BULK");
  if (sets.empty()) return there;
  if (sets.size() > 1)
    any->wrong("the subcases choose different sets of " + kind, "one set for all");
  for_each(cards, (kind + "ADD").c_str(), [&](const Card& card) {
    if (!sets.contains(card.whole(0))) return;
    for (int set : card.list(1)) sets.insert(set);
  });
  if (std::none_of(sets.begin(), sets.end(), [&](int set) { return there.contains(set); })) {
    std::string known;
    for (int set : there) known += (known.empty() ? "" : ", ") + std::to_string(set);
    any->wrong("is not of set " + std::to_string(*sets.begin()) + ", which case control chooses",
               kind + " = one of " + known + " there, or none");
  }
  return sets;
}

} // namespace

void read_rigid_elements(const CardsByName& cards, const NastranGrids& grids, DeckModel& deck) {
  for_each(cards, "RBE2", [&](const Card& card) { rbe2(card, grids, deck); });
  for_each(cards, "RBE3", [&](const Card& card) { rbe3(card, grids, deck); });
  for_each(cards, "RBAR", [&](const Card& card) { rbar(card, grids, deck); });
}

void read_constraints(const CardsByName& cards, const BulkData& bulk, const NastranGrids& grids,
                      DeckModel& deck) {
  const std::set<int> mpcs = in_force(cards, bulk, "MPC", {"MPC"});
  for_each(cards, "MPC", [&](const Card& card) {
    if (mpcs.contains(card.whole(0))) mpc(card, grids, deck);
  });
  const std::set<int> spcs = in_force(cards, bulk, "SPC", {"SPC", "SPC1"});
  std::set<std::pair<int, int>> held;
  for (const Constraint& row : deck.supports) held.insert({row.node, row.dof});
  const auto hold = [&](const Card& card, int node, const std::vector<int>& dofs) {
    for (int dof : dofs)
      if (held.insert({node, dof}).second)
        deck.supports.push_back({node, dof, {}, "SPC " + card.text(0)});
    std::vector<int>& set = deck.sets["SPC[" + card.text(0) + "]"];
    if (std::find(set.begin(), set.end(), node) == set.end()) set.push_back(node);
  };
  for_each(cards, "SPC", [&](const Card& card) {
    if (!spcs.contains(card.whole(0))) return;
    for (std::size_t at : {std::size_t{1}, std::size_t{4}}) {
      if (!card.has(at)) continue;
      if (card.real(at + 2, 0) != 0)
        card.wrong("prescribes a displacement other than zero",
                   "zero; motion of the base is asked for in the case");
      hold(card, grids.at(card, at), card.dofs(at + 1));
    }
  });
  for_each(cards, "SPC1", [&](const Card& card) {
    if (!spcs.contains(card.whole(0))) return;
    for (int node : grids.find(card, card.list(2))) hold(card, node, card.dofs(1));
  });
}

} // namespace plica
