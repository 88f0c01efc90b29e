#include "compare/fit/fit_stiffness.hpp"

#include "compare/compare_stiffness.hpp"
#include "lab/measured/entries.hpp"
#include "lab/measured/states.hpp"
#include "run/study/part_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Of one table; " at 0.1 mm" where it has an amplitude.
std::string name_of(const MeasuredStiffness& m) {
  std::string name = measured_name(m);
  if (m.amplitude > 0)
    name += m.direction < 3 ? fmt::format(" at {:g} mm", 1e3 * m.amplitude)
                            : fmt::format(" at {:g} deg", 180 / std::numbers::pi * m.amplitude);
  return name;
}

bool is_one_motion(const MeasuredStiffness& a, const MeasuredStiffness& b) {
  return a.hertz == b.hertz && a.amplitude == b.amplitude && a.direction == b.direction &&
         a.kind == b.kind;
}

// |k| of the motion that a number belongs to; NaN where its table gives neither that nor storage.
double magnitude_of(const MeasuredStiffness& m, const std::vector<MeasuredStiffness>& table) {
  double storage = std::numeric_limits<double>::quiet_NaN(), loss = 0;
  for (const MeasuredStiffness& other : table) {
    if (!is_one_motion(m, other)) continue;
    if (other.quantity == StiffnessQuantity::magnitude) return std::abs(other.value);
    if (other.quantity == StiffnessQuantity::storage) storage = other.value;
    if (other.quantity == StiffnessQuantity::loss) loss = other.value;
  }
  return std::hypot(storage, loss);
}

void add(const MeasuredStiffnessTable& table, const std::string& entry, bool held_out,
         std::vector<FitStiffness>& targets) {
  const std::size_t first = targets.size();
  std::vector<std::vector<double>> sizes;
  for (const MeasuredStiffness& m : table.numbers) {
    const std::string name = name_of(m);
    std::size_t at = first;
    while (at < targets.size() && targets[at].name != name) ++at;
    if (at == targets.size()) {
      targets.push_back({.name = name,
                         .entry = entry,
                         .ends = table.ends,
                         .numbers = {},
                         .size = {},
                         .sigma = table.sigma.value_or(0),
                         .held_out = held_out});
      sizes.emplace_back();
    }
    targets[at].numbers.push_back(m);
    sizes[at - first].push_back(
        m.quantity == StiffnessQuantity::loss_angle ? 1 : magnitude_of(m, table.numbers));
  }
  for (std::size_t k = 0; k < sizes.size(); ++k)
    targets[first + k].size = Eigen::Map<VectorXd>(sizes[k].data(), Index(sizes[k].size()));
}

// Of the numbers of all targets between the same ends, one after the other.
std::vector<double> computed(const Case& design, const std::vector<std::string>& ends,
                             const std::vector<MeasuredStiffness>& numbers) {
  StiffnessRequest request;
  request.ends = ends;
  double highest = 0;
  for (const MeasuredStiffness& m : numbers) highest = std::max(highest, m.hertz);
  request.hertz = VectorXd::Constant(1, highest); // as far as modes are wanted
  const EndDynamicStiffness found = part_stiffness(design, request, [](const std::string&) {});
  std::vector<double> values;
  for (const StiffnessComparison& c :
       compare_stiffness(found, numbers, request.harmonics, request.samples))
    values.push_back(c.computed);
  return values;
}

} // namespace

std::vector<FitStiffness> stiffness_targets(const Measured& measured) {
  std::vector<FitStiffness> targets;
  for (std::size_t i = 0; i < measured.stiffness.size(); ++i) {
    if (!as_drawn(measured, measured.stiffness[i].state)) continue;
    const std::string entry = entry_name("stiffness", i);
    add(measured.stiffness[i], entry, is_held_out(measured, entry), targets);
  }
  return targets;
}

std::vector<VectorXd> computed_stiffness(const Case& design,
                                         const std::vector<FitStiffness>& targets) {
  std::vector<VectorXd> values(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (values[i].size() > 0) continue; // with others between the same ends
    std::vector<std::size_t> together;
    std::vector<MeasuredStiffness> numbers;
    for (std::size_t j = i; j < targets.size(); ++j)
      if (targets[j].ends == targets[i].ends) {
        together.push_back(j);
        numbers.insert(numbers.end(), targets[j].numbers.begin(), targets[j].numbers.end());
      }
    const std::vector<double> all = computed(design, targets[i].ends, numbers);
    const double* next = all.data();
    for (const std::size_t j : together) {
      values[j] = Eigen::Map<const VectorXd>(next, Index(targets[j].numbers.size()));
      next += targets[j].numbers.size();
    }
  }
  return values;
}

void complete_sizes(const Case& start, std::vector<FitStiffness>& targets) {
  std::vector<FitStiffness> open;
  for (const FitStiffness& t : targets)
    if (!t.size.allFinite()) {
      open.push_back(t);
      for (MeasuredStiffness& m : open.back().numbers) m.quantity = StiffnessQuantity::magnitude;
    }
  if (open.empty()) return;
  const std::vector<VectorXd> magnitudes = computed_stiffness(start, open);
  std::size_t next = 0;
  for (FitStiffness& t : targets) {
    if (t.size.allFinite()) continue;
    t.size = t.size.array().isFinite().select(t.size, magnitudes[next++]);
  }
}

VectorXd deviations_of(const FitStiffness& target, const VectorXd& values) {
  VectorXd d(values.size());
  for (Index k = 0; k < d.size(); ++k)
    d[k] = (values[k] - target.numbers[std::size_t(k)].value) / target.size[k];
  return d;
}

} // namespace plica
