// Numbers under which the coordinates of a superelement stand in the files of other programs.
//
// Boundary node k is grid 101 + k with DOFs 1..6; modal coordinate j is scalar point 1001 + j (DOF
// 1 where a program wants one).
#pragma once

#include "reduction/superelement.hpp"

#include <filesystem>

namespace plica {

constexpr int first_grid = 101, first_scalar = 1001;

struct CoordinateLabel {
  int point = 0, dof = 0; // dof 0 = scalar point
};
CoordinateLabel coordinate_label(const Superelement& s, int coordinate);

// "left.uy", "mode 3": the DOF order of every file.
std::vector<std::string> coordinate_names(const Superelement& s);

// The matrices that are there: K, M and, with damping, C (viscous) and D (structural).
struct NamedMatrix {
  char letter = 'K';
  const Eigen::MatrixXd* matrix = nullptr;
};
std::vector<NamedMatrix> matrices_of(const Superelement& s);

// std::runtime_error "file:line: what".
[[noreturn]] void bad_line(const std::filesystem::path& path, int line, const std::string& what);

} // namespace plica
