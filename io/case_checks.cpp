#include "io/case_checks.hpp"

#include "io/did_you_mean.hpp"
#include "io/units.hpp"
#include "model/profile_checks.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace plica {

namespace {

std::string at(const std::string& list, std::size_t i) {
  return list + "[" + std::to_string(i) + "]";
}

std::string mm(double length) {
  return short_number(length * 1000) + " mm";
}

std::vector<std::string> material_names(const Case& data) {
  std::vector<std::string> names;
  for (const auto& [name, material] : data.materials) names.push_back(name);
  return names;
}

template <class T> std::vector<std::string> part_names(const Case& data) {
  std::vector<std::string> names;
  for (const Part& part : data.parts)
    if (std::holds_alternative<T>(part.body)) names.push_back(part.name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The rules, each adding what is wrong.
class Checker {
public:
  Checker(const Case& data, const std::vector<std::string>& bad, const std::string& directory)
      : data_(data), bad_(bad), directory_(directory), sets_(set_names(data)) {
    std::erase_if(sets_, [&](const std::string& set) { return !sets_known(set); });
  }

  std::vector<InputProblem> run() {
    for (const Part& part : data_.parts) {
      key_ = "parts." + part.name;
      if (!fine(key_ + ".type")) continue;
      std::visit([&](const auto& body) { check(part.name, body); }, part.body);
    }
    if (fine("parts") && fine("materials") && problems_.empty()) unused_materials();
    caps();
    mount();
    for (std::size_t i = 0; i < data_.supports.size(); ++i)
      reference(at("supports", i) + ".set", "node set", data_.supports[i].set, sets_);
    sensors();
    analyses();
    names_once();
    measured();
    return std::move(problems_);
  }

private:
  void add(const std::string& key, std::string wrong, std::string allowed) {
    problems_.push_back({"", 0, key, std::move(wrong), std::move(allowed)});
  }

  // Nothing at, above or below this key was found wrong before.
  bool fine(const std::string& key) const {
    return std::none_of(bad_.begin(), bad_.end(),
                        [&](const std::string& b) { return is_below(b, key) || is_below(key, b); });
  }

  // False when the part that has or would have this node set could not be read.
  bool sets_known(const std::string& set) const {
    const std::string part = "parts." + set.substr(0, set.find('.'));
    return fine(part + ".type") && fine(part + ".profile") && fine(part + ".points");
  }

  void reference(const std::string& key, const std::string& kind, const std::string& name,
                 const std::vector<std::string>& names) {
    if (!fine(key) || contains(names, name)) return;
    if (!sets_known(name)) return;
    add(key, "there is no " + kind + " '" + shown(name) + "'",
        names.empty() ? "this case has none" : suggestion(name, names));
  }

  void material(const std::string& key, const std::string& name) {
    reference(key + ".material", "material", name, material_names(data_));
  }

  void check(const std::string&, const Bellows& b) {
    material(key_, b.material);
    const double t = total_thickness(b.wall);
    if (fine(key_ + ".root_radius") && fine(key_ + ".wall.plies")) {
      double radius = b.root_radius;
      for (std::size_t i = 0; i < b.profile.size(); ++i) {
        const std::string section = at(key_ + ".profile", i);
        if (!fine(section)) break; // the radius behind it is unknown
        for (const ProfileProblem& p : check_section(b.profile[i], radius, t))
          add(section + (p.key.empty() ? "" : "." + p.key), p.wrong, p.allowed);
        radius = end_radius(b.profile[i], radius);
      }
    }
    if (fine(key_ + ".profile") && convolutions(b) > 5000)
      add(key_ + ".profile", "has " + std::to_string(convolutions(b)) + " convolutions",
          "allowed: at most 5000 in one bellows");
    const MeshDensity& m = b.mesh;
    if (!fine(key_ + ".mesh")) return;
    const int counts = (m.around > 0) + (m.arc > 0) + (m.wall > 0);
    if (counts > 0 && m.accuracy > 0)
      add(key_ + ".mesh", "has counts and an accuracy", "give around, arc and wall, or accuracy");
    else if (counts > 0 && counts < 3)
      add(key_ + ".mesh", "has only some of the counts",
          "give around, arc and wall together, or accuracy");
  }

  void check(const std::string&, const Interlock& i) {
    const std::vector<std::string> bellows = part_names<Bellows>(data_);
    reference(key_ + ".along", "bellows", i.along, bellows);
    if (i.attachment == Attachment::synchronous || !fine(key_)) return;
    if (i.EA <= 0 || i.EI <= 0 || i.GJ <= 0)
      add(key_, "is tied at single places but has no stiffness of its own",
          "give EA, EI and GJ above 0, or attachment: synchronous");
    if (!contains(bellows, i.along) || !fine("caps")) return;
    for (const char* end : {".left", ".right"}) {
      const std::string set = i.along + end;
      if (std::none_of(data_.caps.begin(), data_.caps.end(),
                       [&](const Cap& c) { return c.of == set; }))
        add(key_ + ".attachment", "there is no cap of " + set + " to tie it to",
            "add that cap, or attachment: synchronous");
    }
  }

  void check(const std::string&, const Plate& p) {
    material(key_, p.material);
    if (!fine(key_ + ".corners")) return;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (p.corners[i] == p.corners[j])
          add(at(key_ + ".corners", j), "is the same point as corner " + std::to_string(i + 1),
              "four different corners in order round the plate");
  }

  void check(const std::string&, const BeamPart& b) {
    if (b.section.shape != BeamShape::general) material(key_ + ".section", b.section.material);
    if (b.section.shape == BeamShape::pipe && fine(key_ + ".section") &&
        b.section.thickness >= 2 * b.section.radius)
      add(key_ + ".section.thickness",
          "the wall of " + mm(b.section.thickness) + " does not fit a mid-surface radius of " +
              mm(b.section.radius),
          "it must be below " + mm(2 * b.section.radius));
    if (!fine(key_ + ".points") || !fine(key_ + ".up")) return;
    for (std::size_t i = 1; i < b.points.size(); ++i) {
      const Triple &p = b.points[i - 1], &q = b.points[i];
      const Triple d{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
      const double length = std::hypot(d[0], d[1], d[2]);
      if (length == 0) {
        add(at(key_ + ".points", i), "is the same as the point before it", "points must differ");
        continue;
      }
      const Triple c{d[1] * b.up[2] - d[2] * b.up[1], d[2] * b.up[0] - d[0] * b.up[2],
                     d[0] * b.up[1] - d[1] * b.up[0]};
      const double up = std::hypot(b.up[0], b.up[1], b.up[2]);
      if (!(std::hypot(c[0], c[1], c[2]) > 1e-6 * length * up)) {
        add(key_ + ".up",
            "is parallel to the beam between points " + std::to_string(i) + " and " +
                std::to_string(i + 1),
            "give an up vector across the axis, e.g. [1, 0, 0]");
        break;
      }
    }
  }

  void check(const std::string&, const PointMass& m) {
    reference(key_ + ".at", "node set", m.at, sets_);
    inertia(key_ + ".inertia", m.inertia);
  }

  // The inertia tensor of a real body: each principal moment at most the sum of the other two.
  void inertia(const std::string& key, const Sextuple& J) {
    if (!fine(key)) return;
    const double slack = 1e-9 * (std::abs(J[0]) + std::abs(J[1]) + std::abs(J[2]));
    const bool body = J[0] >= 0 && J[1] >= 0 && J[2] >= 0 && J[0] <= J[1] + J[2] + slack &&
                      J[1] <= J[2] + J[0] + slack && J[2] <= J[0] + J[1] + slack &&
                      2 * std::abs(J[3]) <= J[2] + slack && 2 * std::abs(J[4]) <= J[0] + slack &&
                      2 * std::abs(J[5]) <= J[1] + slack;
    if (!body)
      add(key, "no body has these moments of inertia",
          "xx, yy, zz at least 0 and none above the sum of the other two; 2 |xy| <= zz, 2 |yz| <= "
          "xx, 2 |zx| <= yy");
  }

  void unused_materials() {
    std::set<std::string> used;
    for (const Part& part : data_.parts) {
      if (const auto* b = std::get_if<Bellows>(&part.body)) used.insert(b->material);
      if (const auto* p = std::get_if<Plate>(&part.body)) used.insert(p->material);
      if (const auto* b = std::get_if<BeamPart>(&part.body)) used.insert(b->section.material);
    }
    for (const Variant& variant : data_.variants)
      for (const auto& [path, value] : variant.set) used.insert(value);
    for (const auto& [name, material] : data_.materials)
      if (!used.count(name)) add("materials." + name, "no part uses this material", "remove it");
  }

  void caps() {
    std::vector<std::string> ends;
    for (const Part& part : data_.parts) {
      std::vector<const char*> names;
      if (std::holds_alternative<Bellows>(part.body)) names = {"left", "right"};
      if (std::holds_alternative<BeamPart>(part.body)) names = {"start", "end"};
      if (std::holds_alternative<Plate>(part.body)) names = {"edge1", "edge2", "edge3", "edge4"};
      for (const char* name : names) ends.push_back(part.name + "." + name);
    }
    std::map<std::string, std::string> closed;
    for (const Cap& cap : data_.caps) {
      const std::string key = "caps." + cap.name;
      reference(key + ".of", "end", cap.of, ends);
      if (fine(key + ".of") && !closed.emplace(cap.of, cap.name).second)
        add(key + ".of", cap.of + " is already closed by cap '" + closed[cap.of] + "'",
            "one cap per end");
      inertia(key + ".inertia", cap.inertia);
    }
  }

  void mount() {
    std::vector<std::string> names;
    for (const Cap& cap : data_.caps) names.push_back(cap.name);
    if (!fine("caps")) return;
    for (const Mount& m : data_.mount) reference("mount." + m.cap, "cap", m.cap, names);
  }

  // Distance of a point from the box or ring a part lies in; the mesh gives the exact one later.
  double distance(const Triple& x, const Bellows& b) const {
    const auto [low, high] = radius_range(b);
    const double r = std::hypot(x[0], x[2]), end = b.start + axial_length(b);
    const double dr = std::max({low - r, r - high, 0.0});
    return std::hypot(dr, std::max({b.start - x[1], x[1] - end, 0.0}));
  }
  template <class Points> static double box_distance(const Triple& x, const Points& points) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double low = x[k], high = x[k];
      if (!points.empty()) low = high = points[0][k];
      for (const Triple& p : points) {
        low = std::min(low, p[k]);
        high = std::max(high, p[k]);
      }
      const double d = std::max({low - x[k], x[k] - high, 0.0});
      sum += d * d;
    }
    return std::sqrt(sum);
  }
  double distance(const Triple& x, const Plate& p) const { return box_distance(x, p.corners); }
  double distance(const Triple& x, const BeamPart& b) const { return box_distance(x, b.points); }
  double distance(const Triple&, const Interlock&) const { return unbounded; }
  double distance(const Triple&, const PointMass&) const { return unbounded; }

  void sensors() {
    const bool places_known =
        fine("parts") && std::none_of(problems_.begin(), problems_.end(),
                                      [](const auto& p) { return is_below(p.key, "parts"); });
    for (std::size_t i = 0; i < data_.sensors.size(); ++i) {
      const std::string key = at("sensors", i) + ".at";
      if (!places_known || !fine(key)) continue;
      double nearest = unbounded;
      std::string name;
      for (const Part& part : data_.parts) {
        const double d = std::visit(
            [&](const auto& body) { return distance(data_.sensors[i].at, body); }, part.body);
        if (d < nearest) name = part.name;
        nearest = std::min(nearest, d);
      }
      if (nearest > 5e-3)
        add(key,
            "the sensor is off the part" +
                (name.empty() ? "" : ": " + mm(nearest) + " away from '" + name + "'"),
            "allowed: at most 5 mm from the nearest part");
    }
  }

  void analyses() {
    const Analyses& a = data_.analyses;
    const std::size_t n = data_.caps.size();
    if (a.statics && n != 2 && !data_.parts.empty() && fine("caps") && fine("analyses.static"))
      add("analyses.static",
          "static stiffness is between two caps, this case has " + std::to_string(n),
          "give exactly two caps, or static: false");
    if (!a.modes || !fine("analyses.modes")) return;
    const bool band = a.modes->band[1] > 0 || a.modes->band[0] > 0;
    if (band == (a.modes->count > 0))
      add("analyses.modes", band ? "has a count and a band" : "has neither count nor band",
          "give count (number of modes) or band ([from, to] in Hz)");
    else if (band && a.modes->band[1] <= a.modes->band[0])
      add("analyses.modes.band", "ends below its start", "give [from, to] with from below to");
  }

  void names_once() {
    std::set<std::string> sensors, variants;
    for (std::size_t i = 0; i < data_.sensors.size(); ++i)
      once(sensors, data_.sensors[i].name, at("sensors", i) + ".name", "sensor");
    for (std::size_t i = 0; i < data_.variants.size(); ++i)
      once(variants, data_.variants[i].name, at("variants", i) + ".name", "variant");
  }

  void once(std::set<std::string>& names, const std::string& name, const std::string& key,
            const std::string& kind) {
    if (fine(key) && !names.insert(name).second)
      add(key, "the name '" + shown(name) + "' is used by another " + kind, "names must differ");
  }

  void measured() {
    if (data_.measured.empty() || !fine("measured")) return;
    std::error_code ignored;
    const auto path = std::filesystem::path(directory_) / data_.measured;
    if (!std::filesystem::is_regular_file(path, ignored))
      add("measured", "there is no file '" + shown(data_.measured) + "' beside this one",
          "give a path relative to the case file, or leave the key out");
  }

  const Case& data_;
  const std::vector<std::string>& bad_;
  std::string directory_;
  std::vector<std::string> sets_;
  std::string key_; // of the part in hand
  std::vector<InputProblem> problems_;
};

void add_sets(const std::string& name, const Bellows& b, std::vector<std::string>& sets) {
  for (const char* set : {".left", ".right", ".all"}) sets.push_back(name + set);
  if (b.profile.empty()) return;
  if (b.profile.front().shape == SectionShape::cuff) sets.push_back(name + ".cuff.left");
  if (b.profile.size() > 1 && b.profile.back().shape == SectionShape::cuff)
    sets.push_back(name + ".cuff.right");
  const int n = std::min(convolutions(b), 5000);
  for (const char* set : {".convolution[", ".crown[", ".root["})
    for (int k = 1; k <= n; ++k) sets.push_back(name + set + std::to_string(k) + "]");
  if (n > 0) sets.push_back(name + ".root[" + std::to_string(n + 1) + "]");
}
void add_sets(const std::string& name, const Interlock&, std::vector<std::string>& sets) {
  for (const char* set : {".start", ".end", ".all"}) sets.push_back(name + set);
}
void add_sets(const std::string& name, const Plate&, std::vector<std::string>& sets) {
  for (const char* set : {".edge1", ".edge2", ".edge3", ".edge4", ".corner1", ".corner2",
                          ".corner3", ".corner4", ".all"})
    sets.push_back(name + set);
}
void add_sets(const std::string& name, const BeamPart& b, std::vector<std::string>& sets) {
  for (const char* set : {".start", ".end", ".all"}) sets.push_back(name + set);
  for (std::size_t k = 1; k <= b.points.size(); ++k)
    sets.push_back(name + ".point[" + std::to_string(k) + "]");
}
void add_sets(const std::string&, const PointMass&, std::vector<std::string>&) {}

} // namespace

bool is_below(const std::string& key, const std::string& ancestor) {
  if (!key.starts_with(ancestor)) return false;
  return key.size() == ancestor.size() || ancestor.empty() || key[ancestor.size()] == '.' ||
         key[ancestor.size()] == '[';
}

std::vector<std::string> set_names(const Case& data) {
  std::vector<std::string> sets;
  for (const Part& part : data.parts)
    std::visit([&](const auto& body) { add_sets(part.name, body, sets); }, part.body);
  return sets;
}

std::vector<InputProblem> check_case(const Case& data, const std::vector<std::string>& bad,
                                     const std::string& directory) {
  return Checker(data, bad, directory).run();
}

} // namespace plica
