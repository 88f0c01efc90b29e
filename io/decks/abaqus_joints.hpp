// What ties and holds the nodes of an Abaqus deck: couplings, rigid bodies, MPC, equations,
// boundary.
#pragma once

#include "io/decks/abaqus_mesh.hpp"

#include <optional>
#include <utility>

namespace plica {

class AbaqusJoints {
public:
  AbaqusJoints(DeckModel& deck, AbaqusMesh& mesh) : deck_(deck), mesh_(mesh) {}

  KeywordHandlers surfaces(); // to be read before the others
  KeywordHandlers handlers();
  void finish(); // no coupling is left open; modal points; notes
  // Displacements other than zero, by node and DOF, as they are after the keywords so far.
  const std::map<std::pair<int, int>, double>& moved() const { return values_; }
  void move_by(std::map<std::pair<int, int>, double> values) { values_ = std::move(values); }
  // Of a surface of shells, by elements: whether it is the side that their normal points away from.
  std::vector<std::pair<int, bool>> shell_faces(const Keyword& of, const DataLine& line,
                                                const std::string& name) const;
  // What is wrong with prescribed displacements of the step that is open; forgotten once asked for.
  std::vector<std::string> take_doubts() { return std::exchange(doubts_, {}); }

private:
  struct SurfaceNodes {
    std::vector<int> nodes;
    std::vector<double> weights; // area of the wall that belongs to each; empty = equal
  };

  const Keyword& surface(const Keyword& of, const DeckPosition& at, const std::string& name) const;
  SurfaceNodes surface_nodes(const Keyword& of, const std::string& name) const;
  double shell_area(const AbaqusElement& element) const;
  int reference(const Keyword& keyword) const;
  int one_node(const Keyword& keyword, const DataLine& line, std::size_t field) const;
  Keyword take_coupling(const Keyword& keyword);
  void kinematic(const Keyword& keyword);
  void distributing(const Keyword& keyword);
  void kinematic_coupling(const Keyword& keyword);
  void distributing_coupling(const Keyword& keyword);
  void rigid_body(const Keyword& keyword);
  void mpc(const Keyword& keyword);
  void equation(const Keyword& keyword);
  void remove_equations(const Keyword& keyword);
  void tie(const Keyword& keyword);
  void boundary(const Keyword& keyword);
  void no_open_coupling() const;
  void matrix_input(const Keyword& keyword);
  void matrix_assemble(const Keyword& keyword);
  void find_modal_points();

  DeckModel& deck_;
  AbaqusMesh& mesh_;
  std::map<std::pair<std::string, std::string>, Keyword> surfaces_; // by scope and name
  std::set<std::size_t> assembled_;                                 // of DeckModel::springs
  std::map<std::string, Keyword> matrices_;                         // of *MATRIX INPUT
  std::optional<Keyword> coupling_;                                 // the one that is open
  std::set<std::pair<int, int>> held_;
  bool kept_in_step_ = true; // no OP=NEW in this step so far
  int moved_ = 0;            // lines of prescribed displacements
  std::map<std::pair<int, int>, double> values_;
  std::vector<std::string> doubts_;
};

} // namespace plica
