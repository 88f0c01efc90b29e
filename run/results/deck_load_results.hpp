// What the loads of a deck do, in one of its subcases or steps: plain data, SI units, global axes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace plica {

struct DeckLoadNode {
  std::string part;
  int label = 0;                            // its number in the deck
  Eigen::Vector3d at{0, 0, 0};              // m
  Eigen::Matrix<double, 6, 1> displacement; // m, rad
  Eigen::Matrix<double, 6, 1> reaction;     // N, Nm; zero where nothing holds it
  bool held = false;
};

struct DeckLoadResult {
  std::string name;                 // "bracket, subcase 2"
  std::array<double, 6> load{};     // sum of what acts: N, and Nm about the origin
  std::array<double, 6> reaction{}; // of what is held rigidly; springs to the ground not among it
  double energy = 0;                // of strain, J
  double residual = 0;              // ||f - K u|| / ||f||
  double largest = 0;               // displacement, m
  std::array<double, 3> at{};       // where, m
  std::vector<DeckLoadNode> nodes;  // of the deck that acts
  Eigen::MatrixXd sensors;          // sensors x 6: displacement of the node of each
};

} // namespace plica
