#include "solve/dissipation.hpp"

#include "solve/complex_eigen.hpp"
#include "words/short_text.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Complex = std::complex<double>;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
constexpr Complex i_(0, 1);

VectorXd viscous(const ModalModel& m) {
  return 2 * m.zeta.array() * m.lambda.array().max(0).sqrt();
}

// Lambda (1 + i eta), or Lambda + i L.
MatrixXcd constant_stiffness(const ModalModel& m, const Dissipation& d) {
  MatrixXcd K = MatrixXcd(m.lambda.cast<Complex>().asDiagonal());
  if (d.loss.size() > 0)
    K += i_ * d.loss;
  else
    K.diagonal() += i_ * VectorXd(m.lambda.cwiseProduct(m.eta));
  return K;
}

MatrixXd spring_columns(const ModalModel& m, const std::vector<DampedSpring>& springs) {
  MatrixXd B(m.lambda.size(), Index(springs.size()));
  for (std::size_t k = 0; k < springs.size(); ++k) B.col(Index(k)) = m.input.col(springs[k].column);
  return B;
}

// First-order form of s^2 + s C + K: A [q; s q] = s [q; s q].
MatrixXcd state_matrix(const MatrixXcd& K, const MatrixXcd& C) {
  const Index n = K.rows();
  MatrixXcd A = MatrixXcd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n).setIdentity();
  A.bottomLeftCorner(n, n) = -K;
  A.bottomRightCorner(n, n) = -C;
  return A;
}

} // namespace

DissipativeResponse::DissipativeResponse(const ModalModel& model, const Dissipation& dissipation)
    : model_(model), springs_(dissipation.springs), poles_(dissipation.loss.size() > 0) {
  const Index n = model.lambda.size();
  MatrixXd seen(model.output.rows() + Index(springs_.size()), n);
  seen << model.output, spring_columns(model, springs_).transpose();
  left_ = seen.cast<Complex>();
  right_ = model.input.cast<Complex>();
  stretch_ = dissipation.stretch;
  if (!poles_) return; // nothing of what is carried is lost in a material
  if (dissipation.carried_loss.size() > 0) carried_ = i_ * dissipation.carried_loss;
  const VectorXd C = viscous(model);
  const ComplexEigen eigen = complex_eigen(
      state_matrix(constant_stiffness(model, dissipation), C.cast<Complex>().asDiagonal()));
  s_ = eigen.values;
  // (i omega - A)^-1 [0; f]: displacement rows of V (i omega - s)^-1 V^-1.
  const MatrixXcd& V = eigen.vectors;
  const Eigen::PartialPivLU<MatrixXcd> inverse(V);
  for (MatrixXcd* terms : {&right_, &carried_}) {
    if (terms->size() == 0) continue;
    MatrixXcd load = MatrixXcd::Zero(2 * n, terms->cols());
    load.bottomRows(n) = *terms;
    *terms = inverse.solve(load);
  }
  left_ = left_ * V.topRows(n);
}

VectorXcd DissipativeResponse::diagonal(double omega) const {
  if (poles_) return (i_ * omega - s_.array()).inverse();
  const ArrayXd& lambda = model_.lambda.array();
  const ArrayXd damping = lambda * model_.eta.array() + omega * viscous(model_).array();
  // A mode that springs alone damp has no response without them at its own frequency.
  constexpr double least = 1e-8;
  Eigen::ArrayXcd dynamic = (lambda - omega * omega).cast<Complex>() + i_ * damping;
  for (Index j = 0; j < dynamic.size(); ++j)
    if (std::abs(dynamic[j]) < least * lambda[j]) dynamic[j] = i_ * least * lambda[j];
  return dynamic.inverse();
}

