#include "compare/compare_stiffness.hpp"

#include "model/description/analyses.hpp"
#include "words/directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plica {
namespace {

double quantity_of(std::complex<double> k, StiffnessQuantity quantity) {
  switch (quantity) {
  case StiffnessQuantity::storage:
    return k.real();
  case StiffnessQuantity::loss:
    return k.imag();
  case StiffnessQuantity::magnitude:
    return std::abs(k);
  case StiffnessQuantity::loss_angle:
    return std::arg(k);
  }
  return 0;
}

} // namespace

std::complex<double> transfer_stiffness(const Complex1212& Z, int direction) {
  return -Z(6 + direction, direction);
}

std::complex<double> driving_point_stiffness(const Complex1212& Z, int direction, int end) {
  return Z(6 * end + direction, 6 * end + direction);
}

std::string measured_name(const MeasuredStiffness& m) {
  constexpr std::array quantities{"storage", "loss", "magnitude", "loss angle"};
  return direction_names[std::size_t(m.direction)] +
         std::string(m.kind == StiffnessKind::driving_point ? " driving point " : " ") +
         quantities[std::size_t(m.quantity)];
}

std::vector<StiffnessComparison> compare_stiffness(const EndDynamicStiffness& computed,
                                                   const std::vector<MeasuredStiffness>& measured,
                                                   int harmonics, int samples) {
  const PartBetweenEnds& part = computed.states.front().part;
  std::vector<double> hertz;
  std::map<double, std::size_t> translations{{0, 0}}, rotations{{0, 0}};
  for (const MeasuredStiffness& m : measured) {
    hertz.push_back(m.hertz);
    (m.direction < 3 ? translations : rotations)[part.laws.empty() ? 0 : m.amplitude] = 0;
  }
  std::sort(hertz.begin(), hertz.end());
  hertz.erase(std::unique(hertz.begin(), hertz.end()), hertz.end());
  std::vector<MotionLevel> levels(std::max(translations.size(), rotations.size()));
  std::size_t at = 0;
  for (auto& [amplitude, level] : translations) levels[level = at++].translation = amplitude;
  at = 0;
  for (auto& [amplitude, level] : rotations) levels[level = at++].rotation = amplitude;
  const StiffnessOverFrequency over =
      dynamic_stiffness(part, Eigen::Map<const Eigen::VectorXd>(hertz.data(), long(hertz.size())),
                        levels, harmonics, samples);
  std::vector<StiffnessComparison> list;
  for (const MeasuredStiffness& m : measured) {
    const auto f =
        std::size_t(std::lower_bound(hertz.begin(), hertz.end(), m.hertz) - hertz.begin());
    const auto& amplitudes = m.direction < 3 ? translations : rotations;
    const Complex1212& Z = over.at[amplitudes.at(part.laws.empty() ? 0 : m.amplitude)][f];
    const std::complex<double> k = m.kind == StiffnessKind::transfer
                                       ? transfer_stiffness(Z, m.direction)
                                       : driving_point_stiffness(Z, m.direction);
    list.push_back({m, quantity_of(k, m.quantity)});
  }
  return list;
}

} // namespace plica
