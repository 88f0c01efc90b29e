// The modes of one circumferential order of a shell of revolution, alone and cheap.
//
// On a mesh of N equal steps round the axis the orders separate exactly: a mode of order n moves
// every ring, in cylindrical components, as u(theta) = a cos(n theta) + b sin(n theta). Two nodes
// per ring carry a and b (theta = 0 and n theta = 90 degrees, so 4n must divide N); the others
// follow them by constraints. The eigenvalues are those of the full mesh, pairs included.
#pragma once

#include "solve/couplings.hpp"
#include "solve/modes.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica::test {

// Constraints that make the node at angle `theta` follow the ring's node at angle `from` turned
// about y, times `factor`.
inline void follow(Constraint& row, int node, double turn, double factor) {
  const double c = std::cos(turn), s = std::sin(turn); // from x towards z
  const double rotation[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
  for (int j = 0; j < 3; ++j)
    if (rotation[row.dof % 3][j] != 0)
      row.terms.push_back({node, j + row.dof / 3 * 3, factor * rotation[row.dof % 3][j]});
}

// Both end circles held in all directions. `held`: DOFs to leave out of the motion at theta = 0;
// for n = 0, where ux uy rz there are axial motion and uz rx ry torsion, either can be had alone.
inline Model clamped_harmonic_model(const Mesh& mesh, const ShellProperties& shell, int n,
                                    const std::vector<int>& held = {}) {
  Model model;
  model.mesh = mesh;
  model.shells = {shell};
  for (const char* end : {"left", "right"})
    add_support(model, mesh.sets.at(end), {0, 1, 2, 3, 4, 5}, end);
  for (std::size_t j = 1; j + 1 < mesh.rings.size(); ++j) {
    const std::vector<int>& nodes = mesh.rings[j].nodes;
    const int around = static_cast<int>(nodes.size());
    if (n > 0 && around % (4 * n) != 0)
      throw std::invalid_argument("4n does not divide the elements round the circumference");
    const double step = 2 * std::numbers::pi / around;
    const int quarter = n > 0 ? around / (4 * n) : 0;
    add_support(model, {nodes[0]}, held, "held");
    for (int k = 1; k < around; ++k) {
      if (n > 0 && k == quarter) continue;
      for (int dof = 0; dof < 6; ++dof) {
        Constraint row{.node = nodes[k], .dof = dof, .terms = {}, .origin = "harmonic"};
        follow(row, nodes[0], k * step, std::cos(n * k * step));
        if (n > 0) follow(row, nodes[quarter], (k - quarter) * step, std::sin(n * k * step));
        model.constraints.push_back(std::move(row));
      }
    }
  }
  return model;
}

// Frequencies in Hz, complete (the proof must pass).
inline std::vector<double> frequencies(const Model& model, int count) {
  const System system = assemble(model);
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  const ModeSet modes = find_modes(system.K, system.M, {.count = count}, base);
  if (!modes.proof.passed) throw std::runtime_error(modes.proof.reason);
  std::vector<double> hertz;
  for (double lambda : modes.lambda) hertz.push_back(frequency(lambda));
  return hertz;
}

inline std::vector<double> axial_frequencies(const Mesh& mesh, const ShellProperties& shell,
                                             int count) {
  return frequencies(clamped_harmonic_model(mesh, shell, 0, {2, 3, 4}), count);
}

inline std::vector<double> torsion_frequencies(const Mesh& mesh, const ShellProperties& shell,
                                               int count) {
  return frequencies(clamped_harmonic_model(mesh, shell, 0, {0, 1, 5}), count);
}

// n > 0: one of each pair.
inline std::vector<double> pair_frequencies(const Mesh& mesh, const ShellProperties& shell, int n,
                                            int pairs) {
  const std::vector<double> both = frequencies(clamped_harmonic_model(mesh, shell, n), 2 * pairs);
  std::vector<double> one;
  for (std::size_t i = 0; i < both.size(); i += 2) one.push_back(both[i]);
  return one;
}

// Force over displacement of the right end circle, moved along the axis as a rigid ring.
inline double axial_stiffness(const Mesh& mesh, const ShellProperties& shell) {
  Model model = clamped_harmonic_model(mesh, shell, 0, {2, 3, 4});
  const std::vector<int>& end = mesh.sets.at("right");
  std::erase_if(model.constraints,
                [](const Constraint& c) { return c.origin == "right" && c.dof == 1; });
  for (std::size_t k = 1; k < end.size(); ++k)
    model.constraints.push_back(
        {.node = end[k], .dof = 1, .terms = {{end[0], 1, 1}}, .origin = ""});
  const System system = assemble(model);
  SparseFactor factor(system.K);
  if (!factor.factorise(system.K).ok) throw std::runtime_error("axial stiffness: a mechanism");
  Eigen::VectorXd force = Eigen::VectorXd::Zero(system.map.size());
  const int moved = system.map.independent[6 * end[0] + 1];
  force[moved] = 1;
  return 1 / factor.solve(force)(moved, 0);
}

} // namespace plica::test
