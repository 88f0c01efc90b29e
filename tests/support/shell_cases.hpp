// Shapes of shell elements that every test of the element runs over.
#pragma once

#include "elements/shell_mitc4.hpp"

#include <string>
#include <utility>
#include <vector>

namespace plica::test {

struct ShellCase {
  std::string name;
  ShellGeometry geometry;
};

ShellGeometry flat_shell();           // 1.2 x 0.8 in x-y, 0.1 thick
std::vector<ShellCase> flat_shells(); // flat, parallelogram, skewed, turned in space
std::vector<ShellCase> all_shells();  // these and warped ones, curved directors, tapered walls

const std::vector<std::pair<std::string, MembraneStrain>> membranes{
    {"displacement", MembraneStrain::displacement},
    {"mitc4_plus", MembraneStrain::mitc4_plus},
    {"incompatible", MembraneStrain::incompatible}};

std::vector<Eigen::Vector3d> corners(const ShellGeometry& geometry);

// Numbers in [-1, 1].
Eigen::VectorXd random_vector(int size, unsigned seed);

} // namespace plica::test
