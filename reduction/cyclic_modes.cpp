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
constexpr double pair_tolerance = 1e-5;

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
                         .residual = families[f].residual[column]});
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
        if (m.lambda > high * (1 + pair_tolerance)) return m.lambda;
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

// How many of the modes are asked for, without cutting a pair.
std::size_t asked(const ModesRequest& request, const std::vector<CyclicMode>& modes) {
  if (request.count == 0) {
    const double high = std::pow(2 * std::numbers::pi * request.band[1], 2);
    return std::count_if(modes.begin(), modes.end(),
                         [&](const CyclicMode& m) { return m.lambda <= high; });
  }
  std::size_t keep = std::min<std::size_t>(request.count, modes.size());
  const double size = modes.empty() ? 0 : 1e-2 * std::abs(modes.back().lambda);
  while (keep > 0 && keep < modes.size() &&
         modes[keep].lambda - modes[keep - 1].lambda <
             pair_tolerance * std::max(modes[keep].lambda, size))
    ++keep;
  return keep;
}

// Middle of the widest gap at or above `keep`, among modes that are all known.
std::pair<std::size_t, double> widest_gap(const std::vector<CyclicMode>& modes, std::size_t keep,
                                          std::size_t known) {
  std::size_t best = keep;
  double widest = -1, sigma = modes.empty() ? 0 : modes[keep - 1].lambda * (1 + pair_tolerance);
  for (std::size_t m = std::max<std::size_t>(keep, 1); m < known; ++m) {
    const double gap = (modes[m].lambda - modes[m - 1].lambda) / std::abs(modes[m].lambda);
    if (gap <= widest) continue;
    widest = gap;
    best = m;
    sigma = (modes[m].lambda + modes[m - 1].lambda) / 2;
  }
  return {best, sigma};
}

void prove(const CyclicModel& model, const std::vector<CyclicMode>& modes, std::size_t keep,
           std::size_t known, CyclicModes& result) {
  ModesProof& proof = result.proof;
  proof.made = true;
  const auto [found, sigma] = widest_gap(modes, keep, known);
  proof.sigma = sigma;
  proof.found = static_cast<int>(found);
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
  proof.passed = proof.inertia_count == proof.found;
  if (!proof.passed)
    proof.reason = "below " + std::to_string(frequency(proof.sigma)) + " Hz there are " +
                   std::to_string(proof.inertia_count) +
                   " modes by inertia over all harmonics, but " + std::to_string(proof.found) +
                   " were found";
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
  const std::size_t keep = asked(request, modes);
  result.modes.assign(modes.begin(), modes.begin() + std::ptrdiff_t(keep));
  // Known completely: up to the guard, or to the first mode beyond the band.
  const std::size_t known = std::min(
      modes.size(), request.count > 0 ? std::size_t(request.count + guard_modes + 1) : keep + 1);
  if (request.proof && keep > 0) {
    prove(model, modes, keep, known, result);
    watch.lap(result.timing, "proof");
  }
  for (const CyclicMode& m : result.modes)
    result.proof.max_residual = std::max(result.proof.max_residual, m.residual);
  for (const CyclicFamily& f : result.families)
    result.proof.orthogonality = std::max(result.proof.orthogonality, f.orthogonality);
  if (request.count == 0)
    std::erase_if(result.modes,
                  [&](const CyclicMode& m) { return frequency(m.lambda) < request.band[0]; });
  return result;
}

} // namespace plica
