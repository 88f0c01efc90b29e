#include "engine/shift_invert_modes.hpp"

#include "engine/spectrum_slices.hpp"
#include "solve/model_error.hpp"
#include "solve/modes_search.hpp"
#include "solve/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd rounding_errors(const DistributedMatrix& K, const MatrixXd& Phi, const Ranks& ranks) {
  const MatrixXd own = (Phi.cwiseAbs().cwiseProduct(K.absolute(Phi))).colwise().sum();
  return std::numeric_limits<double>::epsilon() * ranks.sum(own).transpose();
}

// The mean of the ranks' medians.
double spectrum_scale(const DistributedMatrix& K, const DistributedMatrix& M, const Ranks& ranks) {
  const double scale = ranks.sum(median_ratio(K.diagonal(), M.diagonal())) / ranks.size();
  return scale > 0 ? scale : 1;
}

// That the smallest eigenvalue is told from the rounding of K, by one inverse iteration.
bool is_definite(const DistributedMatrix& K, const DistributedMatrix& M, const MumpsFactor& factor,
                 const Ranks& ranks) {
  MatrixXd x = factor.solve(M * start_vector(K, 7));
  const double norm = std::sqrt(ranks.sum(x.squaredNorm()));
  if (!std::isfinite(norm) || norm == 0) return false;
  x /= norm;
  constexpr double clear = 100; // times the bound of first order
  const double stiffness = ranks.sum((x.transpose() * (K * x)).value());
  return stiffness > clear * rounding_errors(K, x, ranks)[0];
}

ShiftedFactor factor_at(double sigma, const DistributedMatrix& K, const DistributedMatrix& M,
                        const Ranks& ranks, const MumpsSettings& settings) {
  ShiftedFactor base;
  base.sigma = sigma;
  if (sigma != 0) base.A = K.minus(sigma, M);
  base.factor.emplace(base.A ? *base.A : K, Definiteness::definite, ranks, settings);
  return base;
}

bool is_below_spectrum(const MumpsFactor& factor) {
  return factor.negative_pivots() == 0 && factor.null_pivots() == 0;
}

// A free body: the shift near the lowest elastic mode, where Krylov-Schur is accurate and fast.
double better_shift(double sigma, const DistributedMatrix& K, const EigenColumns& found,
                    const Ranks& ranks) {
  const VectorXd rounding = rounding_errors(K, found.Phi, ranks);
  for (Index i = 0; i < found.lambda.size(); ++i)
    if (found.lambda[i] > std::max(100 * rounding[i], 1e-2 * std::abs(sigma)))
      return -0.1 * found.lambda[i];
  return sigma;
}

ModesProof prove(const DistributedMatrix& K, const DistributedMatrix& M, const VectorXd& lambda,
                 int keep, double small, const Ranks& ranks, const MumpsSettings& settings,
                 MumpsReport& counted) {
  ModesProof proof;
  proof.made = true;
  const SpectrumGap gap = widest_gap(lambda, keep, int(lambda.size()), small);
  proof.found = gap.below;
  proof.sigma = gap.sigma;
  const DistributedMatrix A = K.minus(gap.sigma, M);
  const MumpsFactor factor(A, Definiteness::indefinite, ranks, settings);
  counted = factor.report();
  if (factor.null_pivots() > 0) {
    proof.reason = "the factor at sigma is singular: sigma is too near an eigenvalue";
    return proof;
  }
  proof.inertia_count = factor.negative_pivots();
  compare_counts(proof, "modes by inertia");
  return proof;
}