MatrixXcd DissipativeResponse::operator()(const std::vector<std::pair<int, Complex>>& loads,
                                          const VectorXd& omega) const {
  const auto springs = Index(springs_.size());
  const Index channels = left_.rows() - springs;
  VectorXcd load = VectorXcd::Zero(right_.rows()), carried = load;
  VectorXcd stretch = VectorXcd::Zero(springs);
  for (const auto& [column, factor] : loads) {
    load += factor * right_.col(column);
    if (carried_.size() > 0) carried += factor * carried_.col(column);
    if (stretch_.size() > 0) stretch += factor * stretch_.col(column);
  }
  const auto load_at = [&](double w) -> VectorXcd { return load + carried / (w * w); };
  MatrixXcd response(omega.size(), channels);
  if (springs == 0) {
    constexpr Index block = 64; // frequencies whose terms stay in the cache
#pragma omp parallel for schedule(static)
    for (Index first = 0; first < omega.size(); first += block) {
      const Index count = std::min(block, omega.size() - first);
      MatrixXcd terms(load.size(), count);
      for (Index k = 0; k < count; ++k)
        terms.col(k) = diagonal(omega[first + k]).cwiseProduct(load_at(omega[first + k]));
      response.middleRows(first, count) = (left_ * terms).transpose();
    }
    return response;
  }
  MatrixXcd of_springs(right_.rows(), springs);
  for (Index k = 0; k < springs; ++k)
    of_springs.col(k) = right_.col(springs_[std::size_t(k)].column);
#pragma omp parallel for schedule(static)
  for (Index f = 0; f < omega.size(); ++f) {
    const double w = omega[f];
    const VectorXcd d = diagonal(w);
    const VectorXcd free = left_ * d.cwiseProduct(load_at(w));
    const MatrixXcd receptance = left_ * (d.asDiagonal() * of_springs);
    // Forces of the springs p = -G (free + H p + what is carried) at them.
    VectorXcd G(springs);
    for (Index k = 0; k < springs; ++k) G[k] = springs_[std::size_t(k)].added(i_ * w);
    const MatrixXcd A =
        MatrixXcd::Identity(springs, springs) + G.asDiagonal() * receptance.bottomRows(springs);
    const VectorXcd stretched = free.tail(springs) - stretch / (w * w);
    const VectorXcd p = A.partialPivLu().solve(-G.cwiseProduct(stretched));
    response.row(f) = (free.head(channels) + receptance.topRows(channels) * p).transpose();
  }
  return response;
}

namespace {

// T(s) and its derivative.
class Pencil {
public:
  Pencil(const ModalModel& model, const Dissipation& dissipation)
      : C_(viscous(model).cast<Complex>()), K_(constant_stiffness(model, dissipation)),
        B_(spring_columns(model, dissipation.springs).cast<Complex>()),
        springs_(dissipation.springs) {}

  MatrixXcd at(Complex s) const {
    MatrixXcd T = K_;
    T.diagonal() += s * C_;
    T.diagonal().array() += s * s;
    return T + B_ * added(s).asDiagonal() * B_.transpose();
  }
  MatrixXcd slope(Complex s) const {
    const Complex h = 1e-6 * s;
    MatrixXcd T = B_ * ((added(s + h) - added(s - h)) / (2. * h)).asDiagonal() * B_.transpose();
    T.diagonal() += C_;
    T.diagonal().array() += 2. * s;
    return T;
  }

private:
  VectorXcd added(Complex s) const {
    VectorXcd g(Index(springs_.size()));
    for (std::size_t k = 0; k < springs_.size(); ++k) g[Index(k)] = springs_[k].added(s);
    return g;
  }

