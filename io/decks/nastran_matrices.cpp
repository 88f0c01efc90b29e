// DMIG that case control adds: K2GG = KAAX, M2GG = 2.0*MAAX, MBODY. Matrices of assigned OP4 by the
// same words, and as external superelements (SEBULK, EXTOP4).
#include "io/decks/deck_matrices.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_elements.hpp"
#include "io/decks/op4_file.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

using Dofs = std::vector<GivenMatrix::Dof>;
using Rows = std::map<std::pair<int, int>, GivenMatrix::Dof>; // by number and component

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

// A point by the number that orders it, with the components in a field; a scalar one has its own.
struct NumberedPoint {
  int number = 0, node = 0;
};
void add_components(const NastranReading& r, const Card& card, const NumberedPoint& point,
                    std::size_t field, Rows& rows) {
  if (r.deck.scalars.contains(point.node))
    rows[{point.number, 0}] = {point.node, 0};
  else
    for (int dof : card.dofs(field)) rows[{point.number, dof}] = {point.node, dof};
}

Dofs in_order(const Rows& rows) {
  Dofs all;
  for (const auto& [place, dof] : rows) all.push_back(dof);
  return all;
}

// Rows of a matrix without names: those of ASET and its like, or of all points, by their numbers.
Dofs rows_of_sets(const NastranReading& r) {
  Rows rows;
  for (const char* name : {"ASET", "BSET", "CSET", "QSET"}) {
    r.each(name, [&](const Card& card) {
      for (std::size_t i = 0; i < card.fields.size(); i += 2)
        if (card.has(i)) add_components(r, card, {card.whole(i), r.grids.at(card, i)}, i + 1, rows);
    });
    r.each((name + std::string("1")).c_str(), [&](const Card& card) {
      for (int node : r.grids.list(card, 1))
        add_components(r, card, {r.deck.labels[std::size_t(node)], node}, 0, rows);
    });
  }
  return in_order(rows);
}
Dofs rows_of_points(const NastranReading& r) {
  Rows rows;
  for (int node = 0; node < int(r.deck.nodes.size()); ++node)
    if (const int label = r.deck.labels[std::size_t(node)]; label != 0) // 0: added to split a shell
      for (int dof = 0; dof < (r.deck.scalars.contains(node) ? 1 : 6); ++dof)
        rows[{label, dof}] = {node, dof};
  return in_order(rows);
}

GivenMatrix over(const Dofs& rows, const Eigen::MatrixXd& A) {
  GivenMatrix given;
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      if (A(i, j) != 0) given.add(rows[std::size_t(i)], rows[std::size_t(j)], A(i, j));
  return given;
}

using Named = std::map<std::string, Eigen::MatrixXd>;

// Of all assigned files that case control names.
Named assigned_matrices(const NastranReading& r, const BulkData& bulk) {
  std::set<std::string> wanted;
  for (const DirectMatrices& line : bulk.matrices)
    for (const auto& [factor, name] : line.chosen) wanted.insert(name);
  Named all;
  if (!wanted.empty())
    for (const AssignedMatrices& file : bulk.assigned)
      r.problems.collect([&] {
        for (auto& [name, A] : read_op4_file(file.path, wanted))
          if (!all.try_emplace(name, std::move(A)).second)
            deck_error(file.at, "ASSIGN", "has a matrix " + name + " that another file has too",
                       "a name in one file");
      });
  return all;
}

GivenMatrix of_case_control(const NastranReading& r, const Eigen::MatrixXd& A,
                            const DeckPosition& at, const std::string& name) {
  const Dofs sets = rows_of_sets(r), points = rows_of_points(r);
  for (const Dofs& rows : {sets, points})
    if (Eigen::Index(rows.size()) == A.rows() && A.rows() == A.cols()) return over(rows, A);
  deck_error(
      at, "OP4 " + name,
      fmt::format("has {} rows and {} columns, the points of the deck have {}{}", A.rows(),
                  A.cols(), points.size(),
                  sets.empty() ? "" : fmt::format(", those of ASET and its like {}", sets.size())),
      "a row for each, by number: six of a GRID, one of an SPOINT");
}

// --- SEBULK, id, EXTOP4, , MANUAL, , , unit; SECONCT; EXTRN of its part

