#include "tests/support/direct_response.hpp"

#include "words/short_text.hpp"

#include <Eigen/UmfPackSupport>
#include <stdexcept>

namespace plica::test {

using Eigen::MatrixXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

MatrixXcd direct_response(const SparseMatrix& K, const SparseMatrix& M, double eta,
                          const VectorXd& force, const VectorXd& omega) {
  using ComplexMatrix = Eigen::SparseMatrix<Complex>;
  const auto whole = [](const SparseMatrix& lower) -> SparseMatrix {
    return lower.selfadjointView<Eigen::Lower>();
  };
  const ComplexMatrix stiff = whole(K).cast<Complex>() * Complex(1, eta);
  const ComplexMatrix mass = whole(M).cast<Complex>();
  const Eigen::VectorXcd load = force.cast<Complex>();
  Eigen::UmfPackLU<ComplexMatrix> solver;
  MatrixXcd response(force.size(), omega.size());
  for (Eigen::Index k = 0; k < omega.size(); ++k) {
    const ComplexMatrix dynamic = stiff - Complex(omega[k] * omega[k]) * mass;
    if (k == 0) solver.analyzePattern(dynamic);
    solver.factorize(dynamic);
    if (solver.info() != Eigen::Success)
      throw std::runtime_error("direct response: the dynamic stiffness is singular at " +
                               short_text(omega[k], 6) +
                               " rad/s; without damping it is at every "
                               "eigenfrequency");
    response.col(k) = solver.solve(load);
  }
  return response;
}

} // namespace plica::test
