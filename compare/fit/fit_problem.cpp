#include "compare/fit/fit_problem.hpp"

#include "compare/compare.hpp"
#include "compare/simulated.hpp"
#include "model/description/case_path.hpp"
#include "run/analyses/run.hpp"
#include "run/results/computed_numbers.hpp"
#include "run/study/error_bars.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_samples = 20000;
constexpr double lines_that_count = 20;

double scaled(const FitParameter& p, double value) {
  return p.log_scale ? std::log(value) : value;
}
double from_box(const FitParameter& p, double u) {
  const double low = scaled(p, p.bounds[0]), high = scaled(p, p.bounds[1]);
  const double x = low + u * (high - low);
  return std::clamp(p.log_scale ? std::exp(x) : x, p.bounds[0], p.bounds[1]);
}
double to_box(const FitParameter& p, double value) {
  const double low = scaled(p, p.bounds[0]), high = scaled(p, p.bounds[1]);
  return std::clamp((scaled(p, value) - low) / (high - low), 0., 1.);
}

} // namespace

Case with_design(Case data, const FitRequest& request, const VectorXd& values) {
  for (std::size_t i = 0; i < request.parameters.size(); ++i)
    for (const std::string& path : request.parameters[i].paths)
      *number_at(data, path) = values[Index(i)];
  for (const FitTie& tie : request.ties) {
    double sum = tie.constant;
    for (const auto& [path, factor] : tie.of) sum += factor * *number_at(data, path);
    *number_at(data, tie.path) = sum;
  }
  return data;
}

std::string bad_tie(Case& design, const FitRequest& request) {
  for (const FitTie& tie : request.ties)
    if (const auto q = quantity_at(design, tie.path);
        q && !allows(*q, *number_at(design, tie.path)))
      return tie.path + " = " + short_text(*number_at(design, tie.path), 6);
  return "";
}

FitProblem::FitProblem(const Case& data, const FitRequest& request, const TestData& test,
                       std::function<bool(const Case&)> refused)
    : request_(request), test_(test), measured_(test.data), whole_(data),
      case_(for_comparison(data)), refused_(std::move(refused)), bodies_(data, request) {
  if (asks_for_life()) case_ = with_life(std::move(case_), data);
  if (case_.analyses.levels) case_.analyses.levels->method = request.level_method;
  choose_targets();
}

double prior_residual(const FitParameter& p, double value) {
  const auto& [mean, sigma] = *p.prior;
  return p.log_scale ? std::log(value / mean) * mean / sigma : (value - mean) / sigma;
}

VectorXd FitProblem::unsettled(const VectorXd& u) const {
  VectorXd values(u.size());
  for (Index i = 0; i < u.size(); ++i) values[i] = from_box(request_.parameters[i], u[i]);
  return values;
}
VectorXd FitProblem::values_of(const VectorXd& u) const {
  VectorXd values = unsettled(u);
  bodies_.settle(values);
  return values;
}
bool FitProblem::is_refused(const VectorXd& values) const {
  for (Index i = 0; i < values.size(); ++i) {
    const auto& [low, high] = request_.parameters[std::size_t(i)].bounds;
    if (values[i] < low || values[i] > high) return true; // settled out of its bounds
  }
  return refused_ && refused_(with_design(whole_, request_, values));
}
VectorXd FitProblem::box_of(const VectorXd& values) const {
  VectorXd u(values.size());
  for (Index i = 0; i < u.size(); ++i) u[i] = to_box(request_.parameters[i], values[i]);
  return u;
}
VectorXd FitProblem::start() const {
  Case copy = case_;
  VectorXd values(Index(request_.parameters.size()));
  for (Index i = 0; i < values.size(); ++i)
    values[i] = *number_at(copy, request_.parameters[i].paths.front());
  return box_of(values);
}

double FitProblem::slope(Index i, double u) const {
  const FitParameter& p = request_.parameters[std::size_t(i)];
  const double width = scaled(p, p.bounds[1]) - scaled(p, p.bounds[0]);
  return p.log_scale ? width * from_box(p, u) : width;
}

Results FitProblem::results_of(const Case& design) const {
  if (!friction_) return run(design, [](const std::string&) {});
  Results results = unchanged_;
  results.level_responses = (*friction_)(design);
  return results;
}

double FitProblem::broken(std::size_t constraint, double value) const {
  const FitConstraint& c = request_.constraints[constraint];
  const double sigma = constraint_width * constraint_scale_[constraint];
  if (c.max && value > *c.max) return (value - *c.max) / sigma;
  if (c.min && value < *c.min) return (value - *c.min) / sigma;
  return 0;
}

bool FitProblem::add_stiffness(const Case& design, Outcome& outcome) const {
  if (stiffness_.empty()) return true;
  std::vector<VectorXd> computed;
  try {
    computed = computed_stiffness(design, stiffness_);
  } catch (const std::exception&) {
    return false;
  }
  for (std::size_t i = 0; i < stiffness_.size(); ++i) {
    if (!stiffness_[i].held_out && !computed[i].allFinite()) return false;
    outcome.stiffness.push_back(deviations_of(stiffness_[i], computed[i]));
  }
  return true;
}

