// Pieces of the report of a diagnosis; each is empty when there is nothing to show.
#pragma once

#include "diagnose/results/diagnosis.hpp"
#include "io/tables/text.hpp"

#include <array>
#include <optional>
#include <string>

namespace plica {

std::string place_html(const Diagnosis& d);      // the part; on it, what has a place there
std::string blocks_html(const Diagnosis& d);     // heat maps, direction and band against level
std::string components_html(const Diagnosis& d); // bars
std::string trends_html(const Diagnosis& d);     // slopes over the level, drift of parameters

std::string hypotheses_html(const Diagnosis& d);
std::string probabilities_html(const Diagnosis& d);
std::string compensators_html(const Diagnosis& d);

std::string ledger_html(const Diagnosis& d); // what the gap is made of, as a waterfall, in words
std::string shrink_html(const Diagnosis& d); // table
std::string readings_html(const Diagnosis& d);
std::string baseline_html(const Diagnosis& d); // before the change, beside the model
std::string overlays_html(const Diagnosis& d);
std::string posteriors_html(const Diagnosis& d);

std::string likeness_html(const Diagnosis& d);
std::string detectable_html(const Diagnosis& d);
std::string next_html(const Diagnosis& d);

// "0.42 (0.38 to 0.47) kN/m" (estimate_words)
std::string estimate_html(const EstimatedParameter& parameter);

// "71 to 84 %" of a share.
std::string percent_range(const std::array<double, 2>& share);

// Readings whose difference is within two sigma: of the nominal case, of the best hypothesis.
std::array<int, 2> readings_within(const Diagnosis& d);

// A number on a ground that deepens with it, orange above zero and blue below: told apart by its
// sign in print, in grey and with any colour vision. `full`: where the ground is
// deepest.
std::string tinted(double value, double full, const std::string& text);

// A level bar from one value to another on a rail from `low` to `high`; `mark`: an upright line.
struct LevelBar {
  double from = 0, to = 0, low = 0, high = 1;
  std::optional<double> mark{};
  bool faint = false;
  double width = 10; // rem
};
std::string bar_svg(const LevelBar& bar);

} // namespace plica
