// Decks written by the tests themselves, and what they are held against.
#pragma once

#include "mesh/plate.hpp"
#include "model/shape/deck.hpp"
#include "tests/support/fields.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace plica::test {

constexpr double deck_agreement = 1e-9; // relative, of eigenfrequencies

// 0.3 x 0.2 x 0.002, 6 x 4 elements, E 2e11, nu 0.3, rho 8000, clamped at x = 0.
inline Mesh deck_plate(int along = 6, int across = 4, double thickness = 2e-3) {
  return mesh_plate({Eigen::Vector3d(0, 0, 0), {0.3, 0, 0}, {0.3, 0.2, 0}, {0, 0.2, 0}}, along,
                    across, thickness);
}

inline Model own_plate(Mesh mesh = deck_plate()) {
  Model model = shell_model(std::move(mesh), {.E = 2e11, .nu = 0.3, .rho = 8000},
                            MembraneStrain::incompatible);
  model.components = {"plate"};
  return model;
}

// A Nastran deck whose elements have consistent mass, as those put together by hand.
inline std::string of_consistent_mass(std::string bulk) {
  return bulk.insert(std::min(bulk.find("ENDDATA"), bulk.size()), "PARAM,COUPMASS,1\n");
}

// Number in a deck of the node at a point of the plate.
inline int number_at(double x, double y) {
  return node_at(deck_plate(), {x, y, 0}) + 1;
}

// A body off the end of the plate, on a node of its own.
inline int add_body(Model& own) {
  const int node = add_node(own, {0.34, 0.08, 0.03});
  RigidMass mass{.mass = 0.4};
  mass.inertia.diagonal() << 1e-4, 1e-4, 2e-4;
  own.masses.push_back({node, mass});
  return node;
}

// The lowest frequencies of the deck are those of our own model.
inline void expect_same_frequencies(const DeckModel& deck, const Model& own, int count = 8) {
  const Eigen::VectorXd theirs = find_modes(place(deck, {}), count).hertz;
  const Eigen::VectorXd ours = find_modes(own, count).hertz;
  ASSERT_EQ(theirs.size(), ours.size());
  for (Eigen::Index i = 0; i < ours.size(); ++i)
    EXPECT_LE(std::abs(theirs[i] / ours[i] - 1), deck_agreement)
        << "mode " << i + 1 << ": " << theirs[i] << " of the deck, " << ours[i];
}

} // namespace plica::test
