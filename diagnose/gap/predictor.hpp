// What the readings of a test would be if hypotheses held: logarithms, in their order.
//
// Linear hypotheses: modes of the reduced model, peaks where their sum is largest. A group of
// springs that slips: at each level and peak the amplitude is sought at which the stiffness that
// the sliders keep (describing function, one for the whole group, over the stretch of its energy)
// gives a resonance of that amplitude, with the damping that they take.
#pragma once

#include "diagnose/gap/nominal.hpp"

#include <map>
#include <mutex>

namespace plica {

std::vector<PreparedChange> prepared_changes(const NominalState& state, const Hypothesis& h);

// Changes that are costly to prepare, kept. May be used by several threads.
class PreparedChanges {
public:
  std::vector<PreparedChange> of(const NominalState& state, const Hypothesis& h);

private:
  std::mutex mutex_;
  std::map<std::pair<const NominalState*, const Hypothesis*>, std::vector<PreparedChange>> known_;
};

class Predictor {
public:
  // The hypotheses act together; at most one of them softens.
  Predictor(const Nominal& nominal, const TestReadings& test,
            const std::vector<const Hypothesis*>& together, PreparedChanges* prepared = nullptr);

  int parameters() const { return parameters_; }
  Eigen::VectorXd values_of(const Eigen::VectorXd& z) const;

  // None where the structure has no stable answer for these values; not a number for a reading that
  // the model does not give, and for those held out where only the fitted ones are wanted. May be
  // called from several threads.
  std::optional<Eigen::VectorXd> operator()(const Eigen::VectorXd& values,
                                            bool fitted_only = false) const;

  // Of each reading in the nominal case, the number of the nominal mode it is of; -1 = none.
  std::vector<int> nominal_modes() const;

  // The response of a channel to a run, at frequencies of one's own (linear hypotheses), per unit
  // of the base: for pictures.
  std::optional<Eigen::VectorXcd> response(const Eigen::VectorXd& values, const TestRun& run,
                                           const Eigen::VectorXd& hertz) const;

private:
  struct StateFamily {
    const NominalState* nominal = nullptr;
    ReducedFamily family;
    std::vector<int> free; // coordinates that the mount leaves
  };
  struct Coefficients {
    Eigen::VectorXd all, rig;
  };
  Coefficients coefficients(const Eigen::VectorXd& values) const;
  TestSetup setup(const Eigen::VectorXd& values) const;

  const TestReadings& test_;
  std::vector<const Hypothesis*> together_;
  std::vector<StateFamily> states_;
  std::vector<int> state_of_reading_;
  int parameters_ = 0;
  int softening_ = -1;   // which hypothesis
  int first_change_ = 0; // of it, among all changes

  friend class StateAnswers;
};

// Predictors of one test, each made once. May be used by several threads.
class PredictorStore {
public:
  PredictorStore(const Nominal& nominal, const TestReadings& test)
      : nominal_(nominal), test_(test) {}
  const Predictor& of(const std::vector<const Hypothesis*>& together);

private:
  const Nominal& nominal_;
  const TestReadings& test_;
  std::mutex mutex_;
  PreparedChanges prepared_;
  std::map<std::vector<const Hypothesis*>, std::unique_ptr<Predictor>> known_;
};

} // namespace plica
