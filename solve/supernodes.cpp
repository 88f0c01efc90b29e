#include "solve/supernodes.hpp"

#include "solve/cholmod_indices.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXi;

template <class T> std::vector<T> copied(const void* numbers, int index_type, std::size_t count) {
  return with_indices(numbers, index_type, [&](const auto* from) {
    std::vector<T> to(count);
    std::transform(from, from + count, to.begin(), [](auto x) { return static_cast<T>(x); });
    return to;
  });
}

Supernodes analysed(const SparseMatrix& lower, const VectorXi& order) {
  const CholmodFunctions& cholmod = cholmod_functions(outgrows_narrow(lower.rows()));
  cholmod_common common{};
  cholmod.start(&common);
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  common.postorder = 1;
  common.supernodal = CHOLMOD_SUPERNODAL;
  CholmodView A(lower, cholmod.index_type);
  cholmod_factor* L = analyze_in_order(A, order, cholmod, common);
  Supernodes nodes;
  if (L != nullptr && L->is_super) {
    const std::size_t count = L->nsuper;
    nodes.first_column = copied<int>(L->super, cholmod.index_type, count + 1);
    nodes.rows_at = copied<std::int64_t>(L->pi, cholmod.index_type, count + 1);
    nodes.rows = copied<int>(L->s, cholmod.index_type, L->ssize);
    const auto rows = copied<int>(L->Perm, cholmod.index_type, L->n);
    nodes.order = Eigen::Map<const VectorXi>(rows.data(), Index(rows.size()));
  }
  const int status = common.status;
  cholmod.free_factor(&L, &common);
  cholmod.finish(&common);
  if (nodes.first_column.empty())
    throw std::runtime_error("sparse analysis failed: CHOLMOD status " + std::to_string(status));
  return nodes;
}

// Supernodes above and below each, and the work at a supernode with all below it.
struct Forest {
  std::vector<int> above;   // -1: none
  std::vector<int> lowest;  // the first below it
  std::vector<double> work; // operations
  std::vector<int> roots;   // what has none above
  bool in_order = true;     // what is below a supernode is a run of numbers that it ends
};

Forest forest(const Supernodes& nodes) {
  const int count = nodes.count();
  Forest f;
  f.above.assign(std::size_t(count), -1);
  f.lowest.resize(std::size_t(count));
  std::iota(f.lowest.begin(), f.lowest.end(), 0);
  f.work.assign(std::size_t(count), 0);
  std::vector<int> below(std::size_t(count), 1); // itself included
  for (int s = 0; s < count; ++s) {
    const double height = nodes.height(s);
    f.work[s] += nodes.columns(s) * height * height;
    f.in_order = f.in_order && below[s] == s - f.lowest[s] + 1;
    if (nodes.height(s) == nodes.columns(s)) {
      f.roots.push_back(s);
      continue;
    }
    const int p = f.above[s] = nodes.of_column[nodes.row_numbers(s)[nodes.columns(s)]];
    f.work[p] += f.work[s];
    f.lowest[p] = std::min(f.lowest[p], f.lowest[s]);
    below[p] += below[s];
  }
  return f;
}

// Roots of subtrees, increasing: the heaviest is taken apart until each is a small share of all.
std::vector<int> subtree_roots(const Forest& f) {
  constexpr double share = 1. / 6, worth_sharing = 2e8; // operations
  double total = 0;
  for (int root : f.roots) total += f.work[root];
  if (!f.in_order || total < worth_sharing) return {};
  const auto lighter = [&](int a, int b) { return f.work[a] < f.work[b]; };
  std::vector<int> heap = f.roots;
  std::make_heap(heap.begin(), heap.end(), lighter);
  while (!heap.empty() && f.work[heap.front()] > share * total) {
    std::pop_heap(heap.begin(), heap.end(), lighter);
    const int root = heap.back();
    heap.pop_back();
    for (int child = root - 1; child >= f.lowest[root]; child = f.lowest[child] - 1) {
      heap.push_back(child);
      std::push_heap(heap.begin(), heap.end(), lighter);
    }
  }
  std::sort(heap.begin(), heap.end());
  return heap;
}

void part(Supernodes& nodes) {
  const Forest f = forest(nodes);
  nodes.sum_at = nodes.rows;
  nodes.sums = nodes.size();
  std::vector<int> place(std::size_t(nodes.size()), -1);
  int next = 0;
  for (int root : subtree_roots(f)) {
    const Supernodes::Subtree tree{.first = f.lowest[root], .root = root, .sums = nodes.sums};
    for (; next < tree.first; ++next) nodes.trunk.push_back(next);
    next = root + 1;
    const int end = nodes.first_column[root + 1];
    for (int k = nodes.columns(root); k < nodes.height(root); ++k)
      place[std::size_t(nodes.row_numbers(root)[k])] = nodes.sums++;
    for (auto k = nodes.rows_at[tree.first]; k < nodes.rows_at[root + 1]; ++k)
      if (nodes.rows[std::size_t(k)] >= end)
        nodes.sum_at[std::size_t(k)] = place[std::size_t(nodes.rows[std::size_t(k)])];
    nodes.subtrees.push_back(tree);
  }
  for (; next < nodes.count(); ++next) nodes.trunk.push_back(next);
}

} // namespace

Supernodes supernodes(const SparseMatrix& lower, const VectorXi& order) {
  Supernodes nodes = analysed(lower, order);
  nodes.numbers_at = {0};
  nodes.of_column.resize(std::size_t(nodes.size()));
  for (int s = 0; s < nodes.count(); ++s) {
    nodes.numbers_at.push_back(nodes.numbers_at.back() +
                               std::int64_t(nodes.columns(s)) * nodes.height(s));
    std::fill(nodes.of_column.begin() + nodes.first_column[s],
              nodes.of_column.begin() + nodes.first_column[s + 1], s);
  }
  part(nodes);
  return nodes;
}

} // namespace plica
