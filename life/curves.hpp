// Fatigue curves: how many cycles of a stress range a wall bears. Stress in Pa, lives in cycles.
//
// A curve says nothing beyond the range it was made for: there a life is "at least" the largest or
// "at most" the smallest number of cycles of the curve, and says so.
#pragma once

#include "life/published_curves.hpp"
#include "words/input_error.hpp"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace plica {

enum class Bound { exact, at_least, at_most };

struct CurveLife {
  double cycles = 0; // infinite below a fatigue limit
  Bound bound = Bound::exact;
};

struct StressCycle {
  double range = 0, mean = 0; // range >= 0
};

// As-formed bellows of austenitic steel without reinforcement: ASME VIII-2 (2010) table 4.19.5,
// from the fatigue tests of EJMA. With S = Kg (E0 / Eb) St in MPa, St the total stress range:
//   S >= 448         N = (35850 / (S - 264))^2
//   257.2 < S < 448  N = (46200 / (S - 211))^2
//   S <= 257.2       N = 10^6, which is as far as it was made for: at least
// A factor of 3 on cycles and of 1.25 on stress is inside, none is to be added. It has no mean
// stress. The table states no upper end; less than one cycle is at most one.
struct BellowsCurve {
  static constexpr double factor_on_cycles = 3, factor_on_stress = 1.25;
  static constexpr double most = 1e6;

  double Kg = 1;      // fatigue strength reduction by notches and welds, 1 to 4
  double E_ratio = 1; // E0 / Eb, modulus at room temperature over that of operation
};

// Basquin: N = knee_cycles (knee_amplitude / Sa)^slope above the knee; below it the second slope,
// or none: a fatigue limit, infinite life.
struct StressLifeCurve {
  double knee_amplitude = 0, knee_cycles = 0, slope = 0;
  std::optional<double> second_slope = {};
  std::optional<double> fewest = {}; // cycles down to which it was made; none = not stated
};

// Coffin-Manson with the mean stress of Smith, Watson and Topper (J. Materials 5, 1970), 2N
// reversals:
//   s_max e_a = sf^2/E (2N)^(2b) + sf ef (2N)^(b+c)
// A cycle of elastic stress is taken as one of strain, e_a = range / 2E, as in a wall that is moved
// and not loaded; s_max = mean + s_a with s_a on the cyclic curve e_a = s_a/E + (s_a/K')^(1/n'),
// n' = b/c, K' = sf / ef^n', so that without a mean e_a = sf/E (2N)^b + ef (2N)^c exactly.
// s_max <= 0: no damage, infinite life.
struct StrainLifeCurve {
  double E = 0;
  double sf = 0, b = 0; // fatigue strength coefficient, Pa, and exponent, < 0
  double ef = 0, c = 0; // fatigue ductility coefficient and exponent, < 0
};

// Pairs of cycles and amplitude, joined by straight lines in a log-log plot.
struct TableCurve {
  std::vector<std::array<double, 2>> points; // N increasing, amplitude in Pa decreasing
};

// A curve that is at hand with its source (life/published_curves.hpp): the mean of tests with its
// scatter, or a design curve of a code with its margins, which has a mean stress inside as well. A
// cycle of elastic stress counts as one of strain, amplitude / E. Outside of its range a life is a
// bound.
struct PublishedCurve {
  PublishedSteel of = PublishedSteel::pipe_304L;
  double E = 0; // of the wall whose stress it is, Pa
};

using FatigueLaw =
    std::variant<BellowsCurve, StressLifeCurve, StrainLifeCurve, TableCurve, PublishedCurve>;

// What a mean stress does to the amplitude of stress-life curves, tables and published curves,
// which are for zero mean (but published design curves). Goodman: Sa / (1 - Sm / Su), Sm < 0 counts
// as 0; Sm >= Su: no cycle is borne. Smith, Watson and Topper: sqrt(Sa (Sm + Sa)); 0 without
// tension.
enum class MeanStress { none, goodman, smith_watson_topper };

struct FatigueCurve {
  std::string name, source; // of its numbers, printed beside every life
  FatigueLaw law;
  MeanStress mean_stress = MeanStress::none; // of laws over the stress amplitude
  double ultimate = 0;                       // Su, Pa, for Goodman
  double temperature_factor = 1;             // strength in operation over that of the curve
};

// Everything that is wrong with it, by the keys above; empty = good. life() takes good ones only.
std::vector<InputProblem> check(const FatigueCurve& curve);

// Throws std::invalid_argument for a range below zero or a number that is not finite.
CurveLife life(const FatigueCurve& curve, const StressCycle& cycle);

// A design curve: what it allows has margins inside, and no scatter belongs to it.
bool is_design(const FatigueCurve& curve);

// Standard deviation of log10 of the cycles that comes with a published curve; none: its law has
// none of its own.
std::optional<double> deviation_of(const FatigueCurve& curve);

// "3 on cycles and 1.25 on stress are inside", "no factors are inside, ...": with its source.
std::string what_is_inside(const FatigueCurve& curve);

// "5258", "at least 1000000", "unlimited", as a table shows it.
std::string text_of(const CurveLife& life);

// The cyclic stress amplitude of a strain amplitude, Pa.
double cyclic_stress(const StrainLifeCurve& curve, double strain_amplitude);

// Amplitude without mean that a cycle counts as, Pa; infinite where Goodman bears no cycle.
double equivalent_amplitude(const FatigueCurve& curve, const StressCycle& cycle);

} // namespace plica
