#include "solve/buckling.hpp"

#include "solve/inertia_count.hpp"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// y = L^-1 P D P' L'^-1 x
class Softening {
public:
  using Scalar = double;

  Softening(const SparseMatrix& D, const SparseFactor& factor) : factor_(factor) {
    const Eigen::PermutationMatrix<Eigen::Dynamic> to_rows{Eigen::VectorXi(factor.order())};
    D_ = D.selfadjointView<Eigen::Lower>().twistedBy(to_rows.transpose());
  }

  Eigen::Index rows() const { return D_.rows(); }
  Eigen::Index cols() const { return D_.cols(); }

  void perform_op(const double* x, double* y) const {
    VectorXd up(D_.rows());
    factor_.solve_upper(x, up.data());
    const VectorXd product = D_ * up;
    factor_.solve_lower(product.data(), y);
  }

private:
  const SparseFactor& factor_;
  SparseMatrix D_;
};

void prove(const SparseMatrix& K, const SparseMatrix& D, SparseFactor& factor, double beyond,
           int wanted, BucklingLoads& loads) {
  const Eigen::Index found = loads.factor.size();
  // In the middle between the last two, so that the last one only bounds the gap; where there are
  // no more of them, below all that is of interest.
  const bool more = found > 1 && found == wanted;
  const Eigen::Index kept = more ? found - 1 : found;
  loads.proved_below = more ? (loads.factor[found - 2] + loads.factor[found - 1]) / 2 : beyond;
  const InertiaCount count =
      count_below(K, D, loads.proved_below, loads.shapes.leftCols(kept), factor);
  loads.proved = count.below && *count.below == kept;
  if (!count.below)
    loads.reason = count.reason;
  else if (!loads.proved)
    loads.reason = std::to_string(*count.below) + " by inertia, " + std::to_string(kept) + " found";
}

} // namespace

BucklingLoads buckling_loads(const SparseMatrix& K_rest, const SparseMatrix& K_stress, int count,
                             double beyond) {
  const SparseMatrix D = -K_stress - 0. * K_rest; // arms of couplings that turn add entries
  const SparseMatrix K = K_rest + 0. * D;
  SparseFactor factor(K);
  if (const FactorStatus status = factor.factorise(K); !status.ok)
    throw std::runtime_error("buckling: the stiffness at rest is not positive definite");
  const int n = int(K.rows()), wanted = std::min(count + 1, n - 1);
  const SparseMatrix pruned = D.pruned();
  Softening softening(pruned, factor);
  Spectra::SymEigsSolver<Softening> solver(softening, wanted,
                                           std::min(n, std::max(2 * wanted + 20, 40)));
  std::mt19937 random(1);
  VectorXd start(n);
  for (double& x : start) x = double(random()) / double(std::mt19937::max()) - 0.5;
  solver.init(start.data());
  constexpr int most_restarts = 300;
  solver.compute(Spectra::SortRule::LargestAlge, most_restarts, 1e-9,
                 Spectra::SortRule::LargestAlge);
  BucklingLoads loads;
  std::vector<Eigen::Index> positive;
  const VectorXd mu = solver.eigenvalues();
  for (Eigen::Index i = 0; i < mu.size(); ++i)
    if (mu[i] > 1 / beyond) positive.push_back(i);
  loads.factor = VectorXd(mu(positive).array().inverse());
  loads.shapes.resize(n, Eigen::Index(positive.size()));
  const MatrixXd y = solver.eigenvectors();
  for (std::size_t k = 0; k < positive.size(); ++k) {
    VectorXd x(n);
    factor.solve_upper(y.col(positive[k]).data(), x.data());
    loads.shapes(factor.order(), Eigen::Index(k)) = x / x.cwiseAbs().maxCoeff();
  }
  prove(K, D, factor, beyond, wanted, loads);
  if (Eigen::Index(count) < loads.factor.size()) {
    loads.factor.conservativeResize(count);
    loads.shapes.conservativeResize(Eigen::NoChange, count);
  }
  return loads;
}

} // namespace plica
