#include "diagnose/readings/repeats.hpp"

#include <array>
#include <cmath>
#include <fmt/printf.h>
#include <map>
#include <tuple>

namespace plica {

void widen_by_repeats(TestReadings& test) {
  for (const auto& [kind, name] : {std::pair{ReadingKind::frequency, "frequency"},
                                   std::pair{ReadingKind::damping, "damping"}}) {
    std::map<std::tuple<std::string, Input, int, double, int>, std::vector<double>> groups;
    for (const Reading& r : test.readings) {
      if (r.kind != kind || r.run < 0 || !test.runs[std::size_t(r.run)].input.any()) continue;
      const TestRun& run = test.runs[std::size_t(r.run)];
      groups[{r.state, run.input, run.axis, run.level, r.peak}].push_back(r.log_value);
    }
    double sum = 0;
    std::size_t freedom = 0;
    for (const auto& [of, values] : groups) {
      double mean = 0;
      for (double v : values) mean += v / double(values.size());
      for (double v : values) sum += (v - mean) * (v - mean);
      freedom += values.size() - 1;
    }
    if (freedom == 0) continue;
    const double sigma = std::sqrt(sum / double(freedom));
    double assumed = 0;
    for (Reading& r : test.readings)
      if (r.kind == kind && r.assumed && r.sigma < sigma) {
        assumed = r.sigma;
        r.sigma = sigma;
      }
    if (assumed == 0) continue;
    const std::string text = fmt::sprintf(
        "repeated measurements of a %s scatter by %.2g %% (standard deviation) where %.2g "
        "%% was assumed: taken for all that state none",
        name, 100 * sigma, 100 * assumed);
    test.warnings.emplace_back(text);
  }
}

} // namespace plica
