// Matrices that a deck gives by their entries, and adds to its model: DMIG that case control adds,
// *MATRIX INPUT that *MATRIX ASSEMBLE names. Superelements of other codes come in by them.
#pragma once

#include "io/decks/deck_error.hpp"
#include "model/description/deck_model.hpp"

namespace plica {

enum class GivenKind { stiffness, mass };

class GivenMatrix {
public:
  // DOFs 0..5 along the axes of the node, 0 of a scalar one. Entries of one place add up.
  struct Dof {
    int node = 0, dof = 0;
    auto operator<=>(const Dof&) const = default;
  };
  void add(Dof row, Dof column, double value) { entries_[{row, column}] += value; }
  // Factor times another one; of a triangle its mirrored entries as well.
  void add(const GivenMatrix& other, double factor, bool triangle) {
    for (const auto& [place, value] : other.entries_) {
      entries_[place] += factor * value;
      if (triangle && place.first != place.second)
        entries_[{place.second, place.first}] += factor * value;
    }
  }
  bool empty() const { return entries_.empty(); }

  // Factor times the matrix as an element of `deck`. `triangle`: only one of two mirrored entries
  // is given. Throws InputError at `at` when it is not symmetric within 1e-6 of its diagonal, has a
  // diagonal below zero, or joins more than 1000 points.
  MatrixElement element(const DeckModel& deck, GivenKind kind, bool triangle, double factor,
                        const DeckPosition& at, const std::string& name) const;

private:
  std::map<std::pair<Dof, Dof>, double> entries_;
};

} // namespace plica
