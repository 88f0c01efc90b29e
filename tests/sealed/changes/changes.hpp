// The suite "changes": structures whose model errs by 1 to 4 % (root mean square over the modes),
// measured before and after one change, or after none; made, and scored.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace sealed {

struct ChangesPlan {
  std::uint64_t seed = 1;
  int rounds = 16; // specimens of each structure and mechanism, six of sixteen without change
  bool thresholds = false; // of the mechanisms that choose thresholds, not of the others
};

// Returns the fingerprint of the truth.
std::string make_changes(const ChangesPlan& plan, const std::filesystem::path& data,
                         const std::filesystem::path& truth);

// Prints metrics by band of size; writes score.json beside the diagnoses. False: a diagnosis is
// missing.
bool score_changes(const std::filesystem::path& truth, const std::filesystem::path& out);

} // namespace sealed
