#include "solve/direct_response.hpp"

#include "solve/element_view.hpp"
#include "words/short_text.hpp"

#include <Eigen/LU>
#include <Eigen/UmfPackSupport>
#include <numbers>
#include <stdexcept>
#include <string>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
constexpr Complex direct_i(0, 1);

template <class Scalar> Eigen::SparseMatrix<Scalar> whole(const SparseMatrix& lower) {
  const SparseMatrix both = lower.selfadjointView<Eigen::Lower>();
  return both.cast<Scalar>();
}

template <class Matrix> class Factor {
public:
  Factor(const Matrix& dynamic, double omega) : matrix_(dynamic) {
    solver_.compute(matrix_);
    if (solver_.info() != Eigen::Success)
      throw std::runtime_error("the dynamic stiffness is singular at " +
                               short_text(omega / (2 * std::numbers::pi), 6) +
                               " Hz, or its factor is larger than the memory");
  }
  template <class Right> Right solve(const Right& right) const { return solver_.solve(right); }

private:
  Matrix matrix_;
  Eigen::UmfPackLU<Matrix> solver_;
};

// A^-1 of all columns of F and U. Real matrices solve real and imaginary parts apart.
struct Solved {
  MatrixXcd force, joined;
};

Solved solved(const DirectModel& m, const MatrixXcd& F, const MatrixXd& U, double omega) {
  if (m.loss.size() > 0) {
    const Eigen::SparseMatrix<Complex> A = whole<Complex>(m.K) + direct_i * whole<Complex>(m.loss) -
                                           Complex(omega * omega) * whole<Complex>(m.M);
    const Factor factor(A, omega);
    return {factor.solve(F), factor.solve(MatrixXcd(U.cast<Complex>()))};
  }
  const Eigen::SparseMatrix<double> A = whole<double>(m.K) - omega * omega * whole<double>(m.M);
  const Factor factor(A, omega);
  Solved s{factor.solve(MatrixXd(F.real())).cast<Complex>(), factor.solve(U).cast<Complex>()};
  if (!F.imag().isZero(0)) s.force += direct_i * factor.solve(MatrixXd(F.imag())).cast<Complex>();
  return s;
}

} // namespace

MatrixXcd direct_response(const DirectModel& m, const MatrixXcd& force, double omega) {
  const Index springs = m.springs.cols(), shapes = m.shapes.cols();
  MatrixXd U(m.K.rows(), springs + shapes);
  U << m.springs, m.shapes;
  VectorXcd D(U.cols());
  for (Index k = 0; k < springs; ++k) D[k] = m.added[std::size_t(k)](direct_i * omega);
  D.tail(shapes) = direct_i * (m.eta.array() * m.lambda.array() +
                               2 * omega * m.zeta.array() * m.lambda.array().sqrt())
                                  .matrix();
  const auto [free, joined] = solved(m, force, U, omega);
  if (U.cols() == 0) return free;
  MatrixXcd S = D.asDiagonal() * (U.transpose() * joined);
  S.diagonal().array() += 1;
  return free - joined * S.partialPivLu().solve(D.asDiagonal() * (U.transpose() * free));
}

SparseMatrix loss_matrix(const Model& model, const DofMap& map, const Eigen::VectorXd& eta) {
  const ElementView elements{model};
  std::vector<Eigen::Triplet<double>> entries;
  const auto terms = [&](int dof) -> std::vector<WeightedDof> {
    if (map.independent[std::size_t(dof)] >= 0) return {{map.independent[std::size_t(dof)], 1}};
    return map.dependent[std::size_t(dof)];
  };
  for (int e = 0; e < elements.size(); ++e) {
    const int c = elements.component(e);
    if (c < 0 || c >= eta.size() || eta[c] == 0) continue;
    elements.visit(e, [&](const auto& nodes, const auto& K, const auto&) {
      std::vector<std::vector<WeightedDof>> at;
      for (const int node : nodes)
        for (int dof = 6 * node; dof < 6 * node + 6; ++dof) at.push_back(terms(dof));
      for (std::size_t a = 0; a < at.size(); ++a)
        for (std::size_t b = 0; b < at.size(); ++b)
          for (const WeightedDof& row : at[a])
            for (const WeightedDof& column : at[b])
              if (row.dof >= column.dof)
                entries.emplace_back(row.dof, column.dof,
                                     eta[c] * row.factor * column.factor *
                                         (K(Index(a), Index(b)) + K(Index(b), Index(a))) / 2);
    });
  }
  SparseMatrix L(map.size(), map.size());
  L.setFromTriplets(entries.begin(), entries.end());
  return L;
}

} // namespace plica
