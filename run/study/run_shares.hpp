// How much of the work of a run is done as its stages begin, as far as it can be foretold: the time
// of a stage beside that of the others was measured (run_shares.cpp). Within a stage nothing is
// known, but how far a state is loaded.
#pragma once

#include "model/description/case.hpp"
#include "run/stages.hpp"

#include <vector>

namespace plica {

class RunShares {
public:
  explicit RunShares(const Case& data);

  // Share that is done when a stage of `run()` begins, 0 to 1; it does not fall. Of a stage that is
  // not known it is that of the last one.
  double at(const Stage& stage);

private:
  enum class Route { by_symmetry, reduced, full };
  double before(std::size_t stage) const; // work of the stages ahead of it

  std::vector<double> times_; // of each stage how often it comes
  Route route_ = Route::by_symmetry;
  int level_runs_ = 0; // of levels that began
  double share_ = 0;
};

} // namespace plica
