#include "reduction/matrix_difference.hpp"

#include "solve/element_view.hpp"

#include <map>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

bool same(const ShellSection& a, const ShellSection& b) {
  return a.E == b.E && a.nu == b.nu && a.rho == b.rho && a.bending_factor == b.bending_factor &&
         a.shear_correction == b.shear_correction && a.drilling == b.drilling &&
         a.thermal_strain == b.thermal_strain;
}
template <class Shell>
bool same(const Shell& a, const Model& of_a, const Shell& b, const Model& of_b) {
  return a.thickness == b.thickness &&
         same(of_a.shells[a.section].section, of_b.shells[b.section].section);
}
bool same(const BeamElement& a, const BeamElement& b) {
  const BeamProperties &s = a.section, &t = b.section;
  return s.EA == t.EA && s.EI_y == t.EI_y && s.EI_z == t.EI_z && s.GJ == t.GJ && s.GA_y == t.GA_y &&
         s.GA_z == t.GA_z && s.mass == t.mass && s.inertia_x == t.inertia_x &&
         s.inertia_y == t.inertia_y && s.inertia_z == t.inertia_z &&
         s.thermal_strain == t.thermal_strain;
}
bool same(const MassElement& a, const MassElement& b) {
  return a.node == b.node && a.body.mass == b.body.mass && a.body.offset == b.body.offset &&
         a.body.inertia == b.body.inertia;
}
bool same(const BushingElement& a, const BushingElement& b) {
  return a.node1 == b.node1 && a.node2 == b.node2 && a.bushing.law == b.bushing.law &&
         a.bushing.axes == b.bushing.axes && a.bushing.preload == b.bushing.preload;
}

// What one model has and the other has not: a model of its nodes and those elements alone.
Model only_in(const Model& model, const Model& other) {
  Model rest;
  rest.components = model.components;
  rest.mesh.nodes = model.mesh.nodes;
  rest.shells = model.shells;
  rest.rest = model.rest;
  const auto keep_shells = [&](const auto& own, const auto& others, auto& kept) {
    for (std::size_t i = 0; i < own.size(); ++i)
      if (!same(own[i], model, others[i], other)) kept.push_back(own[i]);
  };
  keep_shells(model.mesh.quads, other.mesh.quads, rest.mesh.quads);
  keep_shells(model.mesh.triangles, other.mesh.triangles, rest.mesh.triangles);
  const auto keep = [](const auto& own, const auto& others, auto& kept) {
    for (std::size_t i = 0; i < own.size(); ++i)
      if (i >= others.size() || !same(own[i], others[i])) kept.push_back(own[i]);
  };
  keep(model.beams, other.beams, rest.beams);
  keep(model.masses, other.masses, rest.masses);
  keep(model.bushings, other.bushings, rest.bushings);
  return rest;
}

using Triplets = std::vector<Eigen::Triplet<double>>;

// Adds the lower triangles of the matrices of one element, over the independent DOFs, times a
// factor.
void add_element(const DofMap& map, const std::vector<int>& nodes, const MatrixXd& K,
                 const MatrixXd& M, double factor, Triplets& k, Triplets& m) {
  std::vector<WeightedDof> reach;
  std::vector<std::size_t> start{0};
  for (int node : nodes)
    for (int dof = 6 * node; dof < 6 * node + 6; ++dof) {
      if (map.independent[dof] >= 0) reach.push_back({map.independent[dof], 1});
      for (const WeightedDof& w : map.dependent[dof]) reach.push_back(w);
      start.push_back(reach.size());
    }
  for (Index a = 0; a < K.rows(); ++a)
    for (Index b = 0; b < K.cols(); ++b)
      for (std::size_t i = start[a]; i < start[a + 1]; ++i)
        for (std::size_t j = start[b]; j < start[b + 1]; ++j) {
          const double weight = factor * reach[i].factor * reach[j].factor;
          if (reach[i].dof < reach[j].dof) continue;
          if (K(a, b) != 0) k.emplace_back(reach[i].dof, reach[j].dof, weight * K(a, b));
          if (M(a, b) != 0) m.emplace_back(reach[i].dof, reach[j].dof, weight * M(a, b));
        }
}

// What elements of one model have more than those of the other. Their quads are the same ones, one
// by one, of which only the difference is scattered.
void add_differences(const Model& more, const Model& less, const DofMap& map, Triplets& k,
                     Triplets& m) {
  const ElementView added{more}, removed{less};
  const int quads = int(more.mesh.quads.size());
  for (int e = 0; e < quads; ++e)
    added.visit(e, [&](const auto& nodes, const auto& K, const auto& M) {
      MatrixXd dK = K, dM = M;
      removed.visit(e, [&](const auto&, const auto& old_K, const auto& old_M) {
        dK -= old_K;
        dM -= old_M;
      });
      add_element(map, std::vector<int>(nodes.begin(), nodes.end()), dK, dM, 1, k, m);
    });
  for (const auto& [view, factor] : {std::pair{&added, 1.}, {&removed, -1.}})
    for (int e = quads; e < view->size(); ++e)
      view->visit(e, [&, sign = factor](const auto& nodes, const auto& K, const auto& M) {
        add_element(map, std::vector<int>(nodes.begin(), nodes.end()), K, M, sign, k, m);
      });
}

