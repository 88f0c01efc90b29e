#include "io/decks/abaqus_sections.hpp"

#include "io/decks/deck_sections.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

const std::set<std::string> shell_types{"S4", "S4R", "S4R5", "S3", "S3R"};

// Of the middle of the wall from the nodes, in thicknesses, along the normal: OFFSET is that of
// the nodes from the middle.
double offset(const Keyword& k) {
  const std::string word = k.word_or("OFFSET", "0");
  if (word == "SPOS") return -0.5;
  if (word == "SNEG") return 0.5;
  const DataLine line{k.at, {word}};
  return -number_in(k, line, 0);
}

BeamProperties profile(const Keyword& k, const std::string& shape, const BeamMaterial& m) {
  const DataLine& line = data_line(k, 0);
  const auto size = [&](std::size_t i) {
    const double value = number_in(k, line, i);
    if (!(value > 0))
      deck_error(line.at, "*" + k.name, "has a size of " + line.fields[i], "above 0");
    return value;
  };
  if (shape == "CIRC") return round_section(m, size(0));
  if (shape == "RECT") return rectangle_section(m, size(0), size(1));
  if (shape == "PIPE") {
    const double radius = size(0), wall = size(1);
    if (wall >= radius)
      deck_error(line.at, "*" + k.name, "has a wall that fills the pipe",
                 "a wall below the outer radius, or SECTION=CIRC");
    return pipe_section(m, radius - wall / 2, wall);
  }
  if (shape != "GENERAL" || k.name == "BEAM SECTION")
    deck_error(k.at, "*" + k.name, "has SECTION=" + shape,
               "CIRC, PIPE, RECT, or GENERAL with "
               "*BEAM GENERAL SECTION");
  if (number_in(k, line, 2, 0) != 0)
    deck_error(line.at, "*" + k.name, "has a product of inertia I12",
               "n1 along a principal axis, and I12 = 0");
  return general_section(m, size(0), size(1), size(3), number_in(k, line, 4));
}

void check_body(const Keyword& k, const RigidMass& body) {
  if (!is_body(body))
    deck_error(data_line(k, 0).at, "*" + k.name, "is no body",
               "a mass of at least 0, moments of inertia none above the sum of the other two");
}

} // namespace

KeywordHandlers AbaqusSections::materials() {
  return {{"MATERIAL", {[this](const Keyword& k) { begin_material(k); }, {"NAME"}}},
          {"ELASTIC", {[this](const Keyword& k) { elastic(k); }, {"TYPE"}}},
          {"DENSITY", {[this](const Keyword& k) { density(k); }, {}}}};
}

