// A plate as a deck of Abaqus, nodes and quads from the mesh, and the same put together by hand.
#pragma once

#include "io/decks/read_abaqus.hpp"
#include "io/files/files.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <functional>

namespace plica::test::abaqus {

inline std::string list(const std::vector<int>& nodes) {
  std::string text;
  for (int node : nodes) text += fmt::format("{}\n", node + 1);
  return text;
}

inline std::string nodes_text(const Mesh& mesh) {
  std::string text = "*NODE\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += fmt::format("{}, {:.17g}, {:.17g}, {:.17g}\n", i + 1, mesh.nodes[i].x(),
                        mesh.nodes[i].y(), mesh.nodes[i].z());
  return text;
}

template <class Shells> std::string elements_text(const Shells& shells, const std::string& type) {
  std::string text = "*ELEMENT, TYPE=" + type + ", ELSET=WALL\n";
  for (std::size_t e = 0; e < shells.size(); ++e) {
    text += std::to_string(e + 1);
    for (int node : shells[e].nodes) text += fmt::format(", {}", node + 1);
    text += "\n";
  }
  return text;
}

inline std::string mesh_text(const Mesh& mesh) {
  return "*HEADING\nplate\n" + nodes_text(mesh) +
         (mesh.quads.empty() ? elements_text(mesh.triangles, "S3")
                             : elements_text(mesh.quads, "S4")) +
         "*NSET, NSET=ROOT\n" + list(mesh.sets.at("edge4")) + "*NSET, NSET=TIP\n" +
         list(mesh.sets.at("edge2"));
}

inline const std::string steel = "*MATERIAL, NAME=STEEL\n*ELASTIC\n2.0e11, 0.3\n*DENSITY\n8000.\n";
inline const std::string section = "*SHELL SECTION, ELSET=WALL, MATERIAL=STEEL\n2.e-3, 5\n";
inline const std::string clamped = "*BOUNDARY\nROOT, ENCASTRE\n";

inline DeckModel read_text(const std::string& text, UnknownCards unknown = UnknownCards::error) {
  const TemporaryFolder folder("abaqus");
  write_whole(folder.path / "model.inp", text);
  return read_abaqus(folder.path / "model.inp", unknown);
}

// The clamped plate with more keywords, and the same by hand.
inline void expect_plate(const std::string& more, const std::function<void(Model&)>& by_hand) {
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  by_hand(own);
  expect_same_frequencies(read_text(mesh_text(deck_plate()) + steel + section + clamped + more),
                          own);
}

inline const int corner = number_at(0.3, 0.2), middle = number_at(0.15, 0.1);

} // namespace plica::test::abaqus
