#include "reduction/craig_bampton.hpp"

#include "reduction/fixed_interface.hpp"

#include <algorithm>
#include <memory>

namespace plica {

using Eigen::MatrixXd;

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
  const auto blocks = std::make_shared<FixedInterface>(
      fixed_interface(system->K, system->M, sorted, cutoff, MatrixXd(system->map.size(), 0),
                      rigid_body_motions(model, system->map, Eigen::Vector3d::Zero())));
  const Eigen::Index modes = blocks->lambda.size();
  Reduction r{.element = empty_superelement(model, boundary, modes),
              .lambda = blocks->lambda,
              .field = {},
              .field_at = {},
              .proved = blocks->proved,
              .reason = blocks->reason};
  Superelement& s = r.element;
  const Eigen::Index n = s.boundary();
  s.K.topLeftCorner(n, n) =
      without_grounding(D * blocks->K_bb * D.transpose(), s.nodes, blocks->unreduced);
  s.K.diagonal().tail(modes) = blocks->lambda;
  s.M.topLeftCorner(n, n) = D * blocks->M_bb * D.transpose();
  s.M.topRightCorner(n, modes) = D * blocks->M_bq;
  s.M.bottomLeftCorner(modes, n) = s.M.topRightCorner(n, modes).transpose();
  s.M.bottomRightCorner(modes, modes).setIdentity();
  r.field = [system, blocks, D](const MatrixXd& c) {
    const MatrixXd q = blocks->Psi * (D.transpose() * c.topRows(D.rows())) +
                       blocks->Phi * c.bottomRows(c.rows() - D.rows());
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

} // namespace plica
