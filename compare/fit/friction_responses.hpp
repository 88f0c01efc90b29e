// Level sweeps of a case of which only friction changes.
#pragma once

#include "run/analyses/jointed_model.hpp"
#include "run/results/level_results.hpp"

namespace plica {

// A case of which only the laws of friction change: its reduced model is made once.
class FrictionResponses {
public:
  explicit FrictionResponses(const Case& data);

  // True when a number of the case is one of a friction law, so that the reduced model stays.
  static bool is_friction(const std::string& path);

  // The level_responses of a case that differs from the first in friction laws alone. May be called
  // from several threads.
  std::vector<LevelResponses> operator()(const Case& design) const;

private:
  JointedModel model_;
  std::vector<BuiltJoint> joints_;
};

} // namespace plica
