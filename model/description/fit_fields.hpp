// Every key of the `fit` section; see field_types.hpp for the visitor.
#pragma once

#include "model/description/fit_request.hpp"
#include "words/field_types.hpp"

namespace plica {

template <class V> void fields(V& v, FitParameter& p) {
  v.one_or_more(p.paths, "path", "a number of this file, or several that share its value");
  v.texts(p.bounds_text, "bounds",
          "[low, high], with units; left out: the limits of its tolerance in this file");
  v.texts(p.prior_text, "prior", "[value, standard deviation] known beforehand, with units");
  v.texts(p.physical_text, "physical", "[low, high] that makes sense: a warning beyond");
  v.choice(p.log_scale, "scale", {{false, "linear"}, {true, "log"}}, optional_key,
           "of the search and the prior");
}

template <class V> void fields(V& v, FitTie& t) {
  v.text(t.path, "path", {.required = true}, "number that follows others");
  v.quantity(t.constant, "constant", {}, "in SI");
  v.replacements(t.of_text, "of", required_key, "path of a number: factor, in SI");
}

template <class V> void fields(V& v, FitConstraint& c) {
  v.text(c.name, "name", {.required = true},
         "shown in the result; without `of` the limit itself: f_axial >= 250 Hz, mass <= 1.75 kg");
  v.replacements(c.of_text, "of", optional_key,
                 "path of a number, or mass, k_axial, k_transverse, k_bending, k_torsion, f_axial, "
                 "f_transverse, f_torsion: factor");
  v.quantity(c.min, "min", {}, "of the sum, in SI and Hz");
  v.quantity(c.max, "max", {}, "of the sum, in SI and Hz");
}

template <class V> void fields(V& v, FitTarget& t) {
  v.text(t.quantity, "quantity", {.required = true},
         "its name in the comparison with the test, or an entry of the measured data: peaks[0]; or "
         "what is wanted of a computed quantity: k_axial = 50 kN/m, least mass, most f_axial");
  v.quantity(
      t.sigma, "sigma", {.unit = Dimension::ratio, .min = 0, .exclusive_min = true},
      "standard deviation relative to the value, in place of the stated one; of least and most "
      "100 % left out");
}

template <class V> void fields(V& v, FitRequest& f) {
  v.list(f.parameters, "parameters", required_key, "numbers that may change");
  v.list(f.ties, "ties", Need{.min_items = 1}, "numbers that follow them");
  v.list(f.targets, "targets", Need{.min_items = 1},
         "measured quantities; left out: all there are");
  v.list(f.constraints, "constraints", Need{.min_items = 1},
         "limits of sums of numbers and results");
  v.quantity(f.default_sigma, "default_sigma",
             {.unit = Dimension::ratio, .min = 0, .exclusive_min = true},
             "relative standard deviation where the measured data state none");
  v.choice(f.search, "search", {{FitSearch::local, "local"}, {FitSearch::global, "global"}},
           optional_key, "from the values of the case, or over the whole box");
  v.quantities(f.hold_out_levels, "hold_out_levels",
               {.unit = Dimension::acceleration, .min = 0, .exclusive_min = true, .min_items = 1},
               "levels of excitation whose peaks are not fitted but compared");
  v.choice(f.level_method, "level_method",
           {{JointMethod::harmonic_balance, "harmonic_balance"},
            {JointMethod::describing_function, "describing_function"}},
           optional_key, "how levels are computed during the fit: the second is the fast path");
  v.whole(f.evaluations, "evaluations", {.min = 10, .max = 10000000}, "budget of a global search");
}

} // namespace plica
