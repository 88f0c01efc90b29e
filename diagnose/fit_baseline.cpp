#include "diagnose/fit_baseline.hpp"

#include "diagnose/effects/take_over.hpp"
#include "lab/measured/entries.hpp"
#include "lab/measured/states.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace plica {

FittedBaseline fitted_to_baseline(const Case& data, const TestData& test,
                                  const FitSettings& settings) {
  const auto refuse = [](const std::string& wrong, const std::string& allowed) {
    throw InputError({{.file = "",
                       .line = 0,
                       .key = "diagnose.fit_baseline",
                       .wrong = wrong,
                       .allowed = allowed}});
  };
  if (!data.fit)
    refuse("needs a section `fit`", "fit: {parameters: [{path: ..., bounds: [..., ...]}]}");
  if (std::none_of(test.data.states.begin(), test.data.states.end(),
                   [](const MeasuredState& s) { return s.baseline && s.set.empty(); }))
    refuse("needs a baseline that differs from the case by no known change",
           "states: [{name: before, baseline: true}] in the measured data");
  TestData baseline{.data = test.data, .responses = {}};
  for (std::size_t i = 0; i < test.data.frf.size(); ++i)
    if (as_drawn(test.data, test.data.frf[i].state) &&
        !is_held_out(test.data, entry_name("frf", i)))
      baseline.responses.push_back(test.responses[i]);
  const FitResult fit = fit_case(data, *data.fit, baseline, settings);
  Eigen::VectorXd values(Eigen::Index(fit.parameters.size()));
  FittedBaseline result;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const FittedParameter& p = fit.parameters[i];
    values[Eigen::Index(i)] = p.value;
    result.words.push_back(fmt::format("fitted to the baseline: {} from {:.4g} to {:.4g} (SI){}",
                                       p.path, p.start, p.value, p.at_bound ? ", at a bound" : ""));
  }
  for (const FittedParameter& p : fit.parameters) {
    result.edits.push_back({p.path, yaml_of(p.value)});
    for (const std::string& also : p.also) result.edits.push_back({also, yaml_of(p.value)});
  }
  for (const auto& [path, value, unit] : fit.ties) result.edits.push_back({path, yaml_of(value)});
  if (!fit.converged) result.words.push_back("the fit to the baseline ended early: " + fit.reason);
  result.data = with_design(data, *data.fit, values);
  return result;
}

} // namespace plica
