#include "reduction/craig_bampton.hpp"

#include "solve/modes.hpp"
#include "solve/parallel.hpp"
#include "solve/statics.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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

// Reduced blocks over given boundary DOFs of one system.
struct Blocks {
  MatrixXd K_bb, M_bb, M_bq;
  VectorXd lambda;
  MatrixXd Psi, Phi; // all DOFs of the system
  bool proved = false;
  std::string reason;
};

struct FixedModes {
  VectorXd lambda;
  MatrixXd Phi;
  bool proved = false;
  std::string reason;
};

// All of a small system at once: M x = mu K x, for M may be semidefinite.
FixedModes all_modes(const SparseMatrix& K, const SparseMatrix& M, double highest) {
  const MatrixXd k = MatrixXd(K).selfadjointView<Eigen::Lower>(),
                 m = MatrixXd(M).selfadjointView<Eigen::Lower>();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(m, k);
  std::vector<int> kept;
  for (Eigen::Index j = solver.eigenvalues().size() - 1; j >= 0; --j)
    if (solver.eigenvalues()[j] * highest >= 1) kept.push_back(int(j));
  FixedModes modes{.lambda = solver.eigenvalues()(kept).cwiseInverse(),
                   .Phi = solver.eigenvectors()(Eigen::all, kept),
                   .proved = true,
                   .reason = ""};
  for (Eigen::Index j = 0; j < modes.lambda.size(); ++j) // from K- to mass-normalised
    modes.Phi.col(j) *= std::sqrt(modes.lambda[j]);
  return modes;
}

FixedModes fixed_modes(const SparseMatrix& K, const SparseMatrix& M, double cutoff,
                       BaseFactor& base) {
  constexpr int small = 150; // unknowns for which all modes at once are the simplest way
  if (K.rows() <= small) return all_modes(K, M, std::pow(2 * std::numbers::pi * cutoff, 2));
  const ModeSet set = find_modes(K, M, {.band = {0, cutoff}}, base);
  return {set.lambda, set.Phi, set.proof.passed, set.proof.reason};
}

Blocks reduce(const SparseMatrix& K, const SparseMatrix& M, const std::vector<int>& boundary,
              double cutoff) {
  const auto n = static_cast<int>(K.rows());
  const std::vector<int> inner = complement(n, boundary);
  const SparseMatrix K_ii = restrict_to(K, inner), M_ii = restrict_to(M, inner);
  BaseFactor base = factor_below_spectrum(K_ii, M_ii);
  if (base.sigma != 0)
    throw std::runtime_error("the part is a mechanism when its boundary is held");
  Blocks b;
  b.Psi = follow_boundary(
      K, boundary, base.factor,
      MatrixXd::Identity(Eigen::Index(boundary.size()), Eigen::Index(boundary.size())));
  const MatrixXd KPsi = symmetric_product(K, b.Psi), MPsi = symmetric_product(M, b.Psi);
  b.K_bb = KPsi(boundary, Eigen::all); // the rest of K Psi vanishes
  b.K_bb = ((b.K_bb + b.K_bb.transpose()) / 2).eval();
  b.M_bb = b.Psi.transpose() * MPsi;
  b.M_bb = ((b.M_bb + b.M_bb.transpose()) / 2).eval();
  const FixedModes fixed = fixed_modes(K_ii, M_ii, cutoff, base);
  b.lambda = fixed.lambda;
  b.Phi = MatrixXd::Zero(n, fixed.Phi.cols());
  b.Phi(inner, Eigen::all) = fixed.Phi;
  b.M_bq = MPsi.transpose() * b.Phi;
  b.proved = fixed.proved;
  b.reason = fixed.reason;
  return b;
}

// Empty matrices of a superelement with room for the modes.
Superelement empty_element(const Model& model, const std::vector<int>& boundary,
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

void clean(Superelement& s) {
  const Eigen::Index n = s.boundary();
  s.K.topLeftCorner(n, n) = without_grounding(s.K.topLeftCorner(n, n), s.nodes);
}

// Adds blocks whose boundary coordinates are D' u_b, their modes from `first` on.
void add_blocks(Superelement& s, const Blocks& b, const MatrixXd& D, Eigen::Index first) {
  const Eigen::Index n = s.boundary(), m = b.lambda.size();
  s.K.topLeftCorner(n, n) += D * b.K_bb * D.transpose();
  s.M.topLeftCorner(n, n) += D * b.M_bb * D.transpose();
  s.M.block(0, n + first, n, m) = D * b.M_bq;
  s.M.block(n + first, 0, m, n) = (D * b.M_bq).transpose();
  s.M.block(n + first, n + first, m, m).setIdentity();
  s.K.block(n + first, n + first, m, m).diagonal() = b.lambda;
}

} // namespace

