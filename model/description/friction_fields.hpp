// Every key of friction laws and of level sweeps; see field_types.hpp for the visitor.
#pragma once

#include "model/description/case.hpp"
#include "words/field_types.hpp"

namespace plica {

template <bool angular> struct FrictionUnits {
  static constexpr Quantity stiffness{.unit = angular ? Dimension::rotational_stiffness
                                                      : Dimension::stiffness,
                                      .required = true,
                                      .min = 0,
                                      .max = 1e12, // beyond it the digits of the structure are lost
                                      .exclusive_min = true};
  static constexpr Quantity slip_force{.unit = angular ? Dimension::moment : Dimension::force,
                                       .required = true,
                                       .min = 0,
                                       .exclusive_min = true};
  static constexpr Dimension motion = angular ? Dimension::angle : Dimension::length;
};
inline constexpr Quantity iwan_chi{.min = -1, .max = 0, .exclusive_min = true};
inline constexpr Quantity not_negative{.min = 0};
inline constexpr Whole slider_count{.min = 1, .max = 1000};

template <class V, bool angular> void fields(V& v, SliderLaw<angular>& s) {
  v.quantity(s.stiffness, "stiffness", FrictionUnits<angular>::stiffness, "of the spring");
  v.quantity(s.slip_force, "slip_force", FrictionUnits<angular>::slip_force,
             "at which it slips, a moment for a rotation");
}

template <class V, bool angular> void fields(V& v, IwanLaw<angular>& i) {
  v.quantity(i.stiffness, "stiffness", FrictionUnits<angular>::stiffness, "K_T, when all stick");
  v.quantity(i.slip_force, "slip_force", FrictionUnits<angular>::slip_force,
             "F_S, when all slip; a moment for a rotation");
  v.quantity(i.chi, "chi", {.min = -2, .max = 0, .exclusive_min = true},
             "exponent of micro slip; -1 and below need a smallest slip");
  v.quantity(i.beta, "beta", not_negative, "stiffness lost at macro slip over that lost before");
  v.quantity(i.smallest, "smallest",
             {.unit = Dimension::ratio, .min = 0, .max = 1, .exclusive_max = true},
             "slip displacement at which micro slip begins, of that of macro slip");
  v.whole(i.sliders, "sliders", slider_count, "Jenkins sliders that stand for it");
}

template <class V, bool angular> void fields(V& v, DryLaw<angular>& d) {
  v.quantity(d.stiffness, "stiffness", FrictionUnits<angular>::stiffness, "of the contact");
  v.quantity(d.coefficient, "coefficient", {.required = true, .min = 0, .exclusive_min = true},
             "of friction");
  v.quantity(d.normal_load, "normal_load",
             {.unit = Dimension::force, .required = true, .min = 0, .exclusive_min = true},
             "that presses the faces together");
  if constexpr (angular)
    v.quantity(d.radius, "radius",
               {.unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true},
               "on which the friction acts");
}

template <class V, bool angular> void fields(V& v, SmoothedLaw<angular>& s) {
  v.quantity(s.slip_force, "slip_force", FrictionUnits<angular>::slip_force,
             "a moment for a rotation");
  v.quantity(s.velocity, "velocity", {.required = true, .min = 0, .exclusive_min = true},
             "at which three quarters of it act, m/s or rad/s");
}

template <class V, bool angular> void fields(V& v, ClearanceLaw<angular>& c) {
  v.quantity(
      c.gap, "gap",
      {.unit = FrictionUnits<angular>::motion, .required = true, .min = 0, .exclusive_min = true},
      "free way on either side");
  v.quantity(c.stiffness, "stiffness", FrictionUnits<angular>::stiffness, "beyond it");
}

template <class V, bool angular> void fields(V& v, FrictionLaw<angular>& f) {
  v.list(f.sliders, "sliders", Need{.min_items = 1},
         "Jenkins sliders in parallel: a free spectrum of slip distances");
  v.object(f.iwan, "iwan", optional_key, "Iwan model with the four parameters of Segalman");
  v.object(f.dry, "dry", optional_key, "elastic dry friction under a normal load");
  v.object(f.smoothed, "smoothed", optional_key, "Coulomb friction without a spring, smoothed");
  v.object(f.clearance, "clearance", optional_key, "a spring beyond a gap");
  v.quantity(f.cubic, "cubic", {}, "force per third power of the motion, N/m3 or Nm/rad3");
  v.points(f.curve, "curve",
           {.unit = FrictionUnits<angular>::motion,
            .tail = FrictionUnits<angular>::slip_force.unit,
            .tail_from = 1,
            .min_items = 3},
           "[motion, force], straight between points and beyond, through [0, 0]");
}

template <class V> void fields(V& v, SlenderFriction& f) {
  v.object(f.axial, "axial", optional_key, "along the pipe");
  v.object(f.lateral, "lateral", optional_key, "across, in x and in z");
  v.object(f.bending, "bending", optional_key, "about x and about z");
  v.object(f.torsion, "torsion", optional_key, "about the pipe");
}

template <class V> void fields(V& v, InterlockFriction& f) {
  v.whole(f.segments, "segments", {.min = 1, .max = 16},
          "attachment caps: pieces that slip against each other, 1 = one element from end to end; "
          "else one between every two places where it is tied");
  fields(v, static_cast<SlenderFriction&>(f));
}

template <class V> void fields(V& v, JointFriction& f) {
  v.object(f.x, "x", optional_key, "along x");
  v.object(f.y, "y", optional_key, "along y");
  v.object(f.z, "z", optional_key, "along z");
  v.object(f.rx, "rx", optional_key, "about x");
  v.object(f.ry, "ry", optional_key, "about y");
  v.object(f.rz, "rz", optional_key, "about z");
}

template <class V> void fields(V& v, PlySlip& p) {
  v.quantity(p.bond, "bond", {.unit = Dimension::ratio, .min = 0, .max = 1},
             "bond fraction while the plies stick; the wall's own is that of slipping plies");
  v.quantity(p.slip_force, "slip_force",
             {.unit = Dimension::force, .required = true, .min = 0, .exclusive_min = true},
             "axial force on the bellows that friction between the plies bears when all slip");
  v.quantity(p.chi, "chi", iwan_chi, "exponent of micro slip, above -1, at most 0");
  v.quantity(p.beta, "beta", not_negative, "stiffness lost at macro slip over that lost before");
  v.whole(p.sliders, "sliders", slider_count, "Jenkins sliders that stand for it");
  v.whole(p.segments, "segments", {.min = 1, .max = 200}, "pieces of the bellows");
}

template <class V> void fields(V& v, LevelForce& f) {
  v.text(f.name, "name", {.required = true, .name = true}, "name");
  v.text(f.at, "at", {.required = true}, "node set, the force is spread evenly over its nodes");
  v.choice(f.direction, "direction", directions, required_key, "of the force or moment");
  v.quantities(f.levels, "levels",
               {.unit = Dimension::force_or_moment,
                .required = true,
                .min = 0,
                .exclusive_min = true,
                .min_items = 1},
               "amplitudes, increasing");
}

template <class V> void fields(V& v, Levels& l) {
  v.choices(l.bases, "base", directions, {.required = false, .min_items = 1},
            "directions in which the base moves, one by one");
  v.quantities(l.levels, "levels",
               {.unit = Dimension::acceleration, .min = 0, .exclusive_min = true, .min_items = 1},
               "amplitudes of the base acceleration, increasing");
  v.list(l.forces, "forces", optional_key, "forces, one by one, the base at rest");
  v.quantities(l.band, "band", {.unit = Dimension::frequency, .required = true, .min = 0},
               "[from, to] of the sweeps");
  v.whole(l.points, "points", {.min = 10, .max = 20000},
          "steps over the band; more where the response turns quickly");
  v.choice(l.method, "method",
           {{JointMethod::harmonic_balance, "harmonic_balance"},
            {JointMethod::describing_function, "describing_function"}},
           optional_key, "all harmonics, or equivalent linearisation of the first: the fast path");
  v.whole(l.harmonics, "harmonics", {.min = 1, .max = 63}, "the highest harmonic");
  v.whole(l.samples, "samples", {.min = 16, .max = 65536, .even = true}, "of a period");
  v.whole(l.backbones, "backbones", {.min = 0, .max = 20},
          "modes of which frequency and damping over amplitude are followed");
  v.whole(l.referee, "referee", {.min = 0, .max = 100},
          "points that integration in time checks, spread over the levels");
}

} // namespace plica
