// What a picture shows beside shells and beams: bodies, springs, what is held.
#pragma once

#include <string>
#include <vector>

namespace plica {

struct Case;
struct BuiltCase;

enum class SymbolKind { mass, spring, ground_spring, held };

struct Symbol {
  SymbolKind kind = SymbolKind::mass;
  std::string name; // as the case names it; empty: of a deck
  int node = 0;     // of the mesh
  int other = -1;   // of a spring: its other end
  double mass = 0;  // kg
};

std::vector<Symbol> symbols_of(const Case& data, const BuiltCase& built);

// Radius at which each beam of the model is drawn, m: that of its outermost fibres, or of the thin
// tube with its EI / EA; 0 where a section has neither.
std::vector<double> drawn_radii(const BuiltCase& built);

} // namespace plica
