#include "diagnose/account/overlays.hpp"

#include "diagnose/readings/reading_list.hpp"
#include "lab/measured/entries.hpp"
#include "lab/measured/measured_words.hpp"

#include <algorithm>

namespace plica {

using Eigen::VectorXcd;
using Eigen::VectorXd;

std::vector<OverlaidResponse> overlays_of(GapProblem& problem, const HypothesisFit& best,
                                          const HypothesisFit* second) {
  std::vector<OverlaidResponse> overlays;
  constexpr std::size_t most = 4;
  for (std::size_t i = 0; i < problem.test.responses.size(); ++i)
    for (const FrfSet& set : problem.test.responses[i]) {
      if (set.references.empty() || overlays.size() >= most) continue;
      const Reading* reading = nullptr;
      for (const Reading& r : problem.readings.readings)
        if (r.entry == entry_name("frf", i) && r.kind == ReadingKind::amplitude) {
          reading = &r;
          break;
        }
      if (!reading) continue;
      const TestRun& run = problem.readings.runs[std::size_t(reading->run)];
      const std::string channel = run.sensor + "." + axis_word(run.axis);
      const auto column = std::find(set.responses.begin(), set.responses.end(), channel);
      if (column == set.responses.end()) continue;
      OverlaidResponse o;
      o.name = where_seen(run);
      o.hertz = set.hertz;
      o.measured = acceleration_of(set, 0, column - set.responses.begin());
      const auto response_of = [&](const HypothesisFit& fit) {
        return problem.predictors->of(fit.together)
            .response(fit.values, run, set.hertz)
            .value_or(VectorXcd());
      };
      o.nominal =
          problem.predictors->of({}).response(VectorXd(), run, set.hertz).value_or(VectorXcd());
      o.best = response_of(best);
      if (second) o.second = response_of(*second);
      overlays.push_back(std::move(o));
    }
  return overlays;
}

} // namespace plica
