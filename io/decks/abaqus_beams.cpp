// Sections of the beams of an Abaqus deck, and of those of CalculiX.
#include "io/decks/abaqus_sections.hpp"

#include "io/decks/deck_sections.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::set<std::string> beam_types{"B31",    "B31R", "B31H", "B33",  "B33H",
                                       "PIPE31", "B32",  "B32R", "B32H", "PIPE32",
                                       "B21",    "B21H", "B22",  "B23",  "U1"};

// Solid, of its sizes along y and z; torsion after Saint-Venant, shear as of a round one.
BeamProperties ellipse(const BeamMaterial& m, double width, double depth) {
  const double a = width / 2, b = depth / 2, A = std::numbers::pi * a * b;
  BeamProperties p =
      general_section(m, A, A * b * b / 4, A * a * a / 4, A * a * a * b * b / (a * a + b * b));
  const BeamProperties round = round_section(m, std::sqrt(a * b)); // of the same area
  p.GA_y = round.GA_y;
  p.GA_z = round.GA_z;
  return p;
}

TurnedSection profile(const Keyword& k, const std::string& shape, const BeamMaterial& m) {
  const DataLine& line = data_line(k, 0);
  const auto size = [&](std::size_t i) {
    const double value = number_in(k, line, i);
    if (!(value > 0))
      deck_error(line.at, "*" + k.name, "has a size of " + line.fields[i], "above 0");
    return value;
  };
  if (shape == "CIRC") {
    // Of Abaqus: its radius. Two numbers are of CalculiX alone: its thicknesses along 1 and 2.
    if (line.fields.size() > 1 && !line.fields[1].empty()) return {ellipse(m, size(0), size(1)), 0};
    return {round_section(m, size(0)), 0};
  }
  if (shape == "RECT") return {rectangle_section(m, size(0), size(1)), 0};
  if (shape == "PIPE") {
    const double radius = size(0), wall = size(1);
    if (wall >= radius)
      deck_error(line.at, "*" + k.name, "has a wall that fills the pipe",
                 "a wall below the outer radius, or SECTION=CIRC");
    return {pipe_section(m, radius - wall / 2, wall), 0};
  }
  if (shape == "BOX") {
    const double t = size(2);
    if (size(4) != t ||
        number_in(k, line, 3, t) != number_in(k, line, 5, number_in(k, line, 3, t)) ||
        size(0) <= 2 * t || size(1) <= 2 * number_in(k, line, 3, t))
      deck_error(line.at, "*" + k.name, "is a box of walls that do not fit, or uneven ones",
                 "walls alike on both sides that leave a hole");
    return box_section(m, size(0), size(1), t, number_in(k, line, 3, t));
  }
  if (shape == "I") {
    const double h = size(1), b1 = size(2), b2 = size(3), t1 = size(4), t2 = size(5), t3 = size(6);
    const bool even = b1 == b2 && t1 == t2 && std::abs(number_in(k, line, 0) - h / 2) < 1e-6 * h;
    if (!even || h <= t1 + t2)
      deck_error(line.at, "*" + k.name, "is an I with uneven flanges or beside its node line",
                 "l = h/2, flanges alike");
    const double at = (h - t1) / 2;
    return rectangles_section(m, {{0, -at, b1, t1}, {0, at, b2, t2}, {0, 0, t3, h - t1 - t2}});
  }
  if (shape == "GENERAL" && k.name == "BEAM SECTION") { // U1 of CalculiX
    TurnedSection s = principal_section(m, size(0), size(1), size(3), 0, size(1) + size(3));
    s.properties.GA_y = s.properties.GA_z = size(4) * m.E / (2 * (1 + m.nu)) * size(0);
    if (number_in(k, line, 2) != 0)
      deck_error(line.at, "*BEAM SECTION", "has a product of inertia", "0, as in CalculiX");
    return s;
  }
  if (shape != "GENERAL")
    deck_error(k.at, "*" + k.name, "has SECTION=" + shape,
               "CIRC, PIPE, RECT, BOX, I, or GENERAL with "
               "*BEAM GENERAL SECTION");
  return principal_section(m, size(0), size(1), size(3), -number_in(k, line, 2, 0),
                           number_in(k, line, 4));
}

} // namespace

void AbaqusSections::hold_in_plane(const AbaqusElement& e) {
  for (int n : e.nodes)
    for (int dof : {2, 3, 4}) deck_.supports.push_back({n, dof, {}, e.origin + " in its plane"});
}

