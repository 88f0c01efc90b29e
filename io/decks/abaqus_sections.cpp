#include "io/decks/abaqus_sections.hpp"

#include "io/decks/deck_panels.hpp"
#include "io/decks/deck_sections.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::set<std::string> beam_types{"B31",  "B31R", "B31H",   "B33", "B33H", "PIPE31", "B32",
                                       "B32R", "B32H", "PIPE32", "B21", "B21H", "B22",    "B23"};

TurnedSection profile(const Keyword& k, const std::string& shape, const BeamMaterial& m) {
  const DataLine& line = data_line(k, 0);
  const auto size = [&](std::size_t i) {
    const double value = number_in(k, line, i);
    if (!(value > 0))
      deck_error(line.at, "*" + k.name, "has a size of " + line.fields[i], "above 0");
    return value;
  };
  if (shape == "CIRC") {
    // An ellipse of two radii is what CalculiX makes of it.
    if (line.fields.size() > 1 && !line.fields[1].empty() && size(1) != size(0))
      deck_error(line.at, "*" + k.name, "is an ellipse", "one radius");
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
  if (shape != "GENERAL" || k.name == "BEAM SECTION")
    deck_error(k.at, "*" + k.name, "has SECTION=" + shape,
               "CIRC, PIPE, RECT, BOX, I, or GENERAL with "
               "*BEAM GENERAL SECTION");
  return principal_section(m, size(0), size(1), size(3), -number_in(k, line, 2, 0),
                           number_in(k, line, 4));
}

void check_body(const Keyword& k, const RigidMass& body) {
  if (!is_body(body))
    deck_error(data_line(k, 0).at, "*" + k.name, "is no body",
               "a mass of at least 0, moments of inertia none above the sum of the other two");
}

} // namespace

KeywordHandlers AbaqusSections::materials() {
  return {
      {"MATERIAL", {[this](const Keyword& k) { begin_material(k); }, {"NAME"}}},
      {"ELASTIC", {[this](const Keyword& k) { elastic(k); }, {"TYPE", "MODULI", "DEPENDENCIES"}}},
      {"ORIENTATION",
       {[this](const Keyword& k) { orientation(k); },
        {"NAME", "SYSTEM", "DEFINITION", "LOCAL DIRECTIONS"}}},
      {"DENSITY", {[this](const Keyword& k) { density(k); }, {"DEPENDENCIES"}}}};
}

KeywordHandlers AbaqusSections::handlers() {
  const auto by = [this](void (AbaqusSections::*read)(const Keyword&)) {
    return [this, read](const Keyword& k) { (this->*read)(k); };
  };
  using S = AbaqusSections;
  return {
      {"SHELL SECTION",
       {by(&S::shell_section),
        {"ELSET", "MATERIAL", "OFFSET", "NODAL THICKNESS", "CONTROLS", "COMPOSITE", "ORIENTATION",
         "SECTION INTEGRATION", "POISSON", "TEMPERATURE", "STACK DIRECTION", "SYMMETRIC",
         "LAYUP"}}},
      {"SHELL GENERAL SECTION",
       {by(&S::shell_section),
        {"ELSET", "MATERIAL", "OFFSET", "NODAL THICKNESS", "CONTROLS", "COMPOSITE", "ORIENTATION",
         "POISSON", "DENSITY", "SYMMETRIC", "LAYUP"}}},
      {"MEMBRANE SECTION",
       {by(&S::membrane_section), {"ELSET", "MATERIAL", "CONTROLS", "ORIENTATION"}}},
      {"SOLID SECTION",
       {by(&S::solid_section), {"ELSET", "MATERIAL", "CONTROLS", "ORIENTATION", "REF NODE"}}},
      {"NODAL THICKNESS", {by(&S::nodal_thickness), {}}},
      {"NORMAL", {by(&S::normal), {"TYPE"}}},
      {"BEAM SECTION",
       {by(&S::beam_section), {"ELSET", "MATERIAL", "SECTION", "POISSON", "TEMPERATURE"}}},
      {"BEAM GENERAL SECTION", {by(&S::beam_section), {"ELSET", "SECTION", "DENSITY", "POISSON"}}},
      {"TRANSVERSE SHEAR STIFFNESS", {by(&S::transverse_shear), {}}},
      {"MASS", {by(&S::mass), {"ELSET"}}},
      {"ROTARY INERTIA", {by(&S::rotary_inertia), {"ELSET"}}},
      {"SPRING", {by(&S::spring), {"ELSET", "NONLINEAR"}}}};
}

