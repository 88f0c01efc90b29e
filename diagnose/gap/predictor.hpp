// What the readings of a test would be if hypotheses held: logarithms, in their order.
#pragma once

#include "diagnose/gap/state_answers.hpp"

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
  bool changes_structure() const { return changes_ > 0; }
  Eigen::VectorXd values_of(const Eigen::VectorXd& z) const;

  // None where the structure has no stable answer for these values; not a number for a reading that
  // the model does not give, or that was not asked for. May be called from several threads.
  enum class Which { all, fitted };
  std::optional<Eigen::VectorXd> operator()(const Eigen::VectorXd& values,
                                            Which which = Which::all) const;

  // How far off the law of what slips may put each log reading `y`; empty where nothing slips.
  Eigen::VectorXd law_error(const Eigen::VectorXd& values, const Eigen::VectorXd& y,
                            Which which = Which::all) const;

  // Largest error that the reduction may leave in the lowest frequencies of the specimen as it
  // stands, relative (ParametricModel::frequency_errors).
  double basis_error(const Eigen::VectorXd& values) const;

  // Of the specimen as it stands, nothing slipping: its modes, none where it is not stable, and the
  // coordinates of ParametricModel::basis that its mount leaves.
  std::optional<FamilyModes> modes(const Eigen::VectorXd& values) const;
  const std::vector<int>& coordinates() const { return family(0).coordinates; }

  // Of each reading in the nominal case, the number of the nominal mode it is of; -1 = none.
  std::vector<int> nominal_modes() const;

  // The response of a channel to a run, at frequencies of one's own (linear hypotheses), per unit
  // of the base: for pictures.
  std::optional<Eigen::VectorXcd> response(const Eigen::VectorXd& values, const TestRun& run,
                                           const Eigen::VectorXd& hertz) const;

private:
  struct Lazy {
    std::once_flag once;
    StateFamily family;
  };
  const StateFamily& family(std::size_t state) const;
  void make(std::size_t state, StateFamily& own) const;
  std::vector<PreparedChange> changes_of(const NominalState& state) const;
  Acting acting(const Eigen::VectorXd& values) const;
  std::optional<Eigen::VectorXd> answers(const Acting& acting, Which which) const;

  const Nominal& nominal_;
  const TestReadings& test_;
  PreparedChanges* prepared_;
  std::vector<const Hypothesis*> together_;
  mutable std::vector<Lazy> states_;
  std::vector<std::size_t> state_of_reading_;
  int parameters_ = 0, changes_ = 0;
  int softening_ = -1; // which hypothesis
  SlipGroup group_;    // its
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
