#include "compare/fit/fit_goal.hpp"

#include "model/description/case_path.hpp"
#include "run/results/computed_numbers.hpp"
#include "words/did_you_mean.hpp"
#include "words/short_text.hpp"
#include "words/units.hpp"

namespace plica {
namespace {

std::optional<Dimension> unit_of(const std::string& quantity, Case data) {
  if (const auto unit = unit_of_computed(quantity)) return unit;
  if (const auto number = quantity_at(data, quantity)) return number->unit;
  return std::nullopt;
}

// What `words` say of a quantity behind a sign; fills what is wrong.
template <class T>
void read_value(const std::string& words, std::size_t sign, std::size_t length, const Case& data,
                Parsed<T>& parsed) {
  parsed.value.quantity = trimmed(std::string_view(words).substr(0, sign));
  const auto unit = unit_of(parsed.value.quantity, data);
  if (!unit) return;
  const ParsedQuantity value =
      parse_quantity(trimmed(std::string_view(words).substr(sign + length)), *unit);
  parsed.value.value = value.value;
  parsed.wrong = value.wrong;
  parsed.allowed = value.allowed;
}

template <class T> void check_quantity(const Case& data, Parsed<T>& parsed) {
  if (!parsed.wrong.empty() || unit_of(parsed.value.quantity, data)) return;
  std::vector<std::string> names;
  for (const ComputedNumber& n : computed_numbers()) names.emplace_back(n.name);
  parsed.wrong = "there is no quantity '" + shown(parsed.value.quantity) + "'";
  parsed.allowed =
      suggestion(parsed.value.quantity, names) + ", or the path of a number of this file";
}

} // namespace

bool is_goal(const std::string& words) {
  return words.starts_with("least ") || words.starts_with("most ") ||
         words.find('=') != std::string::npos;
}

std::string quantity_of_goal(const std::string& words) {
  const std::string_view all = words;
  const std::size_t sign = all.find('=');
  return std::string(
      trimmed(sign == std::string_view::npos ? all.substr(all.find(' ')) : all.substr(0, sign)));
}

Parsed<FitGoal> goal_of(const std::string& words, const Case& data) {
  Parsed<FitGoal> parsed;
  if (const std::size_t sign = words.find('='); sign != std::string::npos) {
    if (sign > 0 && (words[sign - 1] == '<' || words[sign - 1] == '>')) {
      parsed.wrong = "'" + shown(words) + "' is a limit";
      parsed.allowed = "constraints: [{name: " + words + "}]";
      return parsed;
    }
    read_value(words, sign, 1, data, parsed);
    check_quantity(data, parsed);
    if (parsed.wrong.empty() && !(parsed.value.value > 0)) {
      parsed.wrong = "'" + shown(words) + "' is not above zero";
      parsed.allowed = "goals are met by their ratio";
    }
    return parsed;
  }
  parsed.value.aim = words.starts_with("least ") ? GoalAim::least : GoalAim::most;
  parsed.value.quantity = quantity_of_goal(words);
  check_quantity(data, parsed);
  return parsed;
}

Parsed<FitLimit> limit_of(const std::string& words, const Case& data) {
  Parsed<FitLimit> parsed;
  const std::size_t sign = words.find_first_of("<>");
  if (sign == std::string::npos || words.substr(sign + 1, 1) != "=") {
    parsed.wrong = "has no sum to limit, and its name is no limit";
    parsed.allowed = "of: {...}, or a name such as f_axial >= 250 Hz or mass <= 1.75 kg";
    return parsed;
  }
  parsed.value.least = words[sign] == '>';
  read_value(words, sign, 2, data, parsed);
  check_quantity(data, parsed);
  return parsed;
}

std::optional<double> number_of(const std::string& quantity,
                                const std::map<std::string, double>& computed, const Case& data) {
  if (const auto known = computed.find(quantity); known != computed.end()) return known->second;
  if (unit_of_computed(quantity)) return std::nullopt;
  Case copy = data;
  if (const double* number = number_at(copy, quantity)) return *number;
  return std::nullopt;
}

std::string unit_of_goal(const std::string& quantity, const Case& data) {
  const auto unit = unit_of(quantity, data);
  if (!unit || *unit == Dimension::ratio) return ""; // the number is the ratio, not its per cent
  if (*unit == Dimension::force_or_moment) return "N or Nm";
  const auto units = units_of(*unit);
  return units.empty() ? "" : units.front();
}

} // namespace plica