void AbaqusSections::begin_material(const Keyword& k) {
  material_ = k.word("NAME");
  const auto [material, first] = materials_.try_emplace(material_);
  int& line = material->second.lines["MATERIAL"];
  if (!first)
    deck_error(k.at, "*MATERIAL",
               "material " + material_ + " is there already in line " + std::to_string(line),
               "a name once");
  line = k.at.line;
}

AbaqusSections::Material& AbaqusSections::open_material(const Keyword& k) {
  if (material_.empty())
    deck_error(k.at, "*" + k.name, "belongs to no material", "*MATERIAL, NAME=... before it");
  Material& material = materials_.at(material_);
  const auto [line, first] = material.lines.try_emplace(k.name, k.at.line);
  if (!first)
    deck_error(k.at, "*" + k.name,
               "material " + material_ + " has one already in line " + std::to_string(line->second),
               "one for each material");
  return material;
}

// Of values over temperature, `fields` a line with it, the first are taken.
void AbaqusSections::note_first_of_many(const Keyword& k, std::size_t fields) {
  if (k.data.size() < 2) return;
  for (const DataLine& line : k.data)
    if (line.fields.size() < fields || line.fields[fields - 1].empty())
      deck_error(line.at, "*" + k.name,
                 "has " + std::to_string(k.data.size()) + " data lines and no temperatures in them",
                 "one line, or a temperature in each");
  deck_.notes.push_back("of *" + k.name + " in line " + std::to_string(k.at.line) +
                        ", which depends on temperature, the first values are taken");
}

void AbaqusSections::elastic(const Keyword& k) {
  std::string type = k.word_or("TYPE", "ISOTROPIC");
  if (type == "ENGINEERINGCONSTANTS") type = "ENGINEERING CONSTANTS";
  if (type == "ORTHO") type = "ORTHOTROPIC";
  if (type == "LAMINA" || type == "ENGINEERING CONSTANTS" || type == "ORTHOTROPIC") {
    Material& m = open_material(k);
    elastic_ply(k, m, type);
    m.elastic = true;
    return;
  }
  if (type != "ISOTROPIC" && type != "ISO")
    deck_error(k.at, "*ELASTIC", "has TYPE=" + k.word("TYPE"),
               "ISOTROPIC, LAMINA, ENGINEERING CONSTANTS or ORTHOTROPIC");
  note_first_of_many(k, 3);
  Material& m = open_material(k);
  m.E = number_in(k, data_line(k, 0), 0);
  m.nu = number_in(k, data_line(k, 0), 1, 0);
  m.elastic = true;
  if (!(m.E > 0) || !(m.nu > -1 && m.nu < 0.5))
    deck_error(k.data[0].at, "*ELASTIC", "is no material", "E above 0, nu between -1 and 0.5");
}

void AbaqusSections::density(const Keyword& k) {
  Material& m = open_material(k);
  note_first_of_many(k, 2);
  m.rho = number_in(k, data_line(k, 0), 0);
  if (m.rho < 0) deck_error(k.data[0].at, "*DENSITY", "is below zero", "0 or more");
}

const AbaqusSections::Material& AbaqusSections::material_of(const Keyword& k) const {
  const auto found = materials_.find(k.word("MATERIAL"));
  if (found == materials_.end() || !found->second.elastic)
    deck_error(k.at, "*" + k.name, "there is no elastic material " + k.word("MATERIAL"),
               "*MATERIAL with *ELASTIC");
  return found->second;
}

