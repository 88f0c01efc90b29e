// Measured data of one specimen: what the scale, the rig and the shaker table gave.
//
// SI units, frequencies in Hz, damping as fraction of critical, amplitudes as transmissibility
// (absolute acceleration of the sensor / base acceleration), levels in m/s2 of the base. Places and
// axes in the part frame: y along the pipe, x transverse, z vertical. `sigma` is one standard
// deviation; absent where the source gives none.
#pragma once

#include "lab/measured/frf_set.hpp"
#include "lab/measured/measured_stiffness.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace plica {

enum class Axis { x, y, z };
enum class MeasuredShape { axial, transverse, torsion, shell, other };
enum class StaticDirection { axial, transverse_x, transverse_z, bending_x, bending_z, torsion };

struct MeasuredSensor {
  std::string name;
  std::array<double, 3> at{};
  std::vector<int> axes{1, 2, 3}; // its own three axes: 1 x, 2 y, 3 z, negative = reversed
  double mass = 0;
  int node = 0; // its number in universal files; 0 = found by its name
  // What it sits on beside the part: "table", or the fixture under a mount, "mount.left", or under
  // an end that a support holds, "supports[0]"; empty = the part.
  std::string on = {};
};
inline constexpr const char* on_the_table = "table";

// A state of the specimen in which some entries were measured: "loaded", "as_delivered".
struct MeasuredState {
  std::string name;
  // What a diagnosis looks for is not there yet: the change from these states is explained.
  bool baseline = false;
  std::map<std::string, std::string>
      set;                               // a known change: path in the case, value as written there
  std::map<std::string, double> numbers; // the same in SI, once a case gives the units
};

// One weighing. `repeats` are single results; where no sigma is given it is their standard
// deviation.
struct MeasuredMass {
  double value = 0;
  std::optional<double> sigma;
  std::vector<double> repeats;
  std::string state = {}; // empty = the specimen as it stands, here and below
  // The scale did not see the sensors; once a file is read their masses are in `value`.
  bool without_sensors = false;
};

// Force over displacement at the stroke, or how it grows there.
enum class StaticSlope { secant, tangent };

struct MeasuredStatic {
  StaticDirection direction = StaticDirection::axial;
  double value = 0; // N/m; bending and torsion Nm/rad
  std::optional<double> sigma;
  std::optional<double> stroke; // m; rad for bending and torsion
  StaticSlope slope = StaticSlope::secant;
  std::vector<double> repeats;
  std::string state;
  std::string note;
};

// A mode shape at some channels, "mid.y"; complex where `imaginary` is given.
struct MeasuredVector {
  std::vector<std::string> channels;
  std::vector<double> real, imaginary;
};

struct MeasuredMode {
  double frequency = 0;
  std::optional<double> sigma, damping, sigma_damping;
  MeasuredShape shape = MeasuredShape::other;
  int order = 1;                 // which mode of that shape in its direction, from the lowest
  std::optional<Axis> direction; // in which the mode moves, where known
  std::optional<Axis> base;      // excited along
  std::optional<double> level;
  // Excited at a channel, "mid.y", in place of a table: what a controller held there, m/s2, or N.
  std::string drive;
  std::optional<double> acceleration, force;
  std::string sensor;          // at which the peak was seen; empty = not known
  std::vector<double> repeats; // of the frequency
  std::optional<MeasuredVector> vector;
  std::string state;
  std::string note;
};

// First peak against the level of excitation: lists of equal length.
struct MeasuredPeaks {
  Axis base = Axis::y;
  std::string sensor;
  Axis direction = Axis::y;                                 // of the response, in sensor axes
  std::vector<double> level, frequency, amplitude, damping; // the last two may be empty
  std::optional<double> sigma;                              // of the frequencies
  std::string state;
  std::string note;
};

// Names in a MATLAB file: the abscissa (frequency or time) and the values, one channel a column;
// fields of structures by a point.
struct MatlabVariables {
  std::string abscissa, values;
};

struct FrfSigma {
  double relative = 0; // of the magnitude
  double floor = 0;    // transmissibility
};

struct MeasuredFrf {
  std::string file; // UFF 58, CSV or MATLAB, relative to the file that names it
  std::optional<Axis> base;
  std::string force;                   // channel that was driven, "floor1.x"; either this or `base`
  std::optional<FrfQuantity> quantity; // transmissibility by the base, accelerance by a force
  std::optional<double> level;
  std::optional<FrfSigma> sigma;
  std::vector<std::string> channels; // of the columns, "-" = left out; empty = by their names
  MatlabVariables variables;
  std::string state;
};

// What drove the structure: noise or a sine that was recorded beside the responses (`reference`),
// nothing any more behind a hit, or something that nobody measured.
enum class SignalKind { random, sine, free_decay, output_only };

constexpr bool has_input(SignalKind kind) {
  return kind == SignalKind::random || kind == SignalKind::sine;
}

// Time signals of one run.
struct MeasuredSignals {
  std::string file;
  std::optional<Axis> base;          // along which the table moved
  std::string reference;             // channel of the input: "base.y" or "hammer"; of a decay
                                     // that of the hammer, where it was recorded
  std::string force;                 // channel that the input drives, "mid.y", when it is a force
  std::vector<std::string> channels; // of the columns without the time
  std::optional<double> rate;        // Hz; where the file has no time
  std::optional<double> level;
  SignalKind excitation = SignalKind::random;
  std::optional<FrfQuantity> quantity;
  MatlabVariables variables;
  std::string state;
};

struct Measured {
  std::string specimen; // name of the case it belongs to
  std::string source;   // where the numbers are from
  std::vector<MeasuredSensor> sensors;
  std::vector<MeasuredState> states;
  std::vector<MeasuredMass> weighings; // under `mass`
  std::vector<MeasuredStatic> statics;
  std::vector<MeasuredStiffnessTable> stiffness; // dynamic
  std::vector<MeasuredMode> modes;
  std::vector<MeasuredPeaks> peaks;
  std::vector<MeasuredFrf> frf;
  std::vector<MeasuredSignals> signals;
  double level_sigma = 0;            // relative, of the level of each run
  std::vector<std::string> hold_out; // paths of entries that no fit may use
  std::vector<std::string> caveats;  // in words, printed in the report
};

} // namespace plica
