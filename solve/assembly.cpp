#include "solve/assembly.hpp"

#include "solve/element_view.hpp"
#include "solve/independent_element.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <omp.h>

namespace plica {
namespace {

using Eigen::MatrixXd;

// Lists of integers of varying length, one after another.
struct Lists {
  std::vector<int> start{0}, items;
  int size() const { return static_cast<int>(start.size()) - 1; }
  auto begin(int i) const { return items.begin() + start[i]; }
  auto end(int i) const { return items.begin() + start[i + 1]; }
};

Lists reached_by_elements(const ElementView& elements, const DofMap& map) {
  Lists lists;
  for (int e = 0; e < elements.size(); ++e) {
    const std::vector<int> reached = reached_nodes(map, elements.nodes(e));
    lists.items.insert(lists.items.end(), reached.begin(), reached.end());
    lists.start.push_back(static_cast<int>(lists.items.size()));
  }
  return lists;
}

// Node -> elements that reach it.
Lists transpose(const Lists& lists, int columns) {
  Lists result;
  result.start.assign(columns + 1, 0);
  for (int item : lists.items) ++result.start[item + 1];
  for (int i = 0; i < columns; ++i) result.start[i + 1] += result.start[i];
  result.items.resize(lists.items.size());
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  for (int i = 0; i < lists.size(); ++i)
    for (auto it = lists.begin(i); it != lists.end(i); ++it) result.items[next[*it]++] = i;
  return result;
}

// Pattern of the lower triangle by pairs of nodes: neighbours J -> I >= J.
struct Pattern {
  std::vector<std::vector<int>> neighbours; // per node, increasing, itself first
  std::vector<std::vector<int>> offset;     // rows of the column above each neighbour
};

Pattern node_pattern(const DofMap& map, const Lists& reached, const Lists& elements_of_node) {
  const int nodes = elements_of_node.size();
  Pattern pattern;
  pattern.neighbours.resize(nodes);
  pattern.offset.resize(nodes);
#pragma omp parallel for schedule(dynamic, 64)
  for (int J = 0; J < nodes; ++J) {
    std::vector<int>& list = pattern.neighbours[J];
    for (auto e = elements_of_node.begin(J); e != elements_of_node.end(J); ++e)
      for (auto I = reached.begin(*e); I != reached.end(*e); ++I)
        if (*I >= J) list.push_back(*I);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    int rows = 0;
    for (int I : list) {
      pattern.offset[J].push_back(rows);
      rows += map.first[I + 1] - map.first[I];
    }
  }
  return pattern;
}

SparseMatrix empty_matrix(const DofMap& map, const Pattern& pattern) {
  const int n = map.size();
  SparseMatrix A(n, n);
  std::vector<int> columns(n);
  std::int64_t entries = 0;
  for (int J = 0; J < static_cast<int>(pattern.neighbours.size()); ++J) {
    const auto& list = pattern.neighbours[J];
    if (list.empty()) continue;
    const int rows = pattern.offset[J].back() + map.first[list.back() + 1] - map.first[list.back()];
    for (int j = map.first[J]; j < map.first[J + 1]; ++j) {
      columns[j] = rows - (j - map.first[J]);
      entries += columns[j];
    }
  }
  if (entries > std::numeric_limits<int>::max())
    throw std::length_error("the stiffness matrix has more than 2^31 entries");
  A.resizeNonZeros(static_cast<Eigen::Index>(entries));
  int* outer = A.outerIndexPtr();
  outer[0] = 0;
  for (int j = 0; j < n; ++j) outer[j + 1] = outer[j] + columns[j];
#pragma omp parallel for schedule(static)
  for (int J = 0; J < static_cast<int>(pattern.neighbours.size()); ++J)
    for (int j = map.first[J]; j < map.first[J + 1]; ++j) {
      int* row = A.innerIndexPtr() + outer[j];
      for (int I : pattern.neighbours[J])
        for (int i = std::max(map.first[I], j); i < map.first[I + 1]; ++i) *row++ = i;
    }
  std::fill(A.valuePtr(), A.valuePtr() + entries, 0.);
  return A;
}

// Elements by colour, those of one colour sharing no node.
std::vector<std::vector<int>> colours(const Lists& reached, int nodes) {
  std::vector<std::vector<bool>> used(nodes); // per node: colours of its elements so far
  std::vector<std::vector<int>> result;
  for (int e = 0; e < reached.size(); ++e) {
    std::size_t colour = 0;
    const auto taken = [&](std::size_t c) {
      return std::any_of(reached.begin(e), reached.end(e),
                         [&](int n) { return c < used[n].size() && used[n][c]; });
    };
    while (taken(colour)) ++colour;
    for (auto n = reached.begin(e); n != reached.end(e); ++n) {
      if (used[*n].size() <= colour) used[*n].resize(colour + 1);
      used[*n][colour] = true;
    }
    if (result.size() <= colour) result.resize(colour + 1);
    result[colour].push_back(e);
  }
  return result;
}

// Adds element matrices to K and M.
class Scatter {
public:
  Scatter(System& system, const Pattern& pattern) : system_(system), pattern_(pattern) {}

