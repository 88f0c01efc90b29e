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

template <class V> void fields(V& v, BoltForce& b) {
  v.quantity(b.force, "force", {.unit = Dimension::force, .required = true}, "tension");
}

template <class V> void fields(V& v, HeldTemperature& h) {
  v.text(h.set, "set", {.required = true}, "node set, e.g. bellows.left");
  v.quantity(h.temperature, "at",
             {.unit = Dimension::temperature, .required = true, .min = -273.15}, "its temperature");
}

template <class V> void fields(V& v, Film& f) {
  v.quantity(f.gas, "gas", {.unit = Dimension::temperature, .required = true, .min = -273.15},
             "temperature of the gas");
  v.quantity(f.coefficient, "film", {.required = true, .min = 0, .exclusive_min = true},
             "heat that a degree of difference takes from the wall, W/(m2 K)");
}

template <class V> void fields(V& v, PartTemperature& t) {
  v.quantity(t.at, "at", {.unit = Dimension::temperature, .min = -273.15}, "everywhere; or");
  v.points(
      t.along, "along",
      {.unit = Dimension::length, .tail = Dimension::temperature, .tail_from = 1, .min_items = 2},
      "[y, temperature] along the part, straight in between; or by conduction along its shells:");
  v.list(t.held, "held", optional_key, "node sets of the part that are kept at a temperature");
  v.object(t.inside, "inside", optional_key, "gas inside, against the directors of the wall");
  v.object(t.outside, "outside", optional_key, "gas outside");
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
  v.named(s.bolt, &BoltForce::part, "bolt", optional_key,
          "beams by name that are tightened until they bear this force in the state");
  v.whole(s.buckling, "buckling", {.min = 1, .max = 50},
          "number of buckling loads looked for beyond the state");
  v.quantity(s.yield, "yield", {.unit = Dimension::pressure, .min = 0, .exclusive_min = true},
             "yield stress of the formed wall, for EJMA's limit of in-plane squirm");
  v.flag(s.follow, "follow",
         "the equilibrium, by arc length, where the load turns back before all of it acts "
         "(snap-through)");
}

} // namespace plica
