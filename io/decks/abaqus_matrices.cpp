// *MATRIX INPUT, whose lines are node, DOF, node, DOF, value, and *MATRIX ASSEMBLE.
#include "io/decks/abaqus_joints.hpp"
#include "io/decks/deck_matrices.hpp"
#include "words/short_text.hpp"

#include <sstream>

namespace plica {
namespace {

std::vector<DataLine> lines_of(const Keyword& k) {
  if (!k.has("INPUT")) return k.data;
  const std::filesystem::path file =
      std::filesystem::path(k.at.file).parent_path() / k.parameters.at("INPUT");
  std::istringstream stream(included_text(file, k.at, "*" + k.name, 1, 1));
  std::vector<DataLine> lines;
  DeckPosition at{file.string(), 0};
  for (std::string text; std::getline(stream, text);) {
    ++at.line;
    if (trimmed(text).empty() || text.starts_with("**")) continue;
    std::istringstream fields(text);
    DataLine line{at, {}};
    for (std::string field; std::getline(fields, field, ',');)
      line.fields.emplace_back(trimmed(field));
    lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace

void AbaqusJoints::matrix_input(const Keyword& k) {
  const std::string name = k.word("NAME");
  if (const auto [known, first] = matrices_.try_emplace(name, k); !first)
    deck_error(k.at, "*MATRIX INPUT",
               "matrix " + name + " is there already in line " +
                   std::to_string(known->second.at.line),
               "a name once");
  if (const std::string type = k.word_or("TYPE", "SYMMETRIC");
      type != "SYMMETRIC" && type != "UNSYMMETRIC")
    deck_error(k.at, "*MATRIX INPUT", "has TYPE=" + type, "SYMMETRIC or UNSYMMETRIC");
}

void AbaqusJoints::matrix_assemble(const Keyword& k) {
  for (const auto& [parameter, kind] :
       {std::pair{"STIFFNESS", GivenKind::stiffness}, std::pair{"MASS", GivenKind::mass}}) {
    if (!k.has(parameter)) continue;
    const auto found = matrices_.find(k.word(parameter));
    if (found == matrices_.end())
      deck_error(k.at, "*MATRIX ASSEMBLE", "there is no matrix " + k.word(parameter),
                 "*MATRIX INPUT, NAME=...");
    const Keyword& input = found->second;
    GivenMatrix matrix;
    std::set<std::pair<GivenMatrix::Dof, GivenMatrix::Dof>> given;
    bool mirrored = false; // both triangles are there
    for (const DataLine& line : lines_of(input)) {
      const GivenMatrix::Dof row{mesh_.node(input, line, 0), dof_in(input, line, 1)},
          column{mesh_.node(input, line, 2), dof_in(input, line, 3)};
      if (!given.insert({row, column}).second)
        deck_error(line.at, "*MATRIX INPUT", "has this entry twice", "an entry once");
      mirrored = mirrored || (row != column && given.contains({column, row}));
      matrix.add(row, column, number_in(input, line, 4));
    }
    if (matrix.empty())
      deck_error(input.at, "*MATRIX INPUT", "has no entry", "node, DOF, node, DOF, value");
    const bool triangle = input.word_or("TYPE", "SYMMETRIC") == "SYMMETRIC" && !mirrored;
    assembled_.insert(deck_.springs.size());
    deck_.springs.push_back(
        matrix.element(deck_, kind, triangle, 1, input.at, "*MATRIX INPUT " + k.word(parameter)));
  }
  for (const char* damping : {"VISCOUS DAMPING", "STRUCTURAL DAMPING"})
    if (k.has(damping))
      deck_.notes.push_back("*MATRIX ASSEMBLE: " + std::string(damping) +
                            " is passed over: the case says what damps");
}

// Nodes that only matrices use, and of which they use DOF 1 alone, are modal coordinates: without
// place or direction, they do not turn with the part.
void AbaqusJoints::find_modal_points() {
  std::set<int> points, others;
  for (std::size_t i = 0; i < deck_.springs.size(); ++i) {
    const MatrixElement& e = deck_.springs[i];
    if (!assembled_.contains(i)) {
      others.insert(e.nodes.begin(), e.nodes.end());
      continue;
    }
    for (std::size_t n = 0; n < e.nodes.size(); ++n) {
      points.insert(e.nodes[n]);
      const auto first = static_cast<Eigen::Index>(6 * n);
      if (!e.K.middleRows(first + 1, 5).isZero(0) || !e.M.middleRows(first + 1, 5).isZero(0))
        others.insert(e.nodes[n]);
    }
  }
  for (const DeckShell& s : deck_.shells) others.insert(s.nodes.begin(), s.nodes.end());
  for (const BeamElement& b : deck_.beams) others.insert({b.node1, b.node2});
  for (const BushingElement& b : deck_.bushings) others.insert({b.node1, b.node2});
  for (const MassElement& m : deck_.masses) others.insert(m.node);
  for (const DeckCoupling& c : deck_.couplings) {
    others.insert(c.reference);
    others.insert(c.nodes.begin(), c.nodes.end());
  }
  for (const Constraint& row : deck_.equations) {
    others.insert(row.node);
    for (const ConstraintTerm& term : row.terms) others.insert(term.node);
  }
  for (int point : points)
    if (!others.contains(point) && !deck_.axes.contains(point)) deck_.scalars.insert(point);
  std::erase_if(deck_.supports, [&](const Constraint& row) { // of DOFs that they do not have
    return deck_.scalars.contains(row.node) && row.dof > 0;
  });
}

} // namespace plica
