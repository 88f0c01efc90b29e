// What the readings of a test would be if hypotheses held: logarithms, in their order.
#pragma once

#include "diagnose/predict/state_answers.hpp"

#include <map>
#include <mutex>
#include <tuple>

namespace plica {

// Of hypotheses that act together. What is kept is known by them: an address may be that of another
// one later.
using Identities = std::vector<std::uint64_t>;
Identities identities_of(const std::vector<const Hypothesis*>& together);

// States of the specimen reduced with hypotheses in them, each when first asked for: those held out
// are for few hypotheses. Changes that are costly to prepare are kept. May be used by several
// threads.
class StateModels {
public:
  explicit StateModels(const Nominal& nominal) : nominal_(nominal) {}
  using Together = std::vector<const Hypothesis*>;
  const StateModel& of(std::size_t state, const Together& together);
  std::vector<PreparedChange> changes(std::size_t state, const Together& together);

  // Makes a state with each of these alone in it, which takes less time for several at once.
  void reduce(std::size_t state, const Together& each);
  // Prepares what these change in a state and keeps it, for hypotheses that will be taken together
  // with others.
  void keep(std::size_t state, const Together& each);
  // From here on sets hold what their members do to each other (products); a search, which has to
  // tell thousands of sets apart, goes without. What was reduced of sets before is forgotten.
  void solve_anew();
  // What was reduced of sets; no thread may be using it.
  void forget_sets();
  // States in which something was measured that is fitted.
  std::vector<std::size_t> fitted_states(const TestReadings& test) const;

private:
  struct Lazy {
    std::once_flag once;
    StateModel model;
  };
  using Changes = std::vector<PreparedChange>;
  std::optional<Changes> kept(std::size_t state, const Hypothesis& h);
  Changes prepared(std::size_t state, const Hypothesis& h);
  // Of two hypotheses; `a_first`: where the changes of each stand among those of the set.
  Changes products(std::size_t state, const Hypothesis& a, const Changes& of_a, int a_first,
                   const Hypothesis& b, const Changes& of_b, int b_first);
  Lazy& lazy(std::size_t state, const Together& together);
  void make(std::size_t state, const Together& together, const Changes& changes, StateModel& own);

  const Nominal& nominal_;
  std::mutex mutex_;
  std::map<std::pair<std::size_t, std::uint64_t>, Changes> kept_; // by state and hypothesis
  std::map<std::pair<std::size_t, Identities>, Lazy> known_;
  bool solves_anew_ = false;
  // Of pairs of hypotheses, their factors numbered among the changes of each.
  std::map<std::tuple<std::size_t, std::uint64_t, std::uint64_t>, Changes> products_;
};

// What readings would be.
struct Answered {
  Eigen::VectorXd log; // not a number: the model does not give it, or it was not asked for
  // Of readings along other axes (others: zero), what the errors of any test add to their squares:
  // columns a sensor turned by a radian about each axis, a table that moves across as along.
  Eigen::MatrixX2d across;
};

class Predictor {
public:
  // The hypotheses act together; at most one of them softens. `models`: of the same nominal case,
  // shared with other tests; none = its own.
  Predictor(const Nominal& nominal, const TestReadings& test,
            const std::vector<const Hypothesis*>& together,
            std::shared_ptr<StateModels> models = nullptr);

  int parameters() const { return parameters_; }
  bool changes_structure() const { return changes_ > 0; }
  Eigen::VectorXd values_of(const Eigen::VectorXd& z) const;

  // None where the structure has no stable answer for these values; not a number for a reading that
  // the model does not give, or that was not asked for. May be called from several threads.
  enum class Which { all, fitted };
  std::optional<Eigen::VectorXd> operator()(const Eigen::VectorXd& values,
                                            Which which = Which::all) const;
  std::optional<Answered> answered(const Eigen::VectorXd& values, Which which = Which::all) const;

  // How far off the law of what slips may put each log reading `y`; empty where nothing slips.
  Eigen::VectorXd law_error(const Eigen::VectorXd& values, const Eigen::VectorXd& y,
                            Which which = Which::all) const;

  // Largest error that the reduction may leave in the lowest frequencies of the specimen as it
  // stands, relative (ParametricModel::frequency_errors).
  double basis_error(const Eigen::VectorXd& values) const;

  // Of the specimen as it stands, nothing slipping: its modes, none where it is not stable, and the
  // coordinates of ParametricModel::basis that its mount leaves.
  std::optional<AffineModes> modes(const Eigen::VectorXd& values) const;
  const std::vector<int>& coordinates() const { return model(0).coordinates; }

  // Of each reading, the number of the nominal mode that the mode is like which it is of; -1 =
  // none.
  std::vector<int> nominal_modes(const Eigen::VectorXd& values = {}) const;

  // The response of a channel to a run, at frequencies of one's own (linear hypotheses), per unit
  // of the input: for pictures.
  std::optional<Eigen::VectorXcd> response(const Eigen::VectorXd& values, const TestRun& run,
                                           const Eigen::VectorXd& hertz) const;

private:
  const StateModel& model(std::size_t state) const { return models_->of(state, together_); }
  StateAnswers answers_of(std::size_t state, const Acting& acting) const;
  Acting acting(const Eigen::VectorXd& values, std::size_t state) const;
  enum class Slip { as_is, stuck };
  enum class Across { left_out, asked };
  std::optional<Answered> answers(const Eigen::VectorXd& values, Slip slip, Which which,
                                  Across across) const;

  const Nominal& nominal_;
  const TestReadings& test_;
  std::vector<const Hypothesis*> together_;
  std::shared_ptr<StateModels> models_;
  std::vector<Eigen::Index> seen_; // of each state: observed places up to the last of the test
  std::vector<std::size_t> state_of_reading_;
  int parameters_ = 0, changes_ = 0;
  int softening_ = -1; // which hypothesis
  SlipGroup group_;    // its
};

// Predictors of one test, each made once. May be used by several threads.
class PredictorStore {
public:
  PredictorStore(const Nominal& nominal, const TestReadings& test)
      : nominal_(nominal), test_(test), models_(std::make_shared<StateModels>(nominal)) {}
  const Predictor& of(const std::vector<const Hypothesis*>& together);
  const std::shared_ptr<StateModels>& models() const { return models_; }
  // As StateModels does; predictors of sets that were handed out are gone.
  void solve_anew();
  void forget_sets();

private:
  const Nominal& nominal_;
  const TestReadings& test_;
  std::mutex mutex_;
  std::shared_ptr<StateModels> models_;
  std::map<Identities, std::unique_ptr<Predictor>> known_;
};

} // namespace plica
