// What a hypothesis leaves of the readings.
#pragma once

#include "diagnose/weigh/whitening.hpp"

namespace plica {

// What all fits of one test share.
struct FitContext {
  PredictorStore& predictors;
  const TestReadings& test;
  const Uncertainty& uncertainty;
  const Eigen::VectorXd& measured; // log readings
  const Whitening& fitted;
};

// What a hypothesis leaves of the readings: test less prediction, corrected for mesh and bias.
class Deviation {
public:
  Deviation(const FitContext& context, const std::vector<const Hypothesis*>& together);

  // At coordinates of the parameters. None: no stable structure. Readings that the model does not
  // give, or that were not asked for, are far off.
  std::optional<Eigen::VectorXd> at(const Eigen::VectorXd& z,
                                    Predictor::Which which = Predictor::Which::all) const;
  // The same with the further covariance there; empty = none.
  struct Widened {
    Eigen::VectorXd deviation;
    Eigen::MatrixXd further;
    double penalty = 0;                   // of ln Z, for readings that are let off
    std::vector<Eigen::Index> aside = {}; // these: they do not follow what the hypothesis changes
  };
  std::optional<Widened> widened(const Eigen::VectorXd& z, Predictor::Which which) const;
  // Further covariance where parameters have these values and the readings are predicted as `y`, no
  // reading let off.
  Eigen::MatrixXd further(const Eigen::VectorXd& values, const Answered& y,
                          Predictor::Which which) const;
  const Predictor& predictor() const { return predict_; }

private:
  Eigen::VectorXd left_by(const Answered& y) const;
  Eigen::VectorXd change_error(const Answered& y) const;
  Eigen::VectorXd let_off(const Eigen::VectorXd& error, Widened& there) const;
  Eigen::MatrixXd covariance(const Eigen::VectorXd& error, const Eigen::VectorXd& law) const;

  const FitContext& context_;
  const Predictor& predict_;
};

} // namespace plica
