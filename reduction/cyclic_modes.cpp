#include "reduction/cyclic_modes.hpp"

#include "solve/parallel.hpp"
#include "solve/statics.hpp"
#include "solve/stopwatch.hpp"

#include <algorithm>
#include <numbers>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int guard_modes = 4; // found beyond those asked for, to place sigma in a gap

// Finds at least `count` modes of the family.
void solve_family(CyclicFamily& family, int count) {
  BaseFactor base = factor_below_spectrum(family.K, family.M);
  const ModeSet set =
      find_modes(family.K, family.M,
                 {.count = std::min(count, reachable_modes(family.M)), .proof = false}, base);
  family.shift = base.sigma;
  family.lambda = set.lambda;
  family.Phi = set.Phi;
  family.residual = set.residual;
  family.orthogonality = set.proof.orthogonality;
  family.rounding = set.rounding;
}

bool has_none_below(const CyclicFamily& family, double sigma) {
  SparseFactor factor(family.K);
  return factor.factorise(shifted(family.K, family.M, sigma)).ok;
}

int multiplicity(const CyclicModel& model, const CyclicFamily& family) {
  return model.is_pair(family.system.harmonic.n) ? 2 : 1;
}

// All modes found, increasing.
std::vector<CyclicMode> merged(const CyclicModel& model,
                               const std::vector<CyclicFamily>& families) {
  std::vector<CyclicMode> modes;
  for (int f = 0; f < static_cast<int>(families.size()); ++f)
    for (int column = 0; column < families[f].lambda.size(); ++column)
      for (int copy = 0; copy < multiplicity(model, families[f]); ++copy)
        modes.push_back({.family = f,
                         .column = column,
                         .sine = copy == 1 || families[f].system.harmonic.sine,
                         .lambda = families[f].lambda[column],
                         .residual = families[f].residual[column],
                         .rounding = families[f].rounding[column]});
  std::stable_sort(modes.begin(), modes.end(),
                   [](const CyclicMode& a, const CyclicMode& b) { return a.lambda < b.lambda; });
  return modes;
}

class Search {
public:
  Search(const CyclicModel& model, const ModesRequest& request, CyclicModes& result)
      : model_(model), request_(request), result_(result), low_(low_families()) {}

  void run() {
    std::vector<int> wanted(result_.families.size(), 0);
    for (int f : low_) wanted[f] = request_.count > 0 ? std::max(6, request_.count / 2 + 2) : 8;
    while (true) {
      std::vector<int> due;
      for (int f = 0; f < static_cast<int>(wanted.size()); ++f)
        if (wanted[f] > result_.families[f].lambda.size() && !exhausted(f)) due.push_back(f);
      in_parallel(int(due.size()),
                  [&](int i) { solve_family(result_.families[due[i]], wanted[due[i]]); });
      const double reach = needed();
      const auto enough = [&](int f) {
        const VectorXd& lambda = result_.families[f].lambda;
        return exhausted(f) || (lambda.size() > 0 && lambda[lambda.size() - 1] >= reach);
      };
      std::vector<int> open;
      for (int f = 0; f < static_cast<int>(wanted.size()); ++f)
        if (!enough(f) && !(empty_below_.count(f) && empty_below_[f] >= reach)) open.push_back(f);
      if (open.empty()) return;
      std::vector<char> empty(open.size(), 0);
      in_parallel(int(open.size()), [&](int i) {
        const CyclicFamily& family = result_.families[open[i]];
        empty[i] = family.lambda.size() == 0 && std::isfinite(reach) &&
                   has_none_below(family, reach * (1 + 1e-9));
      });
      for (std::size_t i = 0; i < open.size(); ++i) {
        if (empty[i])
          empty_below_[open[i]] = reach;
        else
          wanted[open[i]] = std::max<int>(4, 2 * int(result_.families[open[i]].lambda.size()));
      }
    }
  }

private:
  std::vector<int> low_families() const {
    std::vector<int> low;
    for (int f = 0; f < static_cast<int>(result_.families.size()); ++f)
      if (result_.families[f].system.harmonic.n <= 1) low.push_back(f);
    return low;
  }

  bool exhausted(int f) const {
    return result_.families[f].lambda.size() >= reachable_modes(result_.families[f].M);
  }

  // Every family must be known up to here.
  double needed() const {
    const std::vector<CyclicMode> modes = merged(model_, result_.families);
    if (request_.count == 0) {
      const double high = std::pow(2 * std::numbers::pi * request_.band[1], 2);
      for (const CyclicMode& m : modes) // one mode beyond, for the gap
        if (m.lambda > high * (1 + lambda_pair_tolerance)) return m.lambda;
      return std::numeric_limits<double>::infinity();
    }
    const std::size_t last = static_cast<std::size_t>(request_.count) + guard_modes;
    return modes.size() > last ? modes[last].lambda : std::numeric_limits<double>::infinity();
  }

