// DMIG that case control adds: K2GG = KAAX, M2GG = 2.0*MAAX, MBODY.
#include "io/decks/deck_matrices.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_elements.hpp"

namespace plica {
namespace {

GivenMatrix::Dof dof_at(const NastranReading& r, const Card& card, std::size_t field) {
  const int node = r.grids.at(card, field);
  return {node, r.grids.dof(card, node, field + 1)};
}

struct Direct {
  GivenMatrix matrix;
  const Card* head = nullptr;
};

// NAME, 0, IFO, TIN ... or NAME, GJ, CJ, blank and G, C, A, B of each entry.
void read_entries(const NastranReading& r, const Card& card, Direct& direct) {
  if (card.text(1) == "0") {
    if (direct.head != nullptr)
      card.wrong("has its head already in line " + std::to_string(direct.head->at.line), "one");
    direct.head = &card;
    const int form = card.whole(2), type = card.whole(3);
    if ((form != 6 && form != 1) || type < 1 || type > 2)
      card.wrong("is of form " + card.text(2) + ", type " + card.text(3),
                 "a real (1, 2) symmetric (6) or square (1) matrix");
    return;
  }
  if (direct.head == nullptr) card.wrong("has no head before it", "DMIG, name, 0, form, type");
  const GivenMatrix::Dof column = dof_at(r, card, 1);
  for (std::size_t i = 4; i < card.fields.size(); i += 4)
    if (card.has(i)) direct.matrix.add(dof_at(r, card, i), column, card.real(i + 2));
}

} // namespace

void read_matrices(const NastranReading& r, const BulkData& bulk) {
  std::map<std::string, Direct> all;
  r.each("DMIG", [&](const Card& card) { read_entries(r, card, all[in_capitals(card.text(0))]); });
  for (const DirectMatrices& line : bulk.matrices)
    r.problems.collect([&] {
      GivenMatrix sum; // a second one may be what the digits of the first leave, of any sign
      for (const auto& [factor, name] : line.chosen) {
        const auto found = all.find(name);
        if (found == all.end() || found->second.head == nullptr)
          deck_error(line.at, line.card, "there is no matrix " + name, "a DMIG of the deck");
        sum.add(found->second.matrix, factor, found->second.head->whole(2) == 6);
      }
      if (!sum.empty())
        r.deck.springs.push_back(
            sum.element(r.deck, line.card == "K2GG" ? GivenKind::stiffness : GivenKind::mass, false,
                        1, line.at, line.card));
    });
}

} // namespace plica
