// Craig-Bampton over ranks: substructures that differ are dealt out, the largest first to whoever
// has least; every rank reduces its own, the first gathers their matrices. Fields stay where they
// were reduced: the first asks for them (orders.hpp).
#pragma once

#include "engine/orders.hpp"
#include "reduction/substructures.hpp"

namespace plica {

class SharedReductions {
public:
  explicit SharedReductions(const Ranks& ranks) : ranks_(ranks) {}

  // Collective, with the same parts on every rank. On the first all reductions, on the others their
  // own, null in place of the rest. What goes wrong on one rank is thrown on all, as
  // std::invalid_argument or ModelError where reduce_part() throws that, else as
  // std::runtime_error.
  std::vector<std::shared_ptr<const PartReduction>>
  reduce(const std::vector<std::shared_ptr<const Substructure>>& parts,
         const PartReductionRequest& request);

  // On the others: the order part_fields of the first.
  void answer_fields() const;

  // How many parts each rank has reduced.
  std::vector<int> shares() const;

private:
  void deal(const std::vector<std::shared_ptr<const Substructure>>& parts);
  void reduce_own(const std::vector<std::shared_ptr<const Substructure>>& parts,
                  const PartReductionRequest& request);
  void gather(const std::vector<std::shared_ptr<const Substructure>>& parts);
  Eigen::MatrixXd fields(int part, const std::vector<int>& nodes,
                         const Eigen::MatrixXd& coordinates) const;

  const Ranks& ranks_;
  std::vector<int> owner_; // per part
  std::vector<std::shared_ptr<const PartReduction>> reductions_;
};

} // namespace plica
