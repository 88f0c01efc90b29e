// Files of the truth, apart from the data.
#pragma once

#include "specimen.hpp"

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

namespace sealed {

nlohmann::json truth_of(const Specimen& s, const std::map<std::string, double>& found);

// Makes walls, data and truth on two threads at most; returns the fingerprint of all truth files.
std::string make_suite(const Suite& suite, const std::filesystem::path& data,
                       const std::filesystem::path& truth, int jobs);

// One specimen outside of any suite; a wall of its own is made beside the folder and removed.
struct SingleRequest {
  std::string structure, effect, strength = "strong";
  int variant = 0;
  std::uint64_t seed = 1;
  std::filesystem::path out;
};
void make_single(const SingleRequest& request);

// Prints frequencies of the healthy wall by both roads beside the case of Plica.
void check_roads(const std::filesystem::path& work);
std::string fingerprint(const std::filesystem::path& truth);

struct RunRequest {
  std::filesystem::path data, out, plica;
  int jobs = 2;
  std::string ablate; // passed on as --without
  std::string only;   // one specimen, empty = all
};
void run_suite(const RunRequest& request);

// Numbers of the specimens, in their order.
std::vector<std::string> specimens_in(const std::filesystem::path& data);
// `plica diagnose` of one of them, on one thread, into a folder made anew; its exit code. Options
// begin with a space.
int run_diagnosis(const std::filesystem::path& plica, const std::filesystem::path& data,
                  const std::string& id, const std::filesystem::path& out,
                  const std::string& options);
std::string quoted(const std::filesystem::path& path); // for a shell

// Runs work(i) for i below count; the first error stops the rest.
void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work);

struct ScoreRequest {
  std::filesystem::path data, truth, out;
  std::vector<std::string> ablations; // "form=FOLDER"
  bool require = false;
};
bool score_suite(const ScoreRequest& request);

} // namespace sealed
