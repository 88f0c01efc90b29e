#include "run/study/error_bars.hpp"

#include "model/description/case_path.hpp"
#include "model/description/toleranced_damping.hpp"
#include "model/shape/mesh_choice.hpp"
#include "run/analyses/run.hpp"
#include "run/results/number_keys.hpp"
#include "run/stages.hpp"
#include "run/study/finer_run.hpp"
#include "run/study/refine.hpp"
#include "words/mode_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <random>

namespace plica {
namespace {

using Headline = std::map<std::string, double>;

constexpr double low_point = 0.05, high_point = 0.95;
constexpr int draws = 20000;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Results run_silently(const Case& data) {
  return run(data, [](const std::string&) {});
}

Headline headline_of(const Case& data) {
  return numbers_with_errors(run_silently(with_life(for_headline(data), data)));
}

bool on_log_scale(const Tolerance& t) {
  return t.interval && t.low > 0;
}

double scaled(const Tolerance& t, double value) {
  return on_log_scale(t) ? std::log(value) : value;
}

Case with_number(Case data, const std::string& path, double value) {
  *number_at(data, path) = value;
  return data;
}

// What one tolerance does to the logarithm of one number: a parabola through zero at the nominal.
struct Effect {
  double slope = 0, curvature = 0, nominal = 0; // over the scaled value

  double at(double x) const { return (slope + curvature * (x - nominal)) * (x - nominal); }
};

Effect effect(const Tolerance& t, double nominal, double at_low, double at_high) {
  const double x0 = scaled(t, t.value);
  const double a = scaled(t, quantile(t, low_point)) - x0,
               b = scaled(t, quantile(t, high_point)) - x0;
  if (a == b) return {};
  const double ya = std::log(at_low / nominal), yb = std::log(at_high / nominal);
  if (a == 0) return {.slope = yb / b, .curvature = 0, .nominal = x0};
  if (b == 0) return {.slope = ya / a, .curvature = 0, .nominal = x0};
  const double curvature = (yb / b - ya / a) / (b - a);
  return {.slope = ya / a - curvature * a, .curvature = curvature, .nominal = x0};
}

// Not a number when the run did not meet that shape.
double value_of(const Headline& numbers, const std::string& key) {
  const auto found = numbers.find(key);
  return found == numbers.end() ? unknown : found->second;
}

// The effects of all tolerances on one number, in the order of the tolerances.
using Effects = std::vector<Effect>;

double sum(const std::vector<Tolerance>& tolerances, const Effects& effects,
           const std::vector<double>& u) {
  double total = 0;
  for (std::size_t i = 0; i < effects.size(); ++i)
    total += effects[i].at(scaled(tolerances[i], quantile(tolerances[i], u[i])));
  return total;
}

// Left out when a run did not meet the shape: half an effect would be too narrow an interval.
void add_interval(ErrorBar& bar, const std::vector<Tolerance>& tolerances, const Effects& effects) {
  for (const Effect& e : effects)
    if (!std::isfinite(e.slope + e.curvature)) return;
  std::mt19937_64 random(1);
  const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
  const std::size_t count = effects.size();
  std::vector<double> results(draws), mean(count), square(count), u(count);
  for (double& result : results) {
    for (double& x : u) x = unit();
    for (std::size_t i = 0; i < count; ++i) {
      const double y = effects[i].at(scaled(tolerances[i], quantile(tolerances[i], u[i])));
      mean[i] += y / draws;
      square[i] += y * y / draws;
      result += y;
    }
  }
  std::sort(results.begin(), results.end());
  const auto point = [&](double p) {
    return bar.value * std::exp(results[std::size_t(p * draws)]);
  };
  bar.interval = {point(low_point), point(high_point)};
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) total += square[i] - mean[i] * mean[i];
  for (std::size_t i = 0; i < count; ++i)
    bar.shares.push_back(total > 0 ? (square[i] - mean[i] * mean[i]) / total : 0);
}

void add_tolerances(ErrorBars& all, const Case& fine, const StageListener& stage) {
  Case data = with_coarse_bellows(fine);
  // No stiffness, mode or stress feels damping.
  std::erase_if(data.tolerances, [](const Tolerance& t) { return t.path == toleranced_damping; });
  const std::vector<Tolerance>& tolerances = data.tolerances;
  if (tolerances.empty()) return;
  stage(stages::tolerances);
  const Headline nominal = headline_of(data);
  std::map<std::string, Effects> effects;
  for (const Tolerance& t : tolerances) {
    all.tolerances.push_back(t.path);
    stage({stages::tolerance_of, t.path});
    const Headline low = headline_of(with_number(data, t.path, quantile(t, low_point)));
    const Headline high = headline_of(with_number(data, t.path, quantile(t, high_point)));
    for (const auto& [key, value] : nominal)
      effects[key].push_back(effect(t, value, value_of(low, key), value_of(high, key)));
  }
  for (ErrorBar& bar : all.bars)
    if (effects.contains(bar.key)) add_interval(bar, tolerances, effects[bar.key]);
  if (tolerances.size() < 2) return;
  stage(stages::tolerances_together);
  Case together = data;
  std::mt19937_64 random(2);
  std::vector<double> u;
  for (const Tolerance& t : tolerances) {
    u.push_back(low_point + (high_point - low_point) * double(random() >> 11) * 0x1p-53);
    *number_at(together, t.path) = quantile(t, u.back());
  }
  const Headline found = headline_of(together);
  for (const auto& [key, value] : nominal) {
    if (number_key::kind_of(key) == NumberKind::damage)
      continue; // a high power of stress: said of its range
    const double predicted = value * std::exp(sum(tolerances, effects[key], u));
    const double deviation = std::abs(value_of(found, key) / predicted - 1);
    if (deviation > all.interaction) all.interaction = deviation;
  }
}

} // namespace

