// What was measured, as numbers that a model answers with the same: logarithms of mass, static
// stiffness, dynamic stiffness and its loss, frequencies, damping ratios and heights of peaks, and
// of what shows along other axes; components of mode shapes as they are.
//
// Responses enter by their strong peaks, not line by line: neighbouring lines say the same, and a
// static stiffness must not be outvoted by eight hundred of them.
#pragma once

#include "lab/measured/measured.hpp"
#include "lab/measured/test_data.hpp"

#include <array>
#include <string>
#include <vector>

namespace plica {

enum class ReadingKind {
  mass,
  stiffness,
  frequency,
  damping,
  amplitude,
  cross,
  dynamic_stiffness,
  loss,
  component
};
constexpr const char* word_of(ReadingKind kind) {
  constexpr std::array words{"mass",  "stiffness",         "frequency", "damping", "amplitude",
                             "cross", "dynamic stiffness", "loss",      "shape"};
  return words.at(static_cast<std::size_t>(kind));
}

// What a measured response is a response to: the table along an axis, or a force in a channel.
struct Input {
  int base = -1;     // 0..2 = x y z; -1: no motion of the table
  std::string force; // the channel that is driven, "mid.y"; empty: no force
  auto operator<=>(const Input&) const = default;
  bool any() const { return base >= 0 || !force.empty(); }
};

// Responses to an input, or a list of modes: at rest, or driven by a shaker to a level.
struct TestRun {
  std::string state;         // empty = the specimen as it stands
  Input input = {};          // none: modes alone
  double level = 0;          // m/s2 of the table, or at the channel that is driven; 0 = not stated
  bool by_force = false;     // the level is the force there, N
  std::string sensor;        // in whose channel along `axis` the peaks are seen; empty = not known;
                             // of modes alone: the channel that is driven
  int axis = 0;              // 0..2
  std::vector<double> peaks; // measured, Hz, increasing; zero: of a run that is planned
  bool first = false;        // they are the first peaks of the channel, whatever comes after
  std::array<double, 2> band{}; // of a response, Hz
  bool planned() const { return !peaks.empty() && peaks.front() == 0; }
  // Of a response: the peaks are seen where the input acts along, not across it.
  bool seen_along() const { return input.base < 0 || axis == input.base; }
};

// How a rig moved one end and held the other (dynamic_stiffness, loss).
struct RigRun {
  std::vector<std::string> ends = {}; // caps: which moves, which is held; none = the two
  double hertz = 0;
  bool driving_point = false; // the force at the end that moves; else at the held one
  bool storage = false;       // the real part in place of the magnitude
};

// A mode shape as it was measured, its largest component one.
struct ReadShape {
  std::vector<std::string> sensors; // of each channel
  std::vector<int> axes;            // 0..2, of the sensor
  std::vector<double> values;
};

struct Reading {
  ReadingKind kind = ReadingKind::frequency;
  std::string name, unit, entry; // entry: path in measured.yaml, "frf[3]"
  std::string state;
  int run = -1;         // mass, stiffness: none
  int peak = 0;         // of the run
  int mode = -1;        // that the peak is of, where forces at several places show it; numbered
  int at_run = -1;      // cross: at the first peak of that run, whose base is the axis, and over it
  bool highest = false; // cross: wherever in the band it is highest
  std::string sensor;   // amplitude, cross
  int axis = 0;         // of the response; of a rig 0..5 = x y z rx ry rz
  StaticDirection direction = StaticDirection::axial; // stiffness
  double stroke = 0;    // stiffness: m or rad; 0 = not stated. Of a rig the amplitude; 0 = small
  bool tangent = false; // stiffness: how the force grows at the stroke, not the force over it
  RigRun rig = {};
  int of_shape = -1, channel = 0;             // component: of which of TestReadings::shapes
  MeasuredShape shape = MeasuredShape::other; // of a mode without excitation
  int order = 0;                              // of that mode
  double value = 0, log_value = 0; // measured, in `unit`; of a component both are its value
  // Hz, of a mode without excitation: what chooses its mode; 0 = its value, which is a frequency.
  double paired_as = 0;
  double sigma = 0;     // of `log_value`, of the measurement
  bool assumed = false; // sigma: the test states none
  bool held_out = false;
};

inline bool is_of_rig(const Reading& r) {
  return r.kind == ReadingKind::dynamic_stiffness || r.kind == ReadingKind::loss;
}

struct TestReadings {
  std::vector<TestRun> runs;
  std::vector<Reading> readings;
  std::vector<ReadShape> shapes = {};
  std::vector<std::string> warnings;
  double level_sigma = 0; // relative, of the level of each run
};

// What a cross response adds to before the logarithm: below a fiftieth of the main motion it is
// noise.
constexpr double cross_floor = 0.02;
// The response without it.
double cross_value(double log_reading);
// "base y", "force at mid.y"; empty for none.
std::string word_of(const Input& input);
// The mode that a reading without excitation is of: "transverse mode 2 in z".
std::string mode_name(const Reading& reading);
// In its unit, what its logarithm stands for.
double value_of(const Reading& reading, double log_value);
// How well a component of a mode shape is measured, of the largest.
constexpr double shape_sigma = 0.03;
// How far from a peak a cross response is looked for, relative.
constexpr double cross_window = 0.12;
// The same where the other axis resonates.
constexpr double resonance_window = 0.02;

} // namespace plica