SparseMatrix from_triplets(int size, const Triplets& entries) {
  SparseMatrix A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

// Over the DOFs that have an entry.
MatrixDifference over_own_dofs(Triplets k, Triplets m, int unknowns) {
  MatrixDifference d;
  std::vector<int> number(std::size_t(unknowns), -1);
  for (const Triplets* all : {&k, &m})
    for (const auto& t : *all) number[std::size_t(t.row())] = number[std::size_t(t.col())] = 0;
  for (int i = 0; i < int(number.size()); ++i)
    if (number[std::size_t(i)] == 0) {
      number[std::size_t(i)] = int(d.dofs.size());
      d.dofs.push_back(i);
    }
  for (Triplets* all : {&k, &m})
    for (auto& t : *all)
      t = {number[std::size_t(t.row())], number[std::size_t(t.col())], t.value()};
  d.K = from_triplets(int(d.dofs.size()), k);
  d.M = from_triplets(int(d.dofs.size()), m);
  return d;
}

} // namespace

OnMotion on_mean_motion(std::vector<int> nodes, double mass, double stiffness) {
  const auto n = Index(nodes.size());
  MatrixXd rows = MatrixXd::Zero(3, 6 * n);
  for (Index a = 0; a < n; ++a) rows.block<3, 3>(0, 6 * a).diagonal().setConstant(1 / double(n));
  return {std::move(nodes), std::move(rows), mass, stiffness};
}

DofColumn dof_column(const DofMap& map, const std::vector<int>& nodes, int dof) {
  std::map<int, double> sum;
  const double share = 1 / double(nodes.size());
  for (int node : nodes) {
    const auto full = std::size_t(6 * node + dof);
    if (map.independent[full] >= 0) sum[map.independent[full]] += share;
    for (const WeightedDof& own : map.dependent[full]) sum[own.dof] += share * own.factor;
  }
  DofColumn column{{}, Eigen::VectorXd(Index(sum.size()))};
  for (const auto& [at, factor] : sum) {
    column.factors[Index(column.dofs.size())] = factor;
    column.dofs.push_back(at);
  }
  return column;
}

MatrixDifference matrix_difference(const Model& changed, const Model& nominal, const System& system,
                                   const std::vector<OnMotion>& on_motion) {
  MatrixDifference d;
  const bool other_shape = changed.mesh.nodes != nominal.mesh.nodes;
  const Model more = other_shape ? Model() : only_in(changed, nominal);
  // Another shape, with other arms, or other elements nearly everywhere: the whole anew.
  if (on_motion.empty() &&
      (other_shape || 2 * more.mesh.quads.size() > nominal.mesh.quads.size())) {
    const System other = assemble(changed);
    if (other.map.size() != system.map.size())
      throw std::invalid_argument("a change of a model that changes its unknowns");
    // A change of the modulus leaves the mass as it is, one of the density the stiffness.
    const auto is_there = [](int, int, double value) { return value != 0; };
    d.K = other.K - system.K;
    d.M = other.M - system.M;
    d.K.prune(is_there);
    d.M.prune(is_there);
    d.dofs.resize(std::size_t(system.map.size()));
    std::iota(d.dofs.begin(), d.dofs.end(), 0);
    return d;
  }
  if (other_shape) throw std::invalid_argument("a change of shape with masses on motions of nodes");
  Triplets k, m;
  for (const OnMotion& own : on_motion) {
    const MatrixXd square = own.rows.transpose() * own.rows;
    add_element(system.map, own.nodes, own.stiffness * square, own.mass * square, 1, k, m);
  }
  add_differences(more, only_in(nominal, changed), system.map, k, m);
  return over_own_dofs(k, m, system.map.size());
}

MatrixDifference difference_of(const MatrixDifference& both, const MatrixDifference& a,
                               const MatrixDifference& b, int unknowns) {
  constexpr double rounding = 1e-9; // of what an entry is the sum of
  const auto entries = [&](SparseMatrix MatrixDifference::*matrix) {
    Triplets terms, sizes, left;
    for (const auto& [part, sign] : {std::pair{&both, 1.}, {&a, -1.}, {&b, -1.}}) {
      const SparseMatrix& A = part->*matrix;
      for (int j = 0; j < A.outerSize(); ++j)
        for (SparseMatrix::InnerIterator it(A, j); it; ++it) {
          const int row = part->dofs[std::size_t(it.row())], column = part->dofs[std::size_t(j)];
          terms.emplace_back(row, column, sign * it.value());
          sizes.emplace_back(row, column, std::abs(it.value()));
        }
    }
    const SparseMatrix sum = from_triplets(unknowns, terms), size = from_triplets(unknowns, sizes);
    for (int j = 0; j < sum.outerSize(); ++j) { // of one pattern
      SparseMatrix::InnerIterator own(size, j);
      for (SparseMatrix::InnerIterator it(sum, j); it; ++it, ++own)
        if (std::abs(it.value()) > rounding * own.value())
          left.emplace_back(int(it.row()), j, it.value());
    }
    return left;
  };
  return over_own_dofs(entries(&MatrixDifference::K), entries(&MatrixDifference::M), unknowns);
}

} // namespace plica
