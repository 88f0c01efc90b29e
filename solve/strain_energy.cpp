#include "solve/strain_energy.hpp"

#include "solve/element_view.hpp"

namespace plica {

using Eigen::MatrixXd;

MatrixXd strain_energy(const Model& model, const MatrixXd& u) {
  const ElementView elements{model};
  // Element by element first, so that the order of the sums does not depend on the threads.
  MatrixXd each = MatrixXd::Zero(elements.size(), u.cols());
#pragma omp parallel for schedule(static) if (elements.size() > 64)
  for (int e = 0; e < elements.size(); ++e) {
    if (elements.component(e) < 0) continue;
    elements.visit(e, [&](const auto& nodes, const auto& K, const auto&) {
      MatrixXd own(6 * nodes.size(), u.cols());
      for (std::size_t a = 0; a < nodes.size(); ++a)
        own.middleRows(6 * Eigen::Index(a), 6) = u.middleRows(6 * nodes[a], 6);
      each.row(e) = own.cwiseProduct(K * own).colwise().sum();
    });
  }
  MatrixXd sum = MatrixXd::Zero(Eigen::Index(model.components.size()), u.cols());
  for (int e = 0; e < elements.size(); ++e)
    if (const int c = elements.component(e); c >= 0 && c < sum.rows()) sum.row(c) += each.row(e);
  return sum;
}

std::vector<MatrixXd> component_stiffness(const Model& model, const MatrixXd& u) {
  const ElementView elements{model};
  std::vector<MatrixXd> sum(model.components.size(), MatrixXd::Zero(u.cols(), u.cols()));
  for (int e = 0; e < elements.size(); ++e) {
    const int c = elements.component(e);
    if (c < 0 || c >= static_cast<int>(sum.size())) continue;
    elements.visit(e, [&](const auto& nodes, const auto& K, const auto&) {
      MatrixXd own(6 * nodes.size(), u.cols());
      for (std::size_t a = 0; a < nodes.size(); ++a)
        own.middleRows(6 * Eigen::Index(a), 6) = u.middleRows(6 * nodes[a], 6);
      sum[c] += own.transpose() * (K * own);
    });
  }
  return sum;
}

} // namespace plica
