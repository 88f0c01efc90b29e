// Numbers of a case adjusted to measured data: least squares with priors and limits.
//
// Residuals, in standard deviations: ln(computed / measured) / relative sigma of every target, the
// same of the magnitude of every line of a response, what a dynamic stiffness is off over sigma
// times its magnitude (fit_stiffness.hpp), (p - p0) / sigma of every prior (in ln p on a
// log scale), and a penalty of 1 per 0.1 % by which a constraint is broken. Neighbouring lines of a
// response say nearly the same: all of them together weigh as twenty. The uncertainty of the
// parameters is that of the linearised problem at the best design.
#pragma once

#include "compare/fit/fit_problem.hpp"

#include <functional>

namespace plica {

struct FittedParameter {
  std::string path;
  std::vector<std::string> also; // further paths that share the value
  double start = 0, value = 0;
  std::optional<double> sigma; // of the value; on a log scale relative times the value. None at a
                               // bound, or when data and prior leave it open within the bounds
  bool at_bound = false;
  double known = 0;      // share of the prior range that the data remove: 0 nothing, 1 all
  std::string unit = {}; // of values and sigma: SI; empty = a pure number
};

struct FittedTie { // a number that follows the parameters
  std::string path;
  double value = 0;
  std::string unit;
};

struct FittedTarget {
  std::string quantity, unit;
  double measured = 0, sigma = 0; // sigma in the unit of the value
  double start = 0, value = 0;    // computed before and after
  bool held_out = false;
  bool goal = false; // wanted, not measured
};

struct FittedResponse {
  std::string name; // "mid.y by base.y at 10 m/s2"
  int lines = 0;
  double start = 0, value = 0; // RMS of the difference in dB before and after
};

struct FittedStiffness {
  std::string name; // "y storage at 0.1 mm"
  int numbers = 0;
  double sigma = 0;            // as start and value
  double start = 0, value = 0; // RMS of the difference over the magnitude, of angles in rad
  bool held_out = false;
};

struct FittedAim { // a computed quantity that was to be least or most
  std::string quantity;
  bool least = true;
  double start = 0, value = 0;
  std::string unit = {};
};

struct FittedConstraint {
  std::string name;
  double value = 0;
  std::optional<double> min, max;
  std::string unit = {}; // empty: a pure number, or a sum of unlike ones
};

// A direction of the parameters that the data leave open: a change of these parameters together
// that moves no target by more than its standard deviation within the bounds.
struct OpenDirection {
  std::vector<std::pair<std::string, double>> parts; // path, weight of a unit vector of the box
  double effect = 0; // change of the residuals over the whole box along it, in sigmas
};

struct FitResult {
  std::vector<FittedParameter> parameters;
  std::vector<FittedTie> ties;
  std::vector<FittedTarget> targets;
  std::vector<FittedResponse> responses;
  std::vector<FittedStiffness> stiffness;
  std::vector<FittedAim> aims; // with any, parameters have no uncertainties: limits hold the design
  std::vector<FittedConstraint> constraints;
  Eigen::MatrixXd correlation; // of the parameters; zero rows for those at a bound
  std::vector<OpenDirection> open;
  std::vector<std::string> warnings;
  std::vector<FitSample> samples; // designs that were tried, at most 20,000
  std::vector<Island> islands;    // of a global search
  double start_cost = 0, cost = 0;
  int evaluations = 0;
  bool converged = false;
  bool stopped = false; // before it had converged: the best so far, without uncertainties
  std::string reason;
};

struct FitSettings {
  FitSearch search = FitSearch::local;
  int evaluations = 2000;
  unsigned seed = 1;
  std::vector<Eigen::VectorXd> starts =
      {}; // further designs to begin with, values of the parameters
  std::function<void(int evaluations, double cost)> progress = [](int, double) {};
  // Of a local search, after every step and, while one takes long, now and then.
  std::function<void(int step, int evaluations, double cost)> step = [](int, int, double) {};
  std::function<bool()> stop = [] { return false; };
  // Designs that no reader would take again are not tried.
  std::function<bool(const Case& design)> refused = [](const Case&) { return false; };
};

// Throws std::invalid_argument when there is nothing to fit: no target that the model gives, an
// unknown name of a target, no result at the start.
FitResult fit_case(const Case& data, const FitRequest& request, const TestData& test,
                   const FitSettings& settings);

// Rank correlation (Spearman) of every parameter (rows) with every target and, last, the cost over
// the samples; not a number for what does not vary.
Eigen::MatrixXd rank_correlation(const FitResult& fit);

} // namespace plica
