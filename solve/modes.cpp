#include "solve/modes.hpp"

#include "solve/dense_modes.hpp"
#include "solve/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int guard_modes = 4;          // computed beyond those asked for, to find a gap
constexpr double pair_tolerance = 1e-5; // relative distance of lambda within a pair
constexpr double residual_limit = 1e-5;
constexpr double orthogonality_limit = 1e-8;

int dofs_with_mass(const SparseMatrix& M) {
  return static_cast<int>((VectorXd(M.diagonal()).array() > 0).count());
}

// Order of magnitude of the largest eigenvalue.
double spectrum_scale(const SparseMatrix& K, const SparseMatrix& M) {
  const double mass = VectorXd(M.diagonal()).sum();
  return mass > 0 ? VectorXd(K.diagonal()).sum() / mass : 1;
}

// Rayleigh quotient after one inverse iteration: about the smallest |lambda - sigma|.
double smallest_eigenvalue(const SparseMatrix& K, const SparseMatrix& M,
                           const SparseFactor& factor) {
  std::mt19937 random(7);
  VectorXd v(K.rows());
  for (double& x : v) x = double(random()) / double(std::mt19937::max()) - 0.5;
  VectorXd x = factor.solve(symmetric_product(M, v));
  const double norm = x.norm();
  if (!std::isfinite(norm) || norm == 0) return 0;
  x /= norm;
  const double mass = x.dot(symmetric_product(M, x).col(0));
  return mass > 0 ? x.dot(symmetric_product(K, x).col(0)) / mass : 0;
}

VectorXd residuals(const SparseMatrix& K, const SparseMatrix& M, const VectorXd& lambda,
                   const MatrixXd& Phi, double shift) {
  const MatrixXd MPhi = symmetric_product(M, Phi);
  const MatrixXd R = symmetric_product(K, Phi) - MPhi * lambda.asDiagonal();
  VectorXd r(lambda.size());
  for (Index i = 0; i < r.size(); ++i)
    r[i] = R.col(i).norm() / ((std::abs(lambda[i]) + std::abs(shift)) * MPhi.col(i).norm());
  return r;
}

// Size below which a value is not told from zero, relative to the largest found: keeps the rigid
// modes of a free body together.
double smallest_size(const VectorXd& lambda) {
  return lambda.size() > 0 ? 1e-2 * std::abs(lambda[lambda.size() - 1]) : 0;
}

// Smallest number of modes >= wanted that does not cut a pair, nor the rigid modes.
int whole_pairs(const VectorXd& lambda, int wanted) {
  const double size = smallest_size(lambda);
  int keep = std::min<int>(wanted, static_cast<int>(lambda.size()));
  while (keep > 0 && keep < lambda.size() &&
         lambda[keep] - lambda[keep - 1] < pair_tolerance * std::max(lambda[keep], size))
    ++keep;
  return keep;
}

// Number of modes of `lambda` above which the widest gap lies, at least keep.
int widest_gap(const VectorXd& lambda, int keep) {
  int best = keep;
  double widest = -1;
  for (int m = std::max(keep, 1); m < lambda.size(); ++m) {
    const double gap =
        (lambda[m] - lambda[m - 1]) / std::max(std::abs(lambda[m]), smallest_size(lambda));
    if (gap > widest) {
      widest = gap;
      best = m;
    }
  }
  return best;
}

int modes_asked(const ModesRequest& request, const VectorXd& lambda) {
  if (request.count > 0) return whole_pairs(lambda, request.count);
  const double high = std::pow(2 * std::numbers::pi * request.band[1], 2);
  return static_cast<int>((lambda.array() <= high).count());
}

// Enough modes: the count asked for and a gap above, or one mode beyond the band.
bool reaches_far_enough(const ModesRequest& request, const VectorXd& lambda, int most) {
  return modes_asked(request, lambda) < lambda.size() || lambda.size() >= most;
}

void drop_below_band(ModeSet& modes, double low_hertz) {
  const double low = std::pow(2 * std::numbers::pi * low_hertz, 2);
  const auto below = (modes.lambda.array() < low).count();
  const Index kept = modes.lambda.size() - below;
  modes.lambda = modes.lambda.tail(kept).eval();
  modes.Phi = modes.Phi.rightCols(kept).eval();
  modes.residual = modes.residual.tail(kept).eval();
}

// A free body: put the shift near the lowest elastic mode, where Lanczos is accurate and fast.
void rescale_shift(BaseFactor& base, const SparseMatrix& K, const SparseMatrix& M,
                   const EigenPairs& pairs) {
  const double rigid = 10 * std::abs(base.sigma);
  for (double lambda : pairs.values)
    if (lambda > rigid) {
      base.sigma = -0.1 * lambda;
      break;
    }
  if (!base.factor.factorise(shifted(K, M, base.sigma)).ok)
    throw std::runtime_error("K - sigma M lost definiteness while the shift was scaled");
}

} // namespace

double frequency(double lambda) {
  return std::sqrt(std::max(0., lambda)) / (2 * std::numbers::pi);
}

