#include "lab/identification/modal_fit.hpp"

#include "lab/identification/pole_search.hpp"

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
using Eigen::VectorXd;
using Complex = std::complex<double>;
constexpr double two_pi = 2 * std::numbers::pi;

// Real equations: real parts of all lines above imaginary ones.
void put(MatrixXd& A, Index column, const VectorXcd& values) {
  A.col(column) << values.real(), values.imag();
}

struct Lines {
  VectorXcd s;      // i w
  VectorXcd factor; // (i w)^d
};

Lines lines_of(const VectorXd& hertz, FrfQuantity quantity) {
  Lines lines{.s = VectorXcd(hertz.size()), .factor = VectorXcd(hertz.size())};
  for (Index f = 0; f < hertz.size(); ++f) {
    lines.s[f] = Complex(0, two_pi * hertz[f]);
    lines.factor[f] = std::pow(lines.s[f], derivatives(quantity));
  }
  return lines;
}

// Columns of Re R and Im R of every pole, then of L (absent with a line at 0 Hz of a receptance or
// a mobility, where it is infinite) and U.
MatrixXd basis(const Lines& l, const Poles& poles) {
  MatrixXd A(2 * l.s.size(), 2 * Index(poles.size()) + 2);
  const Complex i(0, 1);
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const VectorXcd a = (l.s.array() - poles[r]).inverse() * l.factor.array();
    const VectorXcd b = (l.s.array() - std::conj(poles[r])).inverse() * l.factor.array();
    put(A, 2 * Index(r), a + b);
    put(A, 2 * Index(r) + 1, i * (a - b));
  }
  VectorXcd low = l.factor;
  for (Index f = 0; f < low.size(); ++f) low[f] = l.s[f] == 0. ? 0. : low[f] / (l.s[f] * l.s[f]);
  put(A, A.cols() - 2, low);
  put(A, A.cols() - 1, l.factor);
  return A;
}

// Derivatives of the two columns of a pole by its real part, then by its imaginary part.
MatrixXd basis_derivatives(const Lines& l, const Poles& poles) {
  MatrixXd D(2 * l.s.size(), 4 * Index(poles.size()));
  const Complex i(0, 1);
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const VectorXcd a = (l.s.array() - poles[r]).square().inverse() * l.factor.array();
    const VectorXcd b = (l.s.array() - std::conj(poles[r])).square().inverse() * l.factor.array();
    const Index c = 4 * Index(r);
    put(D, c, a + b);
    put(D, c + 1, i * (a - b));
    put(D, c + 2, i * (a - b));
    put(D, c + 3, -(a + b));
  }
  return D;
}

// Columns: responses of the first reference, then of the second.
MatrixXd stacked(const FrfSet& set) {
  const Index lines = set.hertz.size(), each = Index(set.responses.size());
  MatrixXd H(2 * lines, each * Index(set.H.size()));
  for (std::size_t i = 0; i < set.H.size(); ++i)
    H.middleCols(Index(i) * each, each) << set.H[i].real(), set.H[i].imag();
  return H;
}

} // namespace

double FittedMode::frequency() const {
  return std::abs(lambda) / two_pi;
}

double FittedMode::damping() const {
  return -lambda.real() / std::abs(lambda);
}

double FittedMode::sigma_frequency() const {
  const double w = std::abs(lambda);
  return std::hypot(lambda.real() * sigma_real, lambda.imag() * sigma_imaginary) / w / two_pi;
}

double FittedMode::sigma_damping() const {
  const double w = std::abs(lambda), zeta = damping();
  return std::hypot((1 - zeta * zeta) * sigma_real, zeta * lambda.imag() / w * sigma_imaginary) / w;
}

ModalFit fit_of(const PoleSearch& found, Index responses, Index references) {
  const Index modes = Index(found.poles.size());
  const auto table = [&](const VectorXd& values) -> MatrixXd {
    return Eigen::Map<const MatrixXd>(values.data(), responses, references);
  };
  ModalFit fit;
  fit.iterations = found.iterations;
  fit.converged = found.converged;
  fit.noise = table(found.rms);
  for (Index r = 0; r < modes; ++r)
    fit.modes.push_back(
        {.lambda = found.poles[std::size_t(r)],
         .sigma_real = found.sigma_real[r],
         .sigma_imaginary = found.sigma_imaginary[r],
         .residue = table(found.C.row(2 * r)).cast<Complex>() +
                    Complex(0, 1) * table(found.C.row(2 * r + 1)).cast<Complex>(),
         .sigma_residue = fit.noise * std::max(found.spread[2 * r], found.spread[2 * r + 1])});
  std::sort(fit.modes.begin(), fit.modes.end(),
            [](const FittedMode& a, const FittedMode& b) { return a.frequency() < b.frequency(); });
  const Index constants = found.C.rows() - 2 * modes;
  fit.lower = table(found.C.row(2 * modes));
  fit.upper = constants > 1 ? table(found.C.row(2 * modes + 1))
                            : MatrixXd::Zero(responses, references).eval();
  return fit;
}

ModalFit fit_modes(const FrfSet& set, const Poles& poles) {
  const Index lines = set.hertz.size(), modes = Index(poles.size());
  const Index each = Index(set.responses.size()), inputs = Index(set.H.size());
  if (2 * lines < 2 * modes + 3)
    throw std::invalid_argument(std::to_string(lines) + " lines are too few for " +
                                std::to_string(modes) + " poles");
  for (const Complex& pole : poles)
    if (!(pole.real() < 0 && pole.imag() > 0))
      throw std::invalid_argument("a pole needs a negative real and a positive imaginary part");
  const Lines l = lines_of(set.hertz, set.quantity);
  const MatrixXd H = stacked(set);
  const MatrixXd noise_level = noise_levels(set);
  const PoleBasis pole_basis{.columns = [&](const Poles& p) { return basis(l, p); },
                             .derivatives = [&](const Poles& p) { return basis_derivatives(l, p); },
                             .lines = lines};
  const PoleSearch found =
      search_poles(pole_basis, H, VectorXd::Map(noise_level.data(), noise_level.size()), poles);
  ModalFit fit = fit_of(found, each, inputs);
  fit.H = synthesise(fit, set.quantity, set.hertz);
  return fit;
}

std::vector<MatrixXcd> synthesise(const ModalFit& fit, FrfQuantity quantity,
                                  const VectorXd& hertz) {
  const Lines l = lines_of(hertz, quantity);
  const Index each = fit.lower.rows();
  std::vector<MatrixXcd> all(std::size_t(fit.lower.cols()), MatrixXcd::Zero(hertz.size(), each));
  for (std::size_t i = 0; i < all.size(); ++i)
    for (Index f = 0; f < hertz.size(); ++f) {
      VectorXcd h = fit.upper.col(Index(i)).cast<Complex>();
      if (l.s[f] != 0.) h += fit.lower.col(Index(i)) / (l.s[f] * l.s[f]);
      for (const FittedMode& m : fit.modes) {
        const VectorXcd R = m.residue.col(Index(i));
        h += R / (l.s[f] - m.lambda) + R.conjugate() / (l.s[f] - std::conj(m.lambda));
      }
      all[i].row(f) = (l.factor[f] * h).transpose();
      if (l.s[f] == 0. && derivatives(quantity) == 2)
        all[i].row(f) = fit.lower.col(Index(i)).transpose().cast<Complex>();
    }
  return all;
}

} // namespace plica