std::optional<FitProblem::Outcome> FitProblem::evaluate(const VectorXd& u) const {
  const VectorXd values = values_of(u);
  Case design = with_design(case_, request_, values);
  if (!bad_tie(design, request_).empty() || is_refused(values)) return std::nullopt;
  Results results;
  try {
    results = results_of(design);
  } catch (const std::exception&) {
    return std::nullopt; // no model, or no solution, for this design
  }
  const auto rows = compare(results, measured_);
  Outcome outcome{VectorXd(Index(targets_.size())),
                  VectorXd(Index(aims_.size())),
                  VectorXd(Index(request_.constraints.size())),
                  {},
                  {}};
  const std::map<std::string, double> numbers = computed_numbers_of(results);
  const std::vector<FrfSet> simulated =
      curves_.empty() ? std::vector<FrfSet>{} : responses_to_base(results);
  for (const Curve& curve : curves_) {
    const auto own = magnitudes(simulated, curve);
    if (!own) return std::nullopt;
    outcome.responses.push_back(log_ratios(curve, own->first, own->second));
  }
  if (!add_stiffness(design, outcome)) return std::nullopt;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (targets_[i].goal) {
      const auto value = number_of(targets_[i].quantity, numbers, design);
      if (!value || !(*value > 0)) return std::nullopt;
      outcome.targets[Index(i)] = *value;
      continue;
    }
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const MeasuredComparison& r) {
      return r.quantity == targets_[i].quantity && r.entry == targets_[i].entry;
    });
    if (row == rows.end() || !(row->computed > 0)) {
      if (!targets_[i].held_out) return std::nullopt;
      outcome.targets[Index(i)] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    outcome.targets[Index(i)] = row->computed;
  }
  for (std::size_t i = 0; i < aims_.size(); ++i) {
    const auto value = number_of(aims_[i].quantity, numbers, design);
    if (!value || !(*value > 0)) return std::nullopt;
    outcome.aims[Index(i)] = *value;
  }
  for (std::size_t i = 0; i < request_.constraints.size(); ++i) {
    double sum = 0;
    for (const auto& [what, factor] : request_.constraints[i].of) {
      const auto number = number_of(what, numbers, design);
      if (!number) return std::nullopt; // a mode that this design does not show
      sum += factor * *number;
    }
    outcome.constraints[Index(i)] = sum;
  }
  return outcome;
}

Index FitProblem::limits() const {
  Index count = 0;
  for (const FitConstraint& c : request_.constraints) count += (c.max ? 1 : 0) + (c.min ? 1 : 0);
  return count;
}

bool FitProblem::is_limited() const {
  return !aims_.empty() ||
         std::any_of(request_.constraints.begin(), request_.constraints.end(),
                     [](const FitConstraint& c) {
                       return std::any_of(c.of.begin(), c.of.end(), [](const auto& term) {
                         return unit_of_computed(term.first).has_value();
                       });
                     });
}

// All but the constraints.
void FitProblem::add_rows(const Outcome& outcome, const VectorXd& values,
                          std::vector<double>& r) const {
  for (std::size_t i = 0; i < targets_.size(); ++i)
    if (!targets_[i].held_out)
      r.push_back(std::log(outcome.targets[Index(i)] / targets_[i].measured) / targets_[i].sigma);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const auto count = double(curves_[i].hertz.size());
    const double weight = std::sqrt(std::min(1., lines_that_count / count));
    for (std::size_t k = 0; k < curves_[i].hertz.size(); ++k)
      r.push_back(weight * outcome.responses[i][Index(k)] / curves_[i].sigma[k]);
  }
  for (std::size_t i = 0; i < stiffness_.size(); ++i) {
    if (stiffness_[i].held_out) continue;
    const VectorXd& off = outcome.stiffness[i];
    const double weight = std::sqrt(std::min(1., lines_that_count / double(off.size())));
    for (const double x : off) r.push_back(weight * x / stiffness_[i].sigma);
  }
  for (std::size_t i = 0; i < request_.parameters.size(); ++i) {
    const FitParameter& p = request_.parameters[i];
    if (p.prior) r.push_back(prior_residual(p, values[Index(i)]));
  }
  for (std::size_t i = 0; i < aims_.size(); ++i) {
    const double ratio = outcome.aims[Index(i)] / aims_[i].start;
    r.push_back((aims_[i].least ? ratio : 1 / ratio) / aims_[i].sigma);
  }
}

std::optional<VectorXd> FitProblem::rows(const VectorXd& u, bool sides) {
  ++evaluations_;
  const std::optional<Outcome> outcome = evaluate(u);
  if (!outcome) return std::nullopt;
  const VectorXd values = values_of(u);
  std::vector<double> r;
  add_rows(*outcome, values, r);
  double cost = 0;
  for (const double x : r) cost += x * x / 2;
  for (std::size_t i = 0; i < request_.constraints.size(); ++i) {
    const FitConstraint& c = request_.constraints[i];
    const double value = outcome->constraints[Index(i)], past = broken(i, value);
    cost += past * past / 2;
    const double sigma = constraint_width * constraint_scale_[i];
    if (sides && c.max) r.push_back((value - *c.max) / sigma);
    if (sides && c.min) r.push_back((*c.min - value) / sigma);
    if (!sides) r.push_back(past);
  }
  remember({values, outcome->targets, cost});
  return Eigen::Map<VectorXd>(r.data(), Index(r.size()));
}

void FitProblem::remember(FitSample sample) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (samples_.size() < most_samples) samples_.push_back(std::move(sample));
}

std::vector<FitSample> FitProblem::take_samples() {
  std::sort(samples_.begin(), samples_.end(), [](const FitSample& a, const FitSample& b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    return std::lexicographical_compare(a.design.begin(), a.design.end(), b.design.begin(),
                                        b.design.end());
  });
  return std::move(samples_);
}

} // namespace plica
