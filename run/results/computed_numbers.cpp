#include "run/results/computed_numbers.hpp"

#include "run/results/number_keys.hpp"
#include "words/units.hpp"

#include <algorithm>

namespace plica {

const std::vector<ComputedNumber>& computed_numbers() {
  static const std::vector<ComputedNumber> all{
      {"mass", Dimension::mass},
      {"k_axial", Dimension::stiffness},
      {"k_transverse", Dimension::stiffness},
      {"k_bending", Dimension::rotational_stiffness},
      {"k_torsion", Dimension::rotational_stiffness},
      {"f_axial", Dimension::frequency},
      {"f_transverse", Dimension::frequency},
      {"f_torsion", Dimension::frequency},
      {"damage", Dimension::number},
  };
  return all;
}

std::optional<Dimension> unit_of_computed(const std::string& name) {
  for (const ComputedNumber& n : computed_numbers())
    if (n.name == name) return n.unit;
  if (number_key::kind_of(name) == NumberKind::stress_range) return Dimension::pressure;
  return std::nullopt;
}

std::string unit_of_result(const std::string& path) {
  std::string name = path;
  if (name.ends_with(".x") || name.ends_with(".z")) name.resize(name.size() - 2); // of a stiffness
  name = name.substr(name.rfind('.') + 1);
  const std::optional<Dimension> unit =
      name == "frequency" ? Dimension::frequency : unit_of_computed(name);
  const std::vector<std::string> units = unit ? units_of(*unit) : std::vector<std::string>();
  return units.empty() ? "" : units.front();
}

std::map<std::string, double> computed_numbers_of(const Results& results) {
  std::map<std::string, double> numbers = headline(results);
  if (const auto& k = results.statics) {
    numbers["k_transverse"] = std::min(k->k_transverse_x, k->k_transverse_z);
    numbers["k_bending"] = std::min(k->k_bending_x, k->k_bending_z);
    numbers["k_torsion"] = k->k_torsion;
  }
  if (results.life && !results.life->spots.empty())
    numbers[number_key::damage] = results.life->spots.front().damage;
  return numbers;
}

} // namespace plica
