// Sections of the beams of an Abaqus deck, and of those of CalculiX.
#include "io/decks/abaqus_sections.hpp"

#include "io/decks/deck_panels.hpp"
#include "io/decks/deck_profiles.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

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

// A section, and where the line of the nodes is in its drawing, m.
struct DrawnSection {
  TurnedSection section;
  std::array<double, 2> line{};
};

double section_size(const BeamProperties& p) {
  return std::sqrt((p.EI_y + p.EI_z) / p.EA);
}

// Of BOX the walls right, up, left, down; the line of the nodes is in its middle, of I at `l` above
// the lower edge, of L where the middles of its legs meet.
DrawnSection walled_profile(const Keyword& k, const std::string& shape, const BeamMaterial& m) {
  const DataLine& line = data_line(k, 0);
  const auto size = [&](std::size_t i, std::size_t otherwise) {
    const bool given = i < line.fields.size() && !line.fields[i].empty();
    const double value = number_in(k, line, given ? i : otherwise);
    if (!(value > 0))
      deck_error(line.at, "*" + k.name, "has a size that is not above 0", "above 0");
    return value;
  };
  try {
    if (shape == "BOX") {
      const double t1 = size(2, 2), t2 = size(3, 2);
      const BoxWalls walls{.right = t1, .top = t2, .left = size(4, 2), .bottom = size(5, 3)};
      return {profile_section(m, box_profile(size(0, 0), size(1, 1), walls))};
    }
    if (shape == "L") {
      const double foot = size(2, 2), leg = size(3, 2);
      return {profile_section(m, l_profile(size(0, 0), size(1, 1), foot, leg)),
              {leg / 2, foot / 2}};
    }
    return {profile_section(m, i_profile(size(1, 1), size(6, 6), {size(2, 2), size(4, 4)},
                                         {size(3, 3), size(5, 5)})),
            {0, number_in(k, line, 0)}};
  } catch (const std::invalid_argument&) {
    deck_error(line.at, "*" + k.name, "has sizes that do not fit its shape " + shape,
               "walls and flanges within the height and width, that leave room between them");
  }
}

DrawnSection profile(const Keyword& k, const std::string& shape, const BeamMaterial& m) {
  const DataLine& line = data_line(k, 0);
  const auto size = [&](std::size_t i) {
    const double value = number_in(k, line, i);
    if (!(value > 0))
      deck_error(line.at, "*" + k.name, "has a size of " + line.fields[i], "above 0");
    return value;
  };
  if (shape == "CIRC") {
    // Of Abaqus: its radius. Two numbers are of CalculiX alone: its thicknesses along 1 and 2.
    if (line.fields.size() > 1 && !line.fields[1].empty()) return {{ellipse(m, size(0), size(1))}};
    return {{round_section(m, size(0))}};
  }
  if (shape == "RECT") return {{rectangle_section(m, size(0), size(1))}};
  if (shape == "PIPE") {
    const double radius = size(0), wall = size(1);
    if (wall >= radius)
      deck_error(line.at, "*" + k.name, "has a wall that fills the pipe",
                 "a wall below the outer radius, or SECTION=CIRC");
    return {{pipe_section(m, radius - wall / 2, wall)}};
  }
  if (shape == "BOX" || shape == "I" || shape == "L") return walled_profile(k, shape, m);
  if (shape == "GENERAL" && k.name == "BEAM SECTION") { // U1 of CalculiX
    DrawnSection s{principal_section(m, size(0), size(1), size(3), 0, size(1) + size(3))};
    s.section.properties.GA_y = s.section.properties.GA_z =
        size(4) * m.E / (2 * (1 + m.nu)) * size(0);
    if (number_in(k, line, 2) != 0)
      deck_error(line.at, "*BEAM SECTION", "has a product of inertia", "0, as in CalculiX");
    return s;
  }
  if (shape != "GENERAL")
    deck_error(k.at, "*" + k.name, "has SECTION=" + shape,
               "CIRC, PIPE, RECT, BOX, I, L, or GENERAL with "
               "*BEAM GENERAL SECTION");
  return {principal_section(m, size(0), size(1), size(3), -number_in(k, line, 2, 0),
                            number_in(k, line, 4))};
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
  const DrawnSection drawn = profile(k, shape, m);
  Vector3d n1(0, 0, -1);
  if (k.data.size() > 1)
    n1 = {number_in(k, k.data[1], 0, 0), number_in(k, k.data[1], 1, 0),
          number_in(k, k.data[1], 2, -1)};
  n1 = mesh_.turn(k) * n1;
  open_beams_.clear();
  const Vector3d beside = beam_offset(k, shape);
  const auto from = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const Vector3d arm(a[0] - b[0], a[1] - b[1], 0); // what is rounding is none
    return Vector3d((arm.array().abs() > 1e-9 * section_size(drawn.section.properties))
                        .select(arm, Vector3d::Zero()));
  };
  const Vector3d to_shear_centre = beside + from(drawn.section.shear_centre, drawn.line);
  const Vector3d to_neutral = from(drawn.section.centroid, drawn.section.shear_centre);
  for (AbaqusElement* e : mesh_.elements_for(k, beam_types)) {
    if ((e->type == "U1") != (shape == "GENERAL" && !general))
      deck_error(k.at, "*" + k.name, "SECTION=" + shape + " is of " + e->type,
                 "SECTION=GENERAL of U1 alone");
    split_beams_ += e->nodes.size() > 2;
    const Vector3d own = e->towards < 0 ? n1 : deck_.nodes[e->towards] - deck_.nodes[e->nodes[0]];
    for (std::size_t i = 0; i + 1 < e->nodes.size(); ++i)
      add_beam(*e, i, own, drawn.section, to_shear_centre, to_neutral, expansion);
    if (e->type.starts_with("B2")) hold_in_plane(*e);
  }
}

