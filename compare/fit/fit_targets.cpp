// What a fit is held against: measured rows and responses that the model gives, goals, limits.
#include "compare/compare.hpp"
#include "compare/fit/fit_problem.hpp"
#include "compare/simulated.hpp"
#include "lab/measured/entries.hpp"
#include "run/analyses/run.hpp"
#include "run/results/computed_numbers.hpp"
#include "run/results/number_keys.hpp"
#include "run/study/error_bars.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace plica {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double response_sigma = 0.1; // relative, where the measured data state none

bool is_frequency(const std::string& quantity) {
  return number_key::kind_of(quantity) == NumberKind::frequency;
}

// "peaks[0]" names "peaks[0].frequency[3]", and each quantity itself.
bool names(const FitTarget& target, const MeasuredComparison& row) {
  const std::string& name = target.quantity;
  return row.quantity == name || row.entry == name || row.entry.starts_with(name + ".");
}

} // namespace

bool FitProblem::asks_for_life() const {
  const auto is_life = [](const std::string& quantity) {
    const NumberKind kind = number_key::kind_of(quantity);
    return kind == NumberKind::stress_range || kind == NumberKind::damage;
  };
  return std::any_of(request_.targets.begin(), request_.targets.end(),
                     [&](const FitTarget& t) {
                       return is_goal(t.quantity) && is_life(quantity_of_goal(t.quantity));
                     }) ||
         std::any_of(request_.constraints.begin(), request_.constraints.end(),
                     [&](const FitConstraint& c) {
                       return std::any_of(c.of.begin(), c.of.end(),
                                          [&](const auto& term) { return is_life(term.first); });
                     });
}

// Of what the model gives at the start; where targets are named, those.
void FitProblem::choose_targets() {
  Case first = with_design(case_, request_, values_of(start()));
  if (const std::string bad = bad_tie(first, request_); !bad.empty())
    throw std::invalid_argument("fit.ties: at the start they give " + bad +
                                ", out of what the number may be");
  const Results results = run(first, [](const std::string&) {});
  scale_constraints(first, results);
  std::string known;
  choose_rows(results, known);
  choose_responses(results, known);
  choose_stiffness(first, known);
  for (const FitTarget& t : request_.targets)
    if (!is_goal(t.quantity) && !is_curve(t.quantity) &&
        std::none_of(targets_.begin(), targets_.end(), [&](const Target& own) {
          return names(t, {.quantity = own.quantity, .unit = "", .entry = own.entry});
        }))
      throw std::invalid_argument("fit.targets: the model gives no '" + t.quantity +
                                  "'; there are: " + known);
  choose_goals(first, results);
  require_targets();
  choose_analyses(first, results);
}

void FitProblem::choose_rows(const Results& results, std::string& known) {
  for (const MeasuredComparison& row : compare(results, measured_)) {
    known += (known.empty() ? "" : ", ") + row.quantity;
    const auto named = std::find_if(request_.targets.begin(), request_.targets.end(),
                                    [&](const FitTarget& t) { return names(t, row); });
    const auto& away = request_.hold_out_levels;
    const bool held_level = row.level && std::any_of(away.begin(), away.end(), [&](double l) {
                              return std::abs(l - *row.level) < 1e-6 * l;
                            });
    if (held_level && named == request_.targets.end() && !request_.targets.empty()) continue;
    const bool held_out = held_level || is_held_out(measured_, row.entry);
    if (named == request_.targets.end() && !held_out && (!request_.targets.empty() || row.of_peak))
      continue;
    if (!(row.measured > 0) || !(row.computed > 0)) continue;
    double sigma = row.sigma > 0 ? row.sigma / row.measured : request_.default_sigma;
    if (named != request_.targets.end() && named->sigma > 0) sigma = named->sigma;
    targets_.push_back({.quantity = row.quantity,
                        .unit = row.unit,
                        .entry = row.entry,
                        .measured = row.measured,
                        .sigma = sigma,
                        .held_out = held_out,
                        .kind = row.kind,
                        .of_peak = row.of_peak,
                        .over_stroke = row.over_stroke,
                        .level = row.level});
  }
  for (double away : request_.hold_out_levels)
    if (std::none_of(measured_.peaks.begin(), measured_.peaks.end(), [&](const MeasuredPeaks& p) {
          return std::any_of(p.level.begin(), p.level.end(),
                             [&](double l) { return std::abs(l - away) < 1e-6 * l; });
        }))
      throw std::invalid_argument("fit.hold_out_levels: no peak was measured at " +
                                  short_text(away, 6) + " m/s2");
}