void measure(DistributedModes& modes, const DistributedMatrix& K, const DistributedMatrix& M,
             double sigma, const Ranks& ranks) {
  const MatrixXd MPhi = M * modes.Phi;
  const MatrixXd R = K * modes.Phi - MPhi * modes.lambda.asDiagonal();
  const MatrixXd r2 = ranks.sum(MatrixXd(R.colwise().squaredNorm())),
                 m2 = ranks.sum(MatrixXd(MPhi.colwise().squaredNorm()));
  modes.residual.resize(modes.lambda.size());
  for (Index i = 0; i < modes.lambda.size(); ++i)
    modes.residual[i] =
        std::sqrt(r2(0, i) / m2(0, i)) / (std::abs(modes.lambda[i]) + std::abs(sigma));
  modes.rounding = rounding_errors(K, modes.Phi, ranks);
  if (modes.lambda.size() == 0) return;
  modes.proof.max_residual = modes.residual.maxCoeff();
  modes.proof.rounding = relative_rounding(modes.lambda, modes.rounding, rigid_size(sigma));
  const MatrixXd gram = ranks.sum(MatrixXd(modes.Phi.transpose() * MPhi));
  modes.proof.orthogonality =
      (gram - MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
}

// Where a band is sliced: from the shift to somewhat beyond it.
double end_of_slices(const ModesRequest& request, int extension) {
  return eigenvalue(request.band[1] * std::pow(1.15, 1 + extension));
}

// How many modes there are at most.
int most_modes(const DistributedMatrix& K, const DistributedMatrix& M, const Ranks& ranks) {
  const int most = std::min(dofs_with_mass(M, ranks), K.size() - 1);
  if (most <= 0)
    throw ModelError("what is free to move has no mass, so there are no modes (is a density zero?)",
                     {"materials", "parts"});
  return most;
}

// How many are sought at first: some beyond those asked for, of a free body beyond its rigid modes.
int first_count(const ModesRequest& request, const ShiftedFactor& base, int most) {
  const int least = base.sigma < 0 ? 6 : 1;
  return std::min(most, (request.count > 0 ? std::max(request.count, least) : 16) + guard_modes);
}

} // namespace

int dofs_with_mass(const DistributedMatrix& M, const Ranks& ranks) {
  return int(ranks.sum((long long)(M.diagonal().array() > 0).count()));
}

ShiftedFactor factor_under_spectrum(const DistributedMatrix& K, const DistributedMatrix& M,
                                    const Ranks& ranks, const MumpsSettings& settings) {
  {
    ShiftedFactor base = factor_at(0, K, M, ranks, settings);
    if (is_below_spectrum(*base.factor) && is_definite(K, M, *base.factor, ranks)) return base;
  }
  const double scale = spectrum_scale(K, M, ranks);
  for (const double fraction : {1e-10, 1e-8, 1e-6}) {
    ShiftedFactor base = factor_at(-fraction * scale, K, M, ranks, settings);
    if (is_below_spectrum(*base.factor)) return base;
  }
  throw ModelError("the model has a degree of freedom without stiffness and mass (a part that "
                   "nothing holds and that has no density?), or an indefinite stiffness");
}

DistributedModes find_modes(const DistributedMatrix& K, const DistributedMatrix& M,
                            const ModesRequest& request, ShiftedFactor& base, const Ranks& ranks,
                            const MumpsSettings& settings) {
  const int most = most_modes(K, M, ranks);
  DistributedModes modes;
  Stopwatch watch;
  int count = first_count(request, base, most);
  unsigned seed = 1;
  bool scaled = base.sigma == 0;
  const bool sliced = request.count == 0;
  int extension = 0; // of the slices
  constexpr int attempts = 3;
  for (int attempt = 0; attempt < attempts;) {
    const bool slices_now = sliced && scaled;
    if (slices_now)
      base.factor.reset();
    else if (!base.factor)
      base = factor_at(base.sigma, K, M, ranks, settings);
    const EigenColumns found =
        slices_now
            ? spectrum_slices(K, M, base.sigma, end_of_slices(request, extension), ranks, settings)
            : krylov_schur(K, M, *base.factor, base.sigma, count, seed, ranks);
    watch.lap(modes.timing, "lanczos");
    if (!scaled && found.converged) {
      base.sigma = better_shift(base.sigma, K, found, ranks);
      base.factor.reset();
      scaled = true;
      continue;
    }
    const double small = rigid_size(base.sigma);
    const int keep = modes_asked(request, found.lambda, small);
    if (found.converged && keep == found.lambda.size() && keep < most) {
      count = std::min(2 * count, most);
      ++extension;
      continue;
    }
    modes.lambda = found.lambda.head(keep);
    modes.Phi = found.Phi.leftCols(keep);
    modes.proof = {};
    if (request.proof && found.converged) {
      base.factor.reset(); // one factor at a time
      modes.proof =
          prove(K, M, found.lambda, std::max(keep, 1), small, ranks, settings, modes.counted);
      watch.lap(modes.timing, "proof");
    }
    measure(modes, K, M, base.sigma, ranks);
    if (!found.converged) modes.proof.reason = found.reason;
    if (found.converged && (!request.proof || modes.proof.passed)) break;
    ++attempt;
    ++seed;
    count = std::min(count + 8, most);
  }
  judge_accuracy(modes.proof);
  if (const int below = modes_below_band(request, modes.lambda, rigid_size(base.sigma)); below > 0)
    drop_lowest(modes, below);
  return modes;
}

} // namespace plica
