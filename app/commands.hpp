// The commands of plica. Each returns the exit code: 0 good, 2 a numerical verdict failed; user
// errors are thrown as InputError (exit code 1).
#pragma once

#include "diagnose/frf_estimate.hpp"
#include "diagnose/identify.hpp"
#include "diagnose/sine_tracking.hpp"
#include "io/superelements/write.hpp"

#include <filesystem>
#include <string>

namespace plica {

struct RunOptions {
  std::string case_path;
  std::filesystem::path out = "out";
  int threads = 0; // 0 = all cores
  bool quiet = false;
  bool write_mesh = false; // mesh.msh beside the results
  std::string deck;        // abaqus or nastran: the model for another solver
  bool variants = true;
  bool error_bars = true;
};

int run_command(const RunOptions& options);

struct ReduceOptions {
  std::string case_path;
  std::filesystem::path out = "out";
  int threads = 0;
  bool quiet = false;
  ReduceRequest request;
  Units units = Units::metres;
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
int check_command(const std::string& case_path, int threads);
int schema_command(const std::string& what); // "case" or "measured"

} // namespace plica
