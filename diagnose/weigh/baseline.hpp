// The change against a baseline: what a test says of a specimen that was measured before.
//
// What is looked for was not there in a baseline, so what the model misses there is the model's own
// error, and it is there afterwards too. Readings of one thing in several states share it,
//
//   Sigma_ij += s^2 (1 within a state, `correlation` between two),
//
// with s the stated error, or what the baselines show where that is more. Of the later readings
// only what the baselines y_b do not say counts:
//
//   y_a | y_b:  mean  y_a,model + K (y_b - y_b,model),   covariance  S_aa - K S_ba,  K = S_ab
//   S_bb^-1
//
// Readings of a baseline speak neither for nor against an effect, whether a model was fitted to
// them or not.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/uncertainty.hpp"

namespace plica {

// Scatter of a specimen mounted anew: as the case says, else 0.45 % of frequencies and 15 % of
// damping ratios, each as four measurements that speak beside what several baselines show.
Remounting remounting_of(const TestReadings& test, const Measured& measured,
                         const DiagnosisRequest& request);

// What the scatter of frequencies is below with 95 %, by the measurements that say so: s sqrt(n /
// chi2_n(5 %)), the point by Wilson and Hilferty (1931). As it is stated, where the case states it.
double most_of(const Remounting& seen);

// Lets modes of later states be paired as those of the baseline are: by how the frequency changed.
void pair_like_baselines(const Nominal& nominal, const Measured& measured, TestReadings& test);

// Adds the model's error and takes the readings of baselines out of the test, which keeps what they
// do not say. Without baselines only an error that the case states.
BaselineFound given_baselines(const Measured& measured, const DiagnosisRequest& request,
                              TestReadings& test, Uncertainty& u);

} // namespace plica
