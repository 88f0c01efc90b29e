// The suite "sets": several effects at once, and strangers beside them; made, and scored.
#pragma once

#include "../specimen.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sealed {

struct SetsPlan {
  std::uint64_t seed = 1;
  int rounds = 20; // of 15 specimens: 3 triples, pairs, singles; 2 healthy, strangers, both
};
Suite plan_sets(const SetsPlan& plan);

// Whether readings tell two effects of a set apart, by a rule that is written down (README.md).
bool told_apart(const std::string& structure, const Effect& a, const Effect& b);
// Effects that readings may not tell from this one, by the same rule.
std::vector<std::string> alike_to(const std::string& effect);

// The true effects of a specimen as the library names them, for `plica diagnose --suppose`; none
// where its parameters cannot say them. Strangers and what the case leaves out are not among them.
std::optional<nlohmann::json> supposed(const nlohmann::json& truth);
// Those of the truth that the diagnosis could name.
nlohmann::json known_effects(const nlohmann::json& truth);

struct SupposeRequest {
  std::filesystem::path data, truth, plica, out;
  int jobs = 2;
};
// True shares of every specimen, <out>/<id>/true/supposed.json. False: some did not come.
bool suppose_sets(const SupposeRequest& request);

// Prints metrics, confusions and verdicts; writes score.json. False: a diagnosis is missing.
bool score_sets(const std::filesystem::path& truth, const std::filesystem::path& out);

} // namespace sealed
