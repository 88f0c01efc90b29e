// One diagnosis of a set beside its truth.
#pragma once

#include "../verdicts.hpp"

#include <optional>

namespace sealed {

struct MarkedSet {
  std::string id, structure, kind, cls, verdict;
  bool confident = false, wrong = false; // one that is wrong is confident
  // Effects that could be named; of these, in the named set, or in one that an ambiguous answer of
  // at most three lists.
  int truths = 0, found = 0;
  bool all_named = false, first_right = false;
  bool ambiguous = false, ambiguous_right = false; // it holds the whole truth
  int shares = 0, shares_held = 0;      // true shares of effects; intervals that hold them
  std::optional<bool> unexplained = {}; // whether its interval holds the true share
  double true_unexplained = 0;
  double seconds = 0;
  std::string truth_words = {}, said_words = {}; // "added_mass@sensor.mid"; alternatives by "or"
};

// `true_shares` is supposed.json; null where there is none.
MarkedSet mark_set(const Scored& s, const nlohmann::json& true_shares);

} // namespace sealed
