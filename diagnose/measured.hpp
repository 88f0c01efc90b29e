// Measured data of one specimen: what the scale, the rig and the shaker table gave.
//
// SI units, frequencies in Hz, damping as fraction of critical, amplitudes as transmissibility
// (absolute acceleration of the sensor / base acceleration), levels in m/s2 of the base. Places and
// axes in the part frame: y along the pipe, x transverse, z vertical. `sigma` is one standard
// deviation; absent where the source gives none.
#pragma once

#include <array>
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
};

struct MeasuredMass {
  double value = 0;
  std::optional<double> sigma;
};

struct MeasuredStatic {
  StaticDirection direction = StaticDirection::axial;
  double value = 0; // N/m; bending and torsion Nm/rad
  std::optional<double> sigma;
  std::optional<double> stroke; // m; rad for bending and torsion
  std::string note;
};

struct MeasuredMode {
  double frequency = 0;
  std::optional<double> sigma, damping, sigma_damping;
  MeasuredShape shape = MeasuredShape::other;
  int order = 1;                 // which mode of that shape, from the lowest
  std::optional<Axis> direction; // in which the mode moves, where known
  std::optional<Axis> base;      // excited along
  std::optional<double> level;
  std::string sensor; // at which the peak was seen; empty = not known
  std::string note;
};

// First peak against the level of excitation: lists of equal length.
struct MeasuredPeaks {
  Axis base = Axis::y;
  std::string sensor;
  Axis direction = Axis::y;                                 // of the response, in sensor axes
  std::vector<double> level, frequency, amplitude, damping; // the last two may be empty
  std::optional<double> sigma;                              // of the frequencies
  std::string note;
};

struct FrfSigma {
  double relative = 0; // of the magnitude
  double floor = 0;    // transmissibility
};

struct MeasuredFrf {
  std::string file; // UFF 58 or CSV, relative to the file that names it
  Axis base = Axis::y;
  std::optional<double> level;
  std::optional<FrfSigma> sigma;
};

struct Measured {
  std::string specimen; // name of the case it belongs to
  std::string source;   // where the numbers are from
  std::vector<MeasuredSensor> sensors;
  std::optional<MeasuredMass> mass;
  std::vector<MeasuredStatic> statics;
  std::vector<MeasuredMode> modes;
  std::vector<MeasuredPeaks> peaks;
  std::vector<MeasuredFrf> frf;
  std::vector<std::string> hold_out; // paths of entries that no fit may use
  std::vector<std::string> caveats;  // in words, printed in the report
};

} // namespace plica
