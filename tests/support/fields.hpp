// What the mechanics tests share: surfaces meshed from a formula, loads, static and modal
// solutions.
#pragma once

#include "solve/couplings.hpp"
#include "solve/modes.hpp"
#include "tests/support/verification_line.hpp"

#include <functional>

namespace plica::test {

struct SurfacePoint {
  Eigen::Vector3d position, normal; // the normal of any length
};

// The point at a, b in [0, 1]; (x_a, x_b, normal) right-handed.
using ParametricSurface = std::function<SurfacePoint(double a, double b)>;

// `along` x `across` quads with the normals of the surface as directors. Sets: a0 a1 b0 b1 (the
// edges a = 0, a = 1, b = 0, b = 1) and all. Edges that coincide are not merged.
Mesh mesh_surface(const ParametricSurface& surface, int along, int across, double thickness);

Model shell_model(Mesh mesh, const ShellSection& section,
                  MembraneStrain membrane = MembraneStrain::displacement);

const std::vector<int> all_dofs{0, 1, 2, 3, 4, 5};

// Holds DOFs on a node set of the mesh.
void hold(Model& model, const std::string& set, const std::vector<int>& dofs);

// Symmetry about a plane normal to the axis 0, 1 or 2.
void hold_symmetry(Model& model, const std::string& set, int axis);

// No motion along a direction: of the displacement (first = 0) or the rotation (first = 3).
void hold_along(Model& model, int node, int first, const Eigen::Vector3d& direction);

int node_at(const Mesh& mesh, const Eigen::Vector3d& position); // fails the test when it is off

Eigen::VectorXd no_force(const Model& model); // all DOFs
Eigen::VectorXd area_load(const Model& model, const Eigen::Vector3d& load);

// A resultant spread evenly over an edge of equal elements.
void add_edge_force(const Model& model, const std::string& set, int dof, double resultant,
                    Eigen::VectorXd& force);

// Displacements of all DOFs under forces on all DOFs.
Eigen::VectorXd solve_static(const Model& model, const Eigen::VectorXd& force);

// |value / wanted - 1| <= tolerance
void expect_ratio(double value, double wanted, double tolerance, const std::string& what);

struct SolvedModes {
  Eigen::VectorXd hertz;
  Eigen::MatrixXd u; // all DOFs
  System system;
  ModeSet set;
};

// The lowest modes; fails the test when the proof of completeness does.
SolvedModes find_modes(const Model& model, int count);

// K (or M) in full, from the lower triangle.
Eigen::MatrixXd dense(const SparseMatrix& lower);

// Exponent of an error e ~ h^p from values on three meshes, each twice as fine as the last.
double observed_order(double coarse, double middle, double fine);

} // namespace plica::test
