#include "model/case.hpp"

#include <algorithm>

namespace plica {

bool is_on_axis(const BeamPart& beam) {
  return std::all_of(beam.points.begin(), beam.points.end(),
                     [](const Triple& p) { return p[0] == 0 && p[2] == 0; });
}

double reduction_cutoff(const Analyses& analyses) {
  if (analyses.reduction && analyses.reduction->cutoff > 0) return analyses.reduction->cutoff;
  double highest = 0;
  if (analyses.response) highest = analyses.response->band[1];
  if (analyses.modes) highest = std::max(highest, analyses.modes->band[1]);
  return highest > 0 ? 2 * highest : 1000;
}

} // namespace plica
