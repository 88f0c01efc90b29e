#include "model/description/part_checks.hpp"

#include "mesh/generation/surface_file.hpp"
#include "mesh/generation/surface_mesher.hpp"
#include "model/description/deck_model.hpp"
#include "model/description/node_sets.hpp"
#include "model/description/pipe_model.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/profile.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <tuple>

namespace plica {

namespace {

std::vector<std::string> bellows_names(const Case& data) {
  std::vector<std::string> names;
  for (const Part& part : data.parts)
    if (std::holds_alternative<Bellows>(part.body)) names.push_back(part.name);
  return names;
}

void material(CheckLog& log, const Case& data, const std::string& key, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& entry : data.materials) names.push_back(entry.first);
  log.reference(key + ".material", "material", name, names);
}

// Places of shells are sets beside those that the part has.
template <class Shell> void check_place_names(const std::string& key, Shell part, CheckLog& log) {
  const std::vector<PartPlace> places = std::move(part.places);
  part.places.clear();
  Case alone;
  alone.parts.push_back({"part", std::move(part)});
  const std::vector<std::string> sets = set_names(alone);
  for (const PartPlace& place : places)
    if (std::find(sets.begin(), sets.end(), "part." + place.name) != sets.end())
      log.add(key + ".places." + place.name, "is a set that the part has", "another name");
}

void check(const std::string& key, const Bellows& b, const Case& data, CheckLog& log) {
  check_place_names(key, b, log);
  material(log, data, key, b.material);
  const double t = total_thickness(b.wall);
  if (log.fine(key + ".root_radius") && log.fine(key + ".wall.plies")) {
    double radius = b.root_radius;
    for (std::size_t i = 0; i < b.profile.size(); ++i) {
      const std::string section = item(key + ".profile", i);
      if (!log.fine(section)) break; // the radius behind it is unknown
      for (const ProfileProblem& p : check_section(b.profile[i], radius, t))
        log.add(section + (p.key.empty() ? "" : "." + p.key), p.wrong, p.allowed);
      radius = end_radius(b.profile[i], radius);
    }
  }
  if (log.fine(key + ".profile") && convolutions(b) > 5000)
    log.add(key + ".profile", "has " + std::to_string(convolutions(b)) + " convolutions",
            "allowed: at most 5000 in one bellows");
  for (std::size_t i = 0; i < b.dents.size(); ++i) {
    const std::string dent = item(key + ".dents", i);
    if (!log.fine(dent)) continue;
    const double off_axis = std::hypot(b.dents[i].at[0], b.dents[i].at[2]);
    if (off_axis <= b.dents[i].depth)
      log.add(dent + ".at", "lies on the axis, or the dent reaches it",
              "a place on the wall and a depth smaller than its distance from the axis");
  }
  const MeshDensity& m = b.mesh;
  if (!log.fine(key + ".mesh")) return;
  const int counts = (m.around > 0) + (m.arc > 0) + (m.wall > 0);
  if (counts > 0 && m.accuracy > 0)
    log.add(key + ".mesh", "has counts and an accuracy", "give around, arc and wall, or accuracy");
  else if (counts > 0 && counts < 3)
    log.add(key + ".mesh", "has only some of the counts",
            "give around, arc and wall together, or accuracy");
  if (counts > 0 && m.waves > 0)
    log.add(key + ".mesh.waves", "stands beside counts", "give it with an accuracy");
}

bool holds_all(const LinerContact& c) {
  return c.axial > 0 && c.lateral > 0 && c.bending > 0 && c.torsion > 0;
}

void check_contact(const std::string& key, const Interlock& i, CheckLog& log) {
  const std::string at = key + ".contact";
  const LinerContact& c = *i.contact;
  if (i.attachment == Attachment::caps && log.fine(key))
    log.add(at, "is of places along the wall, and this liner is tied to its caps alone",
            "attachment: stations or synchronous");
  if (log.fine(at) && !c.friction && c.axial + c.lateral + c.bending + c.torsion == 0)
    log.add(at, "holds nothing", "give axial, lateral, bending or torsion");
}

void check(const std::string& key, const Interlock& i, const Case& data, CheckLog& log) {
  const std::vector<std::string> bellows = bellows_names(data);
  log.reference(key + ".along", "bellows", i.along, bellows);
  if (i.contact) check_contact(key, i, log);
  if (i.attachment == Attachment::synchronous && i.contact && holds_all(*i.contact)) return;
  if ((i.attachment == Attachment::synchronous && !i.contact) || !log.fine(key)) return;
  // Its coils hang on the places where it is tied.
  const bool slides = i.attachment == Attachment::stations && i.friction && !i.contact;
  if (!slides && (i.EA <= 0 || i.EI <= 0 || i.GJ <= 0))
    log.add(key,
            i.contact ? "leans on the wall but has no stiffness of its own"
                      : "is tied at single places but has no stiffness of its own",
            i.contact
                ? "give EA, EI and GJ above 0, or all four springs and attachment: synchronous"
                : "give EA, EI and GJ above 0, or attachment: synchronous");
  if (i.attachment == Attachment::synchronous || !log.fine("caps") ||
      std::find(bellows.begin(), bellows.end(), i.along) == bellows.end())
    return; // its ends follow the circles there
  for (const char* end : {".left", ".right"}) {
    const std::string set = i.along + end;
    if (std::none_of(data.caps.begin(), data.caps.end(), [&](const Cap& c) {
          return std::find(c.of.begin(), c.of.end(), set) != c.of.end();
        }))
      log.add(key + ".attachment", "there is no cap of " + set + " to tie it to",
              "add that cap, or attachment: synchronous");
  }
}

void check(const std::string& key, const Plate& p, const Case& data, CheckLog& log) {
  check_place_names(key, p, log);
  material(log, data, key, p.material);
  if (!log.fine(key + ".corners")) return;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (p.corners[i] == p.corners[j])
        log.add(item(key + ".corners", j), "is the same point as corner " + std::to_string(i + 1),
                "four different corners in order round the plate");
}

void check(const std::string& key, const SurfacePart& s, const Case& data, CheckLog& log) {
  material(log, data, key, s.material);
  if (!log.fine(key + ".file")) return;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(s.file, ignored))
    log.add(key + ".file", "there is no file " + s.file, "a path from the folder of the case");
  const std::string suffix = std::filesystem::path(s.file).extension().string();
  if (is_cad_file(s.file) && s.size == 0 && log.fine(key + ".element_size"))
    log.add(key + ".element_size", "is missing: CAD faces have no elements", "e.g. 8 mm");
  const bool unit_known = is_cad_file(s.file) && has_unit(s.file);
  if ((is_surface_file(s.file) || is_cad_file(s.file)) && !unit_known && !s.unit &&
      log.fine(key + ".unit"))
    log.add(key + ".unit", "is missing: " + suffix + " does not say what its numbers mean",
            "the length of one unit, e.g. 1 mm");
  if (unit_known && s.unit)
    log.add(key + ".unit", "is not for " + suffix + ", which has a unit of its own",
            "leave it out");
  if (!is_surface_file(s.file) && !is_cad_file(s.file))
    log.add(key + ".file", "is neither CAD faces nor triangles",
            ".step, .stp, .iges, .igs, .brep, .stl, .obj, .ply, .glb or .gltf");
}

