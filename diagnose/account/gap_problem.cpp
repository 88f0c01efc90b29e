#include "diagnose/account/gap_problem.hpp"

#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/effects/growth.hpp"
#include "diagnose/effects/resonators.hpp"
#include "diagnose/predict/elastic_readings.hpp"
#include "diagnose/predict/passed_over.hpp"
#include "diagnose/predict/sprung_clamps.hpp"
#include "diagnose/readings/shape_readings.hpp"
#include "diagnose/results/stage_share.hpp"
#include "diagnose/weigh/baseline.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "lab/measured/states.hpp"
#include "model/description/place_keys.hpp"
#include "words/directions.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/ranges.h>
#include <map>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr const char* is_answered = "mass, static, modes, peaks or frf that this case answers";

// Readings that the model answers; what it does not is said.
// That a diagnosis knows in the state of a mode that was measured without excitation.
int modes_of(const Nominal& nominal, const TestReadings& test, const Reading& r) {
  if (r.run < 0 || test.runs[std::size_t(r.run)].input.any()) return r.order;
  return int(nominal.state(r.state).labels.size());
}

TestReadings answered(const Nominal& nominal, TestReadings test) {
  const std::string first = test.readings.front().entry;
  const auto y = Predictor(nominal, test, {})(VectorXd());
  if (!y) throw std::runtime_error("the nominal structure has no stable answer");
  std::vector<Reading> kept;
  std::vector<Index> rows; // of what is kept
  std::set<int> shapes;    // of which it is said
  for (std::size_t i = 0; i < test.readings.size(); ++i) {
    const Reading& r = test.readings[i];
    if (std::isfinite((*y)[Index(i)])) {
      kept.push_back(r);
      rows.push_back(Index(i));
    } else if (const int most = modes_of(nominal, test, r); r.order > most) {
      input_error(r.entry + ".order",
                  fmt::format("is {}, and the model has {} modes in all", r.order, most),
                  "the number of the mode among those of its shape and direction, from 1");
    } else if (r.kind != ReadingKind::component || shapes.insert(r.of_shape).second) {
      test.warnings.push_back("the model gives no " + r.name + " (" + r.entry + ")");
    }
  }
  test.readings = std::move(kept);
  leave_out_unlike_shapes((*y)(rows), test);
  if (test.readings.empty())
    input_error(first, "the model gives none of the measured quantities", is_answered);
  return test;
}

// Runs above the lowest level of their direction go.
void lowest_levels_only(TestReadings& test) {
  std::map<Input, double> lowest;
  for (const TestRun& run : test.runs) {
    const auto [at, made] = lowest.try_emplace(run.input, run.level);
    if (!made) at->second = std::min(at->second, run.level);
  }
  std::erase_if(test.readings, [&](const Reading& r) {
    if (r.run < 0) return false;
    const TestRun& run = test.runs[std::size_t(r.run)];
    return run.level > lowest.at(run.input);
  });
}

// The path of what was first measured after the baselines; empty: nothing.
std::string first_after(const TestData& test, const TestReadings& readings) {
  for (const Reading& r : readings.readings)
    if (!is_baseline(test.data, r.state)) return r.entry;
  return "";
}

TestReadings chosen_readings(const TestData& test, const Guards& without) {
  TestReadings readings = readings_of(test);
  if (readings.readings.empty())
    input_error("specimen", "nothing was measured of it that a diagnosis reads", is_answered);
  if (first_after(test, readings).empty()) {
    std::size_t i = 0;
    while (!test.data.states[i].baseline) ++i;
    input_error("states[" + std::to_string(i) + "].baseline",
                "nothing was measured but in baselines", "entries of a state that is none");
  }
  if (without.contains(Guard::levels)) lowest_levels_only(readings);
  if (without.contains(Guard::heldout))
    for (Reading& r : readings.readings) r.held_out = false;
  return readings;
}

// Tables of a rig that the mesh of the case cannot answer, each once.
void set_aside(TestReadings& test, const std::vector<std::string>& refused) {
  std::vector<Reading> kept;
  std::set<std::string> said;
  for (std::size_t i = 0; i < refused.size(); ++i) {
    const Reading& r = test.readings[i];
    if (refused[i].empty())
      kept.push_back(r);
    else if (said.insert(r.entry).second)
      test.warnings.push_back(r.entry +
                              " is set aside, for the stiffness between its ends cannot "
                              "be computed on the mesh of the case: " +
                              refused[i]);
  }
  test.readings = std::move(kept);
}

