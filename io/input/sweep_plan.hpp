// What a sweep varies: from the words of its options, or a table, to the values of every variant.
//
//   PATH=LOW:HIGH         a range, with units ("7mm:9mm"); of a grid also how many: LOW:HIGH:5
//   PATH=LOW:HIGH:log     evenly in the logarithm
//   PATH=A,B,C            these values, any YAML ("[0.2 mm],[0.2 mm, 0.2 mm]")
//   PATH,PATH=...         one value for several numbers
#pragma once

#include "io/input/case_file.hpp"

#include <optional>

namespace plica {

enum class SweepDesign { grid, latin, sobol };

struct SweepRequest {
  std::vector<std::string> vary; // as above
  std::string table;             // CSV: a path a column, a variant a row; in place of `vary`
  SweepDesign design = SweepDesign::grid;
  std::optional<int> count; // of latin and sobol
  unsigned seed = 1;        // of latin
};

struct SweptColumn {
  std::vector<std::string> paths;
  std::string unit;               // SI; empty where there is none
  std::vector<std::string> texts; // a variant each; empty: as the case says
  std::vector<double> numbers;    // the same in SI; empty where one is no number
};

struct SweepPlan {
  std::vector<SweptColumn> columns;
  int variants = 0;
};

// Throws InputError: words that mean nothing, a path that is not there, a range of what is no
// number.
SweepPlan sweep_plan(const CaseFile& file, const SweepRequest& request);

// What a variant, from 0, puts into the case.
Replacements changes_of(const SweepPlan& plan, int variant);

} // namespace plica
