// Keys of what is asked of a case (case_fields.hpp).
#pragma once

#include "model/description/analyses.hpp"
#include "model/description/friction_fields.hpp"
#include "model/description/life_fields.hpp"
#include "model/description/time_analyses_fields.hpp"
#include "words/field_types.hpp"

namespace plica {

template <class V> void fields(V& v, Modes& m) {
  v.whole(m.count, "count", {.min = 1, .max = 2000}, "number of modes, from the lowest");
  v.quantities(m.band, "band", {.unit = Dimension::frequency, .min = 0},
               "[from, to]: all modes in this band, in place of count");
  v.flag(m.proof, "proof", "prove that no mode is missing");
}

inline constexpr Quantity damping_ratio{
    .unit = Dimension::ratio, .required = true, .min = 0, .max = 1, .exclusive_max = true};

template <class V> void fields(V& v, DampingRange& r) {
  v.quantities(r.band, "band", {.unit = Dimension::frequency, .required = true, .min = 0},
               "[from, to] of the eigenfrequencies it holds for");
  v.quantity(r.ratio, "ratio", damping_ratio, "fraction of critical damping");
}

template <class V> void fields(V& v, ModeDamping& m) {
  v.whole(m.mode, "mode", {.required = true, .min = 1, .max = 2000}, "number of the mode, from 1");
  v.quantity(m.ratio, "ratio", damping_ratio, "fraction of critical damping");
}

template <class V> void fields(V& v, LossFactor& l) {
  v.text(l.of, "of", {.required = true},
         "a part, mount.<cap> of a spring mount, caps.<cap> of a joint, caps.<cap>.<end> of an end "
         "on springs, or <liner>.contact");
  v.quantity(l.value, "value", {.unit = Dimension::ratio, .required = true, .min = 0, .max = 2},
             "structural loss factor, twice the fraction of critical damping");
}

template <class V> void fields(V& v, Damping& d) {
  Quantity every = damping_ratio;
  every.required = false;
  v.quantity(d.modal, "modal", every, "fraction of critical damping of every mode");
  v.list(d.ranges, "ranges", optional_key, "other values in bands of frequency");
  v.list(d.modes, "modes", optional_key, "other values for single modes");
  v.list(d.loss_factors, "loss_factors", optional_key,
         "of components, on top, weighted by their strain energy in each mode");
  v.flag(d.coupled, "coupled",
         "loss factors as complex stiffness in the responses, with what they couple");
}

template <class V> void noise_fields(V& v, Noise& n, Dimension density) {
  v.quantity(n.level, "level", {.unit = density, .min = 0, .exclusive_min = true},
             "constant one-sided density over the band, or");
  v.points(n.table, "table",
           {.unit = Dimension::frequency,
            .min = 0,
            .exclusive_min = true,
            .tail = density,
            .tail_from = 1,
            .min_items = 2},
           "[frequency, density], straight lines in a log-log plot");
}
template <class V> void fields(V& v, BaseNoise& n) {
  noise_fields(v, n, Dimension::acceleration_density);
}
template <class V> void fields(V& v, ForceNoise& n) {
  noise_fields(v, n, Dimension::force_density);
}

template <class V> void fields(V& v, Force& f) {
  v.text(f.name, "name", {.required = true, .name = true}, "name, also of its files");
  v.text(f.at, "at", {.required = true}, "node set, e.g. bellows.crown[14]; spread evenly over it");
  v.choice(f.direction, "direction", directions, required_key, "direction");
  v.quantity(f.amplitude, "amplitude",
             {.unit = Dimension::force_or_moment, .min = 0, .exclusive_min = true},
             "in N or Nm, for stress and motion in absolute numbers");
  v.object(f.random, "random", optional_key, "spectral density of the force");
}

template <class V> void end_motion_fields(V& v, EndMotion& m) {
  v.one_or_more(m.move, "move", "mounted caps that move; the others stay at rest");
  v.choice(m.direction, "direction", directions, required_key,
           "direction; rotations about the middle of each cap");
  v.quantity(m.amplitude, "amplitude", {}, "times the level; 1 where there is no phase");
  v.quantity(m.phase, "phase", {.unit = Dimension::angle}, "ahead of the input");
}
template <class V> void fields(V& v, EndMotion& m) {
  end_motion_fields(v, m);
}
template <class V> void fields(V& v, Motion& m) {
  v.text(m.name, "name", {.name = true}, "name, also of its files; left out: engine_y");
  end_motion_fields(v, m);
  v.list(m.with, "with", optional_key, "ends that move with it, each in its own way");
  v.object(m.random, "random", optional_key,
           "spectral density of the acceleration; left out: that of the response");
}

template <class V> void fields(V& v, Tone& t) {
  v.text(t.of, "of", {.required = true}, "random input that it rides on, by its name");
  v.quantities(t.band, "band", {.unit = Dimension::frequency, .required = true, .min = 0},
               "[from, to] of the sweep");
  v.quantity(t.acceleration, "acceleration",
             {.unit = Dimension::acceleration, .min = 0, .exclusive_min = true},
             "amplitude of a base or of ends, or");
  v.quantity(t.force, "force",
             {.unit = Dimension::force_or_moment, .min = 0, .exclusive_min = true},
             "amplitude of a force");
}

template <class V> void fields(V& v, InputShare& i) {
  v.text(i.of, "of", {.required = true}, "a direction of the base, a motion or a force, by name");
  v.quantity(i.factor, "factor", {}, "times its own amplitude");
  v.quantity(i.phase, "phase", {.unit = Dimension::angle}, "ahead of the others");
}

template <class V> void fields(V& v, InputCoherence& c) {
  v.text(c.a, "a", {.required = true}, "one of the inputs");
  v.text(c.b, "b", {.required = true}, "another one");
  v.quantity(c.magnitude, "magnitude", {.unit = Dimension::ratio, .min = 0, .max = 1},
             "of the complex coherence, |S_ab| / sqrt(S_aa S_bb)");
  v.quantity(c.phase, "phase", {.unit = Dimension::angle}, "of a ahead of b");
}

template <class V> void fields(V& v, SpectrumMatrix& s) {
  v.quantity(s.frequency, "frequency",
             {.unit = Dimension::frequency, .required = true, .min = 0, .exclusive_min = true},
             "where it holds; straight between");
  v.quantities(s.real, "real", {.required = true},
               "rows of the matrix one after the other, SI of the inputs per Hz");
  v.quantities(s.imaginary, "imaginary", {}, "likewise; left out: zero");
}

template <class V> void fields(V& v, Together& t) {
  v.text(t.name, "name", {.required = true, .name = true}, "name, also of its files");
  v.list(t.inputs, "inputs", {.required = true, .min_items = 2}, "what acts at once");
  v.choice(t.correlation, "correlation",
           {{InputCorrelation::none, "none"}, {InputCorrelation::full, "full"}}, optional_key,
           "of their random parts: independent, or one signal with the phases given");
  v.list(t.coherence, "coherence", optional_key, "of pairs, in place of correlation");
  v.list(t.spectra, "spectra", optional_key,
         "cross-spectral matrix of the inputs, in place of their own densities");
}

template <class V> void fields(V& v, CrossPair& c) {
  v.text(c.a, "a", {.required = true}, "channel sensor.direction, e.g. mid.y");
  v.text(c.b, "b", {.required = true}, "another channel");
}

template <class V> void fields(V& v, Response& r) {
  v.choices_or(r.bases, r.motions, "base", directions, {.required = false, .min_items = 1},
               "directions in which the base moves, one by one; then motions of chosen ends");
  v.quantity(
      r.level, "level", {.unit = Dimension::acceleration, .min = 0, .exclusive_min = true},
      "amplitude of the base acceleration; the model is linear, it scales stress and motion");
  v.object(r.random, "random", optional_key, "spectral density of the base acceleration");
  v.list(r.forces, "forces", optional_key, "forces, one by one, the base at rest");
  v.list(r.together, "together", optional_key, "several of these at once");
  v.list(r.tones, "tones", optional_key, "sines that sweep while a random input goes on");
  v.quantities(r.band, "band", {.unit = Dimension::frequency, .min = 0},
               "[from, to] of the frequencies");
  v.whole(r.points, "points", {.min = 2, .max = 1000000},
          "even steps over the band; every eigenfrequency and a cluster round it are added");
  v.points(r.rms_bands, "rms_bands", {.unit = Dimension::frequency, .min = 0},
           "[from, to] of the bands of which a random response gives the RMS");
  v.list(r.cross, "cross", optional_key, "pairs of channels whose cross density is given");
  v.whole(r.referee, "referee", {.min = 0, .max = 100},
          "frequencies at which a direct solution of the whole mesh checks the response");
}

template <class V> void fields(V& v, Stress& s) {
  v.quantities(s.frequencies, "frequencies",
               {.unit = Dimension::frequency, .min = 0, .exclusive_min = true},
               "harmonic stress at these, under every base direction and force");
}

template <class V> void fields(V& v, SuperelementsInRun& r) {
  v.quantity(r.cutoff, "cutoff", {.unit = Dimension::frequency, .min = 0, .exclusive_min = true},
             "of the modes of a part with its caps held; twice the highest frequency asked for");
}

template <class V> void fields(V& v, Analyses& a) {
  v.choice(a.symmetry, "symmetry",
           {{Symmetry::automatic, "automatic"},
            {Symmetry::required, "required"},
            {Symmetry::off, "off"}},
           optional_key, "solve harmonic by harmonic where the part repeats around its axis");
  v.object(a.reduction, "reduction", optional_key,
           "solve with a superelement in place of every part between caps");
  v.flag_or(a.statics, a.deck_loads, "static", "deck",
            "static stiffness between the two caps, by default where there are two; of more, where "
            "asked for, between the two that are mounted; deck: what the loads of a deck do as "
            "well, as its subcases or steps say");
  v.object(a.modes, "modes", optional_key, "natural modes");
  v.object(a.damping, "damping", optional_key, "damping of the modes");
  v.object(a.response, "response", optional_key,
           "response of the sensors to motion of the base and to forces");
  v.list(a.transients, "transients", optional_key,
         "response of the sensors over time to a signal or a shock");
  v.list(a.run_ups, "run_ups", optional_key, "response to the orders of an engine over its speed");
  v.object(a.levels, "levels", optional_key,
           "response at several levels with the friction of the joints");
  v.object(a.stress, "stress", optional_key,
           "stresses: static, of the modes, harmonic, RMS of a random response");
  v.object(a.life, "life", optional_key, "fatigue life of the shells");
  v.flag(a.error_bars, "error_bars",
         "error of the mesh and interval from the tolerances beside the headline numbers");
}

} // namespace plica
