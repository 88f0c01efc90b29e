#include "run/analyses/mode_names.hpp"

#include "words/mode_kinds.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace plica {
namespace {

using Same = std::vector<int>; // modes of one name

// False when all are strained most in the same part.
bool name_by_part(std::vector<ModeResult>& modes, const Same& same,
                  const std::vector<std::string>& components, const EnergyOfModes& energy_of) {
  if (components.size() < 2) return false;
  const Eigen::MatrixXd energy = energy_of(same);
  std::vector<Eigen::Index> most(same.size());
  for (std::size_t i = 0; i < same.size(); ++i) energy.col(Eigen::Index(i)).maxCoeff(&most[i]);
  if (std::all_of(most.begin(), most.end(), [&](Eigen::Index m) { return m == most[0]; }))
    return false;
  for (std::size_t i = 0; i < same.size(); ++i)
    modes[std::size_t(same[i])].place = components[std::size_t(most[i])];
  return true;
}

void name_by_number(std::vector<ModeResult>& modes, const Same& same) {
  constexpr double pair_tolerance = 1e-6;
  int number = 1;
  for (std::size_t i = 1; i < same.size(); ++i) {
    const double before = modes[std::size_t(same[i - 1])].frequency;
    ModeResult& mode = modes[std::size_t(same[i])];
    if (mode.frequency > before * (1 + pair_tolerance)) ++number;
    if (number > 1) mode.place = "no. " + std::to_string(number);
  }
}

} // namespace

void tell_apart(std::vector<ModeResult>& modes, const std::vector<std::string>& components,
                const EnergyOfModes& energy) {
  std::map<std::tuple<std::string, std::string, int, int>, Same> named;
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (const ModeResult& m = modes[i]; m.shape != mode_kind::rigid)
      named[{m.shape, m.direction, m.order, m.harmonic}].push_back(static_cast<int>(i));
  for (const auto& [name, same] : named)
    if (same.size() > 1 && !name_by_part(modes, same, components, energy) &&
        std::get<0>(name) != mode_kind::unnamed)
      name_by_number(modes, same);
}

} // namespace plica
