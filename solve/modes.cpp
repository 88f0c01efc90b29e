#include "solve/modes.hpp"

#include "solve/block_lanczos.hpp"
#include "solve/dense_modes.hpp"
#include "solve/dense_product.hpp"
#include "solve/model_error.hpp"
#include "solve/modes_search.hpp"
#include "solve/spectrum_slices.hpp"
#include "solve/stopwatch.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <omp.h>
#include <random>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index worth_blocks = 5000; // unknowns
constexpr int worth_slices = 500;    // modes
constexpr Index stripe = 64;         // columns at a time: of many modes no second copy is made

double spectrum_scale(const SparseMatrix& K, const SparseMatrix& M) {
  const double scale = median_ratio(K.diagonal(), M.diagonal());
  return scale > 0 ? scale : 1;
}

// That the smallest eigenvalue is told from the rounding of K, by one inverse iteration.
bool is_definite(const SparseMatrix& K, const SparseMatrix& M, const SparseFactor& factor) {
  std::mt19937 random(7);
  VectorXd v(K.rows());
  for (double& x : v) x = double(random()) / double(std::mt19937::max()) - 0.5;
  VectorXd x = factor.solve(symmetric_product(M, v));
  const double norm = x.norm();
  if (!std::isfinite(norm) || norm == 0) return false;
  x /= norm;
  constexpr double clear = 100; // times the bound of first order
  return x.dot(symmetric_product(K, x).col(0)) > clear * rounding_errors(K, x)[0];
}

VectorXd residuals(const SparseMatrix& K, const SparseMatrix& M, const VectorXd& lambda,
                   const MatrixXd& Phi, double shift) {
  VectorXd r(lambda.size());
  for (Index first = 0; first < r.size(); first += stripe) {
    const Index count = std::min(stripe, r.size() - first);
    const MatrixXd X = Phi.middleCols(first, count), MX = symmetric_product(M, X);
    const VectorXd values = lambda.segment(first, count);
    const MatrixXd R = symmetric_product(K, X) - MX * values.asDiagonal();
    r.segment(first, count) =
        R.colwise().norm().transpose().array() /
        ((values.cwiseAbs().array() + std::abs(shift)) * MX.colwise().norm().transpose().array());
  }
  return r;
}

// max |Phi' M Phi - I|
double orthogonality(const SparseMatrix& M, const MatrixXd& Phi) {
  double largest = 0;
  for (Index first = 0; first < Phi.cols(); first += stripe) {
    const Index count = std::min(stripe, Phi.cols() - first);
    const MatrixXd MX = symmetric_product(M, Phi.middleCols(first, count));
    MatrixXd gram = transposed_product(Phi.rightCols(Phi.cols() - first), MX);
    gram.topRows(count) -= MatrixXd::Identity(count, count);
    largest = std::max(largest, gram.cwiseAbs().maxCoeff());
  }
  return largest;
}

// By the way that suits the size. The first attempts at many modes by slices, the last without.
EigenPairs find_pairs(const SparseMatrix& K, const SparseMatrix& M, const BaseFactor& base,
                      const LanczosSettings& settings, bool by_slices) {
  if (better_dense(K, M)) return dense_modes(K, M, base.sigma);
  if (K.rows() < worth_blocks) return lanczos(M, base.factor, base.sigma, settings);
  if (by_slices && settings.count > worth_slices)
    return spectrum_slices(K, M, base.factor, base.sigma,
                           {.count = settings.count, .seed = settings.seed});
  return block_lanczos(M, base.factor, base.sigma, settings);
}

// How many modes to look for where `found` do not fill the band.
int modes_in_band(const SparseMatrix& K, const SparseMatrix& M, const ModesRequest& request,
                  const SparseFactor& factor, int found) {
  const int more = 2 * found;
  if (request.count > 0 || K.rows() < worth_blocks) return more;
  const std::optional<int> below = count_roughly(K, M, eigenvalue(request.band[1]), factor);
  return below ? std::max(*below, found) + guard_modes : more;
}

// Without a copy of K, which is large; the sums over blocks of columns have one order.
VectorXd rounding_of_stripe(const SparseMatrix& K, const Eigen::Ref<const MatrixXd>& Phi) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Rows size = Phi.cwiseAbs();
  constexpr int width = 4096;
  const int blocks = static_cast<int>((K.cols() + width - 1) / width);
  Rows sums = Rows::Zero(blocks, Phi.cols());
#pragma omp parallel for schedule(dynamic) if (!omp_in_parallel())
  for (int b = 0; b < blocks; ++b)
    for (Index j = Index(b) * width; j < std::min<Index>(K.cols(), Index(b + 1) * width); ++j) {
      Eigen::RowVectorXd force = Eigen::RowVectorXd::Zero(Phi.cols());
      for (SparseMatrix::InnerIterator it(K, j); it; ++it)
        force += std::abs(it.value()) * (it.row() == j ? 1. : 2.) * size.row(it.row());
      sums.row(b) += force.cwiseProduct(size.row(j));
    }
  return std::numeric_limits<double>::epsilon() * sums.colwise().sum().transpose();
}

