#include "io/input/fit_input.hpp"

#include "compare/fit/fit_goal.hpp"
#include "model/description/case_path.hpp"
#include "run/results/computed_numbers.hpp"
#include "words/did_you_mean.hpp"
#include "words/units.hpp"

#include <algorithm>

namespace plica {
namespace {

std::string text(double value) {
  return short_number(value);
}

class FitResolver {
public:
  FitResolver(Case& data, CheckLog& log) : data_(data), log_(log) {}

  void resolve(FitRequest& fit) {
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
      parameter(fit.parameters[i], item("fit.parameters", i));
    for (std::size_t i = 0; i < fit.ties.size(); ++i) {
      const std::string key = item("fit.ties", i);
      taken(fit.ties[i].path, key + ".path");
      factors(fit.ties[i].of_text, fit.ties[i].of, key + ".of", false);
    }
    for (std::size_t i = 0; i < fit.constraints.size(); ++i) {
      const std::string key = item("fit.constraints", i);
      FitConstraint& c = fit.constraints[i];
      if (c.of_text.empty()) {
        limit(c, key);
        continue;
      }
      factors(c.of_text, c.of, key + ".of", true);
      if (!c.min && !c.max && log_.fine(key))
        log_.add(key, "limits nothing", "give min, max or both");
      if (c.min && c.max && *c.min > *c.max) log_.add(key + ".max", "lies below min", "min to max");
    }
    for (std::size_t i = 0; i < fit.targets.size(); ++i)
      if (is_goal(fit.targets[i].quantity))
        if (const auto goal = goal_of(fit.targets[i].quantity, data_); !goal.wrong.empty())
          log_.add(item("fit.targets", i) + ".quantity", goal.wrong, goal.allowed);
    sort_ties(fit.ties);
  }

private:
  // A constraint whose name says it: "f_axial >= 250 Hz".
  void limit(FitConstraint& c, const std::string& key) {
    if (!log_.fine(key)) return;
    const Parsed<FitLimit> limit = limit_of(c.name, data_);
    if (!limit.wrong.empty()) return log_.add(key + ".name", limit.wrong, limit.allowed);
    if (c.min || c.max)
      return log_.add(key, "is limited by its name already",
                      "a name alone, or of with min and max");
    c.of = {{limit.value.quantity, 1.}};
    (limit.value.least ? c.min : c.max) = limit.value.value;
  }

  // A tie after those it depends on.
  void sort_ties(std::vector<FitTie>& ties) {
    std::vector<FitTie> sorted;
    while (!ties.empty()) {
      const auto next = std::find_if(ties.begin(), ties.end(), [&](const FitTie& t) {
        return std::none_of(ties.begin(), ties.end(),
                            [&](const FitTie& other) { return t.of.count(other.path) > 0; });
      });
      if (next == ties.end())
        return log_.add("fit.ties",
                        "follow each other in a circle, at '" + shown(ties[0].path) + "'",
                        "numbers that follow parameters");
      sorted.push_back(*next);
      ties.erase(next);
    }
    ties = std::move(sorted);
  }

  // A number of the case that is changed once only.
  std::optional<Quantity> taken(const std::string& path, const std::string& key) {
    const std::optional<Quantity> unit = quantity_at(data_, path);
    if (!unit) {
      if (log_.fine(key))
        log_.add(key, "there is no number at '" + shown(path) + "'",
                 "the path of a number that this file gives, e.g. materials.steel.E");
    } else {
      if (!changed_.insert(path).second)
        log_.add(key, "'" + shown(path) + "' is changed twice", "each number once");
    }
    return unit;
  }