  const CyclicModel& model_;
  const ModesRequest& request_;
  CyclicModes& result_;
  std::vector<int> low_;
  std::map<int, double> empty_below_;
};

VectorXd eigenvalues(const std::vector<CyclicMode>& modes) {
  VectorXd lambda(Eigen::Index(modes.size()));
  for (std::size_t i = 0; i < modes.size(); ++i) lambda[Eigen::Index(i)] = modes[i].lambda;
  return lambda;
}

// Of the family that is free and has the lowest elastic mode.
double smallest_rigid_size(const std::vector<CyclicFamily>& families) {
  double least = 0;
  for (const CyclicFamily& f : families)
    if (f.shift < 0 && (least == 0 || rigid_size(f.shift) < least)) least = rigid_size(f.shift);
  return least;
}

void prove(const CyclicModel& model, const SpectrumGap& gap, CyclicModes& result) {
  ModesProof& proof = result.proof;
  proof.made = true;
  proof.sigma = gap.sigma;
  proof.found = gap.below;
  std::vector<InertiaCount> counts(result.families.size());
  in_parallel(int(counts.size()), [&](int f) {
    const CyclicFamily& family = result.families[f];
    SparseFactor factor(family.K);
    const auto below = (family.lambda.array() < proof.sigma).count();
    if (below == 0 && factor.factorise(shifted(family.K, family.M, proof.sigma)).ok)
      counts[f].below = 0;
    else
      counts[f] = count_below(family.K, family.M, proof.sigma, family.Phi, factor);
  });
  for (std::size_t f = 0; f < counts.size(); ++f) {
    const Harmonic& h = result.families[f].system.harmonic;
    if (!counts[f].below) {
      proof.reason = "harmonic " + std::to_string(h.n) + ": " + counts[f].reason;
      return;
    }
    proof.inertia_count += *counts[f].below * multiplicity(model, result.families[f]);
  }
  compare_counts(proof, "modes by inertia over all harmonics");
}

// What the modes of all families are worth, the listed ones and those found beside them.
void check_accuracy(CyclicModes& result) {
  ModesProof& proof = result.proof;
  for (const CyclicMode& m : result.modes)
    proof.max_residual = std::max(proof.max_residual, m.residual);
  for (const CyclicFamily& f : result.families) {
    proof.orthogonality = std::max(proof.orthogonality, f.orthogonality);
    std::vector<int> listed;
    for (const CyclicMode& m : result.modes)
      if (&result.families[m.family] == &f) listed.push_back(m.column);
    proof.rounding =
        std::max(proof.rounding,
                 relative_rounding(f.lambda(listed), f.rounding(listed), rigid_size(f.shift)));
  }
  judge_accuracy(proof);
}

} // namespace

CyclicFamily cyclic_family(const CyclicModel& model, const Harmonic& harmonic,
                           const std::vector<int>& held) {
  CyclicFamily family;
  family.system = model.system(harmonic);
  std::vector<int> numbers;
  for (const AxisUnknown& a : family.system.axis)
    if (a.number >= 0 && std::find(held.begin(), held.end(), a.node) != held.end())
      numbers.push_back(a.number);
  std::sort(numbers.begin(), numbers.end());
  family.free = complement(static_cast<int>(family.system.K.rows()), numbers);
  family.K = restrict_to(family.system.K, family.free);
  family.M = restrict_to(family.system.M, family.free);
  return family;
}

CyclicModes find_cyclic_modes(const CyclicModel& model, const std::vector<int>& held,
                              const ModesRequest& request) {
  CyclicModes result;
  Stopwatch watch;
  std::vector<Harmonic> harmonics;
  for (int n = 0; n < model.harmonics(); ++n) {
    harmonics.push_back({.n = n});
    if (!model.is_pair(n)) harmonics.push_back({.n = n, .sine = true});
  }
  result.families.resize(harmonics.size());
  in_parallel(int(harmonics.size()),
              [&](int f) { result.families[f] = cyclic_family(model, harmonics[f], held); });
  watch.lap(result.timing, "assembly");
  Search(model, request, result).run();
  watch.lap(result.timing, "lanczos");
  const std::vector<CyclicMode> modes = merged(model, result.families);
  const VectorXd lambda = eigenvalues(modes);
  const double small = smallest_rigid_size(result.families);
  const int keep = modes_asked(request, lambda, small), all = static_cast<int>(lambda.size());
  if (request.proof && all > 0) {
    // Below a gap there is at least one group. All modes are known up to the guard, or to the first
    // group beyond the band.
    const int least = keep > 0 ? keep : modes_asked({.count = 1}, lambda, small);
    const int known = request.count > 0 ? request.count + guard_modes + 1 : least + 1;
    prove(model, widest_gap(lambda, least, std::min(known, all), small), result);
    watch.lap(result.timing, "proof");
  }
  result.modes.assign(modes.begin() + modes_below_band(request, lambda, small),
                      modes.begin() + keep);
  check_accuracy(result);
  return result;
}

} // namespace plica
