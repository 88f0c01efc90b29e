// Which measurement would tell apart what still looks alike.
//
//   e* = argmax [sum_ij P_i P_j min(T_ij(e), 25) / sum_ij P_i P_j] / cost(e)
//   T_ij = sum_k ((y_i - y_j)_k / s_k)^2,   s_k the usual standard deviation of such a reading
//
// over a menu: static directions and axes of the table that were left out, a lower and a higher
// level, further sensors on held ends and along the parts, a known mass; what cannot be computed
// stands in the look-alikes of the effects.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "diagnose/weigh/evidence.hpp"

namespace plica {

struct RivalHypothesis {
  std::vector<const Hypothesis*> together;
  Eigen::VectorXd values;
  double probability = 0;
};

// Best first, at most eight; those that separate nothing are left out.
std::vector<ProposedMeasurement> next_measurements(const Case& data, const Nominal& nominal,
                                                   const Measured& measured,
                                                   const TestReadings& test,
                                                   const std::vector<RivalHypothesis>& rivals,
                                                   const std::shared_ptr<StateFamilies>& families);

} // namespace plica
