#include "lab/identification/modal_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
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
using Poles = std::vector<Complex>;
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

// Everything at one set of poles.
struct State {
  Poles poles;
  MatrixXd A, C, E; // basis, coefficients, weighted residual
  double cost = 0;
  Eigen::HouseholderQR<MatrixXd> factor;
  VectorXd scale; // of the columns
};

State evaluate(const Lines& l, const MatrixXd& H, const Poles& poles) {
  State s{.poles = poles, .A = basis(l, poles), .C = {}, .E = {}, .factor = {}, .scale = {}};
  s.scale = s.A.colwise().norm().transpose().cwiseMax(1e-300);
  s.A = s.A * s.scale.cwiseInverse().asDiagonal();
  s.factor.compute(s.A);
  s.C = s.factor.solve(H);
  s.E = H - s.A * s.C;
  s.cost = s.E.squaredNorm();
  return s;
}

// J'J and J'E of the poles, two parameters each, each in units of half a bandwidth.
struct Normal {
  MatrixXd JJ;
  VectorXd JE;
  MatrixXd score; // JE by line: lines x parameters
};

Normal normal_equations(const Lines& l, const State& s) {
  const Index modes = Index(s.poles.size());
  MatrixXd D = basis_derivatives(l, s.poles);
  for (Index r = 0; r < modes; ++r)
    for (Index a = 0; a < 4; ++a) D.col(4 * r + a) *= -s.poles[r].real() / s.scale[2 * r + a % 2];
  // What of them is orthogonal to the basis.
  const MatrixXd thin = s.factor.householderQ() * MatrixXd::Identity(s.A.rows(), s.A.cols());
  const MatrixXd G = D - thin * (thin.transpose() * D);
  const MatrixXd Q = G.transpose() * G, GE = G.transpose() * s.E;
  const MatrixXd CC = s.C * s.C.transpose();
  const Index lines = s.A.rows() / 2;
  Normal n{.JJ = MatrixXd::Zero(2 * modes, 2 * modes),
           .JE = VectorXd::Zero(2 * modes),
           .score = MatrixXd::Zero(lines, 2 * modes)};
  for (Index j = 0; j < 2 * modes; ++j)
    for (Index a = 0; a < 2; ++a) {
      const Index ca = 2 * (j / 2) + a;
      n.JE[j] += GE.row(2 * j + a).dot(s.C.row(ca));
      const VectorXd product = G.col(2 * j + a).cwiseProduct(s.E * s.C.row(ca).transpose());
      n.score.col(j) += product.head(lines) + product.tail(lines);
      for (Index k = 0; k < 2 * modes; ++k)
        for (Index b = 0; b < 2; ++b)
          n.JJ(j, k) += Q(2 * j + a, 2 * k + b) * CC(ca, 2 * (k / 2) + b);
    }
  return n;
}

Poles moved(const Poles& poles, const VectorXd& step) {
  Poles result = poles;
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const double unit = -poles[r].real();
    const Complex d(unit * std::clamp(step[2 * r], -0.5, 0.5),
                    unit * std::clamp(step[2 * r + 1], -1., 1.));
    result[r] += d;
  }
  return result;
}

struct Search {
  State state;
  int iterations = 0;
  bool converged = false;
};

Search search(const Lines& l, const MatrixXd& H, const Poles& start) {
  Search result{.state = evaluate(l, H, start)};
  result.converged = start.empty();
  double damping = 1e-3;
  for (; result.iterations < 200 && !result.converged; ++result.iterations) {
    const Normal n = normal_equations(l, result.state);
    MatrixXd M = n.JJ;
    M.diagonal() += damping * n.JJ.diagonal();
    const VectorXd step = M.ldlt().solve(n.JE);
    if (!step.allFinite()) break;
    State next = evaluate(l, H, moved(result.state.poles, step));
    const double largest = step.cwiseAbs().maxCoeff();
    const bool better = next.cost <= result.state.cost;
    result.converged = largest < 1e-10 || (better && damping < 1e-2 && largest < 1e-7);
    if (better) {
      result.state = std::move(next);
      damping = std::max(damping / 10, 1e-12);
    } else if ((damping *= 10) > 1e12) {
      break;
    }
  }
  return result;
}

