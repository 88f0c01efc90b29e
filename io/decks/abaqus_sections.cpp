#include "io/decks/abaqus_sections.hpp"

#include "io/decks/deck_panels.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

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
      {"DENSITY", {[this](const Keyword& k) { density(k); }, {"DEPENDENCIES"}}},
      {"EXPANSION",
       {[this](const Keyword& k) { expansion(k); },
        {"TYPE", "ZERO", "DEPENDENCIES", "USER", "PORE FLUID"}}}};
}

KeywordHandlers AbaqusSections::handlers() {
  const auto by = [this](void (AbaqusSections::*read)(const Keyword&)) {
    return [this, read](const Keyword& k) {
      if (!mesh_.is_replaced(k)) return (this->*read)(k);
      open_beams_.clear(); // nothing that follows belongs to it
      open_thickness_ = 0;
    };
  };
  using S = AbaqusSections;
  return {{"SHELL SECTION",
           {by(&S::shell_section),
            {"ELSET", "MATERIAL", "OFFSET", "NODAL THICKNESS", "CONTROLS", "COMPOSITE",
             "ORIENTATION", "SECTION INTEGRATION", "POISSON", "TEMPERATURE", "STACK DIRECTION",
             "SYMMETRIC", "LAYUP"}}},
          {"SHELL GENERAL SECTION",
           {by(&S::shell_section),
            {"ELSET", "MATERIAL", "OFFSET", "NODAL THICKNESS", "CONTROLS", "COMPOSITE",
             "ORIENTATION", "POISSON", "DENSITY", "SYMMETRIC", "LAYUP"}}},
          {"MEMBRANE SECTION",
           {by(&S::membrane_section), {"ELSET", "MATERIAL", "CONTROLS", "ORIENTATION", "OFFSET"}}},
          {"SOLID SECTION",
           {by(&S::solid_section), {"ELSET", "MATERIAL", "CONTROLS", "ORIENTATION", "REF NODE"}}},
          {"NODAL THICKNESS", {by(&S::nodal_thickness), {}}},
          {"NORMAL", {by(&S::normal), {"TYPE"}}},
          {"BEAM SECTION",
           {by(&S::beam_section),
            {"ELSET", "MATERIAL", "SECTION", "POISSON", "TEMPERATURE", "OFFSET1", "OFFSET2",
             "LUMPED"}}},
          {"BEAM GENERAL SECTION",
           {by(&S::beam_section), {"ELSET", "SECTION", "DENSITY", "POISSON", "LUMPED"}}},
          {"TRANSVERSE SHEAR STIFFNESS", {by(&S::transverse_shear), {}}},
          {"TRANSVERSE SHEAR", {by(&S::transverse_shear), {}}}, // as it was called before
          {"USER ELEMENT",
           {by(&S::user_element),
            {"TYPE", "NODES", "INTEGRATION POINTS", "MAXDOF", "COORDINATES", "PROPERTIES",
             "I PROPERTIES", "VARIABLES", "UNSYMM", "LINEAR", "FILE", "TENSOR"}}},
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

// What is not one number for all directions and temperatures concerns who asks for these alone.
void AbaqusSections::expansion(const Keyword& k) {
  if (material_.empty()) return;
  const std::string type = k.word_or("TYPE", "ISO");
  double& alpha = materials_.at(material_).expansion.alpha;
  alpha = std::numeric_limits<double>::quiet_NaN();
  if ((type == "ISO" || type == "ISOTROPIC") && !k.has("USER") && k.data.size() == 1) try {
      alpha = number_in(k, k.data[0], 0, 0);
    } catch (const InputError&) {
    }
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
  for (AbaqusElement* e : trusses) {
    for (std::size_t i = 0; i + 1 < e->nodes.size(); ++i) {
      const int a = e->nodes[i], b = e->nodes[i + 1];
      if (!((deck_.nodes[a] - deck_.nodes[b]).norm() > 0))
        deck_error(e->at, "*ELEMENT", "is a truss without length", "two places");
      e->bars.push_back(int(deck_.springs.size()));
      deck_.of_springs[e->bars.back()] = {e->label, e->origin, m.expansion};
      deck_.springs.push_back(truss({a, b}, deck_.nodes[a], deck_.nodes[b], m.E * A, 0, m.rho * A));
    }
    if (e->type.starts_with("T2D")) hold_in_plane(*e);
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

// CalculiX has a beam U1 of its own; those of Abaqus are somebody's routines.
void AbaqusSections::user_element(const Keyword& k) {
  if (k.word_or("TYPE", "") != "U1" || !k.has("MAXDOF") || k.word_or("NODES", "2") != "2")
    left_out_.note(k, "is not had", "the beam U1 of CalculiX");
}

// Of pairs of force and displacement, those of the interval from rest on.
double AbaqusSections::slope_at_rest(const Keyword& k, std::size_t first) {
  std::vector<std::pair<double, double>> curve; // displacement, force
  for (std::size_t i = first; i < k.data.size(); ++i)
    curve.emplace_back(number_in(k, k.data[i], 1), number_in(k, k.data[i], 0));
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const auto [x1, f1] = curve[i];
    const auto [x2, f2] = curve[i + 1];
    if (!(x2 > x1)) break;
    if (x1 <= 0 && x2 > 0) {
      deck_.notes.push_back("*SPRING in line " + std::to_string(k.at.line) +
                            " is not linear: its slope from rest on is taken, " +
                            fmt::format("{:.6g}", (f2 - f1) / (x2 - x1)));
      return (f2 - f1) / (x2 - x1);
    }
  }
  deck_error(k.at, "*SPRING", "NONLINEAR has no slope at rest",
             "pairs of force and displacement that rise through zero");
}

void AbaqusSections::spring(const Keyword& k) {
  std::optional<double> slope;
  for (const AbaqusElement* e : mesh_.elements_for(k, {"SPRING1", "SPRING2", "SPRINGA"})) {
    // A blank line stands before the stiffness of SPRINGA, which has no degrees of freedom.
    const bool axial = e->type == "SPRINGA" && k.data.size() == 1;
    if (k.has("NONLINEAR") && !slope) slope = slope_at_rest(k, e->type == "SPRINGA" ? 0 : 1);
    const double stiffness = slope ? *slope : number_in(k, data_line(k, axial ? 0 : 1), 0);
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
  for (const Middle& m : middles_) { // by the shape functions of eight nodes
    double t = 0;
    bool given = false;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto own = thickness_.find(m.around[i]);
      given = given || own != thickness_.end();
      t += (i < 4 ? -0.25 : 0.5) * (own == thickness_.end() ? m.thickness : own->second);
    }
    if (given && t > 0) thickness_[m.node] = t;
  }
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
  check_beam_normals();
  if (split_shells_ > 0)
    deck_.notes.push_back(
        std::to_string(split_shells_) +
        " shells of eight or six nodes are split, each into four of four or three nodes");
  if (split_beams_ > 0)
    deck_.notes.push_back(std::to_string(split_beams_) +
                          " beams of three nodes are split, each into two of two nodes");
}

} // namespace plica
