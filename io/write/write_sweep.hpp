// The table of a sweep: one row a variant, what it changed, what came out, or why not.
#pragma once

#include "io/files/output_folder.hpp"
#include "io/input/sweep_plan.hpp"
#include "io/write/sweep_journal.hpp"

namespace plica {

struct SweepTable {
  std::string case_name;
  SweepPlan plan;
  std::vector<std::string> results;             // asked for; none = the headline numbers
  std::vector<std::optional<SweepRecord>> rows; // per variant; none: it was not run yet
};

struct SweepCounts {
  int ok = 0, failed = 0, missing = 0;
};
SweepCounts counts_of(const SweepTable& table);

// Names of the results that any row has, those asked for first.
std::vector<std::string> results_of(const SweepTable& table);

// Columns: variant (from 1), the paths [unit], the results [unit where it is known], status (ok,
// failed or missing), reason.
std::string sweep_csv(const SweepTable& table);

// The same as one HDF5 data set a column, with attributes `unit` and `paths`; a number that is not
// there is NaN.
void write_sweep_hdf5(const SweepTable& table, const std::filesystem::path& file);

std::vector<std::string> sweep_files();
// sweep.csv, sweep.h5 and sweep.json: how many of what, and what the columns are.
void write_sweep(const SweepTable& table, OutputFolder& out);

// "sweep.csv: 9,998 variants, 2 failed", with the shards that are missing.
std::string sweep_text(const SweepTable& table, int shards);

} // namespace plica
