// A test, the nominal case, and what admissible specimens of it may scatter: what effects are held
// against.
#pragma once

#include "diagnose/readings/reading.hpp"
#include "diagnose/results/diagnosis.hpp"
#include "diagnose/results/settings.hpp"
#include "diagnose/weigh/evidence.hpp"
#include "model/description/case.hpp"

#include <memory>

namespace plica {

struct GapProblem {
  const Case& data;
  const TestData& test;
  Nominal nominal = {};
  TestReadings readings = {};
  Uncertainty uncertainty = {};
  Remounting remounting = {};
  BaselineFound baseline = {};
  Eigen::VectorXd log_measured = {};
  std::optional<Whitening> fitted = {}, held_out = {};
  std::optional<PredictorStore> predictors = {};
  std::vector<Hypothesis> hypotheses = {};
  std::vector<std::string> words = {}; // what the case says of effects and priors
  std::vector<EffectNotTried> not_tried = {};

  FitContext context() { return {*predictors, readings, uncertainty, log_measured, *fitted}; }
};

// It stays where it is: predictors look at the nominal case in it. Throws InputError as build()
// does, and with a key of the test when that has nothing that the model answers.
std::unique_ptr<GapProblem> stated_gap(const Case& data, const TestData& test,
                                       const DiagnosisSettings& settings);

// What may hang on the structure by a spring of its own (effects/resonators.hpp), where several
// states changed one after the other with a size for each.
std::vector<Hypothesis> resonators_of(const GapProblem& problem);

} // namespace plica
