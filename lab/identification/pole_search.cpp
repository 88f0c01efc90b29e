#include "lab/identification/pole_search.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

// Everything at one set of poles.
struct PoleState {
  Poles poles;
  MatrixXd A, C, E; // basis, coefficients, weighted residual
  double cost = 0;
  Eigen::HouseholderQR<MatrixXd> factor;
  VectorXd scale; // of the columns
};

PoleState evaluate(const PoleBasis& basis, const MatrixXd& data, const Poles& poles) {
  PoleState s{
      .poles = poles, .A = basis.columns(poles), .C = {}, .E = {}, .factor = {}, .scale = {}};
  s.scale = s.A.colwise().norm().transpose().cwiseMax(1e-300);
  s.A = s.A * s.scale.cwiseInverse().asDiagonal();
  s.factor.compute(s.A);
  s.C = s.factor.solve(data);
  s.E = data - s.A * s.C;
  s.cost = s.E.squaredNorm();
  return s;
}

// J'J and J'E of the poles, two parameters each, each in units of half a bandwidth.
struct PoleNormal {
  MatrixXd JJ;
  VectorXd JE;
  MatrixXd score; // JE by line: lines x parameters
};

PoleNormal normal_equations(const PoleBasis& basis, const PoleState& s) {
  const Index modes = Index(s.poles.size());
  MatrixXd D = basis.derivatives(s.poles);
  for (Index r = 0; r < modes; ++r)
    for (Index a = 0; a < 4; ++a) D.col(4 * r + a) *= -s.poles[r].real() / s.scale[2 * r + a % 2];
  // What of them is orthogonal to the basis.
  const MatrixXd thin = s.factor.householderQ() * MatrixXd::Identity(s.A.rows(), s.A.cols());
  const MatrixXd G = D - thin * (thin.transpose() * D);
  const MatrixXd Q = G.transpose() * G, GE = G.transpose() * s.E;
  const MatrixXd CC = s.C * s.C.transpose();
  PoleNormal n{.JJ = MatrixXd::Zero(2 * modes, 2 * modes),
               .JE = VectorXd::Zero(2 * modes),
               .score = MatrixXd::Zero(basis.lines, 2 * modes)};
  for (Index j = 0; j < 2 * modes; ++j)
    for (Index a = 0; a < 2; ++a) {
      const Index ca = 2 * (j / 2) + a;
      n.JE[j] += GE.row(2 * j + a).dot(s.C.row(ca));
      const VectorXd product = G.col(2 * j + a).cwiseProduct(s.E * s.C.row(ca).transpose());
      for (Index first = 0; first < product.size(); first += basis.lines)
        n.score.col(j) += product.segment(first, basis.lines);
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
    result[r] += Complex(unit * std::clamp(step[2 * Index(r)], -0.5, 0.5),
                         unit * std::clamp(step[2 * Index(r) + 1], -1., 1.));
  }
  return result;
}

struct Descent {
  PoleState state;
  int iterations = 0;
  bool converged = false;
};

Descent descend(const PoleBasis& basis, const MatrixXd& data, const Poles& start, int most) {
  Descent result{.state = evaluate(basis, data, start)};
  result.converged = start.empty();
  double damping = 1e-3;
  for (; result.iterations < most && !result.converged; ++result.iterations) {
    const PoleNormal n = normal_equations(basis, result.state);
    MatrixXd M = n.JJ;
    M.diagonal() += damping * n.JJ.diagonal();
    const VectorXd step = M.ldlt().solve(n.JE);
    if (!step.allFinite()) break;
    PoleState next = evaluate(basis, data, moved(result.state.poles, step));
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

// Variances of the poles in the units of normal_equations(). The larger of two: s^2 (J'J)^-1 of
// white noise, and the sandwich (J'J)^-1 V (J'J)^-1 with V the scatter of the scores of the lines
// and their correlation over three neighbours (Bartlett's weights). The second takes the residual
// as it is, larger at a resonance that wanders, correlated under a window, but is too small where
// few lines lie in a bandwidth (White, Econometrica 48 (1980); Newey and West, ibid. 55 (1987)).
VectorXd variances_of(const PoleNormal& n, double cost, double values, double freedom) {
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

PoleSearch search_poles(const PoleBasis& basis, const MatrixXd& data, const VectorXd& noise,
                        const Poles& start, int iterations) {
  const double root = std::sqrt(double(data.rows()));
  const double size = data.norm() / std::sqrt(double(data.size()));
  VectorXd weight = noise.cwiseInverse();
  Descent found = descend(basis, data * weight.asDiagonal(), start, iterations);
  PoleSearch result{.poles = {},
                    .C = {},
                    .rms = {},
                    .spread = {},
                    .sigma_real = {},
                    .sigma_imaginary = {},
                    .iterations = found.iterations};
  const VectorXd rest = (found.state.E.colwise().norm() / root).transpose();
  weight = rest.cwiseQuotient(weight).cwiseMax(1e-12 * size).cwiseInverse();
  found = descend(basis, data * weight.asDiagonal(), found.state.poles, iterations);
  const PoleState& s = found.state;
  result.poles = s.poles;
  result.iterations += found.iterations;
  result.converged = found.converged;
  const VectorXd unit = s.scale.cwiseInverse();
  result.C = unit.asDiagonal() * s.C * weight.cwiseInverse().asDiagonal();
  result.rms = (s.E.colwise().norm() / root).transpose().cwiseQuotient(weight);
  const MatrixXd R = s.factor.matrixQR().topRows(s.A.cols()).triangularView<Eigen::Upper>();
  const MatrixXd inverse =
      R.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(R.rows(), R.cols()));
  result.spread = inverse.rowwise().norm().cwiseProduct(unit);
  const Index modes = Index(s.poles.size());
  const double freedom =
      std::max(1., double(data.size()) - double(s.C.size()) - 2. * double(modes));
  const VectorXd variance =
      variances_of(normal_equations(basis, s), s.cost, double(data.size()), freedom);
  result.sigma_real.resize(modes);
  result.sigma_imaginary.resize(modes);
  for (Index r = 0; r < modes; ++r) {
    const double width = -s.poles[std::size_t(r)].real();
    result.sigma_real[r] = width * std::sqrt(variance[2 * r]);
    result.sigma_imaginary[r] = width * std::sqrt(variance[2 * r + 1]);
  }
  return result;
}

} // namespace plica
