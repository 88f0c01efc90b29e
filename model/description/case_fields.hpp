// Every key of the case file: unit, bounds, meaning. The one description that the reader, the JSON
// schema and the access by path share; see field_types.hpp for the visitor. Order of the keys is
// the order in which they are shown. Rules between keys are in model/description/case_checks.hpp.
#pragma once

#include "model/description/analyses_fields.hpp"
#include "model/description/case.hpp"
#include "model/description/diagnosis_fields.hpp"
#include "model/description/fit_fields.hpp"
#include "model/description/operating_state_fields.hpp"
#include "model/description/parts_fields.hpp"
#include "model/description/spring_damping_fields.hpp"

namespace plica {

template <class V> void fields(V& v, SprungEnd& e) {
  v.text(e.end, "end", {.required = true}, "one of those that the cap joins");
  v.quantities(e.stiffness, "stiffness",
               {.unit = Dimension::stiffness,
                .required = true,
                .min = 0,
                .exclusive_min = true,
                .tail = Dimension::rotational_stiffness},
               "between that end and the cap, at the end: [ux, uy, uz, rx, ry, rz]");
  v.object(e.friction, "friction", optional_key, "beside these springs");
  v.object(e.damping, "damping", optional_key, "of these springs");
}

template <class V> void fields(V& v, Cap& c) {
  v.one_or_more(c.of, "of", "end circle it closes, e.g. bellows.left, or a list of ends it joins");
  v.quantities(c.stiffness, "stiffness",
               {.unit = Dimension::stiffness,
                .min = 0,
                .exclusive_min = true,
                .tail = Dimension::rotational_stiffness},
               "of a joint between the first end and the others: [ux, uy, uz, rx, ry, rz]; left "
               "out: rigid");
  v.object(c.friction, "friction", optional_key, "of that joint, beside its stiffness");
  v.object(c.damping, "damping", optional_key, "of the springs of that joint");
  v.list(c.ends, "ends", optional_key,
         "ends that hang on springs of their own, in place of `stiffness`; the others are rigid");
  v.quantity(c.mass, "mass", {.unit = Dimension::mass, .min = 0}, "mass");
  v.quantities(c.inertia, "inertia", {.unit = Dimension::inertia},
               "about its centre of mass: [xx, yy, zz, xy, yz, zx]");
  v.quantities(c.offset, "offset", {.unit = Dimension::length},
               "[x, y, z] from the middle of the circle to the centre of mass");
}

template <class V> void fields(V& v, Mount& m) {
  v.word(m.kind, {{MountKind::free, "free"}, {MountKind::rigid, "rigid"}}, MountKind::springs,
         "free, rigid, or a map with the stiffness of six springs");
  if (m.kind == MountKind::springs)
    v.quantities(m.stiffness, "stiffness",
                 {.unit = Dimension::stiffness,
                  .required = true,
                  .min = 0,
                  .tail = Dimension::rotational_stiffness},
                 "of six springs to the table: [ux, uy, uz, rx, ry, rz]");
  v.object(m.friction, "friction", optional_key, "beside these springs");
  v.object(m.damping, "damping", optional_key, "of these springs");
}

template <class V> void fields(V& v, Support& s) {
  v.text(s.set, "set", {.required = true}, "node set, e.g. web.edge1");
  v.choices(s.dofs, "fix", named_in_order<int>(dof_names), {.required = true, .min_items = 1},
            "displacements and rotations held to zero");
}

template <class V> void fields(V& v, Sensor& s) {
  v.text(s.name, "name", {.required = true, .name = true}, "name");
  v.quantities(s.at, "at", {.unit = Dimension::length, .required = true},
               "[x, y, z]; at most 5 mm from the node, section, beam or wall that it rides on");
  v.choices(s.axes, "axes", signed_axes, {.required = false, .min_items = 3},
            "directions of the part frame its three axes point in");
  v.quantity(s.mass, "mass", {.unit = Dimension::mass, .min = 0}, "mass that rides on the node");
}

template <class V> void fields(V& v, Variant& x) {
  v.text(x.name, "name", {.required = true}, "name shown beside its results");
  v.replacements(x.set, "set", required_key, "path of this file: new value");
}

template <class V> void fields(V& v, AlternativeModel& m) {
  v.texts(m.assumptions, "assumptions", "in words, in place of those of the case");
  v.replacements(m.set, "set", optional_key,
                 "path of this file: new value or new key, e.g. friction of an interlock, levels");
  v.named(m.parts, &Part::name, "parts", optional_key, "in place of the parts of the case");
  v.named(m.caps, &Cap::name, "caps", optional_key, "in place of its caps");
  v.named(m.mount, &Mount::cap, "mount", optional_key, "in place of its mount");
  v.list(m.sensors, "sensors", optional_key, "in place of its sensors");
  v.list(m.variants, "variants", optional_key, "of this model; those of the case are left out");
  v.object(m.fit, "fit", optional_key, "of this model");
}

template <class V> void fields(V& v, Case& c) {
  v.text(c.name, "case", {.required = true, .name = true}, "name of the case");
  v.text(c.title, "title", {}, "title of the report");
  v.texts(c.assumptions, "assumptions", "assumptions in words, printed in the report");
  v.named(c.materials, "materials", optional_key, "materials by name");
  v.named(c.parts, &Part::name, "parts", required_key, "parts by name");
  v.named(c.caps, &Cap::name, "caps", optional_key, "rigid end caps by name");
  v.named(c.mount, &Mount::cap, "mount", optional_key,
          "how each cap is held by the table; a cap not named here is free");
  v.list(c.supports, "supports", optional_key, "degrees of freedom held to zero");
  v.list(c.sensors, "sensors", optional_key, "places that are watched");
  v.object(c.state, "state", optional_key,
           "installed, under pressure, hot: the state around which everything is computed");
  v.named(c.states, &OperatingState::name, "states", optional_key,
          "states by name, their headline numbers beside one another; plica run CASE --state NAME "
          "for all of one");
  v.object(c.analyses, "analyses", optional_key, "what is computed");
  v.list(c.variants, "variants", optional_key, "the same case with some values changed");
  v.object(c.fit, "fit", optional_key, "what plica fit adjusts to the measured data");
  v.object(c.diagnose, "diagnose", optional_key,
           "which effects plica diagnose tries, and how far off the model may be");
  v.named(c.models, &AlternativeModel::name, "models", optional_key,
          "the same component by other kinds of model: plica run CASE --model NAME");
  v.text(c.measured, "measured", {}, "file of measured data, relative to this one");
}

} // namespace plica