KeywordHandlers AbaqusSections::handlers() {
  const auto by = [this](void (AbaqusSections::*read)(const Keyword&)) {
    return [this, read](const Keyword& k) { (this->*read)(k); };
  };
  using S = AbaqusSections;
  return {
      {"SHELL SECTION",
       {by(&S::shell_section), {"ELSET", "MATERIAL", "OFFSET", "NODAL THICKNESS", "CONTROLS"}}},
      {"NODAL THICKNESS", {by(&S::nodal_thickness), {}}},
      {"NORMAL", {by(&S::normal), {"TYPE"}}},
      {"BEAM SECTION", {by(&S::beam_section), {"ELSET", "MATERIAL", "SECTION", "POISSON"}}},
      {"BEAM GENERAL SECTION", {by(&S::beam_section), {"ELSET", "SECTION", "DENSITY", "POISSON"}}},
      {"TRANSVERSE SHEAR STIFFNESS", {by(&S::transverse_shear), {}}},
      {"MASS", {by(&S::mass), {"ELSET"}}},
      {"ROTARY INERTIA", {by(&S::rotary_inertia), {"ELSET"}}},
      {"SPRING", {by(&S::spring), {"ELSET"}}}};
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

void AbaqusSections::elastic(const Keyword& k) {
  if (k.word_or("TYPE", "ISOTROPIC") != "ISOTROPIC" && k.word_or("TYPE", "") != "ISO")
    deck_error(k.at, "*ELASTIC", "has TYPE=" + k.word("TYPE"), "an isotropic material");
  if (k.data.size() != 1)
    deck_error(k.at, "*ELASTIC", "has " + std::to_string(k.data.size()) + " data lines",
               "one: E, nu; values over temperature are not read");
  Material& m = open_material(k);
  m.E = number_in(k, data_line(k, 0), 0);
  m.nu = number_in(k, data_line(k, 0), 1, 0);
  m.elastic = true;
  if (!(m.E > 0) || !(m.nu > -1 && m.nu < 0.5))
    deck_error(k.data[0].at, "*ELASTIC", "is no material", "E above 0, nu between -1 and 0.5");
}

void AbaqusSections::density(const Keyword& k) {
  Material& m = open_material(k);
  if (k.data.size() > 1)
    deck_error(k.at, "*DENSITY", "has " + std::to_string(k.data.size()) + " data lines",
               "one; values over temperature are not read");
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

void AbaqusSections::shell_section(const Keyword& k) {
  const Material& m = material_of(k);
  const double t = number_in(k, data_line(k, 0), 0);
  open_beams_.clear();
  if (!(t > 0)) deck_error(k.data[0].at, "*SHELL SECTION", "has no thickness", "above 0");
  const int section = static_cast<int>(deck_.sections.size());
  deck_.sections.push_back({.E = m.E, .nu = m.nu, .rho = m.rho});
  for (AbaqusElement* e : mesh_.elements_for(k, shell_types)) {
    e->shell = static_cast<int>(deck_.shells.size());
    deck_.shells.push_back({.nodes = e->nodes,
                            .section = section,
                            .thickness = std::vector(e->nodes.size(), t),
                            .offset = offset(k) * t,
                            .origin = e->origin,
                            .normal = {}});
    if (k.has("NODAL THICKNESS")) of_nodal_thickness_.push_back(e->shell);
  }
}

void AbaqusSections::nodal_thickness(const Keyword& k) {
  for (const DataLine& line : k.data)
    for (int n : mesh_.nodes(k, line, line.fields.at(0))) thickness_[n] = number_in(k, line, 1);
}

void AbaqusSections::normal(const Keyword& k) {
  if (k.word_or("TYPE", "ELEMENT") != "ELEMENT")
    deck_error(k.at, "*NORMAL", "has TYPE=" + k.word("TYPE"), "TYPE=ELEMENT");
  for (const DataLine& line : k.data)
    for (int label : mesh_.elements(k, line, line.fields.at(0))) {
      const AbaqusElement& e = mesh_.element(label);
      const auto corner = std::find(e.nodes.begin(), e.nodes.end(), mesh_.node(k, line, 1));
      const Vector3d n(number_in(k, line, 2), number_in(k, line, 3), number_in(k, line, 4));
      if (corner == e.nodes.end() || !(n.norm() > 0))
        deck_error(line.at, "*NORMAL", "is not a direction at a node of the element",
                   "element, node of it, three components");
      if (shell_types.contains(e.type))
        normals_.push_back({label, std::size_t(corner - e.nodes.begin()), n.normalized()});
      else
        left_out_.note(k, "is given to a beam", "the direction n1 of its section");
    }
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
    const Material& from = material_of(k);
    m = {from.E, from.nu, from.rho};
  }
  const BeamProperties section = profile(k, shape, m);
  Vector3d n1(0, 0, -1);
  if (k.data.size() > 1)
    n1 = {number_in(k, k.data[1], 0, 0), number_in(k, k.data[1], 1, 0),
          number_in(k, k.data[1], 2, -1)};
  open_beams_.clear();
  for (const AbaqusElement* e : mesh_.elements_for(k, {"B31", "B33"})) {
    const Vector3d axis = deck_.nodes[e->nodes[1]] - deck_.nodes[e->nodes[0]];
    // The local 1 is our y, so that our z is axis x n1.
    const Vector3d up = axis.cross(n1);
    if (!(up.norm() > 1e-6 * axis.norm() * n1.norm()))
      deck_error(e->at, "*ELEMENT", "is a beam without length, or along the n1 of its section",
                 "n1 across the axis");
    open_beams_.push_back(deck_.beams.size());
    deck_.beams.push_back(
        {.node1 = e->nodes[0], .node2 = e->nodes[1], .section = section, .up = up.normalized()});
    if (e->type == "B33") {
      BeamProperties& slender = deck_.beams.back().section;
      slender.GA_y = slender.GA_z = std::numeric_limits<double>::infinity();
    }
  }
}

void AbaqusSections::transverse_shear(const Keyword& k) {
  if (open_beams_.empty())
    deck_error(k.at, "*" + k.name, "follows no section of a beam", "after *BEAM SECTION");
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
    check_body(k, body.body);
    deck_.masses.push_back(body);
  }
}

void AbaqusSections::spring(const Keyword& k) {
  const DataLine& dofs = data_line(k, 0);
  const double stiffness = number_in(k, data_line(k, 1), 0);
  for (const AbaqusElement* e : mesh_.elements_for(k, {"SPRING1", "SPRING2"})) {
    const int first = dof_in(k, dofs, 0);
    MatrixElement spring{.nodes = e->nodes, .K = {}, .M = {}};
    const auto size = static_cast<Eigen::Index>(6 * e->nodes.size());
    Eigen::VectorXd stretch = Eigen::VectorXd::Unit(size, first);
    if (e->nodes.size() == 2) stretch[6 + dof_in(k, dofs, 1)] -= 1;
    spring.K = stiffness * stretch * stretch.transpose();
    spring.M = Eigen::MatrixXd::Zero(size, size);
    deck_.springs.push_back(std::move(spring));
  }
}

void AbaqusSections::finish() {
  for (int s : of_nodal_thickness_) {
    DeckShell& shell = deck_.shells[s];
    for (std::size_t a = 0; a < shell.nodes.size(); ++a)
      if (const auto t = thickness_.find(shell.nodes[a]); t != thickness_.end())
        shell.thickness[a] = t->second;
  }
  for (const auto& [label, corner, n] : normals_) {
    DeckShell& shell = deck_.shells[mesh_.element(label).shell];
    shell.normal.resize(shell.nodes.size());
    shell.normal[corner] = n;
  }
}

} // namespace plica
