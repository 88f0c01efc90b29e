// A test, the nominal case, and what admissible specimens of it may scatter: what effects are held
// against.
#pragma once

#include "diagnose/readings/reading.hpp"
#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/evidence.hpp"
#include "model/description/case.hpp"

namespace plica {

struct GapProblem {
  const Case& data;
  const DiagnosisData& test;
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
};

} // namespace plica
