// Truth and diagnosis of each specimen side by side.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sealed {

struct Scored {
  std::string id, kind, cls, verdict; // verdict "missing" without a diagnosis
  nlohmann::json truth, diagnosis;
  std::vector<std::string> named; // effects of the diagnosis
  double seconds = 0;
  bool is_detectable = false; // as the diagnosis itself declared; else medium and strong
};

std::vector<Scored> read_verdicts(const std::filesystem::path& truth,
                                  const std::filesystem::path& out);

bool names(const Scored& s, const std::string& effect);
std::string true_effect(const Scored& s, std::size_t k = 0); // empty: none
std::string true_place(const Scored& s);

// Cosine that the diagnosis declared between two effects (by name), 0 = not declared.
double declared_cosine(const Scored& s, const std::string& a, const std::string& b);
// The place is right, or declared equivalent to the right one.
bool place_is_right(const Scored& s);
// The same of any effect that is said.
bool says_place(const Scored& s, const nlohmann::json& said, const std::string& truth);

// A number deep in the diagnosis, NaN when it is not there.
double number_at(const nlohmann::json& object, const std::string& pointer);

} // namespace sealed