// Columns: responses of the first reference, then of the second.
MatrixXd stacked(const FrfSet& set) {
  const Index lines = set.hertz.size(), each = Index(set.responses.size());
  MatrixXd H(2 * lines, each * Index(set.H.size()));
  for (std::size_t i = 0; i < set.H.size(); ++i)
    H.middleCols(Index(i) * each, each) << set.H[i].real(), set.H[i].imag();
  return H;
}

// Variances of the poles in the units of normal_equations(). The larger of two: s^2 (J'J)^-1 of
// white noise, and the sandwich (J'J)^-1 V (J'J)^-1 with V the scatter of the scores of the lines
// and their correlation over three neighbours (Bartlett's weights). The second takes the residual
// as it is, larger at a resonance that wanders, correlated under a window, but is too small where
// few lines lie in a bandwidth (White, Econometrica 48 (1980); Newey and West, ibid. 55 (1987)).
VectorXd variances_of(const Normal& n, double cost, double values, double freedom) {
  if (n.JE.size() == 0) return {};
  constexpr Index lags = 3;
  MatrixXd V = n.score.transpose() * n.score;
  for (Index lag = 1; lag <= lags && lag < n.score.rows(); ++lag) {
    const Index common = n.score.rows() - lag;
    const MatrixXd cross = n.score.topRows(common).transpose() * n.score.bottomRows(common);
    V += (1 - double(lag) / (lags + 1)) * (cross + cross.transpose());
  }
  const MatrixXd inverse = n.JJ.ldlt().solve(MatrixXd::Identity(n.JJ.rows(), n.JJ.cols()));
  const VectorXd white = cost / freedom * inverse.diagonal();
  return white.cwiseMax((inverse * V * inverse).diagonal() * (values / freedom));
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
  // Weights: first the noise between the lines, then what a first fit leaves.
  const double size = H.norm() / std::sqrt(double(H.size()));
  const MatrixXd noise_level = noise_levels(set);
  VectorXd weight = VectorXd::Map(noise_level.data(), noise_level.size()).cwiseInverse();
  Search found = search(l, H * weight.asDiagonal(), poles);
  int iterations = found.iterations;
  const VectorXd rest = (found.state.E.colwise().norm() / std::sqrt(double(H.rows()))).transpose();
  const VectorXd noise = rest.cwiseQuotient(weight).cwiseMax(1e-12 * size);
  weight = noise.cwiseInverse();
  found = search(l, H * weight.asDiagonal(), found.state.poles);
  iterations += found.iterations;
  const State& s = found.state;

  ModalFit fit;
  fit.iterations = iterations;
  fit.converged = found.converged;
  const double freedom = std::max(1., double(H.size()) - double(s.C.size()) - 2. * double(modes));
  const VectorXd variance = variances_of(normal_equations(l, s), s.cost, double(H.size()), freedom);
  const VectorXd unit = s.scale.cwiseInverse();
  const MatrixXd R = s.factor.matrixQR().topRows(s.A.cols()).triangularView<Eigen::Upper>();
  const MatrixXd inverse =
      R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(R.rows(), R.cols()));
  const VectorXd spread = inverse.rowwise().norm().cwiseProduct(unit);
  const auto table = [&](Index row) -> MatrixXd {
    const VectorXd values = (s.C.row(row) * unit[row]).transpose().cwiseQuotient(weight);
    return Eigen::Map<const MatrixXd>(values.data(), each, inputs);
  };
  const VectorXd rms =
      (s.E.colwise().norm() / std::sqrt(double(H.rows()))).transpose().cwiseQuotient(weight);
  fit.noise = Eigen::Map<const MatrixXd>(rms.data(), each, inputs);
  for (Index r = 0; r < modes; ++r) {
    const double width = -s.poles[r].real();
    FittedMode mode{.lambda = s.poles[r],
                    .sigma_real = width * std::sqrt(variance[2 * r]),
                    .sigma_imaginary = width * std::sqrt(variance[2 * r + 1]),
                    .residue = table(2 * r).cast<Complex>() +
                               Complex(0, 1) * table(2 * r + 1).cast<Complex>(),
                    .sigma_residue = fit.noise * std::max(spread[2 * r], spread[2 * r + 1])};
    fit.modes.push_back(std::move(mode));
  }
  fit.lower = table(2 * modes);
  fit.upper = table(2 * modes + 1);
  std::sort(fit.modes.begin(), fit.modes.end(),
            [](const FittedMode& a, const FittedMode& b) { return a.frequency() < b.frequency(); });
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
