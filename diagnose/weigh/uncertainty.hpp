// How far the readings of an admissible specimen may lie from the nominal case.
//
//   Sigma = Sigma_measurement + Sigma_reassembly + Sigma_numeric + Sigma_form
//
// Form: Monte Carlo over admissible specimens (scatter.hpp, tolerances of the case), with its mean
// as a bias. What scatters needs no parameter of its own in a fit: a Gaussian nuisance that is
// linear in the readings and integrated out is its covariance.
#pragma once

#include "diagnose/predict/predictor.hpp"
#include "diagnose/results/settings.hpp"
#include "diagnose/weigh/cross_scatter.hpp"

#include <string>

namespace plica {

// How much a specimen that is mounted anew scatters, relative.
struct Remounting {
  double frequency = 0.002, damping = 0.04;
  double measurements = 0; // that say so beside a baseline; 0 = as stated
};

struct Uncertainty {
  Eigen::VectorXd nominal;          // log readings of the case on its own mesh
  Eigen::VectorXd correction;       // what the own mesh differs by from the coarse one
  std::vector<std::string> refused; // of each reading, why that cannot be known; empty: all are
  Eigen::VectorXd bias;             // mean of the admissible specimens, less the nominal one
  std::vector<CrossScatter> cross;  // of readings along other axes
  std::vector<int> series; // of each reading: those that differ in level only share a number
  Eigen::MatrixXd measurement, reassembly, numeric, form;
  Eigen::MatrixXd healthy; // readings x specimens: what would be measured, less nominal and bias
  double change_error = 0; // of what an effect changes beside a baseline (weigh/baseline.hpp)
  Eigen::MatrixXd total() const { return measurement + reassembly + numeric + form; }

  // Mean log readings of admissible specimens that answer so on the coarse mesh.
  Eigen::VectorXd expected(const Answered& coarse) const;
  // By how much readings along other axes scatter there beyond `form`; of all others zero.
  Eigen::VectorXd further_cross(const Answered& coarse) const;
  // The laws of `cross` follow from the nominal readings and their bias: after either changed.
  void settle_cross();
};

// `without`: of the guards form, nuisance and reassembly.
Uncertainty uncertainty_of(const Case& data, const Nominal& nominal, const TestReadings& test,
                           const Measured& measured, const Guards& without,
                           const Remounting& remounting = {});

constexpr int specimens = 500;

// Standard deviations, relative.
namespace test_sigma {
constexpr double run_frequency = 0.0003, run_damping = 0.01; // from run to run
// Of the model, and of what the fit of one mode makes of a peak: damping.
constexpr double numeric_frequency = 0.002, numeric_damping = 0.015, numeric_stiffness = 0.004;
// Of what shows along other axes: modes that are nearly alike turn among each other by trifles.
constexpr double numeric_cross = 0.2;
constexpr double numeric_component = 0.01;  // of the largest of a shape
constexpr double share_of_correction = 0.1; // of the difference of meshes that may be wrong
} // namespace test_sigma

} // namespace plica