  VectorXcd C_;
  MatrixXcd K_, B_;
  const std::vector<DampedSpring>& springs_;
};

// A spring as a dashpot and a spring at the middle of the spectrum: where the search begins.
struct Linear {
  MatrixXcd K, C;
};
Linear linearised(const ModalModel& model, const Dissipation& d, double omega) {
  Linear l{constant_stiffness(model, d), MatrixXcd(viscous(model).cast<Complex>().asDiagonal())};
  const MatrixXd B = spring_columns(model, d.springs);
  for (std::size_t k = 0; k < d.springs.size(); ++k) {
    const Complex g = d.springs[k].added(i_ * omega);
    const MatrixXcd bb = (B.col(Index(k)) * B.col(Index(k)).transpose()).cast<Complex>();
    l.K += g.real() * bb;
    l.C += g.imag() / omega * bb;
  }
  return l;
}

// Newton's method for T(s) q = 0, c' q = 1.
bool follow(const Pencil& pencil, ComplexMode& mode) {
  constexpr int most = 40;
  VectorXcd q = mode.q / std::sqrt(mode.q.squaredNorm());
  for (int step = 0; step < most; ++step) {
    const MatrixXcd T = pencil.at(mode.s);
    mode.residual = (T * q).norm() / std::norm(mode.s);
    const VectorXcd c = q.conjugate();
    const VectorXcd u = T.partialPivLu().solve(pencil.slope(mode.s) * q);
    const Complex change = 1. / c.cwiseProduct(u).sum();
    if (!std::isfinite(std::abs(change)) || !u.allFinite()) break;
    q = u / u.norm();
    mode.s -= change;
    if (std::abs(change) > 1e-13 * std::abs(mode.s)) continue;
    break;
  }
  mode.residual = (pencil.at(mode.s) * q).norm() / std::norm(mode.s);
  mode.q = q / std::sqrt(q.cwiseProduct(q).sum());
  return mode.residual < 1e-10 && mode.s.imag() > 0 && mode.q.allFinite();
}

} // namespace

ComplexModes complex_modes(const ModalModel& model, const Dissipation& dissipation, int count) {
  const Index n = model.lambda.size();
  ComplexModes found;
  if (n == 0 || count == 0) return found;
  const Pencil pencil(model, dissipation);
  const double middle = std::sqrt(std::max(model.lambda[std::min<Index>(n - 1, count / 2)], 1.));
  const Linear linear = linearised(model, dissipation, middle);
  const ComplexEigen eigen = complex_eigen(state_matrix(linear.K, linear.C));
  std::vector<ComplexMode> all;
  int real = 0;
  for (Index k = 0; k < 2 * n; ++k) {
    const Complex s = eigen.values[k];
    if (s.imag() > 1e-9 * std::abs(s))
      all.push_back({s, eigen.vectors.col(k).head(n), 0});
    else if (s.imag() > -1e-9 * std::abs(s))
      ++real;
  }
  found.oscillating = int(all.size());
  found.overdamped = real / 2;
  std::sort(all.begin(), all.end(), [](const ComplexMode& a, const ComplexMode& b) {
    return std::abs(a.s) < std::abs(b.s);
  });
  all.resize(std::min(all.size(), std::size_t(count)));
  found.complete = found.oscillating + found.overdamped == n;
  if (!found.complete)
    found.reason = std::to_string(found.oscillating) + " oscillations and " +
                   std::to_string(found.overdamped) + " overdamped motions of " +
                   std::to_string(n) + " coordinates";
  for (ComplexMode& mode : all) {
    const double before = std::abs(mode.s);
    if (follow(pencil, mode)) continue;
    found.complete = false;
    found.reason = "a mode near " + short_text(before / (2 * std::numbers::pi), 6) +
                   " Hz was not followed to its end";
  }
  std::sort(all.begin(), all.end(), [](const ComplexMode& a, const ComplexMode& b) {
    return std::abs(a.s) < std::abs(b.s);
  });
  for (std::size_t a = 0; found.complete && a < all.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (std::abs(all[a].s - all[b].s) > 1e-9 * std::abs(all[a].s)) continue;
      const double alike = std::abs(all[a].q.dot(all[b].q)) / (all[a].q.norm() * all[b].q.norm());
      if (alike < 0.999) continue;
      found.complete = false;
      found.reason = "two searches ended in one mode";
    }
  if (found.overdamped > 0 && found.reason.empty())
    found.reason = std::to_string(found.overdamped) + " of the motions creep and do not oscillate";
  found.modes = std::move(all);
  return found;
}

} // namespace plica
