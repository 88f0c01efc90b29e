// Walls of an Abaqus deck that are not isotropic: materials of plies, axes, plies, given matrices.
#include "io/decks/abaqus_sections.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

// `count` numbers of a keyword over as many of its lines as they take; what follows is of other
// temperatures. Those of `idle`, which a wall in plane stress does not ask for, may be blank.
std::vector<double> numbers(const Keyword& k, std::size_t count, std::size_t& lines,
                            const std::set<std::size_t>& idle = {}) {
  std::vector<double> all;
  for (lines = 0; all.size() < count; ++lines) {
    const DataLine& line = data_line(k, lines);
    for (std::size_t i = 0; i < std::max<std::size_t>(line.fields.size(), 1); ++i)
      if (all.size() < count && !(i > 0 && i + 1 == line.fields.size() && line.fields[i].empty()))
        all.push_back(idle.contains(all.size()) ? number_in(k, line, i, 0) : number_in(k, line, i));
  }
  return all;
}

// Of the nine moduli of a solid, in plane stress.
PlyMaterial orthotropic_solid(const std::vector<double>& d) {
  PlyMaterial m;
  m.Q << d[0] - d[3] * d[3] / d[5], d[1] - d[3] * d[4] / d[5], 0, //
      d[1] - d[3] * d[4] / d[5], d[2] - d[4] * d[4] / d[5], 0,    //
      0, 0, d[6];
  m.G.diagonal() << d[7], d[8];
  return m;
}

} // namespace

// LAMINA: E1, E2, nu12, G12, G13, G23; ENGINEERING CONSTANTS: E1, E2, E3, nu12, nu13, nu23, G12,
// G13, G23; ORTHOTROPIC: D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323.
void AbaqusSections::elastic_ply(const Keyword& k, Material& m, const std::string& type) {
  std::size_t lines = 0;
  const std::vector<double> c = numbers(
      k, type == "LAMINA" ? 6 : 9, lines,
      type == "ENGINEERING CONSTANTS" ? std::set<std::size_t>{2, 4, 5} : std::set<std::size_t>{});
  if (type == "LAMINA")
    m.ply = orthotropic(c[0], c[1], c[2], c[3], c[4], c[5], 0);
  else if (type == "ORTHOTROPIC")
    m.ply = orthotropic_solid(c);
  else
    m.ply = orthotropic(c[0], c[1], c[3], c[6], c[7], c[8], 0);
  if (!is_material(*m.ply))
    deck_error(k.data[0].at, "*ELASTIC", "is no material in plane stress",
               "stiffness along both axes and in shear, E1 > nu12^2 E2");
  if (k.data.size() > lines)
    deck_.notes.push_back("of *ELASTIC in line " + std::to_string(k.at.line) +
                          ", which depends on temperature, the first values are taken");
}

PlyMaterial AbaqusSections::ply_of(const Material& m) const {
  PlyMaterial ply = m.ply ? *m.ply : isotropic(m.E, m.nu, m.E / (2 * (1 + m.nu)), 0);
  ply.rho = m.rho;
  return ply;
}

void AbaqusSections::orientation(const Keyword& k) {
  const std::string name = k.word("NAME");
  const auto [known, first] = orientations_.try_emplace({k.scope, name}, k);
  if (!first)
    deck_error(k.at, "*ORIENTATION",
               "orientation " + name + " is there already in line " +
                   std::to_string(known->second.at.line),
               "a name once");
}