  void parameter(FitParameter& p, const std::string& key) {
    std::optional<Quantity> number;
    for (const std::string& path : p.paths)
      if (const auto own = taken(path, key + ".path")) {
        if (number && number->unit != own->unit)
          log_.add(key + ".path", "shares a value between numbers of different units",
                   "numbers of one kind");
        number = own;
      }
    if (!number || p.paths.empty()) return;
    const Dimension unit = number->unit;
    bounds(p, *number, key);
    if (const auto prior = pair(p.prior_text, unit, key + ".prior")) {
      p.prior = prior;
      if (!((*prior)[1] > 0))
        log_.add(key + ".prior", "has no standard deviation above zero", "[value, sigma]");
      else if (p.log_scale && !((*prior)[0] > 0))
        log_.add(key + ".prior", "is not above zero on a log scale", "a value above zero");
    }
    if (const auto physical = pair(p.physical_text, unit, key + ".physical")) {
      p.physical = physical;
      ordered(*physical, key + ".physical");
    }
  }

  void bounds(FitParameter& p, const Quantity& number, const std::string& key) {
    const auto tolerance =
        std::find_if(data_.tolerances.begin(), data_.tolerances.end(),
                     [&](const Tolerance& t) { return t.path == p.paths.front(); });
    if (p.bounds_text.empty() && tolerance != data_.tolerances.end())
      p.bounds = {tolerance->low, tolerance->high};
    else if (p.bounds_text.empty())
      return log_.add(key, "has no bounds, and its number no tolerance", "bounds: [low, high]");
    else if (const auto given = pair(p.bounds_text, number.unit, key + ".bounds"))
      p.bounds = *given;
    else
      return;
    if (!ordered(p.bounds, key + ".bounds")) return;
    if (p.log_scale && p.bounds[0] <= 0)
      return log_.add(key + ".bounds", "reach zero on a log scale", "a lower bound above zero");
    for (const double bound : p.bounds)
      if (!allows(number, bound))
        return log_.add(key + ".bounds", "reach out of what the number may be",
                        describe(number, number.unit));
    const double value = *number_at(data_, p.paths.front());
    if (value < p.bounds[0] || value > p.bounds[1])
      log_.add(key + ".bounds", "do not hold the value of the case, " + text(value),
               "bounds around the value the search starts from");
  }

  bool ordered(const std::array<double, 2>& range, const std::string& key) {
    if (range[0] < range[1]) return true;
    log_.add(key, "is empty or ends below its start", "[low, high]");
    return false;
  }

  std::optional<std::array<double, 2>> pair(const std::vector<std::string>& texts, Dimension unit,
                                            const std::string& key) {
    if (texts.empty()) return std::nullopt;
    if (texts.size() != 2) {
      log_.add(key, "has " + std::to_string(texts.size()) + " numbers", "two numbers");
      return std::nullopt;
    }
    std::array<double, 2> values{};
    for (std::size_t i = 0; i < 2; ++i) {
      const ParsedQuantity parsed = parse_quantity(texts[i], unit);
      if (!parsed.wrong.empty()) {
        log_.add(key, parsed.wrong, parsed.allowed);
        return std::nullopt;
      }
      values[i] = parsed.value;
    }
    return values;
  }

  void factors(const std::map<std::string, std::string>& texts, std::map<std::string, double>& of,
               const std::string& key, bool with_results) {
    for (const auto& [path, factor] : texts) {
      const bool result = with_results && unit_of_computed(path).has_value();
      if (!result && !number_at(data_, path))
        log_.add(key, "there is no number at '" + shown(path) + "'",
                 with_results ? "the path of a number, or mass, k_axial, k_transverse, k_bending, "
                                "k_torsion, f_axial, f_transverse, f_torsion"
                              : "the path of a number that this file gives");
      const ParsedQuantity parsed = parse_quantity(factor, Dimension::number);
      if (!parsed.wrong.empty()) log_.add(key, parsed.wrong, "a number");
      of[path] = parsed.value;
    }
  }

  Case& data_;
  CheckLog& log_;
  std::set<std::string> changed_;
};

} // namespace

void resolve_fit(Case& data, CheckLog& log) {
  if (data.fit && log.fine("fit")) FitResolver(data, log).resolve(*data.fit);
}

} // namespace plica