double quantile(const Tolerance& t, double u) {
  if (!t.interval) return t.low + u * (t.high - t.low);
  const double from = u < 0.5 ? t.low : t.value, to = u < 0.5 ? t.value : t.high;
  const double share = u < 0.5 ? 2 * u : 2 * u - 1;
  if (!on_log_scale(t)) return from + share * (to - from);
  return from * std::pow(to / from, share);
}

Case with_life(Case plain, const Case& data) {
  if (!data.analyses.life) return plain;
  plain.analyses.life = data.analyses.life;
  if (data.analyses.levels &&
      !plain.analyses.levels) { // how friction is solved, for sweeps through it
    plain.analyses.levels = data.analyses.levels;
    plain.analyses.levels->bases.clear();
    plain.analyses.levels->forces.clear();
  }
  if (!needs_response(*plain.analyses.life)) return plain;
  plain.analyses.damping = data.analyses.damping;
  plain.analyses.response = data.analyses.response;
  plain.analyses.response->cross.clear(); // of sensors
  plain.analyses.response->tones.clear();
  plain.analyses.response->referee = 0;
  plain.analyses.transients.clear();
  plain.analyses.run_ups.clear();
  return plain;
}

Case for_headline(Case data) {
  data.analyses.response.reset();
  data.analyses.transients.clear();
  data.analyses.run_ups.clear();
  data.analyses.levels.reset();
  data.analyses.stress.reset();
  data.analyses.life.reset();
  data.analyses.error_bars = false;
  data.analyses.damping = {};
  if (data.analyses.modes) data.analyses.modes->proof = false;
  std::erase_if(data.sensors, [](const Sensor& s) { return s.mass == 0; }); // they only look on
  for (Sensor& s : data.sensors)
    s.reach = std::numeric_limits<double>::infinity(); // other meshes have other nodes
  return data;
}

Case for_comparison(const Case& given) {
  Case data = for_headline(given);
  data.analyses.response = given.analyses.response;
  data.analyses.damping = given.analyses.damping;
  data.analyses.levels = given.analyses.levels;
  if (data.analyses.levels) {
    data.analyses.levels->forces.clear();
    data.analyses.levels->backbones = data.analyses.levels->referee = 0;
    if (data.analyses.levels->bases.empty()) data.analyses.levels.reset();
  }
  if (data.analyses.response) {
    data.analyses.response->random.reset();
    data.analyses.response->forces.clear();
    data.analyses.response->motions.clear();
    data.analyses.response->together.clear();
    data.analyses.response->tones.clear();
    data.analyses.response->referee = 0;
    if (data.analyses.response->bases.empty()) data.analyses.response.reset();
  }
  data.sensors = given.sensors;
  for (Sensor& s : data.sensors) s.reach = std::numeric_limits<double>::infinity();
  return data;
}

