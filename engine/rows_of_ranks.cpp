#include "engine/rows_of_ranks.hpp"

#include "solve/element_view.hpp"
#include "solve/independent_element.hpp"

#include <algorithm>
#include <limits>

namespace plica {
namespace {

// The rows of a share: of every node of it the nodes beside it, of every row the columns.
class OwnRows {
public:
  OwnRows(const Model& model, const DofMap& map, const RowShare& share)
      : elements_{model}, map_(map), share_(share) {
    find_neighbours();
    lay_out();
  }

  void add_elements() {
    for (const int e : own_)
      elements_.visit(e, [&](const auto& nodes, const auto& K, const auto& M) {
        on_independent(
            map_, nodes, K, M,
            [&](const std::vector<int>& q, const auto& k, const auto& m) { this->add(q, k, m); });
      });
  }

  CompressedRows rows{};      // of K
  std::vector<double> mass{}; // its values likewise

private:
  bool is_own(int node) const { return node >= share_.first_node && node < share_.end_node; }

  void find_neighbours() {
    neighbours_.resize(std::size_t(share_.end_node - share_.first_node));
    for (int e = 0; e < elements_.size(); ++e) {
      const std::vector<int> reached = reached_nodes(map_, elements_.nodes(e));
      bool own = false;
      for (const int node : reached)
        if (is_own(node)) {
          own = true;
          std::vector<int>& list = neighbours_[std::size_t(node - share_.first_node)];
          list.insert(list.end(), reached.begin(), reached.end());
        }
      if (own) own_.push_back(e);
    }
    for (std::vector<int>& list : neighbours_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      list.shrink_to_fit();
    }
  }

  void lay_out() {
    long long entries = 0;
    rows.start.push_back(0);
    for (int node = share_.first_node; node < share_.end_node; ++node)
      for (int i = map_.first[node]; i < map_.first[node + 1]; ++i) {
        for (const int other : beside(node)) entries += map_.first[other + 1] - map_.first[other];
        if (entries > std::numeric_limits<int>::max())
          end_all("the rows of one rank have more than 2^31 entries: take more ranks");
        rows.start.push_back(int(entries));
      }
    rows.column.reserve(std::size_t(entries));
    for (int node = share_.first_node; node < share_.end_node; ++node)
      for (int i = map_.first[node]; i < map_.first[node + 1]; ++i)
        for (const int other : beside(node))
          for (int j = map_.first[other]; j < map_.first[other + 1]; ++j) rows.column.push_back(j);
    rows.value.assign(std::size_t(entries), 0.);
    mass.assign(std::size_t(entries), 0.);
  }

  const std::vector<int>& beside(int node) const {
    return neighbours_[std::size_t(node - share_.first_node)];
  }

  template <class Matrix> void add(const std::vector<int>& q, const Matrix& K, const Matrix& M) {
    const int n = int(q.size());
    for (int a = 0; a < n; ++a) {
      const int i = q[std::size_t(a)];
      if (i < share_.first || i >= share_.end) continue;
      const auto row = rows.column.begin() + rows.start[std::size_t(i - share_.first)],
                 end = rows.column.begin() + rows.start[std::size_t(i - share_.first) + 1];
      for (int b = 0; b < n; ++b) {
        const int j = q[std::size_t(b)];
        if (j < 0) continue;
        const auto at = std::size_t(std::lower_bound(row, end, j) - rows.column.begin());
        rows.value[at] += K(a, b);
        mass[at] += M(a, b);
      }
    }
  }

  ElementView elements_;
  const DofMap& map_;
  RowShare share_;
  std::vector<int> own_; // elements that reach a row of ours
  std::vector<std::vector<int>> neighbours_;
};

} // namespace

RowShare share_of(const DofMap& map, const Ranks& ranks) {
  const int nodes = int(map.first.size()) - 1;
  const auto node_at = [&](int rank) {
    const long long row = (long long)map.size() * rank / ranks.size();
    return rank == ranks.size()
               ? nodes
               : int(std::lower_bound(map.first.begin(), map.first.end(), int(row)) -
                     map.first.begin());
  };
  RowShare share{.first_node = std::min(node_at(ranks.rank()), nodes),
                 .end_node = std::min(node_at(ranks.rank() + 1), nodes)};
  share.first = map.first[std::size_t(share.first_node)];
  share.end = map.first[std::size_t(share.end_node)];
  return share;
}

DistributedSystem assemble_rows(const Model& model, const DofMap& map, const Ranks& ranks) {
  const RowShare share = share_of(map, ranks);
  OwnRows own(model, map, share);
  std::string trouble;
  try {
    own.add_elements();
  } catch (const std::invalid_argument& error) {
    trouble = error.what();
  }
  for (const std::string& text : ranks.everyones(trouble))
    if (!text.empty()) throw std::invalid_argument(text);
  DistributedSystem system;
  system.K = DistributedMatrix(own.rows, map.size(), ranks);
  own.rows.value = std::move(own.mass);
  system.M = DistributedMatrix(own.rows, map.size(), ranks);
  return system;
}

} // namespace plica
