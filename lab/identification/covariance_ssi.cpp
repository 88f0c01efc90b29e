#include "lab/identification/covariance_ssi.hpp"

#include "lab/identification/state_space.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::RowVectorXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using Complex = std::complex<double>;
constexpr Index most_blocks = 200, fewest_blocks = 20;

// What of a state-space model the derivatives of one mode need.
struct ModeOfModel {
  MatrixXd U1, up, down, A, left; // left: up^+
  MatrixXd gram;                  // (up' up)^-1
  MatrixXd rest;                  // down - up A
  Complex mu;
  VectorXcd right;     // A right = mu right
  RowVectorXcd dual;   // dual A = mu dual, dual right = 1
  MatrixXcd resolvent; // sum over the others of right_j dual_j / (mu - mu_j)
};

ModeOfModel mode_of_model(const Subspace& s, const Pole& pole, int order, double rate) {
  ModeOfModel m;
  m.U1 = s.U.leftCols(2 * order);
  const Index rows = m.U1.rows() - s.channels;
  m.up = m.U1.topRows(rows);
  m.down = m.U1.bottomRows(rows);
  m.A = transition(m.U1, s.channels);
  m.gram = (m.up.transpose() * m.up).ldlt().solve(MatrixXd::Identity(2 * order, 2 * order));
  m.left = m.gram * m.up.transpose();
  m.rest = m.down - m.up * m.A;
  const Eigen::EigenSolver<MatrixXd> solver(m.A);
  const VectorXcd& all = solver.eigenvalues();
  Index own = 0;
  (all.array() - std::exp(pole.lambda / rate)).abs().minCoeff(&own);
  m.mu = all[own];
  const MatrixXcd right = solver.eigenvectors(), dual = right.inverse();
  m.right = right.col(own);
  m.dual = dual.row(own);
  m.resolvent = MatrixXcd::Zero(all.size(), all.size());
  for (Index j = 0; j < all.size(); ++j)
    if (j != own) m.resolvent += right.col(j) * dual.row(j) / (m.mu - all[j]);
  return m;
}

// Derivative of x = row dA right + add dO right by H, summed over what stands for the same
// correlation: per lag channels x references.
//
//   dA right = up^+ (dO_down - mu dO_up) right + gram dO_up' rest right
//   dO = U2 P,  P_ij = (s_j u_i' dH v_j + s_i u_j' dH v_i) / (s_j^2 - s_i^2)
class Derivative {
public:
  Derivative(const Subspace& s, const ModeOfModel& m)
      : s_(s), m_(m), U2_(s.U.rightCols(s.U.cols() - m.U1.cols())) {
    const Index n = m.U1.cols(), more = U2_.cols(), common = s.S.size() - n;
    V1_ = s.V.leftCols(n).transpose();
    V2_ = s.V.middleCols(n, common).transpose();
    by_u_.resize(more, n);
    by_v_.resize(common, n);
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < more; ++i) {
        const double si = i < common ? s.S[n + i] : 0, sj = s.S[j];
        const double apart = std::max(sj * sj - si * si, 1e-12 * sj * sj);
        by_u_(i, j) = sj / apart;
        if (i < common) by_v_(i, j) = si / apart;
      }
  }

  std::vector<MatrixXcd> of(const RowVectorXcd& row, const RowVectorXcd& add) const {
    const Index rows = m_.U1.rows(), r = s_.channels;
    const RowVectorXcd through = row * m_.left.cast<Complex>();
    RowVectorXcd a = RowVectorXcd::Zero(rows);
    a.tail(rows - r) += through;
    a.head(rows - r) -= m_.mu * through;
    a.head(r) += add;
    // row gram dO_up' e = e' dO_up (row gram)'
    VectorXcd e = VectorXcd::Zero(rows);
    e.head(rows - r) = m_.rest * m_.right;
    const VectorXcd c = (row * m_.gram.cast<Complex>()).transpose();
    const MatrixXcd weight = (U2_.transpose() * a.transpose()) * m_.right.transpose() +
                             (U2_.transpose() * e) * c.transpose();
    const MatrixXd real = by_matrix(weight.real()), imaginary = by_matrix(weight.imag());
    return by_lag(real.cast<Complex>() + Complex(0, 1) * imaginary.cast<Complex>());
  }

private:
  MatrixXd by_matrix(const MatrixXd& weight) const {
    const MatrixXd first = U2_ * weight.cwiseProduct(by_u_);
    const MatrixXd second = weight.topRows(by_v_.rows()).cwiseProduct(by_v_).transpose() * V2_;
    return first * V1_ + m_.U1 * second;
  }

  std::vector<MatrixXcd> by_lag(const MatrixXcd& G) const {
    const Index r = s_.channels, q = s_.references;
    const Index down = G.rows() / r, across = G.cols() / q;
    std::vector<MatrixXcd> sum(std::size_t(down + across - 1), MatrixXcd::Zero(r, q));
    for (Index i = 0; i < down; ++i)
      for (Index j = 0; j < across; ++j) sum[std::size_t(i + j)] += G.block(i * r, j * q, r, q);
    return sum;
  }

  const Subspace& s_;
  const ModeOfModel& m_;
  MatrixXd U2_, V1_, V2_, by_u_, by_v_;
};

