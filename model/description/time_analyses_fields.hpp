// Keys of transients and run-ups (analyses_fields.hpp).
#pragma once

#include "model/description/time_analyses.hpp"
#include "words/field_types.hpp"

namespace plica {

inline constexpr Quantity above_zero_seconds{
    .unit = Dimension::time, .required = true, .min = 0, .exclusive_min = true};

template <class V> void fields(V& v, SampledSignal& s) {
  v.text(s.file, "file", {.required = true}, "CSV, universal or MATLAB file beside the case");
  v.text(s.channel, "channel", {}, "which one, where the file has several");
  v.quantity(s.rate, "rate", {.unit = Dimension::frequency, .min = 0, .exclusive_min = true},
             "samples per second, where the file has no times");
  v.quantity(s.factor, "factor", {}, "times the signal");
}

template <class V> void fields(V& v, Pulse& p) {
  v.choice(p.shape, "shape",
           {{PulseShape::half_sine, "half_sine"},
            {PulseShape::sawtooth, "sawtooth"},
            {PulseShape::trapezoid, "trapezoid"}},
           optional_key, "shock of IEC 60068-2-27");
  v.quantity(p.acceleration, "acceleration", {.unit = Dimension::acceleration},
             "peak of a base or of ends (plain number about an axis: rad/s2), or");
  v.quantity(p.force, "force", {.unit = Dimension::force_or_moment}, "peak of a force");
  v.quantity(p.duration, "duration", above_zero_seconds, "how long it lasts");
}

template <class V> void fields(V& v, SpectrumRequest& s) {
  v.quantities(s.band, "band", {.unit = Dimension::frequency, .min = 0}, "[from, to]");
  v.whole(s.per_octave, "per_octave", {.min = 1, .max = 96}, "frequencies per octave");
  v.quantity(s.quality, "quality", {.min = 0.5, .exclusive_min = true},
             "of the oscillators, 1 / (2 zeta)");
}

template <class V> void fields(V& v, Transient& t) {
  v.text(t.name, "name", {.required = true, .name = true}, "name, also of its files");
  v.text(t.of, "of", {.required = true},
         "excitation of the response: a direction of the base, a motion or a force by its name");
  v.object(t.signal, "signal", optional_key, "samples, joined by straight lines; or");
  v.object(t.pulse, "pulse", optional_key, "a standard shock");
  v.quantity(t.after, "after", {.unit = Dimension::time, .min = 0},
             "followed beyond the end of the input, which is then zero");
  v.object(t.spectrum, "spectrum", optional_key,
           "shock response spectra of the input and of the sensors");
}

template <class V> void fields(V& v, EngineOrder& o) {
  v.quantity(o.order, "order", {.required = true, .min = 0, .exclusive_min = true},
             "cycles per revolution");
  v.text(o.of, "of", {.required = true}, "excitation of the response that it acts as");
  v.quantity(o.acceleration, "acceleration", {.unit = Dimension::acceleration},
             "amplitude of a base or of ends, the same at every speed; or");
  v.quantity(o.force, "force", {.unit = Dimension::force_or_moment}, "amplitude of a force; or");
  v.points(o.table, "table",
           {.unit = Dimension::rotational_speed,
            .min = 0,
            .tail = Dimension::number,
            .tail_from = 1,
            .min_items = 2},
           "[speed, amplitude in m/s2, rad/s2, N or Nm], straight between the rows");
  v.quantity(o.phase, "phase", {.unit = Dimension::angle},
             "ahead of the other inputs of the same order");
}

template <class V> void fields(V& v, RunUp& r) {
  v.text(r.name, "name", {.required = true, .name = true}, "name, also of its files");
  v.quantities(r.speed, "speed",
               {.unit = Dimension::rotational_speed, .min = 0, .exclusive_min = true},
               "[from, to] of the engine, or");
  v.points(r.table, "table",
           {.unit = Dimension::time,
            .min = 0,
            .tail = Dimension::rotational_speed,
            .tail_from = 1,
            .min_items = 2},
           "[time, speed]: says also how fast it runs through the modes");
  v.whole(r.points, "points", {.min = 2, .max = 100000},
          "even steps of the speed; crossings of orders and modes are added");
  v.list(r.orders, "orders", required_key, "orders of the engine");
}

} // namespace plica
