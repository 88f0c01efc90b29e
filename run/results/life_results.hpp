// Stress by places and fatigue life of a run: plain data, SI units.
#pragma once

#include "life/curves.hpp"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace plica {

enum class StressKind { state, statics, stroke, mode, harmonic, rms };
constexpr const char* word_of(StressKind kind) {
  constexpr std::array words{"state", "static", "stroke", "mode", "harmonic", "rms"};
  return words.at(static_cast<std::size_t>(kind));
}

enum class DutyKind { stroke, history, random, sweep, dwell };
constexpr const char* word_of(DutyKind kind) {
  constexpr std::array words{"stroke", "history", "random", "sweep", "dwell"};
  return words.at(static_cast<std::size_t>(kind));
}

// "bellows", "root 1"; a part without places inside it has an empty name.
struct StressPlace {
  std::string part, name;
};

// Stress at the point of a place and face where von Mises is largest, Pa. Of a wall of revolution
// along the meridian and around it; of other shells the names do not apply and both are not
// numbers. Harmonic: at the phase where von Mises is largest there. RMS: of each number by itself,
// without signs; the principal stresses of it are not numbers.
struct PlaceStress {
  int place = 0;     // in Results::places
  bool outer = true; // face: along the directors
  int ply = 0;       // from inside, of a wall whose plies slip; 0 = the wall as one
  int node = 0;
  std::array<double, 3> at{};        // m
  double von_mises = 0;              // with the sign of the principal stress of larger magnitude
  std::array<double, 2> principal{}; // the larger first
  double meridional = 0, hoop = 0;
  double meridional_membrane = 0, meridional_bending = 0; // bending: half of outer less inner
  double hoop_membrane = 0, hoop_bending = 0;
};

// Meridional stress along the wall of revolution through the hottest point of a load case.
struct MeridianStress {
  std::string part;
  Eigen::VectorXd along;                  // length of the meridian from its left end, m
  Eigen::VectorXd inner, outer, membrane; // Pa
};

struct StressTable {
  StressKind kind = StressKind::statics;
  std::string name; // as in StressResult
  std::vector<PlaceStress> rows;
  std::optional<MeridianStress> meridian;
};

// Of a random duty at its hot spot.
struct RandomStress {
  double rms = 0, up_crossings = 0, expected_peak = 0; // Pa, Hz, Pa in the duration
  std::vector<std::pair<std::string, double>> damages; // by method
  Eigen::VectorXd hertz, density;                      // Pa2/Hz
};

// One duty at the place where it does most damage, or, where it does none, stresses most.
struct DutyResult {
  DutyKind kind = DutyKind::stroke;
  std::string name, what;
  double count = 0;
  std::string unit;  // of the count: cycles | repeats | s | sweeps
  double range = 0;  // largest stress range, Pa
  double mean = 0;   // of that cycle, Pa
  int spot = 0;      // in LifeResult::spots
  double damage = 0; // of the whole count
  bool at_most = false, at_least = false;
  std::optional<CurveLife> life = {}; // of a duty of one range alone, cycles
  double cycles = 0;                  // that were counted, of a history once through
  std::optional<RandomStress> random = {};
  // 5 and 95 % by the tolerances of the case and, of a mean curve, its deviation; of `life`.
  std::optional<std::array<CurveLife, 2>> between = {};
  // The same of `damage`, which `at_most` and `at_least` bound as they bound it.
  std::optional<std::array<double, 2>> damage_between = {};
};

// The worst point of a place and face.
struct LifeSpot {
  int place = 0;
  bool outer = true;
  int node = 0;
  std::array<double, 3> at{}; // m
  double damage = 0;          // of all duties
  bool at_most = false, at_least = false;
  double direction = 0;        // critical direction from the meridian, rad; not a number: von Mises
  std::vector<double> by_duty; // damages
  std::vector<double> ranges;  // Pa
};

// Damage of all duties along the wall of revolution through the first spot, as LifeResult::inner
// and outer have it.
struct MeridianDamage {
  std::string part;
  Eigen::VectorXd along;        // length of the meridian from its left end, m
  Eigen::VectorXd inner, outer; // not a number where there is none
};

struct LifeResult {
  std::string curve;   // with its source and what is inside
  std::string measure; // in words
  bool design = false; // what the curve allows has margins inside, said in `curve`
  std::optional<double> deviation;
  bool with_tolerances = false; // the intervals have those of the case inside
  // 5 and 95 % of the damage of the first spot.
  std::optional<std::array<double, 2>> damage_between = {};
  std::vector<DutyResult> duties;
  std::vector<LifeSpot> spots;  // most damage first
  Eigen::VectorXd inner, outer; // damage per node; not a number where there is no shell
  std::optional<MeridianDamage> meridian = {};
  std::vector<std::string> warnings;
};

} // namespace plica