const AbaqusSections::Material& AbaqusSections::isotropic_material_of(const Keyword& k) const {
  const Material& m = material_of(k);
  if (m.ply)
    deck_error(k.at, "*" + k.name, "is of material " + k.word("MATERIAL") + ", not isotropic",
               "an isotropic material, or *SHELL SECTION");
  return m;
}

void AbaqusSections::solid_section(const Keyword& k) {
  const std::vector<AbaqusElement*> trusses =
      mesh_.elements_for(k, {"T3D2", "T2D2", "T3D3", "T2D3"});
  if (trusses.empty()) return; // of solids, which are refused or listed
  const Material& m = isotropic_material_of(k);
  const double A = k.data.empty() ? 1 : number_in(k, data_line(k, 0), 0, 1);
  if (!(A > 0)) deck_error(k.data[0].at, "*" + k.name, "has no area", "above 0");
  for (const AbaqusElement* e : trusses) {
    for (std::size_t i = 0; i + 1 < e->nodes.size(); ++i) {
      const int a = e->nodes[i], b = e->nodes[i + 1];
      if (!((deck_.nodes[a] - deck_.nodes[b]).norm() > 0))
        deck_error(e->at, "*ELEMENT", "is a truss without length", "two places");
      deck_.springs.push_back(truss({a, b}, deck_.nodes[a], deck_.nodes[b], m.E * A, 0, m.rho * A));
    }
    if (e->type.starts_with("T2D")) hold_in_plane(*e);
  }
}

void AbaqusSections::hold_in_plane(const AbaqusElement& e) {
  for (int n : e.nodes)
    for (int dof : {2, 3, 4}) deck_.supports.push_back({n, dof, {}, e.origin + " in its plane"});
}

