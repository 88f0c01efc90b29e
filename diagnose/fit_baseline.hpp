// The nominal case adjusted to the baseline before the change is looked at.
#pragma once

#include "compare/fit/fit.hpp"
#include "diagnose/readings/reading.hpp"
#include "model/description/case_edit.hpp"

namespace plica {

struct FittedBaseline {
  Case data;
  std::vector<std::string> words; // what was adjusted, a line each
  CaseEdits edits;                // the same as a case says it
};

// By the section `fit` of the case, to what was measured in baselines that differ from the case by
// no known change. Throws InputError where there is no such section or baseline, std::
// invalid_argument where there is nothing to fit.
FittedBaseline fitted_to_baseline(const Case& data, const TestData& test,
                                  const FitSettings& settings);

} // namespace plica