// A free body: put the shift near the lowest elastic mode, where Lanczos is accurate and fast.
void rescale_shift(BaseFactor& base, const SparseMatrix& K, const SparseMatrix& M,
                   const EigenPairs& pairs) {
  const VectorXd rounding = rounding_errors(K, pairs.vectors);
  for (Index i = 0; i < pairs.values.size(); ++i)
    if (pairs.values[i] > std::max(100 * rounding[i], 1e-2 * std::abs(base.sigma))) {
      base.sigma = -0.1 * pairs.values[i];
      break;
    }
  if (!base.factor.factorise(shifted(K, M, base.sigma)).ok)
    throw ModelError("the stiffness is lost in its rounding: a spring, a joint or a part is so "
                     "much stiffer than what it is tied to that nothing of the rest is left; make "
                     "it rigid or softer");
}

void require_modes(const SparseMatrix& M) {
  if (M.rows() == 0)
    throw ModelError("nothing is free to move: supports and mounts hold it all",
                     {"supports", "mount", "parts"});
  if (dofs_with_mass(M) == 0)
    throw ModelError("what is free to move has no mass, so there are no modes (is a density zero?)",
                     {"materials", "parts"});
}

// Without a proof.
void keep_lowest(ModeSet& modes, const EigenPairs& pairs, int count, const SparseMatrix& K,
                 const SparseMatrix& M, double sigma) {
  modes.lambda = pairs.values.head(count);
  modes.Phi = pairs.vectors.leftCols(count);
  modes.residual = residuals(K, M, modes.lambda, modes.Phi, sigma);
  modes.rounding = rounding_errors(K, modes.Phi);
  modes.proof = {};
}

void measure_accuracy(ModeSet& modes, const SparseMatrix& M, double small) {
  if (modes.lambda.size() == 0) return;
  modes.proof.max_residual = modes.residual.maxCoeff();
  modes.proof.rounding = relative_rounding(modes.lambda, modes.rounding, small);
  modes.proof.orthogonality = orthogonality(M, modes.Phi);
}

} // namespace

void drop_lowest(ModeSet& modes, int below) {
  const Index kept = modes.lambda.size() - below;
  modes.lambda = modes.lambda.tail(kept).eval();
  modes.Phi = modes.Phi.rightCols(kept).eval();
  modes.residual = modes.residual.tail(kept).eval();
  modes.rounding = modes.rounding.tail(kept).eval();
}

double frequency(double lambda) {
  return std::sqrt(std::max(0., lambda)) / (2 * std::numbers::pi);
}

BaseFactor factor_below_spectrum(const SparseMatrix& K, const SparseMatrix& M) {
  BaseFactor base{SparseFactor(K), 0};
  FactorStatus status = base.factor.factorise(K);
  if (K.rows() == 0 || (status.ok && is_definite(K, M, base.factor))) return base;
  const double scale = spectrum_scale(K, M);
  for (double fraction : {1e-10, 1e-8, 1e-6}) {
    base.sigma = -fraction * scale;
    status = base.factor.factorise(shifted(K, M, base.sigma));
    if (status.ok) return base;
  }
  throw ModelError("the model has a degree of freedom without stiffness and mass (a part "
                   "that nothing holds and that has no density?), or an indefinite "
                   "stiffness: factorisation stops at unknown " +
                   std::to_string(status.failed_column + 1) + " of " + std::to_string(K.rows()));
}

int dofs_with_mass(const SparseMatrix& M) {
  return static_cast<int>((VectorXd(M.diagonal()).array() > 0).count());
}

int reachable_modes(const SparseMatrix& M) {
  return std::min(dofs_with_mass(M), static_cast<int>(M.rows()) - 1);
}

double rigid_size(double sigma) {
  return 0.1 * std::abs(sigma);
}

ModesProof prove_complete(const SparseMatrix& K, const SparseMatrix& M, const VectorXd& lambda,
                          const MatrixXd& Phi, int keep, SparseFactor& factor, double small) {
  ModesProof proof;
  proof.made = true;
  const SpectrumGap gap = widest_gap(lambda, keep, static_cast<int>(lambda.size()), small);
  proof.found = gap.below;
  proof.sigma = gap.sigma;
  const InertiaCount count = count_below(K, M, proof.sigma, Phi, factor);
  proof.removed_dofs = count.removed;
  if (!count.below) {
    proof.reason = count.reason;
    return proof;
  }
  proof.inertia_count = *count.below;
  compare_counts(proof, "modes by inertia");
  return proof;
}

void compare_counts(ModesProof& proof, const std::string& what) {
  proof.passed = proof.inertia_count == proof.found;
  if (!proof.passed)
    proof.reason = "below " + short_text(frequency(proof.sigma)) + " Hz there are " +
                   std::to_string(proof.inertia_count) + " " + what + ", but " +
                   std::to_string(proof.found) + " were found";
}