// Axes of a named orientation at a place.
Matrix3d AbaqusSections::axes_of(const Keyword& o, const Vector3d& at) const {
  const std::string system = o.word_or("SYSTEM", "RECTANGULAR");
  const bool round = system.starts_with("C"), along_z = system.starts_with("Z");
  if ((!system.starts_with("R") && !round && !along_z) ||
      o.word_or("DEFINITION", "COORDINATES") != "COORDINATES")
    deck_error(o.at, "*ORIENTATION", "is no system of given points",
               "SYSTEM=RECTANGULAR, Z RECTANGULAR or CYLINDRICAL, DEFINITION=COORDINATES");
  const auto point = [&](std::size_t first) {
    const DataLine& line = data_line(o, 0);
    return Vector3d(number_in(o, line, first, 0), number_in(o, line, first + 1, 0),
                    number_in(o, line, first + 2, 0));
  };
  const Vector3d origin = round ? Vector3d::Zero() : point(6);
  const Matrix3d turn = mesh_.turn(o);
  Vector3d a = turn * (point(0) - origin), b = turn * (point(3) - origin);
  if (round) { // a, b on the axis; the first axis radial
    const Vector3d z = b - a, out = at - mesh_.place(o, point(0));
    b = z.cross(out);
    a = b.cross(z);
  }
  const Vector3d normal = along_z ? a : Vector3d(a.cross(b)); // z: a; a and b span the plane x z
  const Vector3d x = along_z ? Vector3d(b - b.dot(a) / a.squaredNorm() * a) : a;
  if (!(normal.norm() > 1e-9 * a.norm() * b.norm()) || !(x.norm() > 0))
    deck_error(o.at, "*ORIENTATION", "has its points on one line, or is asked on its axis",
               "points that span a plane");
  Matrix3d axes;
  axes.col(0) = x.normalized();
  axes.col(2) = normal.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

const Keyword* AbaqusSections::find_orientation(const Keyword& k, const std::string& name) const {
  auto found = orientations_.find({k.scope, name});
  if (found == orientations_.end()) found = orientations_.find({"", name});
  if (found == orientations_.end())
    deck_error(k.at, "*" + k.name, "there is no orientation " + name, "*ORIENTATION, NAME=...");
  return &found->second;
}

// Axis 1 of the plies of an element, in its plane. The second line of *ORIENTATION names the axis
// across the wall, the next one lies in it; without orientation it is the global x, or z where
// that stands within 0.1 degrees of the normal.
Vector3d AbaqusSections::first_axis(const AbaqusElement& e, const Keyword* o) {
  const auto& x = deck_.nodes;
  const std::vector<int>& n = e.nodes;
  const bool quad = n.size() == 4 || n.size() == 8;
  const Vector3d normal = (quad ? Vector3d((x[n[2]] - x[n[0]]).cross(x[n[3]] - x[n[1]]))
                                : Vector3d((x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]])))
                              .normalized();
  const auto projected = [&](const Vector3d& axis) -> Vector3d {
    return axis - axis.dot(normal) * normal;
  };
  if (o == nullptr) {
    const bool across = std::abs(normal.x()) > std::cos(0.1 * degree);
    return projected(across ? Vector3d::UnitZ() : Vector3d::UnitX());
  }
  Vector3d middle = Vector3d::Zero();
  for (int node : n) middle += x[node] / double(n.size());
  const Matrix3d axes = axes_of(*o, middle);
  int across = 2; // where nothing is said: the axis that lies across
  double angle = 0;
  if (o->data.size() > 1) {
    across = whole_in(*o, o->data[1], 0) - 1;
    angle = number_in(*o, o->data[1], 1, 0);
    if (across < 0 || across > 2)
      deck_error(o->data[1].at, "*ORIENTATION", "names no axis", "1, 2 or 3, and an angle");
  } else if (std::abs(axes.col(0).dot(normal)) > std::abs(axes.col(2).dot(normal)))
    across = 0;
  const Vector3d along = projected(axes.col((across + 1) % 3));
  if (!(along.norm() > 1e-6))
    deck_error(o->at, "*ORIENTATION", "has its axis in the plane along the normal of " + e.origin,
               "on its second line the axis that lies across the wall");
  return Eigen::AngleAxisd(angle * degree, normal) * along;
}

// Thickness, points, material, angle or orientation of each ply, SYMMETRIC: and the same mirrored.
std::vector<AbaqusSections::Ply> AbaqusSections::plies_of(const Keyword& k) const {
  std::vector<Ply> plies;
  for (const DataLine& line : k.data) {
    if (line.fields.size() < 3)
      deck_error(line.at, "*" + k.name, "names no material", "thickness, points, material");
    const auto found = materials_.find(in_capitals(line.fields[2]));
    if (found == materials_.end() || !found->second.elastic)
      deck_error(line.at, "*" + k.name, "there is no elastic material " + line.fields[2],
                 "*MATERIAL with *ELASTIC");
    Ply ply{&found->second, number_in(k, line, 0), 0, nullptr};
    if (!(ply.thickness >= 0))
      deck_error(line.at, "*" + k.name, "has a ply of thickness below zero", "0 or more");
    if (ply.thickness == 0) continue; // adds nothing
    const std::string turned = line.fields.size() > 3 ? line.fields[3] : "";
    const bool number =
        !turned.empty() && turned.find_first_not_of("+-.0123456789eE") == std::string::npos;
    if (number)
      ply.angle = number_in(k, line, 3) * degree;
    else if (!turned.empty())
      ply.orientation = find_orientation(k, in_capitals(turned));
    plies.push_back(ply);
  }
  if (plies.empty()) deck_error(k.at, "*" + k.name, "has no ply", "thickness, points, material");
  if (k.has("SYMMETRIC")) plies.insert(plies.end(), plies.rbegin(), plies.rend());
  return plies;
}

