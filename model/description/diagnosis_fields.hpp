// Keys of the section `diagnose` of a case; see words/field_types.hpp for the visitor.
#pragma once

#include "model/description/diagnosis_request.hpp"
#include "words/field_types.hpp"

namespace plica {

template <class V> void fields(V& v, PriorRequest& p) {
  v.text(p.effect, "effect", {.required = true}, "effect of the library");
  v.text(p.parameter, "parameter", {.required = true}, "its parameter, as a diagnosis names it");
  v.quantities(p.between, "between", {.min_items = 2, .max_items = 2},
               "[low, high] that it cannot leave, in SI");
  v.quantity(p.widening, "widening", {.min = 0, .exclusive_min = true},
             "factor of the width of its prior; one that is even between two bounds has none");
}

template <class V> void fields(V& v, DiagnosisRequest& d) {
  constexpr Quantity share{.unit = Dimension::ratio, .min = 0, .max = 1};
  v.texts(d.effects, "effects", "effects that are tried; left out: all");
  v.texts(d.without, "without", "effects that are not");
  v.texts(d.places, "places", "where effects may sit: beginnings of paths, such as beam.point");
  v.list(d.priors, "priors", Need{.min_items = 1}, "what is known of effects beforehand");
  v.flag(d.fit_baseline, "fit_baseline",
         "the section `fit` adjusts the case to the baseline first, as --fit-baseline does");
  v.quantity(
      d.model_error, "model_error",
      {.unit = Dimension::ratio, .min = 0, .max = 0.5, .exclusive_min = true},
      "of each frequency of the model, the same in a baseline and after; left out: 2 % beside "
      "a baseline, more where it shows more, else none");
  v.quantity(d.correlation, "correlation", share,
             "of the model's error in a baseline and after; left out: 1. What mesh and tolerances "
             "leave open is wholly common");
  v.quantity(d.remounting, "remounting", share,
             "scatter of a frequency when the specimen is mounted anew; left out: 0.45 %, or what "
             "several baselines show");
  v.quantity(
      d.change_error, "change_error", share,
      "of what an effect changes beside a baseline, in terms of the change; more where the model's "
      "frequencies lie farther from the baseline");
}

template <class V> void fields(V& v, SupposedEffect& e) {
  v.text(e.effect, "effect", {.required = true}, "effect of the library");
  v.text(e.place, "place", {.required = true}, "where it sits, as a diagnosis names it");
  v.text(e.way, "way", {}, "how it acts there, where there are several ways: x, all round");
  v.replacements(e.value, "value", required_key, "parameter: its number");
}

template <class V> void fields(V& v, Supposition& s) {
  v.list(s.effects, "effects", Need{.required = true}, "effects that act all at once");
}

} // namespace plica
