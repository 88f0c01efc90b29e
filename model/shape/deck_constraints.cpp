#include "model/shape/deck_constraints.hpp"

#include "solve/couplings.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double rounding = 1e-9;

// Collects rows by node, then solves them node by node.
class DeckRows {
public:
  DeckRows(Model& model, const DeckModel& deck, const DeckPlacing& placing)
      : model_(model), deck_(deck), turn_(placing.turn), L_(placing.units.length) {}

  void add(const DeckCoupling& c) {
    const std::size_t first = model_.constraints.size();
    if (c.distributing)
      add_distributing_coupling(model_, c.reference, c.nodes, c.origin, c.weights);
    else
      add_kinematic_coupling(model_, c.reference, c.nodes, {0, 1, 2, 3, 4, 5}, c.origin);
    const auto begin = model_.constraints.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<Constraint> all(begin, model_.constraints.end()); // six for each node
    model_.constraints.erase(begin, model_.constraints.end());
    for (std::size_t i = 0; i < all.size(); i += 3) add_wanted(c, &all[i]);
  }

  void add(const Constraint& row) {
    Row own{axes_of(row.node).col(row.dof % 3), {}, row.origin, row.terms.empty()};
    for (const ConstraintTerm& term : row.terms) {
      const Vector3d direction = axes_of(term.node).col(term.dof % 3);
      const double factor = term.factor * std::pow(L_, (row.dof < 3) - (term.dof < 3));
      for (int d = 0; d < 3; ++d)
        if (std::abs(direction[d]) > rounding)
          own.terms[{term.node, term.dof / 3 * 3 + d}] += factor * direction[d];
    }
    rows_[{row.node, row.dof / 3 * 3}].push_back(std::move(own));
  }

  // Rows of one node along any axes as rows that each determine a DOF of their own: elimination
  // with pivots. What determines a direction twice goes on as it is; who solves says so.
  void solve() {
    for (auto& [at, rows] : rows_) {
      std::vector<std::pair<int, Row>> solved; // DOF of the three, row with 1 there
      for (const Row& given : rows) {
        Row row = given;
        const auto subtract = [](Row& from, const Row& what, double factor) {
          from.direction -= factor * what.direction;
          for (const auto& [dof, f] : what.terms) from.terms[dof] -= factor * f;
        };
        for (const auto& [d, known] : solved) subtract(row, known, row.direction[d]);
        Eigen::Index pivot = 0;
        if (!(row.direction.cwiseAbs().maxCoeff(&pivot) > rounding)) {
          row = given;
          row.direction.cwiseAbs().maxCoeff(&pivot);
        }
        const double largest = row.direction[pivot];
        row.direction /= largest;
        for (auto& [dof, f] : row.terms) f /= largest;
        for (auto& [d, known] : solved)
          if (d != pivot) subtract(known, row, known.direction[pivot]);
        solved.emplace_back(int(pivot), std::move(row));
      }
      for (const auto& [d, row] : solved) add_row(at.first, at.second + d, row);
    }
  }

private:
  // Axes of the DOFs of a node in a row of the deck.
  Matrix3d axes_of(int node) const {
    if (deck_.scalars.contains(node)) return Matrix3d::Identity();
    const auto own = deck_.axes.find(node);
    return own == deck_.axes.end() ? turn_ : Matrix3d(turn_ * own->second);
  }

  // direction . u = sum of terms, for the translations or the rotations of a node.
  struct Row {
    Vector3d direction;
    std::map<std::pair<int, int>, double> terms; // by node and DOF
    std::string origin;
    bool supports = false;
  };

  // Of three rows, for the translations or the rotations of a node, what a coupling wants.
  void add_wanted(const DeckCoupling& c, const Constraint* rows) {
    const int first = rows[0].dof;
    std::vector<int> wanted;
    for (int k = 0; k < 3; ++k)
      if (std::find(c.dofs.begin(), c.dofs.end(), first + k) != c.dofs.end() ||
          (c.distributing && c.dofs.size() != 3))
        wanted.push_back(k);
    if (wanted.size() == 3) {
      model_.constraints.insert(model_.constraints.end(), rows, rows + 3);
      return;
    }
    const Matrix3d A = axes_of(rows[0].node);
    for (int k : wanted) {
      Row row{A.col(k), {}, c.origin};
      for (int d = 0; d < 3; ++d)
        for (const ConstraintTerm& t : rows[d].terms)
          row.terms[{t.node, t.dof}] += A(d, k) * t.factor;
      rows_[{rows[0].node, first}].push_back(std::move(row));
    }
  }

  void add_row(int node, int dof, const Row& row) {
    Constraint own{node, dof, {}, row.origin};
    own.supports_deck = row.supports;
    for (int d = 0; d < 3; ++d)
      if (d != dof % 3 && std::abs(row.direction[d]) > rounding)
        own.terms.push_back({node, dof / 3 * 3 + d, -row.direction[d]});
    for (const auto& [at, factor] : row.terms)
      if (factor != 0) own.terms.push_back({at.first, at.second, factor});
    model_.constraints.push_back(std::move(own));
  }

  Model& model_;
  const DeckModel& deck_;
  Matrix3d turn_;
  double L_;
  std::map<std::pair<int, int>, std::vector<Row>> rows_; // by node and first of its three DOFs
};

} // namespace

void add_deck_constraints(Model& model, const DeckModel& deck, const DeckPlacing& placing) {
  DeckRows rows(model, deck, placing);
  for (const DeckCoupling& c : deck.couplings) rows.add(c);
  for (const Constraint& row : deck.equations) rows.add(row);
  if (placing.held)
    for (const Constraint& row : deck.supports) rows.add(row);
  rows.solve();
}

} // namespace plica