// Plies over an element whose axis 1 is given: those of an orientation of their own lie at the
// angle between the two.
ShellLaminate AbaqusSections::laminate_of(const std::vector<Ply>& plies, const AbaqusElement& e,
                                          const Vector3d& along) {
  std::vector<GeneralPly> all;
  for (const Ply& ply : plies) {
    double angle = ply.angle;
    if (ply.orientation != nullptr) {
      const auto& x = deck_.nodes;
      const std::vector<int>& n = e.nodes;
      const bool quad = n.size() == 4 || n.size() == 8;
      const Vector3d normal = quad ? (x[n[2]] - x[n[0]]).cross(x[n[3]] - x[n[1]]).normalized()
                                   : (x[n[1]] - x[n[0]]).cross(x[n[2]] - x[n[0]]).normalized();
      const Vector3d own = first_axis(e, ply.orientation);
      angle = std::atan2(along.cross(own).dot(normal), along.dot(own));
      angle = std::round(angle * 1e9) / 1e9; // alike in elements that lie alike
    }
    all.push_back({ply_of(*ply.material), ply.thickness, angle});
  }
  return general_laminate(all);
}

// Upper triangle of the matrix of forces and moments, column by column: 21 numbers; DENSITY is
// mass per area. The thickness is that of which the wall would bend as it does.
ShellLaminate AbaqusSections::given_matrix(const Keyword& k, double& thickness) const {
  std::size_t lines = 0;
  const std::vector<double> c = numbers(k, 21, lines);
  Eigen::Matrix<double, 6, 6> law;
  for (int j = 0, at = 0; j < 6; ++j)
    for (int i = 0; i <= j; ++i, ++at) law(i, j) = law(j, i) = c[std::size_t(at)];
  const double A = law(0, 0) + law(1, 1), D = law(3, 3) + law(4, 4);
  if (!(A > 0 && D > 0 && law(2, 2) > 0))
    deck_error(k.data[0].at, "*" + k.name, "gives no stiffness", "21 numbers of a stiff wall");
  const double t = thickness = std::sqrt(12 * D / A);
  ShellLaminate wall;
  wall.A = law.topLeftCorner<3, 3>() / t;
  wall.B = law.topRightCorner<3, 3>() / (t * t);
  wall.D = 12 * law.bottomRightCorner<3, 3>() / (t * t * t);
  wall.S = (A / 6 + law(2, 2) / 3) / t * Eigen::Matrix2d::Identity();
  wall.rho = k.has("DENSITY") ? number_in(k, {k.at, {k.word("DENSITY")}}, 0) / t : 0;
  wall.drilling = 1e-4 * wall.A(2, 2);
  return wall;
}

int AbaqusSections::add_laminate(const ShellLaminate& wall) {
  for (std::size_t i = deck_.laminates.size(); i > first_of_section_; --i) {
    const ShellLaminate& w = deck_.laminates[i - 1];
    if (w.A == wall.A && w.B == wall.B && w.D == wall.D && w.S == wall.S)
      return static_cast<int>(i) - 1;
  }
  deck_.laminates.push_back(wall);
  return static_cast<int>(deck_.laminates.size()) - 1;
}

// *TRANSVERSE SHEAR STIFFNESS of a wall: K11, K22, K12.
void AbaqusSections::wall_shear(const Keyword& k) {
  const DataLine& line = data_line(k, 0);
  const double K11 = number_in(k, line, 0), K22 = number_in(k, line, 1, K11),
               K12 = number_in(k, line, 2, 0);
  if (!(K11 > 0 && K11 * K22 > K12 * K12))
    deck_error(line.at, "*" + k.name, "is not above zero", "K11, K22, K12");
  const double t = open_thickness_;
  for (std::size_t i = first_of_section_; i < deck_.laminates.size(); ++i)
    deck_.laminates[i].S << K11 / t, K12 / t, K12 / t, K22 / t;
  if (first_of_section_ < deck_.laminates.size() || open_section_ < 0) return;
  ShellSection& s = deck_.sections[open_section_];
  if (std::abs(K22 / K11 - 1) > 1e-3 || std::abs(K12) > 1e-3 * K11)
    deck_error(line.at, "*" + k.name, "differs along the two axes of an isotropic wall",
               "K11 = K22, K12 = 0");
  s.shear_correction = K11 / t / (s.E / (2 * (1 + s.nu)));
}

} // namespace plica