void check(const std::string& key, const DeckPart& d, const Case&, CheckLog& log) {
  if (log.fine(key + ".file") && deck_format(d.file) == DeckFormat::none)
    log.add(key + ".file", "is no deck that can be read",
            ".inp of Abaqus, or .bdf, .dat, .nas, .fem of Nastran");
  else if (log.fine(key + ".file") && !d.content)
    log.add(key + ".file", "there is no file " + d.file, "a path from the folder of the case");
  if (d.content && d.thickness_field.value_or(0) > 0 && d.content->shells.empty())
    log.add(key + ".thickness_field", "is of walls, and the deck has none", "leave it out");
}

void check(const std::string& key, const BeamPart& b, const Case& data, CheckLog& log) {
  if (b.section.shape != BeamShape::general)
    material(log, data, key + ".section", b.section.material);
  if (b.section.shape == BeamShape::pipe && log.fine(key + ".section") &&
      b.section.thickness >= 2 * b.section.radius)
    log.add(key + ".section.thickness",
            "the wall of " + millimetres(b.section.thickness) +
                " does not fit a mid-surface radius of " + millimetres(b.section.radius),
            "it must be below " + millimetres(2 * b.section.radius));
  if (!log.fine(key + ".points") || !log.fine(key + ".up")) return;
  for (const PartPlace& place : b.places) {
    const std::string own = key + ".places." + place.name;
    if (const double off = nearest_on_axis(b, place.at).distance; log.fine(own) && off > 1e-3)
      log.add(own + ".at", "is " + millimetres(off) + " off the axis of the beam",
              "a place on the axis, within 1 mm; sensors sit on its surface");
    if (place.name == "start" || place.name == "end" || place.name == "all")
      log.add(own, "is a set that every beam has", "another name");
  }
  for (std::size_t i = 1; i < b.points.size(); ++i) {
    const Triple &p = b.points[i - 1], &q = b.points[i];
    const Triple d{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const double length = std::hypot(d[0], d[1], d[2]);
    if (length == 0) {
      log.add(item(key + ".points", i), "is the same as the point before it", "points must differ");
      continue;
    }
    const Triple c{d[1] * b.up[2] - d[2] * b.up[1], d[2] * b.up[0] - d[0] * b.up[2],
                   d[0] * b.up[1] - d[1] * b.up[0]};
    const double up = std::hypot(b.up[0], b.up[1], b.up[2]);
    if (!(std::hypot(c[0], c[1], c[2]) > 1e-6 * length * up)) {
      log.add(key + ".up",
              "is parallel to the beam between points " + std::to_string(i) + " and " +
                  std::to_string(i + 1),
              "give an up vector across the axis, e.g. [1, 0, 0]");
      break;
    }
  }
}

void check(const std::string& key, const EquivalentPipe& p, const Case& data, CheckLog& log) {
  material(log, data, key, p.material);
  if (log.fine(key + ".convoluted") && log.fine(key + ".length") && p.convoluted > p.length)
    log.add(key + ".convoluted", "is longer than the whole", "at most " + millimetres(p.length));
  if (log.fine(key + ".outer") && p.outer.mass > 0)
    log.add(key + ".outer.mass", "is for the inner layer", "the wall that has this mass");
  if (log.fine(key + ".outer") && !(p.outer.wall > 0))
    log.add(key + ".outer", "has no wall", "the wall that has the mass of the convolutions");
  for (const auto& [name, value] :
       {std::pair{"axial", p.outer.axial}, {"torsion", p.outer.torsion}})
    if (!(value > 0) && log.fine(key + ".outer." + name))
      log.add(key + ".outer." + name, "is zero",
              "a stiffness above zero; the inner layer may have none");
  if (p.inner && log.fine(key + ".inner") && p.inner->wall > 0)
    log.add(key + ".inner.wall", "is for the outer layer", "the mass of the inner layer");
}

void check_curve(const std::string& key, const std::vector<std::array<double, 2>>& curve,
                 CheckLog& log) {
  if (curve.empty() || !log.fine(key)) return;
  bool through_rest = false;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    through_rest = through_rest || (curve[i][0] == 0 && curve[i][1] == 0);
    if (i > 0 && (curve[i][0] <= curve[i - 1][0] || curve[i][1] <= curve[i - 1][1]))
      log.add(item(key, i), "does not lie above the point before it",
              "displacements and forces that increase");
  }
  if (!through_rest) log.add(key, "does not pass through [0, 0]", "a point at rest");
}

