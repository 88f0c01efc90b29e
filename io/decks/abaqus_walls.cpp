#include "io/decks/abaqus_sections.hpp"
#include "io/decks/deck_panels.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

constexpr double by_plies = std::numeric_limits<double>::quiet_NaN(); // DeckExpansion

const std::set<std::string> shell_types{"S4", "S4R", "S4R5",   "S3",  "S3R", "STRI3",
                                        "S6", "S8",  "STRI65", "S8R", "S8R5"};
// Of the middle of the wall from the nodes, in thicknesses, along the normal: OFFSET is that of
// the nodes from the middle.
double offset(const Keyword& k) {
  const std::string word = k.word_or("OFFSET", "0");
  if (word == "SPOS") return -0.5;
  if (word == "SNEG") return 0.5;
  const DataLine line{k.at, {word}};
  return -number_in(k, line, 0);
}

} // namespace

void AbaqusSections::isotropic_wall(const Keyword& k, const ShellSection& section, double thickness,
                                    const DeckExpansion& expansion) {
  open_thickness_ = thickness;
  open_section_ = static_cast<int>(deck_.sections.size());
  first_of_section_ = deck_.laminates.size();
  deck_.sections.push_back(section);
  for (AbaqusElement* e : mesh_.elements_for(k, shell_types))
    add_shells(*e, {.section = open_section_,
                    .thickness = thickness,
                    .offset = offset(k) * thickness,
                    .expansion = expansion});
}

// Of plies, of a material that is not isotropic, or of a given matrix.
void AbaqusSections::laminated_section(const Keyword& k) {
  open_section_ = -1;
  first_of_section_ = deck_.laminates.size();
  const bool given = !k.has("COMPOSITE") && !k.has("MATERIAL");
  std::vector<Ply> plies;
  if (k.has("COMPOSITE"))
    plies = plies_of(k);
  else if (!given)
    plies = {{&material_of(k), number_in(k, data_line(k, 0), 0), 0, nullptr}};
  double t = 0;
  DeckExpansion expansion;
  for (const Ply& ply : plies) {
    t += ply.thickness;
    if (ply.material->expansion.alpha != 0) expansion.alpha = by_plies;
  }
  std::optional<ShellLaminate> matrix;
  if (given) matrix = given_matrix(k, t);
  if (!(t > 0)) deck_error(data_line(k, 0).at, "*" + k.name, "has no thickness", "above 0");
  open_thickness_ = t;
  const Keyword* axes = k.has("ORIENTATION") ? find_orientation(k, k.word("ORIENTATION")) : nullptr;
  for (AbaqusElement* e : mesh_.elements_for(k, shell_types)) {
    const Vector3d along = first_axis(*e, axes);
    add_shells(*e, {.laminate = add_laminate(matrix ? *matrix : laminate_of(plies, *e, along)),
                    .thickness = t,
                    .offset = offset(k) * t,
                    .along = along,
                    .expansion = expansion});
  }
}

void AbaqusSections::shell_section(const Keyword& k) {
  open_beams_.clear();
  const std::size_t before = deck_.shells.size();
  if (k.has("COMPOSITE")) {
    std::vector<LaminatePly> plies;
    bool isotropic = true;
    std::optional<DeckExpansion> expansion;
    for (const Ply& ply : plies_of(k)) {
      const Material& m = *ply.material;
      if (!expansion) expansion = m.expansion;
      if (expansion->alpha != m.expansion.alpha) expansion->alpha = by_plies;
      isotropic = isotropic && !m.ply;
      plies.push_back({m.E, m.nu, m.rho, m.E / (2 * (1 + m.nu)), ply.thickness});
    }
    const IsotropicLaminate laminate = isotropic
                                           ? isotropic_laminate(plies)
                                           : IsotropicLaminate{.section = {}, .refusal = "is not"};
    if (laminate.refusal.empty())
      isotropic_wall(k, laminate.section, laminate.thickness, expansion.value_or(DeckExpansion()));
    else
      laminated_section(k);
  } else if ((!k.has("MATERIAL") && k.name == "SHELL GENERAL SECTION") || material_of(k).ply) {
    laminated_section(k);
  } else {
    const Material& m = material_of(k);
    const double t = number_in(k, data_line(k, 0), 0);
    if (!(t > 0)) deck_error(data_line(k, 0).at, "*" + k.name, "has no thickness", "above 0");
    isotropic_wall(k, {.E = m.E, .nu = m.nu, .rho = m.rho}, t, m.expansion);
  }
  if (k.has("NODAL THICKNESS"))
    for (std::size_t i = before; i < deck_.shells.size(); ++i)
      of_nodal_thickness_.push_back(static_cast<int>(i));
}

