#include "reduction/fixed_interface.hpp"

#include "solve/dense_product.hpp"
#include "solve/model_error.hpp"
#include "solve/modes.hpp"
#include "solve/statics.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct FixedModes {
  VectorXd lambda;
  MatrixXd Phi;
  bool proved = false;
  std::string reason;
};

FixedModes fixed_modes(const SparseMatrix& K, const SparseMatrix& M, double cutoff,
                       BaseFactor& base) {
  const double highest = std::pow(2 * std::numbers::pi * cutoff, 2);
  if (base.factor.factorise(shifted(K, M, highest)).ok) // definite: no mode below
    return {.lambda = VectorXd(0), .Phi = MatrixXd(K.rows(), 0), .proved = true, .reason = ""};
  base.factor.factorise(K);
  const ModeSet set = find_modes(K, M, {.band = {0, cutoff}}, base);
  return {set.lambda, set.Phi, set.proof.passed, set.proof.reason};
}

// Psi R_b = R, to the last digit. Left alone when the part is held, so that R is no answer of it.
void keep_rigid(MatrixXd& Psi, const std::vector<int>& boundary, const MatrixXd& R) {
  if (boundary.empty() || R.cols() == 0) return;
  const MatrixXd R_b = R(boundary, Eigen::all);
  const MatrixXd missing = R - Psi * R_b;
  if (missing.norm() > 1e-5 * R.norm()) return;
  Psi += missing * R_b.completeOrthogonalDecomposition().pseudoInverse();
}

} // namespace

FixedInterface fixed_interface(const SparseMatrix& K, const SparseMatrix& M,
                               const std::vector<int>& boundary, double cutoff,
                               const MatrixXd& loads, const MatrixXd& rigid) {
  const auto n = static_cast<int>(K.rows());
  const auto nb = static_cast<Eigen::Index>(boundary.size());
  const std::vector<int> inner = complement(n, boundary);
  const SparseMatrix K_ii = restrict_to(K, inner), M_ii = restrict_to(M, inner);
  BaseFactor base = factor_below_spectrum(K_ii, M_ii);
  if (base.sigma != 0) throw ModelError("the part is a mechanism when its boundary is held");
  FixedInterface f;
  f.Psi = nb > 0 ? follow_boundary(K, boundary, base.factor, MatrixXd::Identity(nb, nb))
                 : MatrixXd(n, 0);
  f.X = MatrixXd::Zero(n, loads.cols());
  if (loads.cols() > 0) f.X(inner, Eigen::all) = base.factor.solve(loads(inner, Eigen::all));
  for (int i : boundary) f.unreduced = std::max(f.unreduced, K.coeff(i, i));
  f.K_bb = boundary_stiffness(K, boundary, f.Psi);
  keep_rigid(f.Psi, boundary, rigid);
  const MatrixXd MPsi = symmetric_product(M, f.Psi);
  f.M_bb = symmetrised(f.Psi.transpose() * MPsi);
  const FixedModes fixed = fixed_modes(K_ii, M_ii, cutoff, base);
  f.lambda = fixed.lambda;
  f.Phi = MatrixXd::Zero(n, fixed.Phi.cols());
  f.Phi(inner, Eigen::all) = fixed.Phi;
  f.M_bq = MPsi.transpose() * f.Phi;
  f.proved = fixed.proved;
  f.reason = fixed.reason;
  return f;
}

void check_boundary(const Model& model, const std::vector<int>& boundary) {
  if (boundary.empty()) throw std::invalid_argument("a superelement needs a boundary node");
  std::vector<int> sorted = boundary;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw std::invalid_argument("boundary node " + std::to_string(*twice + 1) + " is given twice");
  for (const Constraint& c : model.constraints)
    if (std::binary_search(sorted.begin(), sorted.end(), c.node))
      throw std::invalid_argument("boundary node " + std::to_string(c.node + 1) +
                                  " is the dependent side of " + c.origin +
                                  "; take its reference node");
}

Superelement empty_superelement(const Model& model, const std::vector<int>& boundary,
                                Eigen::Index modes) {
  Superelement s;
  for (int node : boundary) {
    s.nodes.push_back(model.mesh.nodes[node]);
    s.node_names.push_back("node " + std::to_string(node + 1));
  }
  s.K = MatrixXd::Zero(s.boundary() + modes, s.boundary() + modes);
  s.M = s.K;
  return s;
}

} // namespace plica
