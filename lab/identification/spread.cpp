#include "lab/identification/spread.hpp"

#include "lab/identification/mode_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace plica {
namespace {

constexpr double reach = 0.1, similar = 0.8, same = 0.9; // relative frequency, MAC, MAC

bool alike(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b, double least) {
  return a.size() < 2 || mac(a, b) > least;
}

bool near_each_other(double a, double b) {
  return std::abs(a / b - 1) < reach;
}

// Of each mode of the whole its partner in a part, -1 = none: the nearest in frequency first, each
// once.
std::vector<int> partners(const PartialIdentification& part,
                          const std::vector<IdentifiedMode>& modes) {
  std::vector<std::tuple<double, int, int>> pairs;
  for (std::size_t r = 0; r < modes.size(); ++r)
    for (std::size_t j = 0; j < part.modes.size(); ++j)
      if (near_each_other(part.modes[j].frequency, modes[r].frequency) &&
          alike(part.modes[j].shape, modes[r].shape, similar))
        pairs.emplace_back(std::abs(part.modes[j].frequency / modes[r].frequency - 1), int(r),
                           int(j));
  std::sort(pairs.begin(), pairs.end());
  std::vector<int> partner(modes.size(), -1);
  std::vector<bool> taken(part.modes.size());
  for (const auto& [apart, r, j] : pairs)
    if (partner[std::size_t(r)] < 0 && !taken[std::size_t(j)]) {
      partner[std::size_t(r)] = j;
      taken[std::size_t(j)] = true;
    }
  return partner;
}

using Partners = std::vector<std::vector<int>>; // per part

// Whether two modes of the whole may be one.
bool may_be_one(const Partners& partner, const std::vector<IdentifiedMode>& modes, std::size_t a,
                std::size_t b) {
  return a != b && near_each_other(modes[a].frequency, modes[b].frequency) &&
         alike(modes[a].shape, modes[b].shape, same) &&
         std::none_of(partner.begin(), partner.end(),
                      [&](const std::vector<int>& part) { return part[a] >= 0 && part[b] >= 0; });
}

// The mode of a part that stands for mode r; null where it has none.
const PartialMode* standing_for(const PartialIdentification& part, const std::vector<int>& own,
                                const Partners& partner, const std::vector<IdentifiedMode>& modes,
                                std::size_t r) {
  if (own[r] >= 0) return &part.modes[std::size_t(own[r])];
  const PartialMode* nearest = nullptr;
  for (std::size_t s = 0; s < modes.size(); ++s) {
    if (own[s] < 0 || !may_be_one(partner, modes, r, s)) continue;
    const PartialMode* other = &part.modes[std::size_t(own[s])];
    const auto apart = [&](const PartialMode* m) {
      return std::abs(m->frequency - modes[r].frequency);
    };
    if (!nearest || apart(other) < apart(nearest)) nearest = other;
  }
  return nearest;
}

double excess(double x, double sigma, double whole) {
  return std::max(0., (x - whole) * (x - whole) - sigma * sigma);
}

} // namespace

PartialIdentification partial_identification(const std::string& name, const ModalFit& fit) {
  PartialIdentification part{.name = name, .modes = {}};
  for (const FittedMode& m : fit.modes)
    part.modes.push_back({.frequency = m.frequency(),
                          .sigma_frequency = m.sigma_frequency(),
                          .damping = m.damping(),
                          .sigma_damping = m.sigma_damping(),
                          .shape = m.residue.col(0),
                          .size = m.residue.norm()});
  return part;
}

void widen_by_parts(const std::vector<PartialIdentification>& parts,
                    std::vector<IdentifiedMode>& modes, std::vector<std::string>& warnings) {
  if (parts.size() < 2) return;
  Partners partner;
  for (const PartialIdentification& part : parts) partner.push_back(partners(part, modes));
  for (std::size_t r = 0; r < modes.size(); ++r) {
    IdentifiedMode& mode = modes[r];
    double weight = 0, frequency = 0, damping = 0;
    std::string each;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PartialMode* m = standing_for(parts[i], partner[i], partner, modes, r);
      if (!m) continue;
      const double w = m->size * m->size;
      weight += w;
      frequency += w * excess(m->frequency, m->sigma_frequency, mode.frequency);
      damping += w * excess(m->damping, m->sigma_damping, mode.damping);
      each +=
          fmt::format("{}{:.5g} Hz by {}", each.empty() ? "" : ", ", m->frequency, parts[i].name);
    }
    if (!(weight > 0)) continue;
    frequency = std::sqrt(frequency / weight);
    if (frequency > std::max(3 * mode.sigma_frequency, 0.1 * mode.damping * mode.frequency))
      warnings.push_back(fmt::format("mode at {:.5g} Hz: one at a time they give {}: what excites "
                                     "it moves it, or they were not measured on the same structure",
                                     mode.frequency, each));
    mode.sigma_frequency = std::hypot(mode.sigma_frequency, frequency);
    mode.sigma_damping = std::hypot(mode.sigma_damping, std::sqrt(damping / weight));
  }
}

} // namespace plica