namespace {

// Also what the stresses are of, where they are asked for.
Case for_mesh_error(const Case& data) {
  Case fine = with_life(for_headline(data), data);
  fine.analyses.stress = data.analyses.stress;
  if (!data.analyses.stress) return fine;
  fine.analyses.damping = data.analyses.damping;
  fine.analyses.response = data.analyses.response;
  if (fine.analyses.response) {
    fine.analyses.response->cross.clear(); // of sensors
    fine.analyses.response->referee = 0;
  }
  return fine;
}

// More modes in every superelement: those up to twice the cut-off, and to four times the highest
// mode listed, for a mode feels what lies far above it (its error falls with the fourth power of
// the ratio). Where a superelement has none there, further up. None: not met.
std::optional<Results> with_more_modes(const Case& data, const Results& nominal) {
  Case more = for_mesh_error(data);
  double highest = 0;
  for (const ModeResult& mode : nominal.modes) highest = std::max(highest, mode.frequency);
  double& cutoff = more.analyses.reduction->cutoff;
  cutoff = std::max(2 * reduction_cutoff(data.analyses), 4 * highest);
  for (int attempt = 0; attempt < 4; ++attempt, cutoff *= 2) {
    Results fine = run_silently(more);
    const auto grown = [&](std::size_t k) {
      return fine.reduced->superelements[k].modes > nominal.reduced->superelements[k].modes;
    };
    bool all = fine.reduced->superelements.size() == nominal.reduced->superelements.size();
    for (std::size_t k = 0; all && k < fine.reduced->superelements.size(); ++k) all = grown(k);
    if (all) return fine;
  }
  return std::nullopt;
}

} // namespace

ErrorBars error_bars(const Case& data, const Results& nominal, const StageListener& stage) {
  // Twice along: anything else would refine arcs and walls by different ratios.
  constexpr double finer_along = 2, finer_around = 1.5;
  ErrorBars all;
  prepare_mesh_errors(nominal, all);
  for (const bool along : {true, false}) {
    const Refinement factor{.along = along ? finer_along : 1, .around = along ? 1 : finer_around};
    const Refinement ratio = refinement_ratio(data, factor);
    const double q = along ? ratio.along : ratio.around;
    if (q == 1) continue; // nothing in the case has that direction
    stage(along ? stages::finer_along : stages::finer_around);
    (along ? all.along : all.around) = true;
    const FinerRun fine = numbers_of(run_silently(refined(for_mesh_error(data), factor)), nominal);
    add_differences(all, nominal, fine, along ? &MeshError::along : &MeshError::around,
                    1 - 1 / (q * q), 1 - 1 / q);
  }
  if (data.analyses.reduction && nominal.reduced) {
    stage(stages::cut_off);
    FinerRun fine = not_met(nominal);
    if (const std::optional<Results> more = with_more_modes(data, nominal))
      fine = numbers_of(*more, nominal);
    add_differences(all, nominal, fine, &MeshError::cutoff, 1, 1);
  }
  if (!data.tolerances.empty()) add_tolerances(all, data, stage);
  return all;
}

std::string beyond_accuracy(const Case& data, const Results& results) {
  double accuracy = 0, worst = 0;
  for (const Part& part : data.parts)
    if (const auto* bellows = std::get_if<Bellows>(&part.body))
      accuracy = std::max(accuracy, mesh_accuracy(*bellows));
  if (accuracy == 0) return "";
  std::string list;
  const auto add = [&](const std::string& name, const MeshError& error, double value) {
    const double share = error.total() / value;
    if (!(std::abs(share) > accuracy)) return;
    worst = std::max(worst, std::abs(share));
    list += (list.empty() ? "" : ", ") + name + fmt::format(" ({:+.1f} %)", 100 * share);
  };
  const ErrorBars& errors = results.error_bars;
  for (std::size_t i = 0; i < errors.statics.size(); ++i)
    add(stiffness_names[i] + std::string(" stiffness"), errors.statics[i],
        results.statics->all()[i]);
  for (std::size_t i = 0; i < errors.modes.size(); ++i)
    if (results.modes[i].shape != mode_kind::rigid)
      add("mode " + std::to_string(i + 1), errors.modes[i], results.modes[i].frequency);
  if (list.empty()) return "";
  // Errors are in proportion to the accuracy: elements grow with its root, errors fall with their
  // square.
  return fmt::format("beyond the accuracy of {:.3g} % that the mesh was chosen for, by its "
                     "estimated error: {}; mesh.accuracy: {:.2g} % would do",
                     100 * accuracy, list, 100 * (0.95 * accuracy * accuracy / worst));
}

} // namespace plica