void FitProblem::require_targets() const {
  const bool stiffness = std::any_of(stiffness_.begin(), stiffness_.end(),
                                     [](const FitStiffness& s) { return !s.held_out; });
  if (curves_.empty() && aims_.empty() && !stiffness &&
      std::all_of(targets_.begin(), targets_.end(), [](const Target& t) { return t.held_out; }))
    throw std::invalid_argument(targets_.empty()
                                    ? "nothing to fit: the model gives none of the measured "
                                      "quantities, and there is no goal"
                                    : "nothing to fit: all that was measured is held out");
}

// What no target needs is not computed in the fit.
void FitProblem::choose_analyses(const Case& start, const Results& results) {
  const bool peaks =
      std::any_of(targets_.begin(), targets_.end(), [](const Target& t) { return t.of_peak; });
  const bool levels = std::any_of(targets_.begin(), targets_.end(),
                                  [](const Target& t) { return t.level.has_value(); });
  if (!levels) case_.analyses.levels.reset();
  if (!peaks && !levels && curves_.empty() && stiffness_.empty()) case_ = for_headline(case_);
  if (asks_for_life()) case_ = with_life(std::move(case_), whole_);
  if (levels && friction_alone()) {
    friction_.emplace(start);
    unchanged_ = results;
  }
}

// Values to be met stand among the targets, as if they had been measured.
void FitProblem::choose_goals(const Case& start, const Results& results) {
  const std::map<std::string, double> numbers = computed_numbers_of(results);
  for (const FitTarget& target : request_.targets) {
    if (!is_goal(target.quantity)) continue;
    const Parsed<FitGoal> goal = goal_of(target.quantity, start);
    if (!goal.wrong.empty()) throw std::invalid_argument("fit.targets: " + goal.wrong);
    const std::string& quantity = goal.value.quantity;
    const auto value = number_of(quantity, numbers, start);
    if (!value || !(*value > 0)) {
      std::string known;
      for (const auto& [name, number] : numbers) known += (known.empty() ? "" : ", ") + name;
      throw std::invalid_argument("fit.targets: the model gives no '" + quantity +
                                  "' above zero; there are: " + known);
    }
    if (goal.value.aim == GoalAim::value)
      targets_.push_back({.quantity = quantity,
                          .unit = unit_of_goal(quantity, start),
                          .entry = "goal",
                          .measured = goal.value.value,
                          .sigma = target.sigma > 0 ? target.sigma : request_.default_sigma,
                          .held_out = false,
                          .goal = true});
    else
      aims_.push_back({.quantity = quantity,
                       .least = goal.value.aim == GoalAim::least,
                       .start = *value,
                       .sigma = target.sigma > 0 ? target.sigma : 1});
  }
}

// Friction has no part in mass and slipping stiffness, and all of the model in the rest.
bool FitProblem::friction_alone() const {
  if (asks_for_life() || whole_.state) return false; // friction moves the part in its state, too
  for (const FitParameter& p : request_.parameters)
    for (const std::string& path : p.paths)
      if (!FrictionResponses::is_friction(path)) return false;
  for (const FitTie& tie : request_.ties)
    if (!FrictionResponses::is_friction(tie.path)) return false;
  for (const FitConstraint& c : request_.constraints)
    for (const auto& [what, factor] : c.of)
      if (is_frequency(what)) return false;
  for (const Aim& aim : aims_)
    if (is_frequency(aim.quantity)) return false;
  return curves_.empty() && stiffness_.empty() &&
         std::all_of(targets_.begin(), targets_.end(), [](const Target& t) {
           if (t.goal) return !is_frequency(t.quantity);
           return t.kind == ComparedKind::mass || t.level.has_value() ||
                  (t.kind == ComparedKind::stiffness && !t.over_stroke);
         });
}

