#include "diagnose/fit_baseline.hpp"

#include "lab/measured/states.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace plica {

FittedBaseline fitted_to_baseline(const Case& data, const DiagnosisData& test,
                                  const FitSettings& settings) {
  if (!data.fit) throw std::invalid_argument("the case has no section `fit` to fit a baseline by");
  if (!has_baseline(test.data))
    throw std::invalid_argument("no state has baseline: true, so there is no baseline to fit to");
  TestData baseline{.data = measured_as_drawn(test.data), .frfs = {}};
  for (std::size_t i = 0; i < test.data.frf.size(); ++i)
    if (as_drawn(test.data, test.data.frf[i].state))
      baseline.frfs.insert(baseline.frfs.end(), test.responses[i].begin(), test.responses[i].end());
  const FitResult fit = fit_case(data, *data.fit, baseline, settings);
  Eigen::VectorXd values(Eigen::Index(fit.parameters.size()));
  FittedBaseline result;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const FittedParameter& p = fit.parameters[i];
    values[Eigen::Index(i)] = p.value;
    result.words.push_back(fmt::format("fitted to the baseline: {} from {:.4g} to {:.4g} (SI){}",
                                       p.path, p.start, p.value, p.at_bound ? ", at a bound" : ""));
  }
  if (!fit.converged) result.words.push_back("the fit to the baseline ended early: " + fit.reason);
  result.data = with_design(data, *data.fit, values);
  return result;
}

} // namespace plica
