// Keys of the state of a case (case_fields.hpp).
#pragma once

#include "model/description/operating_state.hpp"
#include "words/field_types.hpp"

namespace plica {

template <class V> void fields(V& v, EndOffset& o) {
  v.quantities(o.move, "move", {.unit = Dimension::length}, "[x, y, z]");
  v.quantities(o.turn, "turn", {.unit = Dimension::angle, .min = -3.1, .max = 3.1},
               "about an axis through the cap: rotation vector [x, y, z]");
}

template <class V> void fields(V& v, EndLoad& l) {
  v.quantities(l.force, "force", {.unit = Dimension::force}, "[x, y, z], of constant direction");
  v.quantities(l.moment, "moment", {.unit = Dimension::moment}, "[x, y, z]");
}

template <class V> void fields(V& v, PartTemperature& t) {
  v.quantity(t.at, "at", {.unit = Dimension::temperature, .min = -273.15}, "everywhere; or");
  v.points(
      t.along, "along",
      {.unit = Dimension::length, .tail = Dimension::temperature, .tail_from = 1, .min_items = 2},
      "[y, temperature] along the part, straight in between");
}

template <class V> void fields(V& v, OperatingState& s) {
  v.named(s.offset, &EndOffset::cap, "offset", optional_key,
          "how far what holds a cap has moved from where the part is free of stress");
  v.named(s.force, &EndLoad::cap, "force", optional_key, "on a cap that is free or sprung");
  v.quantity(s.pressure, "pressure", {.unit = Dimension::pressure},
             "inside the bellows, above that outside; caps close their ends and bear the thrust");
  v.named(s.temperature, &PartTemperature::part, "temperature", optional_key,
          "of parts by name; the others are as they are drawn");
  v.quantity(s.free_of_stress_at, "free_of_stress_at",
             {.unit = Dimension::temperature, .min = -273.15},
             "temperature at which no part strains another");
  v.quantities(s.gravity, "gravity", {.unit = Dimension::acceleration},
               "[x, y, z], e.g. [0, 0, -1 g]");
  v.whole(s.buckling, "buckling", {.min = 1, .max = 50},
          "number of buckling loads looked for beyond the state");
}

} // namespace plica
