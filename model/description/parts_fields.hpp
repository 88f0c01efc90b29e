// Keys of the parts of a case (case_fields.hpp).
#pragma once

#include "model/description/friction_fields.hpp"
#include "model/description/parts.hpp"
#include "model/description/pipe_fields.hpp"
#include "words/field_types.hpp"

namespace plica {

template <class V> void fields(V& v, Material& m) {
  v.quantity(m.E, "E",
             {.unit = Dimension::pressure, .required = true, .min = 0, .exclusive_min = true},
             "Young's modulus");
  v.quantity(
      m.nu, "nu",
      {.required = true, .min = -1, .max = 0.5, .exclusive_min = true, .exclusive_max = true},
      "Poisson's ratio");
  v.quantity(m.rho, "rho", {.unit = Dimension::density, .required = true, .min = 0}, "density");
  v.points(
      m.E_over_temperature, "E_over_temperature",
      {.unit = Dimension::temperature, .tail = Dimension::pressure, .tail_from = 1, .min_items = 2},
      "[temperature, Young's modulus], straight in between, for a state");
  v.points(
      m.expansion, "expansion",
      {.unit = Dimension::temperature, .tail = Dimension::number, .tail_from = 1, .min_items = 2},
      "[temperature, mean thermal expansion per K between 20 degC and there], for a state");
  v.points(
      m.nu_over_temperature, "nu_over_temperature",
      {.unit = Dimension::temperature, .tail = Dimension::number, .tail_from = 1, .min_items = 2},
      "[temperature, Poisson's ratio], for a state; left out: nu");
  v.points(
      m.conductivity, "conductivity",
      {.unit = Dimension::temperature, .tail = Dimension::number, .tail_from = 1, .min_items = 2},
      "[temperature, thermal conductivity in W/(m K)], for heat conduction of a state");
}

template <class V> void fields(V& v, MeridianSection& s) {
  const Quantity above_zero{
      .unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true};
  const Quantity radius{.unit = Dimension::length, .min = 0, .exclusive_min = true};
  v.tag(s.shape, "shape",
        {{SectionShape::cuff, "cuff"},
         {SectionShape::u, "U"},
         {SectionShape::omega, "omega"},
         {SectionShape::disc, "disc"},
         {SectionShape::points, "points"}},
        required_key, "straight cuff or cone, or the shape of its convolutions");
  if (s.shape == SectionShape::cuff) {
    v.quantity(s.length, "length", above_zero, "length along the axis");
    v.whole(s.elements, "elements", {.min = 1, .max = 100000},
            "elements along it; left out: from the density of the mesh");
    v.quantity(s.end_radius, "end_radius", radius,
               "mid-surface radius at the right end of a cone; left out: a cylinder");
    return;
  }
  v.whole(s.count, "count", {.required = true, .min = 1, .max = 1000}, "number of convolutions");
  if (s.shape == SectionShape::points) {
    v.points(s.points, "points", {.unit = Dimension::length, .required = true, .min_items = 3},
             "[y, r] along the mid-surface of one convolution, from y = 0 to its pitch");
    v.choice(s.interpolation, "interpolation",
             {{Interpolation::straight, "straight"}, {Interpolation::smooth, "smooth"}},
             optional_key, "how the points are joined");
    return;
  }
  v.quantity(s.height, "height", above_zero, "from root to crown, mid-surface to mid-surface");
  v.quantity(s.pitch, "pitch", above_zero, "axial length of one convolution");
  if (s.shape == SectionShape::disc) return;
  v.quantity(s.root_arc_radius, "root_arc_radius", radius,
             "mid-surface radius of the root arc; left out: pitch/4");
  v.quantity(s.crown_arc_radius, "crown_arc_radius", radius,
             "mid-surface radius of the crown arc; left out: pitch/4");
}

template <class V> void fields(V& v, Wall& w) {
  v.quantities(w.plies, "plies",
               {.unit = Dimension::length,
                .required = true,
                .min = 0,
                .exclusive_min = true,
                .min_items = 1,
                .max_items = 100},
               "thickness of each ply");
  v.quantity(w.bond, "bond", {.unit = Dimension::ratio, .min = 0, .max = 1},
             "bond fraction of the plies in bending: 0 they slip, 1 one solid wall");
  v.tag(w.thinning, "thinning",
        {{Thinning::none, "none"}, {Thinning::uniform, "uniform"}, {Thinning::local, "local"}},
        optional_key,
        "by hydroforming; uniform: t sqrt(D_inner/D_mean), local: t(r) = t (r_root/r)^exponent");
  if (w.thinning == Thinning::local)
    v.quantity(w.thinning_exponent, "thinning_exponent", {.min = 0, .max = 3},
               "exponent of local thinning");
  v.object(w.slip, "slip", optional_key, "friction between the plies, which stick until they slip");
  v.quantity(w.thickness_field, "thickness_field", {.unit = Dimension::ratio, .min = 0, .max = 0.2},
             "how far the thickness scatters smoothly along the wall: standard deviation that a "
             "diagnosis gives it, in place of 2 % of stiffness");
}

// Of a wall that is no bellows, which has a field of nothing else.
template <class V> void thickness_field(V& v, std::optional<double>& field) {
  v.quantity(field, "thickness_field", {.unit = Dimension::ratio, .min = 0, .max = 0.2},
             "how far the thickness scatters smoothly over the wall: standard deviation that a "
             "diagnosis gives it; left out: not at all");
}

template <class V> void fields(V& v, MeshDensity& m) {
  v.whole(m.around, "around", {.min = 8, .max = 4000, .even = true},
          "elements around the circumference");
  v.whole(m.arc, "arc", {.min = 1, .max = 200}, "elements per quarter of a circular arc");
  v.whole(m.wall, "wall", {.min = 1, .max = 2000}, "elements per straight wall or cuff");
  v.quantity(
      m.accuracy, "accuracy", {.unit = Dimension::ratio, .min = 1e-4, .max = 0.2},
      "relative error aimed at in stiffness and modes, in place of the counts; left out with them: "
      "1 %");
  v.whole(
      m.waves, "waves", {.min = 1, .max = 100},
      "with an accuracy: modes up to so many waves around keep it; left out: those that a first "
      "run lists");
}

template <class V> void fields(V& v, Membrane& m) {
  v.choice(m, "membrane",
           {{Membrane::displacement, "displacement"},
            {Membrane::mitc4_plus, "mitc4+"},
            {Membrane::incompatible, "incompatible"}},
           optional_key, "membrane part of the shell element");
}

template <class V> void fields(V& v, DentSpot& d) {
  const Quantity length{
      .unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true};
  v.quantities(d.at, "at", {.unit = Dimension::length, .required = true},
               "[x, y, z] on the wall, or near it; off the axis");
  v.quantity(d.depth, "depth", length, "how far its middle is pressed towards the axis");
  v.quantity(d.radius, "radius", length, "of the sphere within which the wall is moved");
}

template <class V> void fields(V& v, PartPlace& p) {
  v.quantities(p.at, "at", {.unit = Dimension::length, .required = true},
               "[x, y, z] on the axis of a beam, on the wall of a shell");
}

template <class V> void fields(V& v, Bellows& b) {
  v.text(b.material, "material", {.required = true}, "name of a material");
  v.quantity(b.root_radius, "root_radius",
             {.unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true},
             "mid-surface radius at the left end");
  v.quantity(b.start, "start", {.unit = Dimension::length}, "y of the left end");
  v.list(b.profile, "profile", required_key, "sections of the meridian from left to right");
  v.object(b.wall, "wall", required_key, "plies of the wall");
  v.list(b.dents, "dents", optional_key, "local damage: dents");
  v.object(b.mesh, "mesh", optional_key, "density of the mesh: counts, or one accuracy");
  v.named(b.places, &PartPlace::name, "places", optional_key,
          "points of the wall where caps, masses and forces may sit, as sets bellows.<name>");
  fields(v, b.membrane);
}

template <class V> void fields(V& v, LinerContact& c) {
  const Quantity spring{.unit = Dimension::stiffness, .min = 0, .max = 1e12},
      turning{.unit = Dimension::rotational_stiffness, .min = 0, .max = 1e12};
  v.quantity(c.axial, "axial", spring, "along the pipe");
  v.quantity(c.lateral, "lateral", spring, "across, in x and in z");
  v.quantity(c.bending, "bending", turning, "about x and about z");
  v.quantity(c.torsion, "torsion", turning, "about the pipe");
  v.object(c.friction, "friction", optional_key, "of each of them, beside its springs");
}

template <class V> void fields(V& v, Interlock& i) {
  const Quantity section{.unit = Dimension::section_stiffness, .min = 0};
  v.text(i.along, "along", {.required = true}, "name of the bellows it lies in");
  v.tag(i.attachment, "attachment",
        {{Attachment::caps, "caps"},
         {Attachment::stations, "stations"},
         {Attachment::synchronous, "synchronous"}},
        optional_key, "tied to the two caps only, at stations along the bellows, or everywhere");
  if (i.attachment == Attachment::stations)
    v.whole(i.stations, "stations", {.required = true, .min = 1, .max = 1000},
            "number of inner stations, evenly spaced");
  v.object(i.contact, "contact", optional_key,
           "springs by which it leans on the wall at each place where it is tied; left out: it "
           "moves with the wall there");
  v.quantity(i.EA, "EA", {.unit = Dimension::force, .min = 0}, "axial stiffness, N");
  v.quantity(i.EI, "EI", section, "bending stiffness, N m2");
  v.quantity(i.GJ, "GJ", section, "torsional stiffness, N m2");
  v.quantity(i.mass, "mass", {.unit = Dimension::mass, .min = 0}, "total mass");
  v.quantity(i.radius, "radius", {.unit = Dimension::length, .min = 0},
             "mean radius of its mass, for rotary inertia");
  v.object(i.friction, "friction", optional_key, "between its coils, beside EA, EI and GJ");
}

template <class V> void fields(V& v, Plate& p) {
  v.text(p.material, "material", {.required = true}, "name of a material");
  v.points(p.corners, "corners", {.unit = Dimension::length, .required = true},
           "four corners [x, y, z] in order round the plate");
  v.quantity(p.thickness, "thickness",
             {.unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true},
             "thickness");
  v.whole(p.elements, "elements", {.required = true, .min = 1, .max = 2000},
          "elements along edges 1 and 3, and along edges 2 and 4");
  v.named(p.places, &PartPlace::name, "places", optional_key,
          "points of the wall where caps, masses and forces may sit, as sets plate.<name>");
  fields(v, p.membrane);
  thickness_field(v, p.thickness_field);
}

template <class V> void fields(V& v, SurfacePlace& p) {
  v.quantities(p.at, "at", {.unit = Dimension::length, .required = true}, "[x, y, z]");
  v.quantity(p.within, "within", {.unit = Dimension::length, .min = 0, .exclusive_min = true},
             "nodes at most so far from it; left out: the point of the wall itself");
}

template <class V> void fields(V& v, SurfacePart& s) {
  const Quantity length{
      .unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true};
  v.text(s.material, "material", {.required = true}, "name of a material");
  v.text(s.file, "file", {.required = true},
         "STEP, IGES or BREP faces, or triangles as STL, OBJ, PLY or glTF; from the folder of the "
         "case");
  v.quantity(s.unit, "unit",
             {.unit = Dimension::length, .min = 0, .exclusive_min = true, .is_unit = true},
             "length of one unit of a file of triangles or a BREP, which do not say");
  v.quantity(s.thickness, "thickness", length, "thickness");
  v.choice(s.given, "surface_is",
           {{WallSide::middle, "middle"}, {WallSide::outer, "outer"}, {WallSide::inner, "inner"}},
           optional_key, "of the wall; left out: its middle");
  v.quantity(s.size, "element_size", {.unit = Dimension::length, .min = 0, .exclusive_min = true},
             "largest edge of an element; left out: the triangles of the file as they are");
  v.quantity(s.turn, "element_turn", {.unit = Dimension::angle, .min = 0.02, .max = 1.6},
             "how far an element of a CAD face may turn; left out: 22.5 deg");
  v.quantity(s.weld, "weld", {.unit = Dimension::length, .min = 0},
             "vertices of triangles that are one; left out: 1 um");
  v.quantities(s.rotate, "rotate", {.unit = Dimension::angle}, "about x, then y, then z");
  v.quantities(s.move, "move", {.unit = Dimension::length}, "then moved by [x, y, z]");
  v.named(s.places, &SurfacePlace::name, "places", optional_key,
          "points of the wall, or the nodes near them, as sets part.name");
  fields(v, s.membrane);
  thickness_field(v, s.thickness_field);
}

template <class V> void fields(V& v, DeckPart& d) {
  v.text(d.file, "file", {.required = true},
         "Abaqus .inp, or Nastran .bdf, .dat, .nas, .fem; from the folder of the case");
  v.quantity(d.length_unit, "length_unit",
             {.unit = Dimension::length,
              .required = true,
              .min = 0,
              .exclusive_min = true,
              .is_unit = true},
             "length of one unit of the deck, which does not say, e.g. mm");
  v.quantity(
      d.mass_unit, "mass_unit",
      {.unit = Dimension::mass, .required = true, .min = 0, .exclusive_min = true, .is_unit = true},
      "mass of one unit, e.g. t in a deck of mm, N and MPa");
  v.choice(d.unknown_cards, "unknown_cards",
           {{UnknownCards::error, "error"}, {UnknownCards::list, "list"}}, optional_key,
           "what to do with cards that are not followed: an error, or a list among the warnings");
  v.flag(d.held, "held", "keep the supports of the deck; left out: yes");
  v.quantities(d.rotate, "rotate", {.unit = Dimension::angle}, "about x, then y, then z");
  v.quantities(d.move, "move", {.unit = Dimension::length}, "then moved by [x, y, z]");
  v.named(d.places, &SurfacePlace::name, "places", optional_key,
          "points of the wall, or the nodes near them, as sets part.name");
  fields(v, d.membrane);
  thickness_field(v, d.thickness_field);
}

template <class V> void fields(V& v, BeamSection& s) {
  const Quantity size{.unit = Dimension::length, .required = true, .min = 0, .exclusive_min = true};
  const Quantity section{
      .unit = Dimension::section_stiffness, .required = true, .min = 0, .exclusive_min = true};
  const Quantity force{.unit = Dimension::force, .required = true, .min = 0, .exclusive_min = true};
  v.tag(s.shape, "shape",
        {{BeamShape::pipe, "pipe"},
         {BeamShape::solid, "solid"},
         {BeamShape::rectangle, "rectangle"},
         {BeamShape::general, "general"}},
        required_key, "thin pipe, solid round, solid rectangle, or stiffness given as numbers");
  if (s.shape != BeamShape::general)
    v.text(s.material, "material", {.required = true}, "name of a material");
  if (s.shape == BeamShape::pipe || s.shape == BeamShape::solid)
    v.quantity(s.radius, "radius", size, "pipe: mid-surface radius; solid: outer radius");
  if (s.shape == BeamShape::pipe) v.quantity(s.thickness, "thickness", size, "wall of the pipe");
  if (s.shape == BeamShape::rectangle) {
    v.quantity(s.width, "width", size, "along the local y");
    v.quantity(s.depth, "depth", size, "along the local z");
  }
  if (s.shape != BeamShape::general) return;
  v.quantity(s.EA, "EA", force, "axial stiffness, N");
  v.quantity(s.EI, "EI", section, "bending stiffness, N m2");
  v.quantity(s.GJ, "GJ", section, "torsional stiffness, N m2");
  v.quantity(s.GA, "GA", {.unit = Dimension::force, .min = 0, .exclusive_min = true},
             "shear stiffness with its shear factor, N; left out: rigid in shear");
  v.quantity(s.mass_per_length, "mass_per_length", {.unit = Dimension::mass_per_length, .min = 0},
             "mass per length");
  v.quantity(s.rotary_inertia_per_length, "rotary_inertia_per_length",
             {.unit = Dimension::inertia_per_length, .min = 0},
             "rotary inertia per length about each transverse axis");
  v.quantity(s.polar_inertia_per_length, "polar_inertia_per_length",
             {.unit = Dimension::inertia_per_length, .min = 0},
             "rotary inertia per length about the axis");
}

template <class V> void fields(V& v, BeamPart& b) {
  v.points(b.points, "points", {.unit = Dimension::length, .required = true, .min_items = 2},
           "[x, y, z] of the axis, straight between points");
  v.whole(b.elements, "elements", {.min = 1, .max = 10000}, "elements per straight stretch");
  v.quantities(b.up, "up", {}, "local z lies in the plane of the axis and this vector");
  v.object(b.section, "section", required_key, "cross-section");
  v.named(b.places, &PartPlace::name, "places", optional_key,
          "where caps, masses and forces may sit besides its points, as sets beam.<name>");
}

template <class V> void fields(V& v, PointMass& m) {
  v.text(m.at, "at", {.required = true}, "node set it is fixed to, e.g. arm.end");
  v.quantities(m.offset, "offset", {.unit = Dimension::length},
               "[x, y, z] from that set to the centre of mass");
  v.quantity(m.mass, "mass", {.unit = Dimension::mass, .required = true, .min = 0}, "mass");
  v.flag(m.soft, "soft",
         "clamped softly: it moves with the mean motion of the set, whose circle may go out of "
         "round, and without mass holds nothing; else the set is rigid with it");
  v.quantities(m.inertia, "inertia", {.unit = Dimension::inertia},
               "about the centre of mass: [xx, yy, zz, xy, yz, zx]");
}

template <class V> void fields(V& v, Part& p) {
  v.one_of(
      p.body, "type",
      {"bellows", "interlock", "plate", "beam", "mass", "pipe", "connector", "surface", "deck"},
      "kind of part");
}

} // namespace plica
