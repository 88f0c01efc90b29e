#include "engine/shared_reductions.hpp"

#include "reduction/fixed_interface.hpp"
#include "solve/model_error.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Parts = std::vector<std::shared_ptr<const Substructure>>;

// A reduction but for its fields: sectors, proof, number of modes, K, M and lambda in one column.
MatrixXd packed(const PartReduction& part) {
  const Reduction& r = part.reduction;
  const Index n = r.element.K.rows(), modes = r.lambda.size();
  MatrixXd column(3 + 2 * n * n + modes, 1);
  column.topRows(3) << part.sectors, r.proved ? 1 : 0, double(modes);
  column.middleRows(3, n * n) = r.element.K.reshaped();
  column.middleRows(3 + n * n, n * n) = r.element.M.reshaped();
  column.bottomRows(modes) = r.lambda;
  return column;
}

// The first in a column of several, of a part with its boundary; `at` moves behind it.
PartReduction unpacked(const MatrixXd& column, Index& at, const Substructure& part) {
  const auto modes = Index(column(at + 2, 0)), n = 6 * Index(part.boundary.size()) + modes;
  PartReduction own;
  own.sectors = int(column(at, 0));
  Reduction& r = own.reduction;
  r.element = empty_superelement(part.model, part.boundary, modes);
  r.proved = column(at + 1, 0) != 0;
  r.element.K = column.middleRows(at + 3, n * n).reshaped(n, n);
  r.element.M = column.middleRows(at + 3 + n * n, n * n).reshaped(n, n);
  r.lambda = column.middleRows(at + 3 + 2 * n * n, modes);
  at += 3 + 2 * n * n + modes;
  return own;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

} // namespace

std::vector<std::shared_ptr<const PartReduction>>
SharedReductions::reduce(const Parts& parts, const PartReductionRequest& request) {
  deal(parts);
  reductions_.assign(parts.size(), nullptr);
  std::string trouble;
  try {
    reduce_own(parts, request);
  } catch (const std::invalid_argument& error) {
    trouble = std::string("!") + error.what();
  } catch (const ModelError& error) {
    trouble = std::string("?") + error.what();
  } catch (const std::exception& error) {
    trouble = std::string(" ") + error.what();
  }
  for (const std::string& text : ranks_.everyones(trouble)) {
    if (text.empty()) continue;
    if (text[0] == '!') throw std::invalid_argument(text.substr(1));
    if (text[0] == '?') throw ModelError(text.substr(1));
    throw std::runtime_error(text.substr(1));
  }
  gather(parts);
  return reductions_;
}

std::vector<int> SharedReductions::shares() const {
  std::vector<int> count(std::size_t(ranks_.size()), 0);
  for (const int rank : owner_) ++count[std::size_t(rank)];
  return count;
}

void SharedReductions::deal(const Parts& parts) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts[a]->nodes.size() > parts[b]->nodes.size();
  });
  std::vector<std::size_t> work(std::size_t(ranks_.size()), 0); // nodes of each rank
  owner_.assign(parts.size(), 0);
  for (const std::size_t part : order) {
    const auto least = std::min_element(work.begin(), work.end());
    owner_[part] = int(least - work.begin());
    *least += parts[part]->nodes.size();
  }
}

void SharedReductions::reduce_own(const Parts& parts, const PartReductionRequest& request) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (owner_[i] == ranks_.rank()) reductions_[i] = reduce_part(*parts[i], request);
}

void SharedReductions::gather(const Parts& parts) {
  std::vector<MatrixXd> columns;
  std::string words; // of each of the own: why not by symmetry, why not proved
  Index rows = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (owner_[i] != ranks_.rank()) continue;
    columns.push_back(packed(*reductions_[i]));
    words += reductions_[i]->because + "\n" + reductions_[i]->reduction.reason + "\n";
    rows += columns.back().rows();
  }
  MatrixXd own(rows, 1);
  Index at = 0;
  for (const MatrixXd& column : columns) {
    own.middleRows(at, column.rows()) = column;
    at += column.rows();
  }
  const MatrixXd all = ranks_.gather_rows(own);
  const std::vector<std::string> texts = ranks_.everyones(words);
  if (!ranks_.first()) return;
  at = 0;
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    const std::vector<std::string> lines = lines_of(texts[std::size_t(rank)]);
    std::size_t line = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (owner_[i] != rank) continue;
      PartReduction part = unpacked(all, at, *parts[i]);
      part.because = lines[line++];
      part.reduction.reason = lines[line++];
      if (rank == 0) continue; // it has its own, with its fields
      part.reduction.field_at = [this, i](const MatrixXd& c, const std::vector<int>& nodes) {
        return fields(int(i), nodes, c);
      };
      part.reduction.field = [this, i](const MatrixXd& c) { return fields(int(i), {}, c); };
      reductions_[i] = std::make_shared<const PartReduction>(std::move(part));
    }
  }
}

MatrixXd SharedReductions::fields(int part, const std::vector<int>& nodes,
                                  const MatrixXd& coordinates) const {
  tell(ranks_, Order::part_fields);
  ranks_.broadcast(std::vector<int>{part});
  ranks_.broadcast(nodes);
  ranks_.broadcast(coordinates);
  return ranks_.gather_rows(MatrixXd(0, coordinates.cols()));
}

void SharedReductions::answer_fields() const {
  const int part = ranks_.broadcast(std::vector<int>{}).front();
  const std::vector<int> nodes = ranks_.broadcast(std::vector<int>{});
  const MatrixXd coordinates = ranks_.broadcast(MatrixXd());
  MatrixXd own(0, coordinates.cols());
  if (owner_[std::size_t(part)] == ranks_.rank()) {
    const Reduction& r = reductions_[std::size_t(part)]->reduction;
    own = nodes.empty() ? r.field(coordinates) : r.field_at(coordinates, nodes);
  }
  ranks_.gather_rows(own);
}

} // namespace plica