bool FitProblem::is_curve(const std::string& name) const {
  return std::any_of(curves_.begin(), curves_.end(),
                     [&](const Curve& c) { return c.name == name; }) ||
         std::any_of(stiffness_.begin(), stiffness_.end(),
                     [&](const FitStiffness& s) { return s.name == name || s.entry == name; });
}

// Measured responses to motion of the base that the model has too, on their lines in its band.
void FitProblem::choose_responses(const Results& results, std::string& known) {
  const std::vector<FrfSet> simulated = responses_to_base(results);
  for (const FrfSet* set : all_responses(test_))
    for (std::size_t r = 0; r < set->references.size(); ++r)
      for (std::size_t c = 0; c < set->responses.size(); ++c)
        add_curve(*set, r, c, simulated, known);
}

void FitProblem::add_curve(const FrfSet& set, std::size_t r, std::size_t c,
                           const std::vector<FrfSet>& simulated, std::string& known) {
  Curve curve;
  curve.reference = set.references[r];
  curve.response = set.responses[c];
  const auto own = magnitudes(simulated, curve);
  constexpr double silent = 1e-6; // of the largest channel
  if (!own ||
      set.H[r].col(Index(c)).cwiseAbs().maxCoeff() < silent * set.H[r].cwiseAbs().maxCoeff())
    return;
  curve.name = curve.response + " by " + curve.reference;
  if (set.level) curve.name += fmt::format(" at {:g}", *set.level);
  known += ", " + curve.name;
  const auto named = std::find_if(request_.targets.begin(), request_.targets.end(),
                                  [&](const FitTarget& t) { return t.quantity == curve.name; });
  if (!request_.targets.empty() && named == request_.targets.end()) return;
  const double low = own->first[0], high = own->first[own->first.size() - 1];
  for (Index k = 0; k < set.hertz.size(); ++k) {
    const double magnitude = std::abs(set.H[r](k, Index(c)));
    if (set.hertz[k] < low || set.hertz[k] > high || !(magnitude > 0)) continue;
    double sigma = response_sigma;
    if (named != request_.targets.end() && named->sigma > 0)
      sigma = named->sigma;
    else if (!set.sigma.empty())
      sigma = std::max(1e-3, set.sigma[r](k, Index(c)) / magnitude);
    curve.hertz.push_back(set.hertz[k]);
    curve.log_magnitude.push_back(std::log(magnitude));
    curve.sigma.push_back(sigma);
  }
  if (curve.hertz.size() >= 2) curves_.push_back(std::move(curve));
}

// All that was measured; where targets are named, those.
void FitProblem::choose_stiffness(const Case& start, std::string& known) {
  for (FitStiffness& s : stiffness_targets(measured_)) {
    known += (known.empty() ? "" : ", ") + s.name;
    const auto named =
        std::find_if(request_.targets.begin(), request_.targets.end(), [&](const FitTarget& t) {
          return t.quantity == s.name || t.quantity == s.entry;
        });
    if (!request_.targets.empty() && named == request_.targets.end()) continue;
    if (named != request_.targets.end() && named->sigma > 0) s.sigma = named->sigma;
    if (!(s.sigma > 0)) s.sigma = request_.default_sigma;
    stiffness_.push_back(std::move(s));
  }
  complete_sizes(start, stiffness_);
}

void FitProblem::scale_constraints(const Case& start, const Results& results) {
  const std::map<std::string, double> numbers = computed_numbers_of(results);
  for (const FitConstraint& c : request_.constraints) {
    double scale = std::max(std::abs(c.max.value_or(0)), std::abs(c.min.value_or(0)));
    for (const auto& [what, factor] : c.of) {
      const auto number = number_of(what, numbers, start);
      if (!number)
        throw std::invalid_argument("fit.constraints: the model gives no '" + what + "'");
      scale = std::max(scale, std::abs(factor * *number));
    }
    constraint_scale_.push_back(std::max(scale, 1e-300));
  }
}

} // namespace plica
