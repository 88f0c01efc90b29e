// Keys of the damping of springs (case_fields.hpp).
#pragma once

#include "model/description/spring_damping.hpp"
#include "words/field_types.hpp"

namespace plica {

inline constexpr Quantity relaxation_time{
    .unit = Dimension::time, .required = true, .min = 0, .exclusive_min = true};

template <class V> void fields(V& v, MaxwellBranch& m) {
  v.quantity(m.share, "share",
             {.unit = Dimension::ratio, .required = true, .min = 0, .exclusive_min = true},
             "stiffness over that of the spring at rest");
  v.quantity(m.time, "time", relaxation_time, "of relaxation: dashpot over stiffness");
}

template <class V> void fields(V& v, Springpot& s) {
  v.quantity(s.time, "time", relaxation_time, "tau of k (i omega tau)^exponent");
  v.quantity(s.exponent, "exponent",
             {.required = true, .min = 0, .max = 1, .exclusive_min = true, .exclusive_max = true},
             "of the fractional derivative");
}

template <class V> void fields(V& v, SpringDamping& d) {
  v.quantities(d.dashpot, "dashpot",
               {.unit = Dimension::damping, .min = 0, .tail = Dimension::rotational_damping},
               "beside the springs: [ux, uy, uz, rx, ry, rz]");
  v.quantity(d.loss_factor, "loss_factor", {.unit = Dimension::ratio, .min = 0, .max = 2},
             "of the springs, the same at every frequency");
  v.list(d.maxwell, "maxwell", optional_key, "branches of a spring and a dashpot in series");
  v.object(d.springpot, "springpot", optional_key, "fractional Kelvin-Voigt, beside the springs");
  v.points(d.table, "table",
           {.unit = Dimension::frequency,
            .min = 0,
            .tail = Dimension::ratio,
            .tail_from = 1,
            .min_items = 2},
           "[frequency, stiffness over that at rest, loss factor], in place of the others");
}

} // namespace plica
