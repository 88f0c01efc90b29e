// Keys of the fatigue life (analyses_fields.hpp).
#pragma once

#include "model/description/life_request.hpp"
#include "model/description/time_analyses_fields.hpp"

namespace plica {

inline constexpr Quantity required_stress{
    .unit = Dimension::pressure, .required = true, .min = 0, .exclusive_min = true};
inline constexpr Quantity required_count{.required = true, .min = 0, .exclusive_min = true};
inline constexpr Quantity negative_exponent{.required = true, .max = 0, .exclusive_max = true};

template <class V> void fields(V& v, BellowsCurve& c) {
  v.quantity(c.Kg, "Kg", {.min = 1, .max = 4},
             "fatigue strength reduction by notches and welds, 1 to 4");
  v.quantity(c.E_ratio, "E_ratio", {.min = 0, .exclusive_min = true},
             "modulus at room temperature over that of the case");
}

template <class V> void fields(V& v, StressLifeCurve& c) {
  v.quantity(c.knee_amplitude, "knee_amplitude", required_stress, "stress amplitude of the knee");
  v.quantity(c.knee_cycles, "knee_cycles", required_count, "cycles of the knee");
  v.quantity(c.slope, "slope", required_count, "k of N = knee_cycles (knee_amplitude / Sa)^k");
  v.quantity(c.second_slope, "second_slope", {.min = 0, .exclusive_min = true},
             "slope below the knee; left out: a fatigue limit");
  v.quantity(c.fewest, "fewest", {.min = 0, .exclusive_min = true},
             "cycles down to which it was made");
}

template <class V> void fields(V& v, StrainLifeCurve& c) {
  v.quantity(c.E, "E", required_stress, "Young's modulus");
  v.quantity(c.sf, "sf", required_stress, "fatigue strength coefficient");
  v.quantity(c.b, "b", negative_exponent, "fatigue strength exponent, below 0");
  v.quantity(c.ef, "ef", required_count, "fatigue ductility coefficient");
  v.quantity(c.c, "c", negative_exponent, "fatigue ductility exponent, below 0");
}

template <class V> void fields(V& v, TableCurve& c) {
  v.points(c.points, "points",
           {.required = true,
            .min = 0,
            .exclusive_min = true,
            .tail = Dimension::pressure,
            .tail_from = 1,
            .min_items = 2},
           "[cycles, stress amplitude], straight lines in a log-log plot");
}

template <class V> void fields(V& v, PublishedCurve& c) {
  v.choice(c.of, "of",
           {{PublishedSteel::pipe_304L, "304L_pipe"},
            {PublishedSteel::pipe_304L_butt_weld, "304L_pipe_butt_weld"},
            {PublishedSteel::austenitic_asme_III, "austenitic_asme_III"},
            {PublishedSteel::rcc_mrx_316LN, "316LN_rcc_mrx"},
            {PublishedSteel::rcc_mrx_316LN_450C, "316LN_rcc_mrx_450C"},
            {PublishedSteel::rcc_mrx_316LN_500C, "316LN_rcc_mrx_500C"},
            {PublishedSteel::rcc_mrx_316LN_550C, "316LN_rcc_mrx_550C"},
            {PublishedSteel::rcc_mrx_316LN_600C, "316LN_rcc_mrx_600C"},
            {PublishedSteel::rcc_mrx_316LN_650C, "316LN_rcc_mrx_650C"}},
           required_key,
           "which curve: 304L_*: the mean of tests with its deviation; the others: of codes, for "
           "design");
  v.quantity(c.E, "E", required_stress,
             "Young's modulus of the wall, which makes strain of stress");
}

template <class V> void fields(V& v, FatigueCurve& c) {
  v.text(c.name, "name", {}, "printed beside every life; left out: its type");
  v.text(c.source, "source", {}, "of its numbers, printed beside every life");
  v.choice(c.mean_stress, "mean_stress",
           {{MeanStress::none, "none"},
            {MeanStress::goodman, "goodman"},
            {MeanStress::smith_watson_topper, "smith_watson_topper"}},
           optional_key, "what a mean does to curves over the stress amplitude");
  v.quantity(c.ultimate, "ultimate", {.unit = Dimension::pressure, .min = 0, .exclusive_min = true},
             "tensile strength, for goodman");
  v.quantity(c.temperature_factor, "temperature_factor",
             {.unit = Dimension::ratio, .min = 0, .exclusive_min = true},
             "strength in operation over that of the curve");
  v.one_of(c.law, "type", {"bellows", "stress_life", "strain_life", "table", "published"},
           "kind of curve");
}

template <class V> void fields(V& v, EndShift& s) {
  const Quantity along{.unit = Dimension::length}, about{.unit = Dimension::angle};
  v.quantity(s.axial, "axial", along, "along y; compression below 0");
  v.quantity(s.lateral_x, "lateral_x", along, "across, the end kept parallel");
  v.quantity(s.lateral_z, "lateral_z", along, "the same along z");
  v.quantity(s.angular_x, "angular_x", about, "turn about x, by a moment alone");
  v.quantity(s.angular_z, "angular_z", about, "the same about z");
  v.quantity(s.twist, "twist", about, "turn about y");
}

template <class V> void fields(V& v, LifeStroke& s) {
  v.text(s.name, "name", {.required = true, .name = true}, "name");
  fields(v, s.shift);
  v.flag(s.reversed, "reversed", "from minus to plus that movement; else from rest to it");
  v.quantity(s.count, "count", required_count, "cycles, there and back");
}

template <class V> void fields(V& v, LifeSignal& s) {
  v.text(s.of, "of", {.required = true},
         "axial, lateral_x, lateral_z, angular_x, angular_z or twist of the second cap, all others "
         "being zero; or an excitation of the response by its name");
  fields(v, s.signal);
}

template <class V> void fields(V& v, LifeHistory& h) {
  v.text(h.name, "name", {.required = true, .name = true}, "name");
  v.list(h.signals, "signals", required_key, "what moves or pushes, at the same times");
  v.quantity(h.repeats, "repeats", {.min = 0, .exclusive_min = true}, "how often it comes");
}

template <class V> void fields(V& v, LifeRandom& r) {
  v.text(r.name, "name", {.required = true, .name = true}, "name");
  v.text(r.of, "of", {.required = true}, "random excitation of the response, by its name");
  v.quantity(r.duration, "duration", above_zero_seconds, "how long it acts");
  v.choice(r.method, "method",
           {{SpectralMethod::narrow_band, "narrow_band"},
            {SpectralMethod::dirlik, "dirlik"},
            {SpectralMethod::tovo_benasciutti, "tovo_benasciutti"},
            {SpectralMethod::alpha_075, "alpha_075"}},
           optional_key, "whose damage is added up; those of the others stand beside it");
}

template <class V>
void amplitude_fields(V& v, std::optional<double>& acceleration, std::optional<double>& force) {
  v.quantity(acceleration, "acceleration",
             {.unit = Dimension::acceleration, .min = 0, .exclusive_min = true},
             "amplitude of a base or of ends, or");
  v.quantity(force, "force", {.unit = Dimension::force_or_moment, .min = 0, .exclusive_min = true},
             "amplitude of a force");
}

template <class V> void fields(V& v, LifeSweep& s) {
  v.text(s.name, "name", {.required = true, .name = true}, "name");
  v.text(s.of, "of", {.required = true}, "excitation of the response, by its name");
  amplitude_fields(v, s.acceleration, s.force);
  v.quantities(s.band, "band",
               {.unit = Dimension::frequency, .required = true, .min = 0, .exclusive_min = true},
               "[from, to]");
  v.quantity(s.octaves_per_minute, "octaves_per_minute", {.min = 0, .exclusive_min = true},
             "how fast");
  v.quantity(s.count, "count", {.min = 0, .exclusive_min = true},
             "sweeps from one end of the band to the other");
  v.flag(s.friction, "friction",
         "the response of the joints at this level, by harmonic balance as analyses.levels has it");
}

template <class V> void fields(V& v, LifeDwell& d) {
  v.text(d.name, "name", {.required = true, .name = true}, "name");
  v.text(d.of, "of", {.required = true}, "excitation of the response, by its name");
  amplitude_fields(v, d.acceleration, d.force);
  v.whole(d.mode, "mode", {.min = 1, .max = 2000}, "at the frequency of this mode, from 1; or");
  v.quantity(d.frequency, "frequency",
             {.unit = Dimension::frequency, .min = 0, .exclusive_min = true}, "at this frequency");
  v.quantity(d.duration, "duration", {.unit = Dimension::time, .min = 0, .exclusive_min = true},
             "how long, or");
  v.quantity(d.cycles, "cycles", {.min = 0, .exclusive_min = true}, "how many cycles");
}

template <class V> void fields(V& v, Life& l) {
  v.object(l.curve, "curve", required_key, "fatigue curve");
  v.quantity(
      l.deviation, "deviation", {.min = 0, .exclusive_min = true},
      "of a mean curve: standard deviation of log10 of the cycles; left out: that of a published "
      "curve, else a design curve");
  v.choice(l.measure, "measure",
           {{StressMeasure::critical_direction, "critical_direction"},
            {StressMeasure::signed_von_mises, "signed_von_mises"}},
           optional_key, "how a stress of several components becomes one number");
  v.list(l.strokes, "strokes", optional_key, "cycles of movement of the second cap");
  v.list(l.histories, "histories", optional_key, "movements and accelerations over time");
  v.list(l.random, "random", optional_key, "random excitations for a time");
  v.list(l.sweeps, "sweeps", optional_key, "sines that sweep through a band");
  v.list(l.dwells, "dwells", optional_key, "sines at one frequency");
}

} // namespace plica
