// Decks of shells whose frequencies are known: a rectangle of steel on four edges, all corners of
// which lie in z = 0, and a clamped beam.
#pragma once

#include "lab/measured/measured.hpp"
#include "model/description/case.hpp"
#include "model/description/deck_model.hpp"
#include "tests/abaqus_plate.hpp"

#include <memory>
#include <set>

namespace plica::test::deck_panel {

inline constexpr double length = 0.3, width = 0.2, thickness = 2e-3, E = 2e11, nu = 0.3, rho = 8000;

inline Case drawn(int along, int across) {
  const Mesh mesh = deck_plate(along, across, thickness);
  std::set<int> edges;
  for (const char* edge : {"edge1", "edge2", "edge3", "edge4"})
    edges.insert(mesh.sets.at(edge).begin(), mesh.sets.at(edge).end());
  std::vector<int> all(mesh.nodes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = int(i);
  const std::string held = "*NSET, NSET=EDGES\n" + abaqus::list({edges.begin(), edges.end()}) +
                           "*NSET, NSET=EACH\n" + abaqus::list(all) +
                           "*BOUNDARY\nEDGES, 3, 3\nEACH, 1, 2\nEACH, 6, 6\n";
  Case c;
  c.name = "panel";
  DeckPart deck{.file = "panel.inp"};
  deck.content = std::make_shared<DeckModel>(
      abaqus::read_text(abaqus::mesh_text(mesh) + abaqus::steel + abaqus::section + held));
  c.parts.push_back({"panel", deck});
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  return c;
}

} // namespace plica::test::deck_panel

namespace plica::test {

// A beam along y, clamped at its start, that bends out of its plane alone; `SENSOR` is the node in
// its middle at that element along.
struct DeckBeam {
  double width = 0, length = 0, thickness = 0, E = 0, rho = 0; // SI
  int elements = 0, sensor = 0;
};

inline Case deck_beam(const DeckBeam& b) {
  const double half = b.width / 2;
  const Mesh mesh = mesh_plate(
      {Eigen::Vector3d(-half, 0, 0), {half, 0, 0}, {half, b.length, 0}, {-half, b.length, 0}}, 4,
      b.elements, b.thickness);
  std::vector<int> all(mesh.nodes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = int(i);
  const std::string text = "*HEADING\nbeam\n" + abaqus::nodes_text(mesh) +
                           abaqus::elements_text(mesh.quads, "S4") + "*NSET, NSET=ROOT\n" +
                           abaqus::list(mesh.sets.at("edge1")) + "*NSET, NSET=SENSOR\n" +
                           abaqus::list({node_at(mesh, {0, b.sensor * b.length / b.elements, 0})}) +
                           "*NSET, NSET=EACH\n" + abaqus::list(all) +
                           fmt::format("*MATERIAL, NAME=STEEL\n*ELASTIC\n{}, 0.3\n*DENSITY\n{}\n"
                                       "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL\n{}, 5\n",
                                       b.E, b.rho, b.thickness) +
                           "*BOUNDARY\nROOT, ENCASTRE\nEACH, 1, 1\nEACH, 6, 6\n";
  Case c;
  c.name = "beam";
  DeckPart deck{.file = "beam.inp"};
  deck.content = std::make_shared<DeckModel>(abaqus::read_text(text));
  c.parts.push_back({"beam", deck});
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  return c;
}

// What is read of it: shells do not say what bends.
inline Measured by_order_alone(Measured m) {
  for (MeasuredMode& mode : m.modes) {
    mode.shape = MeasuredShape::other;
    mode.direction.reset();
  }
  return m;
}

} // namespace plica::test