// dx_k of all blocks.
VectorXcd directions(const Correlations& c, const std::vector<MatrixXcd>& derivative) {
  VectorXcd d(Index(c.blocks.size()));
  for (Index k = 0; k < d.size(); ++k) {
    Complex sum = 0;
    for (std::size_t i = 0; i < c.R.size(); ++i)
      sum += derivative[i].cwiseProduct(c.blocks[std::size_t(k)][i] - c.R[i]).sum();
    d[k] = sum;
  }
  return d;
}

double deviation(const VectorXd& d, Index lags) {
  const Index b = d.size();
  double sum = d.squaredNorm();
  for (Index lag = 1; lag <= lags && lag < b; ++lag)
    sum += 2 * (1 - double(lag) / double(lags + 1)) * d.head(b - lag).dot(d.tail(b - lag));
  return std::sqrt(std::max(0., sum) / double(b * (b - 1)));
}

// As many blocks as the mode's responses remember, four times over.
Index remembered(const Complex& lambda, const Correlations& c, double rate) {
  const double memory = rate / std::max(-lambda.real(), 1e-6 * std::abs(lambda));
  return std::min(Index(std::ceil(4 * memory / double(c.block))) + 1, Index(c.blocks.size()) / 5);
}

} // namespace

Correlations correlations(const MatrixXd& samples, const std::vector<Index>& references,
                          Index lags) {
  const Index usable = samples.rows() - lags;
  Correlations c;
  c.block = std::max(2 * lags, usable / most_blocks);
  const Index count = usable / c.block;
  if (count < fewest_blocks)
    throw std::invalid_argument(std::to_string(samples.rows()) + " samples give " +
                                std::to_string(std::max<Index>(0, count)) + " blocks of " +
                                std::to_string(c.block) + ", 20 are needed");
  const MatrixXd reference = samples(Eigen::all, references);
  c.R.assign(std::size_t(lags), MatrixXd::Zero(samples.cols(), reference.cols()));
  for (Index k = 0; k < count; ++k) {
    std::vector<MatrixXd> own;
    for (Index i = 1; i <= lags; ++i) {
      own.emplace_back(samples.middleRows(k * c.block + i, c.block).transpose() *
                       reference.middleRows(k * c.block, c.block) / double(c.block));
      c.R[std::size_t(i - 1)] += own.back() / double(count);
    }
    c.blocks.push_back(std::move(own));
  }
  return c;
}

Subspace subspace(const Correlations& c) {
  const Index half = Index(c.R.size()) / 2, r = c.R[0].rows(), q = c.R[0].cols();
  MatrixXd H((half + 1) * r, half * q);
  for (Index i = 0; i <= half; ++i)
    for (Index j = 0; j < half; ++j) H.block(i * r, j * q, r, q) = c.R[std::size_t(i + j)];
  const Eigen::BDCSVD<MatrixXd> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {.U = svd.matrixU(),
          .V = svd.matrixV(),
          .S = svd.singularValues(),
          .channels = r,
          .references = q};
}

StochasticMode stochastic_mode(const Subspace& s, const Correlations& c, const Pole& pole,
                               int order, double rate, const VectorXd& scale) {
  const ModeOfModel m = mode_of_model(s, pole, order, rate);
  const Derivative derivative(s, m);
  const Index r = s.channels;
  const RowVectorXcd none = RowVectorXcd::Zero(r);
  StochasticMode mode{.lambda = std::log(m.mu) * rate, .shape = {}, .sigma_shape = {}};
  const double w = std::abs(mode.lambda);
  const Index lags = remembered(mode.lambda, c, rate);
  const VectorXcd lambda = directions(c, derivative.of(m.dual, none)) * (rate / m.mu);
  // |l| and -Re l / |l|
  const VectorXd size = (std::conj(mode.lambda) * lambda).real() / w;
  mode.sigma_frequency = deviation(size, lags) / (2 * std::numbers::pi);
  mode.sigma_damping = deviation(-lambda.real() / w + mode.lambda.real() / (w * w) * size, lags);
  if (scale.size() == 0) return mode;
  const MatrixXd C = scale.asDiagonal() * m.U1.topRows(r);
  const VectorXcd shape = C * m.right;
  Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  std::vector<VectorXcd> each; // of the components, each block
  for (Index k = 0; k < r; ++k) {
    RowVectorXcd own = none;
    own[k] = scale[k];
    each.push_back(directions(c, derivative.of(C.row(k).cast<Complex>() * m.resolvent, own)));
  }
  mode.shape = shape / shape[largest];
  mode.sigma_shape = VectorXd::Zero(r);
  for (Index k = 0; k < r; ++k) {
    const VectorXcd d =
        (each[std::size_t(k)] - mode.shape[k] * each[std::size_t(largest)]) / shape[largest];
    mode.sigma_shape[k] =
        std::hypot(deviation(d.real(), lags), deviation(d.imag(), lags)) / std::numbers::sqrt2;
  }
  return mode;
}

} // namespace plica
