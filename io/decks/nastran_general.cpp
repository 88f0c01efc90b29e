// GENEL: an element by its stiffness or its flexibility between single degrees of freedom.
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_elements.hpp"

#include "io/decks/deck_panels.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

bool is_word(const Card& card, std::size_t field) {
  return card.has(field) && std::isalpha(static_cast<unsigned char>(card.text(field)[0]));
}

// Points and components in turn up to a word; leaves `field` there.
std::vector<SpringEnd> places(const NastranReading& r, const Card& card, std::size_t& field) {
  std::vector<SpringEnd> all;
  for (; field < card.fields.size() && !is_word(card, field); ++field) {
    if (!card.has(field)) continue;
    const int node = r.grids.at(card, field);
    const int dof = r.grids.dof(card, node, field + 1);
    all.push_back({node, along(r.grids.axes(node), dof)});
    ++field;
  }
  return all;
}

// `count` numbers behind a word; blanks at the ends of lines do not count.
std::vector<double> numbers(const Card& card, std::size_t& field, std::size_t count) {
  std::vector<double> all;
  for (; field < card.fields.size() && !is_word(card, field); ++field)
    if (card.has(field)) all.push_back(card.real(field));
  if (all.size() != count)
    card.wrong("has a matrix of " + std::to_string(all.size()) + " numbers",
               std::to_string(count) + " for its degrees of freedom");
  return all;
}

// The lower triangle by columns; of flexibilities the stiffness.
MatrixXd stiffness(const Card& card, const std::vector<double>& lower, Index size, bool flexible) {
  MatrixXd K(size, size);
  std::size_t next = 0;
  for (Index column = 0; column < size; ++column)
    for (Index row = column; row < size; ++row) K(row, column) = K(column, row) = lower[next++];
  if (!flexible) return K;
  const Eigen::FullPivLU<MatrixXd> inner(K);
  if (!inner.isInvertible()) card.wrong("has flexibilities without an inverse", "Z, or K");
  return inner.inverse();
}

// Motion of places by that of a body about the origin.
MatrixXd moved_by_a_body(const NastranReading& r, const std::vector<SpringEnd>& places) {
  MatrixXd rows(static_cast<Index>(places.size()), 6);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d u = places[i].direction.head<3>(), turn = places[i].direction.tail<3>();
    rows.row(Index(i)) << u.transpose(), (r.deck.nodes[places[i].node].cross(u) + turn).transpose();
  }
  return rows;
}

void genel(const NastranReading& r, const Card& card) {
  std::size_t field = 1;
  std::vector<SpringEnd> ends = places(r, card, field);
  const auto inner = static_cast<Index>(ends.size());
  std::vector<SpringEnd> base;
  if (in_capitals(card.text(field)) == "UD") base = places(r, card, ++field);
  const std::string kind = in_capitals(card.text(field));
  if (inner == 0 || (kind != "K" && kind != "Z"))
    card.wrong("has no matrix, or no degrees of freedom", "UI, then K or Z");
  const std::size_t count = ends.size();
  MatrixXd K = stiffness(card, numbers(card, ++field, count * (count + 1) / 2), inner, kind == "Z");
  const auto outer = static_cast<Index>(base.size());
  if (outer > 0) {
    MatrixXd S(inner, outer);
    if (in_capitals(card.text(field)) == "S") {
      const std::vector<double> all = numbers(card, ++field, count * base.size());
      for (Index i = 0; i < inner; ++i)
        for (Index j = 0; j < outer; ++j) S(i, j) = all[std::size_t(i * outer + j)];
    } else {
      const Eigen::FullPivLU<MatrixXd> body(moved_by_a_body(r, base));
      if (outer != 6 || !body.isInvertible())
        card.wrong("has UD that do not determine how a body moves", "six that hold it, or S");
      S = moved_by_a_body(r, ends) * body.inverse();
    }
    MatrixXd whole(inner, inner + outer); // what stretches: ui - S ud
    whole << MatrixXd::Identity(inner, inner), -S;
    K = whole.transpose() * K * whole;
    ends.insert(ends.end(), base.begin(), base.end());
  }
  MatrixElement element;
  for (const SpringEnd& end : ends)
    if (std::find(element.nodes.begin(), element.nodes.end(), end.node) == element.nodes.end())
      element.nodes.push_back(end.node);
  MatrixXd seen = MatrixXd::Zero(inner + outer, 6 * static_cast<Index>(element.nodes.size()));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto at = std::find(element.nodes.begin(), element.nodes.end(), ends[i].node);
    seen.block<1, 6>(Index(i), 6 * (at - element.nodes.begin())) = ends[i].direction.transpose();
  }
  element.K = seen.transpose() * K * seen;
  element.M = MatrixXd::Zero(element.K.rows(), element.K.cols());
  r.deck.springs.push_back(std::move(element));
}

} // namespace

void read_general_elements(const NastranReading& r) {
  r.each("GENEL", [&](const Card& card) { genel(r, card); });
}

} // namespace plica