// One of eight nodes as four around a node in its middle, one of six as four triangles.
void AbaqusSections::add_shells(AbaqusElement& e, const ShellWall& wall) {
  const std::vector<int> n = e.nodes;
  std::vector<std::vector<int>> parts{n};
  if (n.size() == 6)
    parts = {{n[0], n[3], n[5]}, {n[1], n[4], n[3]}, {n[2], n[5], n[4]}, {n[3], n[4], n[5]}};
  if (n.size() == 8) {
    Vector3d x = Vector3d::Zero(); // of the shape functions of eight nodes
    for (int i = 0; i < 4; ++i) x += deck_.nodes[n[i + 4]] / 2 - deck_.nodes[n[i]] / 4;
    const int middle = static_cast<int>(deck_.nodes.size());
    deck_.nodes.push_back(x);
    deck_.labels.push_back(0);
    middles_.push_back({middle, n, wall.thickness});
    parts = {{n[0], n[4], middle, n[7]},
             {n[1], n[5], middle, n[4]},
             {n[2], n[6], middle, n[5]},
             {n[3], n[7], middle, n[6]}};
  }
  split_shells_ += parts.size() > 1;
  for (const std::vector<int>& nodes : parts) {
    e.shells.push_back(static_cast<int>(deck_.shells.size()));
    deck_.shells.push_back({.nodes = nodes,
                            .section = wall.section,
                            .thickness = std::vector(nodes.size(), wall.thickness),
                            .offset = wall.offset,
                            .origin = e.origin,
                            .normal = {},
                            .laminate = wall.laminate,
                            .along = wall.along,
                            .expansion = wall.expansion});
  }
}

void AbaqusSections::membrane_section(const Keyword& k) {
  const Material& m = isotropic_material_of(k);
  const double t = number_in(k, data_line(k, 0), 0);
  if (!(t > 0)) deck_error(k.data[0].at, "*" + k.name, "has no thickness", "above 0");
  const ShellSection section{.E = m.E,
                             .nu = m.nu,
                             .rho = m.rho,
                             .bending_factor = 0,
                             .shear_correction = 0,
                             .drilling = 0};
  const int index = static_cast<int>(deck_.sections.size());
  deck_.sections.push_back(section);
  for (AbaqusElement* e : mesh_.elements_for(k, {"M3D3", "M3D4", "M3D4R"})) {
    if (e->nodes.size() == 4) {
      add_shells(
          *e,
          {.section = index, .thickness = t, .offset = offset(k) * t, .expansion = m.expansion});
      continue;
    }
    if (offset(k) != 0)
      deck_error(k.at, "*MEMBRANE SECTION", "has OFFSET for " + e->origin + " of three nodes",
                 "elements of four nodes, or no OFFSET");
    Eigen::Matrix3d x;
    for (int i = 0; i < 3; ++i) x.col(i) = deck_.nodes[e->nodes[i]];
    if (!((x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).norm() > 0))
      deck_error(e->at, "*ELEMENT", e->origin + " has no area", "three corners");
    e->bars.push_back(int(deck_.springs.size()));
    deck_.of_springs[e->bars.back()] = {e->label, e->origin, m.expansion};
    deck_.springs.push_back(membrane_triangle(e->nodes, x, section, t));
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
      const Vector3d n = mesh_.turn(k) * Vector3d(number_in(k, line, 2), number_in(k, line, 3),
                                                  number_in(k, line, 4));
      if (corner == e.nodes.end() || !(n.norm() > 0))
        deck_error(line.at, "*NORMAL", "is not a direction at a node of the element",
                   "element, node of it, three components");
      if (shell_types.contains(e.type))
        normals_.push_back({label, std::size_t(corner - e.nodes.begin()), n.normalized()});
      else
        beam_normals_.push_back({label, {k.at, k.name, {}, {}}});
    }
}

// Abaqus takes it for the second axis of the section, CalculiX for the first: where both are alike
// it says nothing.
void AbaqusSections::check_beam_normals() {
  for (const auto& [element, k] : beam_normals_)
    for (int i : mesh_.element(element).beams) {
      const BeamProperties& s = deck_.beams[std::size_t(i)].section;
      if (s.EI_y != s.EI_z || s.GA_y != s.GA_z)
        return left_out_.note(k, "is given to a beam whose section has two different axes",
                              "the direction n1 of its section");
    }
}

} // namespace plica
