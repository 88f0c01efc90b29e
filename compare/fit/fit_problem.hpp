// What a fit evaluates: a design of the unit box to the residuals of its targets, priors and
// constraints (compare/fit/fit.hpp says which).
#pragma once

#include "compare/correlate.hpp"
#include "compare/fit/fit_bodies.hpp"
#include "compare/fit/fit_curves.hpp"
#include "compare/fit/fit_goal.hpp"
#include "compare/fit/fit_stiffness.hpp"
#include "compare/fit/friction_responses.hpp"
#include "compare/search/search.hpp"
#include "model/description/case.hpp"
#include "run/results/results.hpp"

#include <atomic>
#include <functional>
#include <mutex>

namespace plica {

// The case with these values of the parameters of the request, and its ties.
Case with_design(Case data, const FitRequest& request, const Eigen::VectorXd& values);

// Ties that leave the range of their number, in words; empty = none.
std::string bad_tie(Case& design, const FitRequest& request);

struct FitSample {
  Eigen::VectorXd design;  // values of the parameters
  Eigen::VectorXd targets; // computed values, in the order of the targets
  double cost = 0;
};

class FitProblem {
public:
  // Runs the case once to see what it gives. Throws std::invalid_argument when that is nothing the
  // test has, or an unknown target is named.
  // `refused`: says which designs, of the whole case, are none.
  FitProblem(const Case& data, const FitRequest& request, const TestData& test,
             std::function<bool(const Case&)> refused = {});

  struct Target {
    std::string quantity, unit, entry; // of the measured data: "static[0]"
    double measured = 0, sigma = 0;    // sigma relative
    bool held_out = false;
    bool goal = false; // a computed quantity that is wanted, not measured
    // As of MeasuredComparison.
    ComparedKind kind = ComparedKind::frequency;
    bool of_peak = false, over_stroke = false;
    std::optional<double> level = {};
  };
  struct Aim { // a computed quantity that is to be least or most
    std::string quantity;
    bool least = true;
    double start = 0, sigma = 1; // relative to the start
  };
  using Curve = FitCurve;
  struct Outcome {
    Eigen::VectorXd targets;                // computed values, all of them
    Eigen::VectorXd aims;                   // computed values
    Eigen::VectorXd constraints;            // sums
    std::vector<Eigen::VectorXd> responses; // ln of computed over measured, per curve
    std::vector<Eigen::VectorXd> stiffness; // deviations_of() each
  };

  const FitRequest& request() const { return request_; }
  const Case& data() const { return case_; }
  const std::vector<Target>& targets() const { return targets_; }
  const std::vector<Curve>& curves() const { return curves_; }
  const std::vector<FitStiffness>& stiffness() const { return stiffness_; }
  const std::vector<Aim>& aims() const { return aims_; }

  // Values of the parameters by a design of the box and back, on their scales. Moments of inertia
  // that no body has become the nearest that one has (FitBodies).
  Eigen::VectorXd values_of(const Eigen::VectorXd& u) const;
  Eigen::VectorXd unsettled(const Eigen::VectorXd& u) const; // without this
  Eigen::VectorXd box_of(const Eigen::VectorXd& values) const;
  Eigen::VectorXd start() const;                // of the case, in the box
  double slope(Eigen::Index i, double u) const; // change of the value per unit of the box

  // None where the model has no result. Both may be called from several threads.
  std::optional<Outcome> evaluate(const Eigen::VectorXd& u) const;
  std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& u) { return rows(u, false); }

  // The same, the last `limits()` of them the sides of the constraints: standard deviations by
  // which each is broken, below zero how far it is from that.
  std::optional<Eigen::VectorXd> residuals_and_limits(const Eigen::VectorXd& u) {
    return rows(u, true);
  }
  Eigen::Index limits() const;

  // Is a computed quantity to be least or most, or limited?
  bool is_limited() const;

  // Standard deviations by which a constraint is broken; 0 = kept.
  double broken(std::size_t constraint, double value) const;

  int evaluations() const { return evaluations_; }
  std::vector<FitSample> take_samples(); // by cost

private:
  void choose_targets();
  bool asks_for_life() const;
  std::optional<Eigen::VectorXd> rows(const Eigen::VectorXd& u, bool sides);
  void add_rows(const Outcome& outcome, const Eigen::VectorXd& values,
                std::vector<double>& r) const;
  bool add_stiffness(const Case& design, Outcome& outcome) const; // false: there is none
  bool is_refused(const Eigen::VectorXd& values) const;
  bool friction_alone() const;
  Results results_of(const Case& design) const;
  bool is_curve(const std::string& name) const;
  // Names of what the model gives are added to `known`.
  void choose_rows(const Results& results, std::string& known);
  void choose_stiffness(const Case& start, std::string& known);
  void choose_responses(const Results& results, std::string& known);
  void add_curve(const FrfSet& set, std::size_t reference, std::size_t response,
                 const std::vector<FrfSet>& simulated, std::string& known);
  void choose_goals(const Case& start, const Results& results);
  void require_targets() const;
  void choose_analyses(const Case& start, const Results& results);
  void scale_constraints(const Case& start, const Results& results);
  void remember(FitSample sample);

  const FitRequest& request_;
  const TestData& test_;
  const Measured& measured_;
  Case whole_, case_; // as given, and what of it is computed
  std::function<bool(const Case&)> refused_;
  FitBodies bodies_;
  // Where friction alone changes and no target feels it but the levels: what does not change.
  std::optional<FrictionResponses> friction_;
  Results unchanged_;
  std::vector<Target> targets_;
  std::vector<Curve> curves_;
  std::vector<FitStiffness> stiffness_;
  std::vector<Aim> aims_;
  std::vector<double> constraint_scale_; // size of its terms at the start
  std::vector<FitSample> samples_;       // the first 20,000
  std::atomic<int> evaluations_{0};
  std::mutex mutex_;
};

// In standard deviations; the parameter has a prior.
double prior_residual(const FitParameter& parameter, double value);

// Share by which a constraint is broken that costs one standard deviation.
constexpr double constraint_width = 1e-3;

} // namespace plica