// Of CalculiX: where the line of the nodes is in the section, in its thicknesses along 1 and 2.
Eigen::Vector3d AbaqusSections::beam_offset(const Keyword& k, const std::string& shape) const {
  Vector3d beside(0, 0, 0);
  for (int d = 0; d < 2; ++d) {
    const std::string name = d == 0 ? "OFFSET1" : "OFFSET2";
    if (!k.has(name)) continue;
    const double share = number_in(k, {k.at, {k.word(name)}}, 0);
    const bool rectangle = shape == "RECT" || shape == "CIRC";
    if (share != 0 && !rectangle)
      deck_error(k.at, "*" + k.name, "has " + name + " for SECTION=" + shape, "RECT or CIRC");
    const DataLine& line = data_line(k, 0);
    const double diameter = 2 * number_in(k, line, 0); // of CIRC by its radius alone
    const bool round = line.fields.size() < 2 || line.fields[1].empty();
    if (share != 0) beside[d] = -share * (round ? diameter : number_in(k, line, std::size_t(d)));
  }
  return beside;
}

void AbaqusSections::beam_section(const Keyword& k) {
  const bool general = k.name == "BEAM GENERAL SECTION";
  std::string shape = k.word_or("SECTION", general ? "GENERAL" : "");
  for (const char* known : {"RECT", "CIRC"}) // of RECTANGULAR CalculiX reads as much
    if (shape.starts_with(known)) shape = known;
  BeamMaterial m;
  DeckExpansion expansion;
  if (general) {
    m.E = number_in(k, data_line(k, 2), 0);
    const double G = number_in(k, data_line(k, 2), 1, m.E / 2.6);
    if (!(m.E > 0 && G > 0))
      deck_error(k.data[2].at, "*" + k.name, "has no stiffness", "E and G above 0");
    m.nu = m.E / (2 * G) - 1;
    expansion.alpha = number_in(k, data_line(k, 2), 2, 0);
    m.rho = k.has("DENSITY") ? number_in(k, {k.at, {k.word("DENSITY")}}, 0) : 0;
  } else {
    const Material& from = isotropic_material_of(k);
    m = {from.E, from.nu, from.rho};
    expansion = from.expansion;
  }
  open_thickness_ = 0;
  const TurnedSection section = profile(k, shape, m);
  Vector3d n1(0, 0, -1);
  if (k.data.size() > 1)
    n1 = {number_in(k, k.data[1], 0, 0), number_in(k, k.data[1], 1, 0),
          number_in(k, k.data[1], 2, -1)};
  n1 = mesh_.turn(k) * n1;
  open_beams_.clear();
  const Vector3d beside = beam_offset(k, shape);
  for (AbaqusElement* e : mesh_.elements_for(k, beam_types)) {
    if ((e->type == "U1") != (shape == "GENERAL" && !general))
      deck_error(k.at, "*" + k.name, "SECTION=" + shape + " is of " + e->type,
                 "SECTION=GENERAL of U1 alone");
    split_beams_ += e->nodes.size() > 2;
    const Vector3d own = e->towards < 0 ? n1 : deck_.nodes[e->towards] - deck_.nodes[e->nodes[0]];
    for (std::size_t i = 0; i + 1 < e->nodes.size(); ++i) {
      const Vector3d axis = deck_.nodes[e->nodes[i + 1]] - deck_.nodes[e->nodes[i]];
      // The local 1 is our y, so that our z is axis x n1.
      const Vector3d z = axis.cross(own);
      if (!(z.norm() > 1e-6 * axis.norm() * own.norm()))
        deck_error(e->at, "*ELEMENT", "is a beam without length, or along the n1 of its section",
                   "n1 across the axis");
      const Vector3d y = z.cross(axis).normalized();
      open_beams_.push_back(deck_.beams.size());
      e->beams.push_back(int(deck_.beams.size()));
      deck_.of_beams[e->beams.back()] = {e->label, e->origin, expansion, y};
      deck_.beams.push_back(
          {.node1 = e->nodes[i],
           .node2 = e->nodes[i + 1],
           .section = section.properties,
           .up = std::cos(section.turn) * z.normalized() - std::sin(section.turn) * y,
           .offset1 = beside[0] * y + beside[1] * z.normalized(),
           .offset2 = beside[0] * y + beside[1] * z.normalized()});
      if (e->type.find("33") != std::string::npos || e->type == "B23") {
        BeamProperties& slender = deck_.beams.back().section;
        slender.GA_y = slender.GA_z = std::numeric_limits<double>::infinity();
      }
    }
    if (e->type.starts_with("B2")) hold_in_plane(*e);
  }
}

void AbaqusSections::transverse_shear(const Keyword& k) {
  if (open_beams_.empty() && open_thickness_ > 0) return wall_shear(k);
  if (open_beams_.empty())
    deck_error(k.at, "*" + k.name, "follows no section",
               "after *BEAM SECTION, *SHELL SECTION or *SHELL GENERAL SECTION");
  const double K23 = number_in(k, data_line(k, 0), 0);
  const double K13 = number_in(k, data_line(k, 0), 1, K23);
  if (!(K23 > 0 && K13 > 0))
    deck_error(k.data[0].at, "*" + k.name, "is not above zero", "K23, K13");
  for (std::size_t i : open_beams_) {
    deck_.beams[i].section.GA_z = K23;
    deck_.beams[i].section.GA_y = K13;
  }
}

} // namespace plica
