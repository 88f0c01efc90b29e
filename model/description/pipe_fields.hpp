// Every key of equivalent pipes and connectors; see field_types.hpp for the visitor.
#pragma once

#include "model/description/case.hpp"
#include "model/description/friction_fields.hpp"
#include "words/field_types.hpp"

namespace plica {

inline constexpr Quantity positive_length{
    .unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true};

template <class V> void fields(V& v, PipeLayer& l) {
  v.quantity(l.radius, "radius", positive_length, "mean radius");
  v.quantity(l.wall, "wall", {.unit = Dimension::length, .min = 0},
             "outer layer: wall with the mass of the convolutions");
  v.quantity(l.mass, "mass", {.unit = Dimension::mass, .min = 0}, "inner layer: its mass");
  v.quantity(l.mass_radius, "mass_radius", {.unit = Dimension::length, .min = 0},
             "radius of gyration of the mass about the axis; left out: the mean radius");
  v.quantity(l.axial, "axial", {.unit = Dimension::stiffness, .required = true, .min = 0},
             "axial stiffness");
  v.quantity(l.torsion, "torsion",
             {.unit = Dimension::rotational_stiffness, .required = true, .min = 0},
             "torsional stiffness");
}

template <class V> void fields(V& v, EquivalentPipe& p) {
  v.text(p.material, "material", {.required = true}, "name of a material");
  v.quantity(p.start, "start", {.unit = Dimension::length}, "y of the left end");
  v.quantity(p.length, "length", positive_length, "of the whole");
  v.quantity(p.convoluted, "convoluted", positive_length, "length of the convoluted part");
  v.object(p.outer, "outer", required_key, "convolutions");
  v.object(p.inner, "inner", optional_key, "interlock and sleeves, along the whole length");
  v.quantity(p.end_radius, "end_radius", positive_length, "mean radius of the straight ends");
  v.quantity(p.end_wall, "end_wall", positive_length, "wall of the straight ends");
  v.quantity(p.end_cap, "end_cap", {.unit = Dimension::mass, .min = 0},
             "mass in the middle of each straight end");
  v.choice(p.modulus_over, "modulus_over",
           {{PipeLength::convoluted, "convoluted"}, {PipeLength::whole, "whole"}}, optional_key,
           "length that turns stiffnesses into moduli");
  v.choice(p.shear, "shear", {{PipeShear::rigid, "rigid"}, {PipeShear::elastic, "elastic"}},
           optional_key, "transverse shear");
  v.flag(p.rotary_inertia, "rotary_inertia", "rotary inertia of the sections");
  v.whole(p.elements, "elements", {.min = 2, .max = 10000}, "along the convoluted part");
}

template <class V> void fields(V& v, ConnectorSpring& s) {
  constexpr Quantity k{.unit = Dimension::stiffness, .min = 0};
  constexpr Quantity c{.unit = Dimension::rotational_stiffness, .min = 0};
  v.quantity(s.axial, "axial", k, "axial stiffness of one element");
  v.quantity(s.transverse, "transverse", k, "transverse stiffness of one element");
  v.quantity(s.bending, "bending", c, "bending stiffness of one element");
  v.quantity(s.torsion, "torsion", c, "torsional stiffness of one element");
  constexpr Quantity curve{
      .unit = Dimension::length, .tail = Dimension::force, .tail_from = 1, .min_items = 3};
  v.points(s.axial_curve, "axial_curve", curve,
           "in place of axial: [displacement, force] of one element, through [0, 0]");
  v.points(s.transverse_curve, "transverse_curve", curve,
           "in place of transverse: the same across");
  v.points(s.matrix, "matrix", {.unit = Dimension::number, .min_items = 6, .max_items = 6},
           "in place of these: six rows of force and moment per ux uy uz rx ry rz, in SI");
}

template <class V> void fields(V& v, ConnectorChain& c) {
  v.quantity(c.start, "start", {.unit = Dimension::length}, "y of the left end");
  v.quantity(c.length, "length", positive_length, "of the whole");
  v.quantity(c.arms, "arms", {.unit = Dimension::length, .min = 0},
             "length of a rigid arm at each end, part of the whole");
  v.whole(c.count, "count", {.required = true, .min = 1, .max = 10000}, "elements in series");
  v.object(c.spring, "spring", required_key, "one element");
  v.object(c.end_spring, "end_spring", optional_key, "the first and the last element");
  v.quantity(c.mass, "mass",
             {.unit = Dimension::mass, .required = true, .min = 0, .exclusive_min = true},
             "between the arms, shared by the elements; half of each on either node");
  v.quantity(c.radius, "radius", {.unit = Dimension::length, .min = 0},
             "radius of the mass for rotary inertia; left out: none");
  v.quantity(c.arm_mass, "arm_mass", {.unit = Dimension::mass, .min = 0}, "mass of each arm");
  v.object(c.friction, "friction", optional_key, "of each element, beside its springs");
}

} // namespace plica
