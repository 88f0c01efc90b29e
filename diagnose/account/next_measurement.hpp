// Which measurement would change the ledger most.
//
// What explains the gap is open: which set of effects, and their numbers. Draws of both give shares
// s of the ledger and readings y of what could be measured, with weights. Shares follow readings,
// in the mean, by C_sy (C_yy + R)^-1, R of the usual scatter of such readings, so that the
// measurement is expected to move the shares by
//   change^2 = trace C_sy (C_yy + R)^-1 C_ys
// and the best is that of the largest change per cost, over a menu: static directions and axes of
// the table that were left out, a lower and a higher level, further sensors on held ends and along
// the parts; what cannot be computed stands in the look-alikes of the effects.
//
// Beside it, how far apart it puts two sets at their best numbers, in squared standard deviations.
#pragma once

#include "diagnose/account/ledger.hpp"
#include "diagnose/predict/menu.hpp"

namespace plica {

struct RivalSet {
  std::vector<const Hypothesis*> together; // none: the nominal case
  Eigen::VectorXd values;                  // at its optimum
  double probability = 0;
  ShareDraws draws;
};

// Of the menu, the best first, at most eight; those that change nothing are left out.
std::vector<ProposedMeasurement> next_measurements(const Nominal& nominal,
                                                   const OfferedReadings& menu,
                                                   const std::vector<RivalSet>& rivals,
                                                   const std::shared_ptr<StateModels>& models);

} // namespace plica
