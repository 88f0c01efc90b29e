#include "solve/drilling.hpp"

#include <map>

namespace plica {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::set<int> nodes_with_something(const Model& model) {
  std::set<int> nodes;
  for (const MassElement& m : model.masses) nodes.insert(m.node);
  for (const BeamElement& b : model.beams) nodes.insert({b.node1, b.node2});
  for (const BushingElement& b : model.bushings) nodes.insert({b.node1, b.node2});
  for (const MatrixElement& m : model.matrices) nodes.insert(m.nodes.begin(), m.nodes.end());
  for (const Constraint& c : model.constraints)
    for (const ConstraintTerm& t : c.terms) nodes.insert(t.node);
  return nodes;
}

namespace {

ShellSection without_drilling(ShellSection section) {
  section.drilling = 0;
  return section;
}

// u' (K - K without drilling) u of one shell, per column.
template <class Shell>
VectorXd drilling_energy(const Model& model, const Shell& shell, const MatrixXd& u) {
  const ShellProperties& p = model.shells[std::size_t(shell.section)];
  const auto geometry = shell_geometry(model.mesh, shell);
  const auto stiffness = [&](const ShellSection& section) -> MatrixXd {
    if constexpr (std::is_same_v<Shell, ShellQuad>)
      return shell_mitc4_stiffness(geometry, section, p.membrane);
    else
      return shell_mitc3_stiffness(geometry, section);
  };
  MatrixXd own(6 * Eigen::Index(shell.nodes.size()), u.cols());
  for (std::size_t a = 0; a < shell.nodes.size(); ++a)
    own.middleRows<6>(6 * Eigen::Index(a)) = u.middleRows<6>(6 * shell.nodes[a]);
  const MatrixXd K = stiffness(p.section) - stiffness(without_drilling(p.section));
  return own.cwiseProduct(K * own).colwise().sum().transpose();
}

} // namespace

std::vector<DrillingShare> drilling_shares(const Model& model, const MatrixXd& u,
                                           const VectorXd& energy) {
  const std::set<int> looked_at = nodes_with_something(model);
  std::map<int, VectorXd> at;
  const auto add = [&](const auto& shells) {
    for (const auto& shell : shells) {
      std::vector<int> reached;
      for (int node : shell.nodes)
        if (looked_at.contains(node)) reached.push_back(node);
      if (reached.empty()) continue;
      const VectorXd own = drilling_energy(model, shell, u);
      for (int node : reached) {
        const auto [sum, is_new] = at.try_emplace(node, own);
        if (!is_new) sum->second += own;
      }
    }
  };
  add(model.mesh.quads);
  add(model.mesh.triangles);
  std::vector<DrillingShare> shares(std::size_t(u.cols()));
  for (const auto& [node, sum] : at)
    for (Eigen::Index j = 0; j < u.cols(); ++j)
      if (const double share = energy[j] > 0 ? sum[j] / energy[j] : 0;
          share > shares[std::size_t(j)].share)
        shares[std::size_t(j)] = {.share = share, .node = node};
  return shares;
}

} // namespace plica
