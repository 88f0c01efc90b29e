// The commands of plica. Each returns the exit code: 0 good, 2 a numerical verdict failed; user
// errors are thrown as InputError (exit code 1).
#pragma once

#include "lab/signals/frf_estimate.hpp"
#include "lab/identification/identify.hpp"
#include "diagnose/pretest.hpp"
#include "lab/signals/sine_tracking.hpp"
#include "io/write/write_superelement.hpp"

#include <filesystem>
#include <string>

namespace plica {

struct RunOptions {
  std::string case_path;
  std::string model; // one of the models of the case; empty = its parts
  std::filesystem::path out = "out";
  int threads = 0; // 0 = all cores
  bool quiet = false;
  std::vector<std::string> geometry; // formats to write the part in, of geometry_formats()
  std::string deck;                  // abaqus or nastran: the model for another solver
  bool variants = true;
  bool error_bars = true;
};

int run_command(const RunOptions& options);
int benchmark_command(const RunOptions& options); // of a file with a `benchmark` key

// A folder stands for the file in it that has its name.
std::string case_file_of(const std::string& path);

struct ReduceOptions {
  std::string case_path;
  std::string model; // as for a run
  std::filesystem::path out = "out";
  int threads = 0;
  bool quiet = false;
  ReduceRequest request;
  Units units = Units::metres;
  bool beam = false; // equivalent pipe and connectors besides
};

int reduce_command(const ReduceOptions& options);

struct IdentifyOptions {
  std::vector<std::string> files; // one measured.yaml, or files of frequency responses
  std::filesystem::path out = "out";
  bool quiet = false;
  IdentifySettings settings;
  std::optional<FrfQuantity> quantity; // of bare files; none = as they say, or accelerance
  WelchSettings welch{.block = 0};     // by the length of the record
  FrfEstimator estimator = FrfEstimator::H1;
  SineTracking tracking;
};

int identify_command(const IdentifyOptions& options);

struct CompareOptions {
  std::string result, measured; // each a measured.yaml or a folder of results
  std::filesystem::path out = "out";
  bool quiet = false;
};

int compare_command(const CompareOptions& options);

struct FitOptions {
  std::string case_path;
  std::string model;    // as for a run
  std::string measured; // in place of the file the case names
  std::string restart;  // fit.json of an earlier fit; empty = none
  std::filesystem::path out = "out";
  int threads = 0;
  bool quiet = false;
  std::optional<FitSearch> search;
  std::optional<int> evaluations;
  unsigned seed = 1;
};

int fit_command(const FitOptions& options);

struct DiagnoseOptions {
  std::string case_path;
  std::string model;                // as for a run
  std::string measured;             // folder with a measured.yaml, or that file
  std::vector<std::string> without; // guards left out, for ablations
  std::filesystem::path out = "out";
  int threads = 0;
  bool quiet = false;
  bool plan_next = true;
  bool pretest = false; // what a planned test could tell, before it is made
  TestPlan plan;
};

int diagnose_command(const DiagnoseOptions& options);

struct CheckOptions {
  std::string case_path;
  std::string model; // as for a run
  int threads = 0;
};

int check_command(const CheckOptions& options);

// Writes a commented case file; a name without extension gets .yaml. Throws InputError for a file
// that is there and for a name that no case can have.
int init_command(const std::filesystem::path& file);

// Of case, measured or benchmark files; `reference`: in Markdown.
int schema_command(const std::string& what, bool reference);

} // namespace plica
