// What of the fatigue life is asked (analyses.hpp): a curve, how a stress of several components
// becomes one number, and what the shells bear in a life: the damages of all of it add up.
#pragma once

#include "life/curves.hpp"
#include "life/spectral.hpp"
#include "model/description/time_analyses.hpp"

#include <string_view>

namespace plica {

// Of an in-plane stress that changes:
//   critical_direction  the normal stress in the direction, out of 18 in steps of 10 degrees from
//                       that of the meridian, in which the damages of all duties add up to most
//   signed_von_mises    von Mises stress with the sign of the principal stress of larger magnitude;
//                       of a stroke, of what it changes
enum class StressMeasure { critical_direction, signed_von_mises };

// One movement of the second cap against the first, which is held: along y; across x and z with the
// end kept parallel; a turn about z and x by a moment alone; a twist about y. m and rad.
struct EndShift {
  double axial = 0, lateral_x = 0, lateral_z = 0, angular_x = 0, angular_z = 0, twist = 0;

  std::array<double, 6> all() const {
    return {axial, lateral_x, lateral_z, angular_x, angular_z, twist};
  }
};
inline constexpr std::array end_shift_names{"axial",     "lateral_x", "lateral_z",
                                            "angular_x", "angular_z", "twist"};
// Which of these; -1 = none.
int end_shift_index(std::string_view name);

struct LifeStroke {
  std::string name;
  EndShift shift;
  bool reversed = false; // from minus to plus the shift; else from rest to it
  double count = 0;      // cycles, there and back
};

// One of the signals of a history: of a component of the end's movement, or of an excitation of the
// response.
struct LifeSignal {
  std::string of;
  SampledSignal signal;
};

struct LifeHistory {
  std::string name;
  std::vector<LifeSignal> signals; // at the same times
  double repeats = 1;
};

struct LifeRandom {
  std::string name, of;
  double duration = 0; // s
  SpectralMethod method = SpectralMethod::dirlik;
};

struct LifeSweep {
  std::string name, of;
  std::optional<double> acceleration, force; // amplitude
  std::array<double, 2> band{};              // Hz
  double octaves_per_minute = 1;
  double count = 1;      // sweeps from one end of the band to the other
  bool friction = false; // by harmonic balance with the joints of the case
};

struct LifeDwell {
  std::string name, of;
  std::optional<double> acceleration, force; // amplitude
  int mode = 0;                              // at its frequency, or
  double frequency = 0;                      // Hz
  double duration = 0;                       // s, or
  double cycles = 0;
};

struct Life {
  FatigueCurve curve;
  std::optional<double> deviation; // standard deviation of log10 of the cycles, of a mean curve
  StressMeasure measure = StressMeasure::critical_direction;
  std::vector<LifeStroke> strokes;
  std::vector<LifeHistory> histories;
  std::vector<LifeRandom> random;
  std::vector<LifeSweep> sweeps;
  std::vector<LifeDwell> dwells;
};

bool moves_end(const LifeHistory& history); // else it acts by excitations
bool needs_statics(const Life& life);
bool needs_response(const Life& life);

} // namespace plica