void check_spring(const std::string& key, const ConnectorSpring& s, CheckLog& log) {
  if (!log.fine(key)) return;
  check_curve(key + ".axial_curve", s.axial_curve, log);
  check_curve(key + ".transverse_curve", s.transverse_curve, log);
  const bool curves = !s.axial_curve.empty() || !s.transverse_curve.empty();
  struct Entry {
    const char* name;
    double value;
    bool tabulated;
  };
  const std::array entries{Entry{"axial", s.axial, !s.axial_curve.empty()},
                           Entry{"transverse", s.transverse, !s.transverse_curve.empty()},
                           Entry{"bending", s.bending, false}, Entry{"torsion", s.torsion, false}};
  for (const Entry& e : entries) {
    const std::string own = key + "." + e.name;
    if (!log.fine(own)) continue;
    if (e.value > 0 && e.tabulated)
      log.add(own, "stands beside its curve", "one or the other");
    else if (e.value > 0 && !s.matrix.empty())
      log.add(own, "stands beside a matrix", "one or the other");
    else if (!(e.value > 0) && !e.tabulated && s.matrix.empty())
      log.add(own, "is missing or zero", "a stiffness above zero, or a matrix");
  }
  if (s.matrix.empty()) return;
  if (curves) log.add(key + ".matrix", "stands beside a curve", "one or the other");
  const Matrix6 law = connector_law(s);
  const double size = law.cwiseAbs().maxCoeff();
  if ((law - law.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size)
    log.add(key + ".matrix", "is not symmetric", "a symmetric stiffness matrix");
  else if (!resists_every_motion(s))
    log.add(key + ".matrix", "is not positive definite",
            "a matrix that resists every relative motion");
}

void check(const std::string& key, const ConnectorChain& c, const Case&, CheckLog& log) {
  if (log.fine(key + ".arms") && log.fine(key + ".length") && 2 * c.arms >= c.length)
    log.add(key + ".arms", "leave nothing between them", "less than half of the length");
  check_spring(key + ".spring", c.spring, log);
  if (!c.end_spring) return;
  check_spring(key + ".end_spring", *c.end_spring, log);
  const auto curves = [](const ConnectorSpring& s) {
    return !s.axial_curve.empty() || !s.transverse_curve.empty();
  };
  const auto& [one, other] = std::tie(c.spring, *c.end_spring);
  if ((curves(one) && !other.matrix.empty()) || (curves(other) && !one.matrix.empty()))
    log.add(key + ".end_spring", "joins a matrix and a curve in one chain", "one or the other");
  if (c.count < 3 && log.fine(key + ".count"))
    log.add(key + ".end_spring",
            "leaves no element for spring: there are " + std::to_string(c.count),
            "at least three elements");
}

void check(const std::string& key, const PointMass& m, const Case&, CheckLog& log) {
  log.set_reference(key + ".at", m.at);
  check_inertia(key + ".inertia", m.inertia, log);
}

} // namespace

void check_inertia(const std::string& key, const Sextuple& J, CheckLog& log) {
  if (!log.fine(key)) return;
  const double slack = 1e-9 * (std::abs(J[0]) + std::abs(J[1]) + std::abs(J[2]));
  const bool body = J[0] >= 0 && J[1] >= 0 && J[2] >= 0 && J[0] <= J[1] + J[2] + slack &&
                    J[1] <= J[2] + J[0] + slack && J[2] <= J[0] + J[1] + slack &&
                    2 * std::abs(J[3]) <= J[2] + slack && 2 * std::abs(J[4]) <= J[0] + slack &&
                    2 * std::abs(J[5]) <= J[1] + slack;
  if (!body)
    log.add(
        key, "no body has these moments of inertia",
        "xx, yy, zz at least 0 and none above the sum of the other two; 2 |xy| <= zz, 2 |yz| <= "
        "xx, 2 |zx| <= yy");
}

void check_parts(const Case& data, CheckLog& log) {
  for (const Part& part : data.parts) {
    const std::string key = part_key(part.name);
    if (log.fine(key + ".type"))
      std::visit([&](const auto& body) { check(key, body, data, log); }, part.body);
  }
}

} // namespace plica