Reduction craig_bampton(const Model& model, const std::vector<int>& boundary, double cutoff) {
  check_boundary(model, boundary);
  const auto system = std::make_shared<System>(assemble(model));
  std::vector<int> dofs;
  for (int node : boundary)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof)
      dofs.push_back(system->map.independent[dof]);
  // The partition wants increasing numbers; D puts them back in the order given.
  std::vector<int> sorted = dofs;
  std::sort(sorted.begin(), sorted.end());
  MatrixXd D = MatrixXd::Zero(Eigen::Index(dofs.size()), Eigen::Index(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i)
    D(i, std::lower_bound(sorted.begin(), sorted.end(), dofs[i]) - sorted.begin()) = 1;
  const auto blocks = std::make_shared<Blocks>(reduce(system->K, system->M, sorted, cutoff));
  Reduction r{.element = empty_element(model, boundary, blocks->lambda.size()),
              .lambda = blocks->lambda,
              .field = {},
              .field_at = {},
              .proved = blocks->proved,
              .reason = blocks->reason};
  add_blocks(r.element, *blocks, D, 0);
  clean(r.element);
  r.field = [system, blocks, D](const MatrixXd& c) {
    const Eigen::Index n = D.rows();
    const MatrixXd q =
        blocks->Psi * (D.transpose() * c.topRows(n)) + blocks->Phi * c.bottomRows(c.rows() - n);
    return expand(system->map, q);
  };
  r.field_at = [field = r.field](const MatrixXd& c, const std::vector<int>& nodes) {
    const MatrixXd u = field(c);
    MatrixXd chosen(6 * Eigen::Index(nodes.size()), c.cols());
    for (std::size_t i = 0; i < nodes.size(); ++i)
      chosen.middleRows<6>(6 * Eigen::Index(i)) = u.middleRows<6>(6 * nodes[i]);
    return chosen;
  };
  return r;
}

Reduction craig_bampton(const CyclicModel& given, const std::vector<int>& boundary, double cutoff) {
  check_boundary(given.model(), boundary);
  struct Family {
    HarmonicSystem system;
    Blocks blocks;
    MatrixXd D;
    Eigen::Index first = 0;
  };
  const auto model = std::make_shared<CyclicModel>(given);
  const auto families = std::make_shared<std::vector<Family>>();
  // The boundary unknowns of a harmonic, and D: the DOFs of the boundary nodes by them.
  const auto family_of = [&](HarmonicSystem system, const Blocks* known) {
    std::vector<std::pair<int, Eigen::VectorXd>> unknowns; // number, column of D
    for (std::size_t b = 0; b < boundary.size(); ++b)
      for (const AxisUnknown& a : system.axis) {
        if (a.node != boundary[b]) continue;
        VectorXd column = VectorXd::Zero(6 * Eigen::Index(boundary.size()));
        column.segment<6>(6 * Eigen::Index(b)) = a.direction;
        unknowns.emplace_back(a.number, column);
      }
    std::sort(unknowns.begin(), unknowns.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    Family family;
    family.D.resize(6 * Eigen::Index(boundary.size()), Eigen::Index(unknowns.size()));
    std::vector<int> numbers;
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      numbers.push_back(unknowns[k].first);
      family.D.col(Eigen::Index(k)) = unknowns[k].second;
    }
    family.blocks = known ? *known : reduce(system.K, system.M, numbers, cutoff);
    family.system = std::move(system);
    return family;
  };
  for (int node : boundary)
    for (const Ring& ring : given.model().mesh.rings)
      if (std::find(ring.nodes.begin(), ring.nodes.end(), node) != ring.nodes.end())
        throw std::invalid_argument("boundary node " + std::to_string(node + 1) +
                                    " lies on the wall; by symmetry only nodes on the axis can be");
  constexpr std::array solved{Harmonic{0, false}, Harmonic{0, true}, Harmonic{1, false}};
  families->resize(solved.size());
  in_parallel(int(solved.size()),
              [&](int i) { (*families)[i] = family_of(model->system(solved[i]), nullptr); });
  const Blocks cosine = families->back().blocks;
  families->push_back(family_of(model->quarter_turned(families->back().system), &cosine));
  Eigen::Index modes = 0;
  for (Family& f : *families) {
    f.first = modes;
    modes += f.blocks.lambda.size();
  }
  Reduction r{.element = empty_element(given.model(), boundary, modes),
              .lambda = VectorXd(modes),
              .field = {},
              .field_at = {},
              .proved = true,
              .reason = ""};
  for (const Family& f : *families) {
    add_blocks(r.element, f.blocks, f.D, f.first);
    r.lambda.segment(f.first, f.blocks.lambda.size()) = f.blocks.lambda;
    r.proved = r.proved && f.blocks.proved;
    if (!f.blocks.proved)
      r.reason = "harmonic " + std::to_string(f.system.harmonic.n) + ": " + f.blocks.reason;
  }
  clean(r.element);
  const auto coordinates = [](const Family& f, const MatrixXd& c) {
    return MatrixXd(f.blocks.Psi * (f.D.transpose() * c.topRows(f.D.rows())) +
                    f.blocks.Phi * c.middleRows(f.D.rows() + f.first, f.blocks.lambda.size()));
  };
  r.field = [model, families, coordinates](const MatrixXd& c) {
    MatrixXd u = MatrixXd::Zero(dof_count(model->model()), c.cols());
    for (const Family& f : *families) u += model->expand(f.system, coordinates(f, c));
    return u;
  };
  r.field_at = [model, families, coordinates](const MatrixXd& c, const std::vector<int>& nodes) {
    MatrixXd u = MatrixXd::Zero(6 * Eigen::Index(nodes.size()), c.cols());
    for (const Family& f : *families) u += model->expand(f.system, coordinates(f, c), nodes);
    return u;
  };
  return r;
}

} // namespace plica