// What the scatter of readings rests on comes first; readings of baselines go with it.
void state_errors(GapProblem& p, const Guards& without) {
  const Measured& measured = p.test.data;
  p.remounting = remounting_of(p.readings, measured, p.data.diagnose);
  p.uncertainty = uncertainty_of(p.data, p.nominal, p.readings, measured, without, p.remounting);
  if (!p.uncertainty.refused.empty()) {
    const std::string first = p.readings.readings.front().entry;
    set_aside(p.readings, p.uncertainty.refused);
    if (p.readings.readings.empty())
      input_error(first,
                  "the model gives none of the measured quantities: " + p.readings.warnings.back(),
                  is_answered);
    p.uncertainty = uncertainty_of(p.data, p.nominal, p.readings, measured, without, p.remounting);
  }
  p.baseline = given_baselines(measured, p.data.diagnose, p.readings, p.uncertainty);
  if (p.readings.readings.empty())
    input_error(first_after(p.test, readings_of(p.test)),
                "the model gives none of what was measured after the baseline", is_answered);
  p.fitted.emplace(p.readings, p.uncertainty, false);
  p.held_out.emplace(p.readings, p.uncertainty, true);
  if (p.fitted->rows().empty())
    input_error("hold_out", "all that was measured is held out", "entries that are not");
}

// Clamps drawn as rigid of which a hypothesis says otherwise.
std::vector<std::string> clamps_that_may_give_way(const GapProblem& p) {
  std::vector<std::string> found;
  for (const std::string& place : p.nominal.rigid_clamps)
    if (std::any_of(p.hypotheses.begin(), p.hypotheses.end(), [&](const Hypothesis& h) {
          return h.place == place && h.effect.starts_with("joint_");
        }))
      found.push_back(place);
  return found;
}

std::vector<Hypothesis> grown_in_states(std::vector<Hypothesis> all, const Measured& measured) {
  const std::vector<std::string> states = changed_states(measured);
  for (Hypothesis& h : all) h = grown(std::move(h), states);
  return all;
}

// Cross readings of a force at the axis that it drives are shares of other places.
bool is_across(const TestReadings& test, const Reading& r) {
  if (r.kind != ReadingKind::cross) return false;
  const Input& input = test.runs[std::size_t(r.run)].input;
  return input.base >= 0 || axis_of_channel(input.force) != r.axis;
}

bool reads_across(const TestReadings& test) {
  std::map<int, std::set<int>> axes; // of the components of each shape
  for (const Reading& r : test.readings) {
    if (is_across(test, r)) return true;
    if (r.kind == ReadingKind::component)
      axes[r.of_shape].insert(test.shapes[std::size_t(r.of_shape)].axes[std::size_t(r.channel)]);
  }
  return std::any_of(axes.begin(), axes.end(),
                     [](const auto& shape) { return shape.second.size() > 1; });
}

void list_hypotheses(GapProblem& p) {
  Structure structure = p.nominal.structure(p.test.data);
  structure.reads_across = reads_across(p.readings);
  ChosenEffects chosen = chosen_effects(structure);
  for (const std::string& name : chosen.without_place)
    p.not_tried.push_back({name, effect_named(name).needs});
  p.hypotheses = grown_in_states(std::move(chosen.hypotheses), p.test.data);
  p.words = std::move(chosen.words);
  if (const std::vector<std::string> clamps = clamps_that_may_give_way(p); !clamps.empty())
    p.words.push_back(fmt::format("drawn as rigid, they may give way, and stand on springs that "
                                  "the nominal case does not feel: {}",
                                  fmt::join(clamps, ", ")));
  if (const std::vector<std::string> rigid = clamps_left_rigid(p.nominal.states.front().data);
      !rigid.empty())
    p.words.push_back(
        fmt::format("left rigid, as nothing resists there in one direction or more: {}",
                    fmt::join(rigid, ", ")));
}

} // namespace

std::vector<Hypothesis> resonators_of(const GapProblem& p) {
  return grown_in_states(resonators(p.nominal.structure(p.test.data)), p.test.data);
}

std::unique_ptr<GapProblem> stated_gap(const Case& data, const TestData& test,
                                       const DiagnosisSettings& settings) {
  std::unique_ptr<GapProblem> stated(new GapProblem{.data = data, .test = test});
  GapProblem& p = *stated;
  settings.stage("nominal case", 0);
  p.nominal = nominal_of(data, test.data);
  p.readings = chosen_readings(test, settings.without);
  leave_out_rigid_motions(p.nominal, p.readings);
  pair_like_baselines(p.nominal, test.data, p.readings);
  p.readings = answered(p.nominal, std::move(p.readings));
  for (std::string& words : words_of_passed_over(p.nominal, p.readings))
    p.readings.warnings.push_back(std::move(words));
  settings.stage("admissible specimens", share::specimens);
  state_errors(p, settings.without);
  p.log_measured.resize(Index(p.readings.readings.size()));
  for (Index i = 0; i < p.log_measured.size(); ++i)
    p.log_measured[i] = p.readings.readings[std::size_t(i)].log_value;
  p.predictors.emplace(p.nominal, p.readings);
  p.baseline.words.insert(p.baseline.words.begin(), settings.words.begin(), settings.words.end());
  list_hypotheses(p);
  return stated;
}

} // namespace plica