std::map<int, int> outer_points(const NastranReading& r, int id) {
  std::map<int, int> outer;
  r.each("SECONCT", [&](const Card& card) {
    if (card.whole(0) != id) return;
    for (std::size_t i = 8; i < card.fields.size(); i += 2)
      if (card.has(i)) outer[card.whole(i)] = card.whole(i + 1);
  });
  return outer;
}

Dofs rows_of_external(const NastranReading& r, const Card& bulk_card) {
  const std::map<int, int> outer = outer_points(r, bulk_card.whole(0));
  Rows rows; // by the numbers within the superelement
  r.each("EXTRN", [&](const Card& card) {
    if (card.super != bulk_card.whole(0)) return;
    for (std::size_t i = 0; i < card.fields.size(); i += 2) {
      if (!card.has(i)) continue;
      const int inner = card.whole(i);
      const auto found = outer.find(inner);
      const int node = r.grids.find(card, found == outer.end() ? inner : found->second);
      add_components(r, card, {inner, node}, i + 1, rows);
    }
  });
  return in_order(rows);
}

void add_external(const NastranReading& r, const BulkData& bulk, const Card& card) {
  const int unit = card.whole(6, 0);
  const AssignedMatrices* file = nullptr;
  for (const AssignedMatrices& assigned : bulk.assigned)
    if (assigned.unit == unit || (unit == 0 && bulk.assigned.size() == 1)) file = &assigned;
  if (file == nullptr)
    card.wrong("has no file on unit " + card.text(6),
               "ASSIGN INPUTT4='file.op4', UNIT=" + card.text(6));
  const Dofs rows = rows_of_external(r, card);
  if (rows.empty())
    card.wrong("has no EXTRN",
               "BEGIN SUPER=" + card.text(0) + " with EXTRN, the rows of its matrices");
  const Named matrices = read_op4_file(file->path, {"KXX", "MXX"});
  for (const auto& [name, kind] :
       {std::pair{"KXX", GivenKind::stiffness}, std::pair{"MXX", GivenKind::mass}}) {
    const auto found = matrices.find(name);
    if (found == matrices.end() && kind == GivenKind::stiffness)
      deck_error({file->path.string(), 0}, "OP4", "has no KXX", "the matrices of EXTSEOUT");
    if (found == matrices.end()) continue;
    const Eigen::MatrixXd& A = found->second;
    if (A.rows() != Eigen::Index(rows.size()) || A.cols() != A.rows())
      deck_error({file->path.string(), 0}, std::string("OP4 ") + name,
                 fmt::format("has {} rows and {} columns, EXTRN of superelement {} names {}",
                             A.rows(), A.cols(), card.text(0), rows.size()),
                 "a row for each");
    const GivenMatrix given = over(rows, A);
    if (!given.empty())
      r.deck.springs.push_back(given.element(r.deck, kind, false, 1, card.at, name));
  }
  r.deck.files.insert(file->path.string());
  r.deck.notes.push_back("superelement " + card.text(0) + " has KXX and MXX of " +
                         file->path.filename().string() +
                         "; what else stands there, damping and loads, is passed over");
}

} // namespace

void read_matrices(const NastranReading& r, const BulkData& bulk) {
  std::map<std::string, Direct> all;
  r.each("DMIG", [&](const Card& card) { read_entries(r, card, all[in_capitals(card.text(0))]); });
  const Named assigned = assigned_matrices(r, bulk);
  for (const DirectMatrices& line : bulk.matrices)
    r.problems.collect([&] {
      GivenMatrix sum; // a second one may be what the digits of the first leave, of any sign
      for (const auto& [factor, name] : line.chosen) {
        if (const auto op4 = assigned.find(name); op4 != assigned.end()) {
          sum.add(of_case_control(r, op4->second, line.at, name), factor, false);
          continue;
        }
        const auto found = all.find(name);
        if (found == all.end() || found->second.head == nullptr)
          deck_error(line.at, line.card, "there is no matrix " + name,
                     "a DMIG of the deck, or a matrix of an OP4 that it assigns (INPUTT4)");
        sum.add(found->second.matrix, factor, found->second.head->whole(2) == 6);
      }
      if (!sum.empty())
        r.deck.springs.push_back(
            sum.element(r.deck, line.card == "K2GG" ? GivenKind::stiffness : GivenKind::mass, false,
                        1, line.at, line.card));
    });
  for (const AssignedMatrices& file : bulk.assigned)
    if (!assigned.empty()) r.deck.files.insert(file.path.string());
  r.each("SEBULK", [&](const Card& card) { add_external(r, bulk, card); });
}

} // namespace plica
