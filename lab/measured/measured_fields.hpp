// Every key of measured.yaml: unit, bounds, meaning; see words/field_types.hpp for the visitor.
#pragma once

#include "lab/measured/measured_words.hpp"
#include "words/directions.hpp"
#include "words/field_types.hpp"

namespace plica {

inline const std::vector<Named<Axis>> named_axes = named_in_order<Axis>(axis_names);

inline const std::vector<Named<FrfQuantity>> quantity_names{
    {FrfQuantity::receptance, "receptance"},
    {FrfQuantity::mobility, "mobility"},
    {FrfQuantity::accelerance, "accelerance"},
    {FrfQuantity::transmissibility, "transmissibility"}};

inline constexpr Quantity measured_level{
    .unit = Dimension::acceleration, .min = 0, .exclusive_min = true};
inline constexpr Quantity measured_damping{
    .unit = Dimension::ratio, .min = 0, .max = 1, .exclusive_max = true};
inline constexpr Quantity measured_frequency{
    .unit = Dimension::frequency, .required = true, .min = 0, .exclusive_min = true};
inline constexpr Quantity sigma_frequency{
    .unit = Dimension::frequency, .min = 0, .exclusive_min = true};

template <class V> void fields(V& v, MeasuredSensor& s) {
  v.text(s.name, "name", {.required = true, .name = true}, "name");
  v.quantities(s.at, "at", {.unit = Dimension::length, .required = true},
               "[x, y, z] in the part frame");
  v.choices(s.axes, "axes", signed_axes, {.required = false, .min_items = 3},
            "directions of the part frame its three axes point in");
  v.quantity(s.mass, "mass", {.unit = Dimension::mass, .min = 0}, "mass");
  v.whole(s.node, "node", {.min = 1}, "its number in universal files");
  v.text(s.on, "on", {},
         "what it sits on beside the part: table, or the fixture under a mount or a support of the "
         "case, such as mount.left");
}

template <class V> void fields(V& v, MeasuredState& s) {
  v.text(s.name, "name", {.required = true, .name = true}, "name");
  v.flag(s.baseline, "baseline",
         "what is looked for was not there yet: a diagnosis explains the change from here");
  v.replacements(s.set, "set", optional_key, "known change: path in the case, its number here");
}

inline constexpr const char* state_meaning = "state of the specimen, one of `states`";

template <class V> void fields(V& v, MeasuredMass& m) {
  v.quantity(m.value, "value",
             {.unit = Dimension::mass, .required = true, .min = 0, .exclusive_min = true},
             "weighed mass of the specimen");
  v.quantity(m.sigma, "sigma", {.unit = Dimension::mass, .min = 0, .exclusive_min = true},
             "standard deviation");
  v.quantities(m.repeats, "repeats",
               {.unit = Dimension::mass, .min = 0, .exclusive_min = true, .min_items = 2},
               "single results, where no sigma is given");
  v.text(m.state, "state", {}, state_meaning);
  v.flag(m.without_sensors, "without_sensors",
         "the sensors were not on the scale: their masses, which `sensors` has to state, come "
         "besides");
}

template <class V> void fields(V& v, MeasuredStatic& s) {
  v.tag(s.direction, "direction", named_in_order<StaticDirection>(static_direction_names),
        required_key, "which stiffness between the end caps");
  const bool turns = s.direction >= StaticDirection::bending_x;
  const Dimension unit = turns ? Dimension::rotational_stiffness : Dimension::stiffness;
  v.quantity(s.value, "value", {.unit = unit, .required = true, .min = 0, .exclusive_min = true},
             "stiffness");
  v.quantity(s.sigma, "sigma", {.unit = unit, .min = 0, .exclusive_min = true},
             "standard deviation");
  v.quantity(
      s.stroke, "stroke",
      {.unit = turns ? Dimension::angle : Dimension::length, .min = 0, .exclusive_min = true},
      "largest displacement or rotation of the test");
  v.choice(s.slope, "slope", {{StaticSlope::secant, "secant"}, {StaticSlope::tangent, "tangent"}},
           optional_key,
           "force over displacement at the stroke, or how the force grows there as it is reached");
  v.quantities(s.repeats, "repeats",
               {.unit = unit, .min = 0, .exclusive_min = true, .min_items = 2},
               "single results, where no sigma is given");
  v.text(s.state, "state", {}, state_meaning);
  v.text(s.note, "note", {}, "remark");
}

template <class V> void fields(V& v, MeasuredStiffnessTable& s) {
  v.text(s.file, "file", {.required = true},
         "table as plica stiffness --measured reads it, relative to this file");
  v.texts(s.ends, "ends",
          "two caps: the end that moves and the one that is held; left out: those "
          "of the case");
  v.quantity(s.sigma, "sigma", {.unit = Dimension::ratio, .min = 0, .exclusive_min = true},
             "standard deviation of the complex stiffness over its magnitude; of a loss angle in "
             "radians");
  v.text(s.state, "state", {}, state_meaning);
  v.text(s.note, "note", {}, "remark");
}

template <class V> void fields(V& v, MeasuredVector& s) {
  v.one_or_more(s.channels, "channels", "sensor and axis, such as mid.y");
  v.quantities(s.real, "real", {.required = true}, "real parts");
  v.quantities(s.imaginary, "imaginary", {}, "imaginary parts");
}

template <class V> void fields(V& v, MeasuredMode& m) {
  v.quantity(m.frequency, "frequency", measured_frequency, "frequency");
  v.quantity(m.sigma, "sigma", sigma_frequency, "standard deviation of the frequency");
  v.quantity(m.damping, "damping", measured_damping, "fraction of critical damping");
  v.quantity(m.sigma_damping, "sigma_damping", measured_damping,
             "standard deviation of the damping");
  v.choice(m.shape, "shape", named_in_order<MeasuredShape>(measured_shape_names), required_key,
           "kind of motion");
  v.whole(m.order, "order", {.min = 1, .max = 1000},
          "which mode of that shape in its direction, from the lowest; left out: 1, and for shape "
          "other in the order of their frequencies");
  v.choice(m.direction, "direction", named_axes, optional_key, "axis along which the mode moves");
  v.choice(m.base, "base", named_axes, optional_key, "axis along which the table moved");
  v.quantity(m.level, "level", measured_level, "base acceleration");
  v.text(m.drive, "drive", {}, "sensor and axis at which a shaker drove it, such as mid.y");
  v.quantity(m.acceleration, "acceleration", measured_level,
             "amplitude that was held at the drive");
  v.quantity(m.force, "force", {.unit = Dimension::force, .min = 0, .exclusive_min = true},
             "amplitude of the force at the drive");
  v.text(m.sensor, "sensor", {},
         "name of the sensor that showed it: its peaks are paired in order");
  v.quantities(m.repeats, "repeats",
               {.unit = Dimension::frequency, .min = 0, .exclusive_min = true, .min_items = 2},
               "single results of the frequency, where no sigma is given");
  v.object(m.vector, "vector", optional_key, "shape at the sensors");
  v.text(m.state, "state", {}, state_meaning);
  v.text(m.note, "note", {}, "remark");
}

template <class V> void fields(V& v, MeasuredPeaks& p) {
  Quantity level = measured_level;
  level.required = true;
  v.choice(p.base, "base", named_axes, required_key, "axis along which the table moved");
  v.text(p.sensor, "sensor", {.required = true}, "name of a sensor of this file");
  v.choice(p.direction, "direction", named_axes, required_key, "axis of the response");
  v.quantities(p.level, "level", level, "base accelerations");
  v.quantities(p.frequency, "frequency", measured_frequency, "peak frequency at each level");
  v.quantity(p.sigma, "sigma", sigma_frequency, "standard deviation of the frequencies");
  v.quantities(p.amplitude, "amplitude", {.min = 0}, "peak transmissibility at each level");
  v.quantities(p.damping, "damping", measured_damping,
               "fraction of critical damping at each level");
  v.text(p.state, "state", {}, state_meaning);
  v.text(p.note, "note", {}, "remark");
}

template <class V> void fields(V& v, MatlabVariables& m) {
  v.text(m.abscissa, "abscissa", {},
         "frequencies or times, or a structure of `start_value` and `increment`");
  v.text(m.values, "values", {}, "one channel a column");
}

template <class V> void fields(V& v, FrfSigma& s) {
  v.quantity(s.relative, "relative", {.unit = Dimension::ratio, .min = 0}, "part of the magnitude");
  v.quantity(s.floor, "floor", {.min = 0}, "transmissibility that is never undercut");
}

template <class V> void fields(V& v, MeasuredFrf& f) {
  v.text(f.file, "file", {.required = true}, "UFF 58, CSV or MATLAB, relative to this file");
  v.choice(f.base, "base", named_axes, optional_key, "axis along which the table moved");
  v.text(f.force, "force", {}, "channel that was driven, instead of base");
  v.choice(f.quantity, "quantity", quantity_names, optional_key,
           "what the responses are; by the base transmissibility, by a force accelerance");
  Quantity level = measured_level;
  if (!f.force.empty()) level.unit = Dimension::force;
  v.quantity(f.level, "level", level, "base acceleration, or amplitude of the force (N)");
  v.object(f.sigma, "sigma", optional_key, "standard deviation");
  v.texts(f.channels, "channels",
          "sensor and axis of every column, such as mid.y; - leaves it out");
  v.object(f.variables, "variables", optional_key, "names in a MATLAB file");
  v.text(f.state, "state", {}, state_meaning);
}

template <class V> void fields(V& v, MeasuredSignals& s) {
  v.text(s.file, "file", {.required = true}, "UFF 58, CSV or MATLAB, relative to this file");
  v.choice(s.base, "base", named_axes, optional_key, "axis along which the table moved");
  v.text(s.reference, "reference", {},
         "channel of the input, such as base.y; needed but for a free_decay, where it tells when a "
         "hammer had left, and for output_only, which has none");
  v.text(s.force, "force", {}, "channel that the input drives, where it is a force");
  v.texts(s.channels, "channels",
          "sensor and axis of every column, such as mid.y; - leaves it out");
  v.quantity(s.rate, "rate", sigma_frequency,
             "sampling rate, where the file has no time; beside times, what they must agree with");
  Quantity level = measured_level;
  if (!s.force.empty()) level.unit = Dimension::force;
  v.quantity(s.level, "level", level, "base acceleration, or amplitude of the force (N)");
  v.choice(s.excitation, "excitation",
           {{SignalKind::random, "random"},
            {SignalKind::sine, "sine"},
            {SignalKind::free_decay, "free_decay"},
            {SignalKind::output_only, "output_only"}},
           optional_key,
           "random noise, or a stepped or swept sine, recorded beside the responses; free_decay: a "
           "hit or a release, free behind it; output_only: steady noise that nobody measured");
  v.choice(s.quantity, "quantity", quantity_names, optional_key,
           "what the responses are; by the base transmissibility, by a force accelerance");
  v.object(s.variables, "variables", optional_key, "names in a MATLAB file");
  v.text(s.state, "state", {}, state_meaning);
}

template <class V> void fields(V& v, Measured& m) {
  v.text(m.specimen, "specimen", {.required = true, .name = true}, "case the data belong to");
  v.text(m.source, "source", {}, "where the numbers are from");
  v.list(m.sensors, "sensors", optional_key, "accelerometers");
  v.list(m.states, "states", optional_key, "states of the specimen in which entries were measured");
  v.one_or_more(m.weighings, "mass", optional_key,
                "weighed mass, or a list of weighings: of several states, or repeated");
  v.list(m.statics, "static", optional_key, "static stiffnesses from a rig");
  v.list(m.stiffness, "stiffness", optional_key, "dynamic stiffnesses from a rig");
  v.list(m.modes, "modes", optional_key, "identified modes");
  v.list(m.peaks, "peaks", optional_key, "peaks against the level of excitation");
  v.list(m.frf, "frf", optional_key, "measured frequency responses");
  v.list(m.signals, "signals", optional_key, "time signals");
  v.quantity(m.level_sigma, "level_sigma", {.unit = Dimension::ratio, .min = 0, .max = 1},
             "standard deviation of the level of each run: of levels, accelerations and forces");
  v.texts(m.hold_out, "hold_out", "paths of entries that no fit may use, e.g. modes[1]");
  v.texts(m.caveats, "caveats", "what a user of these numbers must know");
}

} // namespace plica
