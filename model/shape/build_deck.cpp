#include "model/shape/build_deck.hpp"

#include "model/shape/build_surface.hpp"
#include "model/shape/deck.hpp"

#include <numeric>

namespace plica {

DeckPlacing placing_of(const DeckPart& part) {
  return {.units = {.length = part.length_unit, .mass = part.mass_unit},
          .turn = turn_of(part.rotate),
          .move = {part.move[0], part.move[1], part.move[2]},
          .held = part.held,
          .membrane = part.membrane};
}

Model deck_model(const DeckPart& part) {
  Model model = place(*part.content, placing_of(part));
  if (model.mesh.nodes.empty()) throw std::runtime_error("the deck has no element");
  std::vector<int>& all = model.mesh.sets["all"];
  all.resize(model.mesh.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  add_places(model.mesh, part.places);
  return model;
}

void append(Model& model, const Model& part, const std::string& name, int component) {
  const int section = static_cast<int>(model.shells.size());
  const std::size_t quads = model.mesh.quads.size(), triangles = model.mesh.triangles.size();
  const int first = append(model.mesh, part.mesh, name, section);
  for (std::size_t i = 0; i < part.mesh.quads.size(); ++i)
    model.mesh.quads[quads + i].section += part.mesh.quads[i].section;
  for (std::size_t i = 0; i < part.mesh.triangles.size(); ++i)
    model.mesh.triangles[triangles + i].section += part.mesh.triangles[i].section;
  for (ShellProperties shell : part.shells) {
    shell.component = component;
    model.shells.push_back(shell);
  }
  for (BeamElement beam : part.beams) {
    beam.node1 += first;
    beam.node2 += first;
    beam.component = component;
    model.beams.push_back(std::move(beam));
  }
  for (MassElement mass : part.masses) {
    mass.node += first;
    model.masses.push_back(mass);
  }
  for (BushingElement bushing : part.bushings) {
    bushing.node1 += first;
    if (bushing.node2 >= 0) bushing.node2 += first;
    bushing.component = component;
    model.bushings.push_back(bushing);
  }
  for (MatrixElement matrix : part.matrices) {
    for (int& node : matrix.nodes) node += first;
    matrix.component = component;
    model.matrices.push_back(std::move(matrix));
  }
  for (Constraint row : part.constraints) {
    row.node += first;
    for (ConstraintTerm& term : row.terms) term.node += first;
    row.origin = name + ": " + row.origin;
    model.constraints.push_back(std::move(row));
  }
}

} // namespace plica