// Between two nodes of an element. The local 1 is our y, so that our z is axis x n1.
void AbaqusSections::add_beam(AbaqusElement& e, std::size_t first, const Vector3d& n1,
                              const TurnedSection& section, const Vector3d& to_shear_centre,
                              const Vector3d& to_neutral, const DeckExpansion& expansion) {
  BeamElement beam{
      .node1 = e.nodes[first], .node2 = e.nodes[first + 1], .section = section.properties};
  const std::vector<Vector3d> ends{deck_.nodes[beam.node1], deck_.nodes[beam.node2]};
  const Vector3d axis = ends[1] - ends[0], across = axis.cross(n1);
  if (!(across.norm() > 1e-6 * axis.norm() * n1.norm()))
    deck_error(e.at, "*ELEMENT", "is a beam without length, or along the n1 of its section",
               "n1 across the axis");
  const Vector3d z = across.normalized(), y = z.cross(axis).normalized();
  beam.up = std::cos(section.turn) * z - std::sin(section.turn) * y;
  beam.offset1 = beam.offset2 = to_shear_centre[0] * y + to_shear_centre[1] * z;
  if (e.type.find("33") != std::string::npos || e.type == "B23")
    beam.section.GA_y = beam.section.GA_z = std::numeric_limits<double>::infinity();
  const DeckBar bar{e.label, e.origin, expansion, y};
  if (!to_neutral.isZero(0)) {
    e.bars.push_back(int(deck_.springs.size()));
    deck_.of_springs[e.bars.back()] = bar;
    deck_.springs.push_back(
        beam_beside_its_line(ends, beam, {.neutral = to_neutral[0] * y + to_neutral[1] * z}));
    return;
  }
  open_beams_.push_back(deck_.beams.size());
  e.beams.push_back(int(deck_.beams.size()));
  deck_.of_beams[e.beams.back()] = bar;
  deck_.beams.push_back(beam);
}

void AbaqusSections::transverse_shear(const Keyword& k) {
  if (open_beams_.empty() && open_thickness_ > 0) return wall_shear(k);
  if (open_beams_.empty())
    deck_error(k.at, "*" + k.name,
               "follows no section, or one of beams that bear beside the line of their nodes",
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