  template <class Nodes, class Matrix>
  void operator()(const Nodes& nodes, const Matrix& K, const Matrix& M) const {
    on_independent(system_.map, nodes, K, M,
                   [&](const std::vector<int>& q, const auto& k, const auto& m) { add(q, k, m); });
  }

private:
  template <class Matrix>
  void add(const std::vector<int>& q, const Matrix& K, const Matrix& M) const {
    const int* outer = system_.K.outerIndexPtr();
    double* k = system_.K.valuePtr();
    double* m = system_.M.valuePtr();
    const int n = static_cast<int>(q.size());
    for (int b = 0; b < n; ++b) {
      if (q[b] < 0) continue;
      const int j = q[b], J = system_.map.full[j] / 6;
      const std::vector<int>& list = pattern_.neighbours[J];
      int last_node = -1, last_offset = 0; // rows of one node follow one another
      for (int a = 0; a < n; ++a) {
        const int i = q[a];
        if (i < j) continue;
        const int I = system_.map.full[i] / 6;
        if (I != last_node) {
          last_node = I;
          last_offset =
              pattern_.offset[J][std::lower_bound(list.begin(), list.end(), I) - list.begin()];
        }
        const int position =
            outer[j] + last_offset + (i - system_.map.first[I]) - (j - system_.map.first[J]);
        k[position] += K(a, b);
        m[position] += M(a, b);
      }
    }
  }

  System& system_;
  const Pattern& pattern_;
};

} // namespace

System assemble(const Model& model) {
  System system{.map = eliminate(model), .K = {}, .M = {}};
  const ElementView elements{model};
  const int nodes = static_cast<int>(model.mesh.nodes.size());
  const Lists reached = reached_by_elements(elements, system.map);
  const Pattern pattern = node_pattern(system.map, reached, transpose(reached, nodes));
  system.K = empty_matrix(system.map, pattern);
  system.M = system.K;
  const Scatter scatter(system, pattern);
  std::exception_ptr error;
  for (const std::vector<int>& colour : colours(reached, nodes)) {
#pragma omp parallel for schedule(static) if (colour.size() > 64)
    for (int c = 0; c < static_cast<int>(colour.size()); ++c) {
      try {
        elements.visit(colour[c], scatter);
      } catch (...) {
#pragma omp critical(plica_assembly_error)
        error = std::current_exception();
      }
    }
    if (error) std::rethrow_exception(error);
  }
  return system;
}

SparseMatrix restrict_to(const SparseMatrix& lower, const std::vector<int>& kept) {
  const int n = static_cast<int>(kept.size());
  std::vector<int> number(lower.rows(), -1);
  for (int i = 0; i < n; ++i) number[kept[i]] = i;
  SparseMatrix result(n, n);
  result.reserve(lower.nonZeros());
  for (int j = 0; j < n; ++j) {
    result.startVec(j);
    for (SparseMatrix::InnerIterator it(lower, kept[j]); it; ++it)
      if (number[it.row()] >= 0) result.insertBack(number[it.row()], j) = it.value();
  }
  result.finalize();
  return result;
}

void add_dense(SparseMatrix& lower, const std::vector<int>& dofs, const MatrixXd& block) {
  for (std::size_t b = 0; b < dofs.size(); ++b)
    for (std::size_t a = 0; a < dofs.size(); ++a)
      if (dofs[a] >= dofs[b]) lower.coeffRef(dofs[a], dofs[b]) += block(a, b);
}

// By blocks of columns, each held by rows, so that an entry of the matrix meets neighbours in
// memory.
MatrixXd symmetric_product(const SparseMatrix& lower, const MatrixXd& x) {
  constexpr int width = 8;
  using Block = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;
  if (x.cols() < width / 2) return lower.selfadjointView<Eigen::Lower>() * x;
  MatrixXd y(lower.rows(), x.cols());
  const int blocks = int((x.cols() + width - 1) / width);
#pragma omp parallel for schedule(dynamic) if (blocks > 1 && !omp_in_parallel())
  for (int b = 0; b < blocks; ++b) {
    const auto columns =
        Eigen::seqN(b * width, std::min<Eigen::Index>(width, x.cols() - b * width));
    Block in = Block::Zero(x.rows(), width), out = Block::Zero(x.rows(), width);
    in.leftCols(columns.size()) = x(Eigen::all, columns);
    for (int j = 0; j < lower.outerSize(); ++j) {
      Eigen::Matrix<double, 1, width> sum = Eigen::Matrix<double, 1, width>::Zero();
      const Eigen::Matrix<double, 1, width> own = in.row(j);
      for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
        out.row(it.row()) += it.value() * own;
        if (it.row() != j) sum += it.value() * in.row(it.row());
      }
      out.row(j) += sum;
    }
    y(Eigen::all, columns) = out.leftCols(columns.size());
  }
  return y;
}

MatrixXd rigid_body_motions(const Model& model, const DofMap& map, const Eigen::Vector3d& about) {
  MatrixXd R = MatrixXd::Zero(map.size(), 6);
  for (int i = 0; i < map.size(); ++i) {
    const int node = map.full[i] / 6, dof = map.full[i] % 6;
    if (model.scalar_nodes.contains(node)) continue;
    const Eigen::Vector3d d = model.mesh.nodes[node] - about;
    R(i, dof) = 1;
    if (dof == 0) R.row(i).tail<3>() << 0, d.z(), -d.y();
    if (dof == 1) R.row(i).tail<3>() << -d.z(), 0, d.x();
    if (dof == 2) R.row(i).tail<3>() << d.y(), -d.x(), 0;
  }
  return R;
}

} // namespace plica