void judge_accuracy(ModesProof& proof) {
  if (!proof.passed) return;
  const auto refuse = [&](const std::string& what, double value, double limit) {
    proof.passed = false;
    proof.reason += (proof.reason.empty() ? "" : "; ") + what + " " + short_text(value) +
                    ", and at most " + short_text(limit) + " is accepted";
  };
  if (!(proof.max_residual <= residual_limit))
    refuse("a mode has a residual of", proof.max_residual, residual_limit);
  if (!(proof.orthogonality <= orthogonality_limit))
    refuse("the modes are orthogonal only to", proof.orthogonality, orthogonality_limit);
  if (!(proof.rounding <= rounding_limit))
    refuse("rounding of the stiffness may move a squared frequency by a share of", proof.rounding,
           rounding_limit);
  if (!proof.passed)
    proof.reason += ". Every mode is counted, but not every number is accurate: likely a spring, a "
                    "joint or a part is so much stiffer, or a mass so much smaller, than what it "
                    "is tied to that rounding shows. Make the stiff one rigid (a cap, a clamp, a "
                    "mount: rigid) or softer, leave the small mass away";
}

VectorXd rounding_errors(const SparseMatrix& K, const MatrixXd& Phi) {
  VectorXd errors(Phi.cols());
  for (Index first = 0; first < Phi.cols(); first += stripe) {
    const Index count = std::min(stripe, Phi.cols() - first);
    errors.segment(first, count) = rounding_of_stripe(K, Phi.middleCols(first, count));
  }
  return errors;
}

double relative_rounding(const VectorXd& lambda, const VectorXd& errors, double small) {
  double elastic = 100 * small; // as the shift has it
  for (double value : lambda)
    if (value > small) {
      elastic = value;
      break;
    }
  double largest = 0;
  for (Index i = 0; i < lambda.size(); ++i)
    largest = std::max(largest, errors[i] / std::max(lambda[i], elastic));
  return largest;
}

ModeSet find_modes(const SparseMatrix& K, const SparseMatrix& M, const ModesRequest& request,
                   BaseFactor& base) {
  require_modes(M);
  const int most = reachable_modes(M);
  ModeSet modes;
  Stopwatch watch;
  LanczosSettings settings;
  // A free body: beyond its rigid modes, or nothing tells them from small elastic ones.
  const int least = base.sigma < 0 ? 6 : 1;
  settings.count =
      std::min(most, (request.count > 0 ? std::max(request.count, least) : 16) + guard_modes);
  constexpr int attempts = 3, few = 24;
  bool scaled = base.sigma == 0;
  double factored_at = base.sigma;
  for (int attempt = 0; attempt < attempts;) {
    if (factored_at != base.sigma && !base.factor.factorise(shifted(K, M, base.sigma)).ok)
      throw ModelError("the stiffness is lost in its rounding: its factor could not be made again");
    factored_at = base.sigma;
    LanczosSettings now = settings;
    if (!scaled && settings.count > worth_slices) now.count = few; // no more are needed to scale
    const EigenPairs pairs = find_pairs(K, M, base, now, attempt + 1 < attempts);
    modes.operations += pairs.operations;
    watch.lap(modes.timing, "lanczos");
    if (!scaled && pairs.converged) {
      rescale_shift(base, K, M, pairs);
      factored_at = base.sigma;
      scaled = true;
      watch.lap(modes.timing, "factorise");
      continue;
    }
    const double small = rigid_size(base.sigma);
    // Enough modes: the count asked for and a gap above, or one mode beyond the band.
    const int keep = modes_asked(request, pairs.values, small);
    if (pairs.converged && !better_dense(K, M) && keep == pairs.values.size() &&
        pairs.values.size() < most) {
      settings.count = std::min(modes_in_band(K, M, request, base.factor, settings.count), most);
      continue;
    }
    keep_lowest(modes, pairs, keep, K, M, base.sigma);
    if (request.proof && pairs.converged) {
      modes.proof =
          prove_complete(K, M, pairs.values, pairs.vectors, std::max(keep, 1), base.factor, small);
      factored_at = std::numeric_limits<double>::quiet_NaN(); // the factor is overwritten
      watch.lap(modes.timing, "proof");
    }
    measure_accuracy(modes, M, small);
    if (!pairs.converged) modes.proof.reason = pairs.reason;
    if (pairs.converged && (!request.proof || modes.proof.passed)) break;
    ++attempt;
    modes.restarts = attempt;
    settings.seed += 1;
    settings.count = std::min(settings.count + 8, most);
    settings.subspace = 3 * settings.count + 40;
  }
  judge_accuracy(modes.proof);
  if (const int below = modes_below_band(request, modes.lambda, rigid_size(base.sigma)); below > 0)
    drop_lowest(modes, below);
  return modes;
}

} // namespace plica