BaseFactor factor_below_spectrum(const SparseMatrix& K, const SparseMatrix& M) {
  BaseFactor base{SparseFactor(K), 0};
  const double scale = spectrum_scale(K, M);
  FactorStatus status = base.factor.factorise(K);
  constexpr double rounding = 1e-12; // of the largest eigenvalue: smaller is not told from zero
  if (status.ok && smallest_eigenvalue(K, M, base.factor) > rounding * scale) return base;
  for (double fraction : {1e-10, 1e-8, 1e-6}) {
    base.sigma = -fraction * scale;
    status = base.factor.factorise(shifted(K, M, base.sigma));
    if (status.ok) return base;
  }
  throw std::runtime_error("the model has a degree of freedom without stiffness and mass (a part "
                           "that nothing holds and that has no density?), or an indefinite "
                           "stiffness: factorisation stops at unknown " +
                           std::to_string(status.failed_column + 1) + " of " +
                           std::to_string(K.rows()));
}

int reachable_modes(const SparseMatrix& M) {
  return std::min(dofs_with_mass(M), static_cast<int>(M.rows()) - 1);
}

ModesProof prove_complete(const SparseMatrix& K, const SparseMatrix& M, const VectorXd& lambda,
                          const MatrixXd& Phi, int keep, SparseFactor& factor) {
  ModesProof proof;
  proof.made = true;
  proof.found = widest_gap(lambda, keep);
  const double below = lambda[proof.found - 1];
  // Without a mode above, a little above the last one: the pair tolerance apart.
  const double above = proof.found < lambda.size() ? lambda[proof.found]
                                                   : below + 100 * pair_tolerance * std::abs(below);
  proof.sigma = below + 0.5 * (above - below);
  const InertiaCount count = count_below(K, M, proof.sigma, Phi, factor);
  proof.removed_dofs = count.removed;
  if (!count.below) {
    proof.reason = count.reason;
    return proof;
  }
  proof.inertia_count = *count.below;
  proof.passed = proof.inertia_count == proof.found;
  if (!proof.passed)
    proof.reason = "below " + std::to_string(frequency(proof.sigma)) + " Hz there are " +
                   std::to_string(proof.inertia_count) + " modes by inertia, but " +
                   std::to_string(proof.found) + " were found";
  return proof;
}

ModeSet find_modes(const SparseMatrix& K, const SparseMatrix& M, const ModesRequest& request,
                   BaseFactor& base) {
  const int most = reachable_modes(M);
  if (dofs_with_mass(M) == 0)
    throw std::runtime_error("what is free to move has no mass, so there are no modes");
  ModeSet modes;
  Stopwatch watch;
  LanczosSettings settings;
  // A free body: beyond its rigid modes, or nothing tells them from small elastic ones.
  const int least = base.sigma < 0 ? 6 : 1;
  settings.count =
      std::min(most, (request.count > 0 ? std::max(request.count, least) : 16) + guard_modes);
  constexpr int attempts = 3;
  bool scaled = base.sigma == 0;
  double factored_at = base.sigma;
  for (int attempt = 0; attempt < attempts;) {
    if (factored_at != base.sigma && !base.factor.factorise(shifted(K, M, base.sigma)).ok)
      throw std::runtime_error("K - sigma M could not be factored again");
    factored_at = base.sigma;
    const EigenPairs pairs = better_dense(K, M) ? dense_modes(K, M, base.sigma)
                                                : lanczos(M, base.factor, base.sigma, settings);
    modes.operations += pairs.operations;
    watch.lap(modes.timing, "lanczos");
    if (!scaled && pairs.converged) {
      rescale_shift(base, K, M, pairs);
      factored_at = base.sigma;
      scaled = true;
      watch.lap(modes.timing, "factorise");
      continue;
    }
    if (pairs.converged && !better_dense(K, M) &&
        !reaches_far_enough(request, pairs.values, most)) {
      settings.count = std::min(2 * settings.count, most);
      continue;
    }
    const int keep = modes_asked(request, pairs.values);
    modes.lambda = pairs.values.head(keep);
    modes.Phi = pairs.vectors.leftCols(keep);
    modes.residual = residuals(K, M, modes.lambda, modes.Phi, base.sigma);
    modes.proof = {};
    if (request.proof && pairs.converged) {
      modes.proof =
          prove_complete(K, M, pairs.values, pairs.vectors, std::max(keep, 1), base.factor);
      factored_at = std::numeric_limits<double>::quiet_NaN(); // the factor is overwritten
      watch.lap(modes.timing, "proof");
    }
    if (keep > 0) {
      modes.proof.max_residual = modes.residual.maxCoeff();
      const MatrixXd gram = modes.Phi.transpose() * symmetric_product(M, modes.Phi);
      modes.proof.orthogonality = (gram - MatrixXd::Identity(keep, keep)).cwiseAbs().maxCoeff();
    }
    if (!pairs.converged) modes.proof.reason = pairs.reason;
    if (pairs.converged && (!request.proof || modes.proof.passed)) break;
    ++attempt;
    modes.restarts = attempt;
    settings.seed += 1;
    settings.count = std::min(settings.count + 8, most);
    settings.subspace = 3 * settings.count + 40;
  }
  if (request.proof && modes.proof.passed &&
      (modes.proof.max_residual > residual_limit ||
       modes.proof.orthogonality > orthogonality_limit)) {
    modes.proof.passed = false;
    modes.proof.reason = "a mode has a residual of " + std::to_string(modes.proof.max_residual) +
                         " or the modes are not orthogonal to " +
                         std::to_string(modes.proof.orthogonality);
  }
  if (request.count == 0 && request.band[0] > 0) drop_below_band(modes, request.band[0]);
  return modes;
}

} // namespace plica