void AbaqusSections::beam_section(const Keyword& k) {
  const bool general = k.name == "BEAM GENERAL SECTION";
  const std::string shape = k.word_or("SECTION", general ? "GENERAL" : "");
  BeamMaterial m;
  if (general) {
    m.E = number_in(k, data_line(k, 2), 0);
    const double G = number_in(k, data_line(k, 2), 1, m.E / 2.6);
    if (!(m.E > 0 && G > 0))
      deck_error(k.data[2].at, "*" + k.name, "has no stiffness", "E and G above 0");
    m.nu = m.E / (2 * G) - 1;
    m.rho = k.has("DENSITY") ? number_in(k, {k.at, {k.word("DENSITY")}}, 0) : 0;
  } else {
    const Material& from = isotropic_material_of(k);
    m = {from.E, from.nu, from.rho};
  }
  open_thickness_ = 0;
  const TurnedSection section = profile(k, shape, m);
  Vector3d n1(0, 0, -1);
  if (k.data.size() > 1)
    n1 = {number_in(k, k.data[1], 0, 0), number_in(k, k.data[1], 1, 0),
          number_in(k, k.data[1], 2, -1)};
  n1 = mesh_.turn(k) * n1;
  open_beams_.clear();
  for (const AbaqusElement* e : mesh_.elements_for(k, beam_types)) {
    split_beams_ += e->nodes.size() > 2;
    for (std::size_t i = 0; i + 1 < e->nodes.size(); ++i) {
      const Vector3d axis = deck_.nodes[e->nodes[i + 1]] - deck_.nodes[e->nodes[i]];
      // The local 1 is our y, so that our z is axis x n1.
      const Vector3d z = axis.cross(n1);
      if (!(z.norm() > 1e-6 * axis.norm() * n1.norm()))
        deck_error(e->at, "*ELEMENT", "is a beam without length, or along the n1 of its section",
                   "n1 across the axis");
      const Vector3d y = z.cross(axis).normalized();
      open_beams_.push_back(deck_.beams.size());
      deck_.beams.push_back(
          {.node1 = e->nodes[i],
           .node2 = e->nodes[i + 1],
           .section = section.properties,
           .up = std::cos(section.turn) * z.normalized() - std::sin(section.turn) * y});
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

void AbaqusSections::mass(const Keyword& k) {
  const RigidMass body{.mass = number_in(k, data_line(k, 0), 0)};
  check_body(k, body);
  for (const AbaqusElement* e : mesh_.elements_for(k, {"MASS"}))
    deck_.masses.push_back({e->nodes[0], body});
}

void AbaqusSections::rotary_inertia(const Keyword& k) {
  const DataLine& line = data_line(k, 0);
  for (const AbaqusElement* e : mesh_.elements_for(k, {"ROTARYI"})) {
    const double xx = number_in(k, line, 0), yy = number_in(k, line, 1, 0),
                 zz = number_in(k, line, 2, 0), xy = number_in(k, line, 3, 0),
                 xz = number_in(k, line, 4, 0), yz = number_in(k, line, 5, 0);
    MassElement body{.node = e->nodes[0], .body = {}};
    body.body.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    body.body.inertia = mesh_.turn(k) * body.body.inertia * mesh_.turn(k).transpose();
    check_body(k, body.body);
    deck_.masses.push_back(body);
  }
}

void AbaqusSections::spring(const Keyword& k) {
  if (k.has("NONLINEAR")) deck_error(k.at, "*SPRING", "is not linear (NONLINEAR)", "one stiffness");
  for (const AbaqusElement* e : mesh_.elements_for(k, {"SPRING1", "SPRING2", "SPRINGA"})) {
    // A blank line stands before the stiffness of SPRINGA, which has no degrees of freedom.
    const bool axial = e->type == "SPRINGA" && k.data.size() == 1;
    const double stiffness = number_in(k, data_line(k, axial ? 0 : 1), 0);
    const auto axes = [&](int n) {
      const auto own = deck_.axes.find(n);
      return own == deck_.axes.end() ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : own->second;
    };
    if (e->type == "SPRINGA") { // along the line between its nodes
      const Vector3d &x1 = deck_.nodes[e->nodes[0]], &x2 = deck_.nodes[e->nodes[1]];
      if (!((x2 - x1).norm() > 0))
        deck_error(e->at, "*ELEMENT", "is a spring without length", "two places, or SPRING2");
      deck_.springs.push_back(truss(e->nodes, x1, x2, stiffness * (x2 - x1).norm(), 0, 0));
      continue;
    }
    std::vector<SpringEnd> ends;
    for (std::size_t i = 0; i < e->nodes.size(); ++i)
      ends.push_back({e->nodes[i], along(axes(e->nodes[i]), dof_in(k, data_line(k, 0), i))});
    const Eigen::MatrixXd K = spring_matrix(ends, stiffness);
    deck_.springs.push_back(
        {.nodes = e->nodes, .K = K, .M = Eigen::MatrixXd::Zero(K.rows(), K.cols())});
  }
}

void AbaqusSections::finish() {
  note_laminates(deck_);
  for (int s : of_nodal_thickness_) {
    DeckShell& shell = deck_.shells[s];
    for (std::size_t a = 0; a < shell.nodes.size(); ++a)
      if (const auto t = thickness_.find(shell.nodes[a]); t != thickness_.end())
        shell.thickness[a] = t->second;
  }
  for (const auto& [label, corner, n] : normals_) {
    const AbaqusElement& e = mesh_.element(label);
    for (int s : e.shells) {
      DeckShell& shell = deck_.shells[s];
      const auto at = std::find(shell.nodes.begin(), shell.nodes.end(), e.nodes[corner]);
      if (at == shell.nodes.end()) continue;
      shell.normal.resize(shell.nodes.size());
      shell.normal[std::size_t(at - shell.nodes.begin())] = n;
    }
  }
  if (split_shells_ > 0)
    deck_.notes.push_back(
        std::to_string(split_shells_) +
        " shells of eight or six nodes are split, each into four of four or three nodes");
  if (split_beams_ > 0)
    deck_.notes.push_back(std::to_string(split_beams_) +
                          " beams of three nodes are split, each into two of two nodes");
}

} // namespace plica
