// The case with the effects in it that a diagnosis names: `plica diagnose --add`.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "io/input/case_file.hpp"

namespace plica {

struct ExplainedCase {
  Case data;
  std::string text;                      // of explained.yaml
  std::vector<std::string> in, left_out; // effects, what no key of a case says among the latter
};

// `fitted`: what was adjusted before. Of effects or sets that the test cannot tell apart the first
// is taken. The text stands for a file in `folder`, held against `measured`. None in it where none
// is named.
ExplainedCase explained_case(const CaseFile& file, const CaseEdits& fitted, const Diagnosis& d,
                             const std::filesystem::path& measured,
                             const std::filesystem::path& folder);

} // namespace plica
