#include "diagnose/weigh/tempered_chains.hpp"

#include "diagnose/weigh/normal_draws.hpp"
#include "solve/parallel.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double impossible = -1e6; // ln of the likelihood of what cannot be
constexpr int most_stages = 40;
constexpr int moves = 2; // steps of Metropolis of a particle and stage

// ln of the standard normal density.
double log_normal(const VectorXd& z) {
  return -z.squaredNorm() / 2 - double(z.size()) / 2 * std::log(2 * std::numbers::pi);
}

// Where the chains begin.
class Reference {
public:
  explicit Reference(const std::vector<ChainStart>& starts) {
    for (const ChainStart& start : starts) {
      Near own{start.optimum, Eigen::LLT<MatrixXd>(4 * start.covariance)};
      const MatrixXd L = own.root.matrixL();
      own.log_det = L.diagonal().array().log().sum();
      near_.push_back(std::move(own));
    }
  }
  VectorXd draw(const VectorXd& white, double u) const {
    if (u >= share_near) return white;
    const Near& own = near_[std::size_t(u / share_near * double(near_.size()))];
    return own.centre + own.root.matrixL() * white;
  }
  double log_density(const VectorXd& z) const {
    double all = std::log(1 - share_near) + log_normal(z);
    for (const Near& n : near_) {
      const double own = std::log(share_near / double(near_.size())) +
                         log_normal(n.root.matrixL().solve(z - n.centre)) - n.log_det;
      all = std::max(all, own) + std::log1p(std::exp(-std::abs(all - own)));
    }
    return all;
  }

private:
  struct Near {
    VectorXd centre;
    Eigen::LLT<MatrixXd> root;
    double log_det = 0;
  };
  static constexpr double share_near = 0.9;
  std::vector<Near> near_;
};

// Particles with ln of likelihood times prior, and of the density they began with.
struct Particles {
  MatrixXd z;
  VectorXd target, start;
};

// The next power makes the weights vary by as much as they are on average; with ln of their mean.
struct Tempered {
  double power = 0, log_mean = 0;
  VectorXd share; // of the particles
};
Tempered tempered(const Particles& at, double power) {
  const VectorXd ratio = at.target - at.start;
  const double highest = ratio.maxCoeff();
  const auto weights = [&](double next) {
    return VectorXd(((next - power) * (ratio.array() - highest)).exp());
  };
  const auto varies = [&](double next) {
    const VectorXd w = weights(next);
    return std::sqrt((w.array() - w.mean()).square().mean()) / w.mean();
  };
  double low = power, high = 1;
  if (varies(1) > 1) {
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (varies(middle) > 1 ? high : low) = middle;
    }
  } else {
    low = 1;
  }
  const VectorXd w = weights(low);
  return {low, std::log(w.mean()) + (low - power) * highest, w / w.sum()};
}

// What a stage draws, in one order, whatever the threads: from which particle each goes on
// (systematic resampling), its steps, and the chance that each must beat.
struct StageDraws {
  std::vector<Index> origin;
  MatrixXd steps;
  VectorXd chance;
};
StageDraws draws_of(const VectorXd& share, Index parameters, NormalDraws& normal) {
  const Index particles = share.size();
  StageDraws drawn{{}, MatrixXd(parameters, moves * particles), VectorXd(moves * particles)};
  double cumulated = share[0];
  Index from = 0;
  const double offset = normal.uniform();
  for (Index k = 0; k < particles; ++k) {
    const double position = (double(k) + offset) / double(particles);
    while (cumulated < position && from + 1 < particles) cumulated += share[++from];
    drawn.origin.push_back(from);
    for (Index m = moves * k; m < moves * (k + 1); ++m) {
      for (double& x : drawn.steps.col(m)) x = normal();
      drawn.chance[m] = normal.uniform();
    }
  }
  return drawn;
}

// Root of half the covariance of the weighted particles, squared: the size of a step.
MatrixXd step_root(const MatrixXd& z, const VectorXd& share) {
  const VectorXd mean = z * share;
  const MatrixXd centred = z.colwise() - mean;
  constexpr double scale = 0.5; // of the covariance, squared
  MatrixXd C = scale * centred * share.asDiagonal() * centred.transpose();
  C.diagonal().array() += 1e-10;
  return C.llt().matrixL();
}

} // namespace

ChainDraws
tempered_chains(const std::vector<ChainStart>& starts,
                const std::function<std::optional<double>(const VectorXd&)>& log_likelihood,
                int particles, unsigned seed) {
  const Index p = starts.front().optimum.size();
  NormalDraws normal(seed);
  const Reference reference(starts);
  const auto log_target = [&](const VectorXd& z) {
    const std::optional<double> own = log_likelihood(z);
    return own ? *own + log_normal(z) : impossible;
  };
  Particles at{MatrixXd(p, particles), VectorXd(particles), VectorXd(particles)};
  for (Index k = 0; k < particles; ++k) {
    VectorXd white(p);
    for (double& x : white) x = normal();
    at.z.col(k) = reference.draw(white, normal.uniform());
  }
  in_parallel(particles, [&](int k) {
    at.target[k] = log_target(at.z.col(k));
    at.start[k] = reference.log_density(at.z.col(k));
  });
  double power = 0, log_evidence = 0;
  for (int stage = 0; stage < most_stages && power < 1; ++stage) {
    const Tempered t = tempered(at, power);
    log_evidence += t.log_mean;
    power = t.power;
    const MatrixXd root = step_root(at.z, t.share);
    const StageDraws drawn = draws_of(t.share, p, normal);
    Particles next = at;
    in_parallel(particles, [&](int k) {
      const Index of = drawn.origin[std::size_t(k)];
      VectorXd here = at.z.col(of);
      double own = at.target[of], own_start = at.start[of];
      for (Index m = moves * k; m < moves * (k + 1); ++m) {
        const VectorXd there = here + root * drawn.steps.col(m);
        const double value = log_target(there), there_start = reference.log_density(there);
        const double gain = power * (value - own) + (1 - power) * (there_start - own_start);
        if (std::log(drawn.chance[m]) < gain) {
          here = there;
          own = value;
          own_start = there_start;
        }
      }
      next.z.col(k) = here;
      next.target[k] = own;
      next.start[k] = own_start;
    });
    at = std::move(next);
  }
  return {at.z, power >= 1 ? std::optional(log_evidence) : std::nullopt};
}

} // namespace plica
