#include "lab/identification/lscf.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Complex = std::complex<double>;

// Normal equations of the highest order; those of a lower one are their leading parts.
struct NormalEquations {
  MatrixXd R;              // (n + 1) x (n + 1), the same for all responses
  std::vector<MatrixXd> S; // per response: (n + 1) x (n + 1) inputs
  MatrixXd T;              // their sum
};

NormalEquations normal_equations(const FrfSet& set, int n) {
  const Index lines = set.hertz.size(), inputs = Index(set.H.size());
  const double low = set.hertz[0], span = set.hertz[lines - 1] - low;
  MatrixXcd Z(lines, n + 1);
  for (Index f = 0; f < lines; ++f)
    for (int k = 0; k <= n; ++k)
      Z(f, k) = std::polar(1., std::numbers::pi * k * (set.hertz[f] - low) / span);
  NormalEquations e{.R = (Z.adjoint() * Z).real(),
                    .S = {},
                    .T = MatrixXd::Zero((n + 1) * inputs, (n + 1) * inputs)};
  const MatrixXd noise = noise_levels(set);
  MatrixXcd Y(lines, (n + 1) * inputs);
  for (Index o = 0; o < Index(set.responses.size()); ++o) {
    const double weight = std::sqrt(double(inputs)) / noise.row(o).norm();
    for (int k = 0; k <= n; ++k)
      for (Index i = 0; i < inputs; ++i)
        Y.col(k * inputs + i) = -weight * Z.col(k).cwiseProduct(set.H[i].col(o));
    e.S.emplace_back((Z.adjoint() * Y).real());
    e.T.selfadjointView<Eigen::Lower>().rankUpdate(Y.real().transpose());
    e.T.selfadjointView<Eigen::Lower>().rankUpdate(Y.imag().transpose());
  }
  e.T = MatrixXd(e.T.selfadjointView<Eigen::Lower>());
  return e;
}

// [A_1; ..; A_n] with A_0 = I.
MatrixXd denominator(const NormalEquations& e, int n, Index inputs) {
  const Index size = (n + 1) * inputs;
  MatrixXd M = e.T.topLeftCorner(size, size);
  const Eigen::LDLT<MatrixXd> R(MatrixXd(e.R.topLeftCorner(n + 1, n + 1)));
  for (const MatrixXd& S : e.S) {
    const auto part = S.topLeftCorner(n + 1, size);
    M.noalias() -= part.transpose() * R.solve(part);
  }
  const Index rest = size - inputs;
  return -M.bottomRightCorner(rest, rest).fullPivLu().solve(M.bottomLeftCorner(rest, inputs));
}

// u with u' A(z) = 0: eigenvectors of the companion matrix of w = 1/z, w^n u = -sum A_k' w^(n-k) u.
std::vector<Pole> poles_of(const MatrixXd& A, int n, Index inputs, double low, double span) {
  MatrixXd companion = MatrixXd::Zero(n * inputs, n * inputs);
  for (int k = 0; k < n; ++k)
    companion.block(0, k * inputs, inputs, inputs) = -A.middleRows(k * inputs, inputs).transpose();
  companion.bottomLeftCorner((n - 1) * inputs, (n - 1) * inputs).setIdentity();
  const Eigen::EigenSolver<MatrixXd> solver(companion);
  std::vector<Pole> poles;
  if (solver.info() != Eigen::Success) return poles;
  for (Index j = 0; j < n * inputs; ++j) {
    const Complex w = solver.eigenvalues()[j];
    if (std::abs(w) < 1e-12) continue;
    const Complex shifted = -std::log(w) * 2. * span; // ln z / T, T = 1 / (2 span)
    Pole pole{.lambda = shifted + Complex(0, 2 * std::numbers::pi * low),
              .participation = solver.eigenvectors().col(j).tail(inputs)};
    const double hertz = pole.lambda.imag() / (2 * std::numbers::pi);
    if (shifted.imag() <= 0 || pole.lambda.real() >= 0 || hertz < low || hertz > low + span)
      continue;
    if (pole.damping() > 0.5) continue;
    // z e^{...} has the participation of H = R / (i w - lambda): u' itself.
    pole.participation.normalize();
    poles.push_back(std::move(pole));
  }
  std::sort(poles.begin(), poles.end(),
            [](const Pole& a, const Pole& b) { return a.frequency() < b.frequency(); });
  return poles;
}

} // namespace

double Pole::frequency() const {
  return std::abs(lambda) / (2 * std::numbers::pi);
}

double Pole::damping() const {
  return -lambda.real() / std::abs(lambda);
}

std::vector<PolesOfOrder> lscf(const FrfSet& set, int highest) {
  const Index inputs = Index(set.H.size()), lines = set.hertz.size();
  if (inputs < 1 || set.responses.empty()) throw std::invalid_argument("there are no responses");
  if (highest < 2) throw std::invalid_argument("the polynomial needs an order of at least 2");
  const Index equations = 2 * lines * Index(set.responses.size());
  const Index unknowns = (highest + 1) * (Index(set.responses.size()) + inputs);
  if (lines < 2 || equations < unknowns)
    throw std::invalid_argument(std::to_string(lines) + " lines are too few for order " +
                                std::to_string(highest));
  if (std::all_of(set.H.begin(), set.H.end(), [](const MatrixXcd& H) { return H.isZero(0); }))
    throw std::invalid_argument("all responses are zero");
  const NormalEquations e = normal_equations(set, highest);
  const double low = set.hertz[0], span = set.hertz[lines - 1] - low;
  std::vector<PolesOfOrder> all;
  for (int n = 2; n <= highest; ++n)
    all.push_back({n, poles_of(denominator(e, n, inputs), n, inputs, low, span)});
  return all;
}

} // namespace plica
