#include "io/report/viewer.hpp"

#include "io/files/json_text.hpp"
#include "io/report/colour.hpp"
#include "io/report/drawn_shapes.hpp"
#include "io/report/fields.hpp"
#include "io/report/markup.hpp"
#include "io/report/picture.hpp"
#include "io/report/surface.hpp"
#include "io/report/symbols.hpp"
#include "io/report/tubes.hpp"
#include "io/tables/text.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <vtkBase64Utilities.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace plica {
namespace {

constexpr int quad_budget = 7800; // at which an arc of thirty convolutions has two elements
constexpr std::size_t most_modes = 12, most_fields = 24;

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3), ' ');
  text.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
                                         bytes.size(),
                                         reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

// The thinned mesh with the tubes of beams, and what of the model its nodes are.
struct Drawn {
  Surface surface;
  std::vector<DrawnPoint> points;
};

Drawn drawn(const Results& results) {
  Drawn d;
  std::vector<int> number(results.mesh.nodes.size(), -1);
  const auto own = [&](int node) {
    int& n = number[std::size_t(node)];
    if (n < 0) {
      n = int(d.points.size());
      d.points.push_back({node});
      d.surface.nodes.push_back(results.mesh.nodes[std::size_t(node)]);
    }
    return n;
  };
  for (const std::array<int, 4>& q : drawn_quads(results.mesh, quad_budget)) {
    const std::array<int, 4> at{own(q[0]), own(q[1]), own(q[2]), own(q[3])};
    for (const std::array<int, 3>& t : halves(at))
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) d.surface.triangles.push_back(t);
  }
  for (const std::array<int, 2>& line : results.lines)
    d.surface.lines.push_back({own(line[0]), own(line[1])});
  std::vector<DrawnPoint> round;
  std::vector<std::array<int, 4>> tubes;
  add_tubes(results, int(d.points.size()), round, tubes);
  for (const DrawnPoint& point : round) {
    d.points.push_back(point);
    d.surface.nodes.push_back(place_of(results, point));
  }
  for (const std::array<int, 4>& q : tubes)
    for (const std::array<int, 3>& t : halves(q)) d.surface.triangles.push_back(t);
  return d;
}

std::size_t modes_in(const Results& results) {
  return std::min(shown_modes(results), most_modes);
}

std::vector<SurfaceShape> shapes_of(const Results& results, const Drawn& d) {
  require_one_row_per_node(results);
  std::vector<SurfaceShape> shapes;
  for (std::size_t m = 0; m < modes_in(results); ++m)
    shapes.push_back({fmt::format("mode {}", m + 1),
                      drawn_scale(results, m) * motion_of(d.points, results.shapes[m])});
  return shapes;
}

// Shares as 16 bits each, little endian, in the order of the drawn nodes.
std::string shares_of(const Eigen::VectorXd& shares, const Drawn& d) {
  std::string bytes;
  for (const DrawnPoint& point : d.points) {
    const double own = shares[point.node];
    const double share = std::isfinite(own) ? std::clamp(own, 0., 1.) : 0.;
    const auto number = static_cast<unsigned>(std::lround(65535 * share));
    bytes += char(number & 255u);
    bytes += char(number >> 8u);
  }
  return base64(bytes);
}

nlohmann::ordered_json fields_of(const Results& results, const Drawn& d) {
  auto list = nlohmann::ordered_json::array();
  for (const ShownField& f : shown_fields(results, most_fields))
    list.push_back({{"name", f.name},
                    {"unit", f.unit},
                    {"scale", {f.scale[0], f.scale[1]}},
                    {"spot", f.spot},
                    {"at", {f.at[0], f.at[1], f.at[2]}},
                    {"spot_above", f.spot_above},
                    {"below", shares_of(f.below, d)},
                    {"above", shares_of(f.above, d)}});
  return list;
}

nlohmann::ordered_json triple(const Eigen::Vector3d& x) {
  return {x.x(), x.y(), x.z()};
}

// Bodies and springs: where they are, and how their ends move in each mode.
nlohmann::ordered_json symbols_json(const Results& results, double size) {
  constexpr std::array kinds{"mass", "spring", "ground", "held"};
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Symbol& s : results.symbols) {
    nlohmann::ordered_json ends = nlohmann::ordered_json::array();
    for (const int node : {s.node, s.other}) {
      if (node < 0) continue;
      nlohmann::ordered_json moves = nlohmann::ordered_json::array();
      for (std::size_t m = 0; m < modes_in(results); ++m) {
        const Eigen::MatrixXd u = drawn_scale(results, m) * motion_of({{node}}, results.shapes[m]);
        moves.push_back(triple(u.row(0).transpose()));
      }
      ends.push_back({{"at", triple(results.mesh.nodes[std::size_t(node)])}, {"moves", moves}});
    }
    list.push_back({{"kind", kinds[std::size_t(s.kind)]},
                    {"name", s.name},
                    {"radius", s.kind == SymbolKind::mass ? ball_radius(s.mass, size) : 0},
                    {"ends", ends}});
  }
  return list;
}

} // namespace

std::string part_viewer(const Results& results, const std::string& drawing,
                        std::optional<std::size_t> mode) {
  const Drawn d = drawn(results);
  if (d.surface.nodes.empty()) return drawing;
  const bool plays = mode && *mode < modes_in(results);
  const std::string still = mode ? mode_picture(results, *mode) : "";
  const std::vector<SurfaceShape> shapes = shapes_of(results, d);
  nlohmann::ordered_json data;
  data["modes"] = nlohmann::ordered_json::array();
  for (std::size_t m = 0; m < shapes.size(); ++m)
    data["modes"].push_back(fmt::format("{}: {:.1f} Hz, {}", m + 1, results.modes[m].frequency,
                                        mode_label(results.modes[m])));
  for (int stop = 0; stop <= 8; ++stop) data["colours"].push_back(viridis(stop / 8.));
  data["sensors"] = nlohmann::ordered_json::array();
  for (const SensorResult& s : results.sensors)
    if (s.node >= 0 && s.node < int(results.mesh.nodes.size())) {
      const Eigen::Vector3d& x = results.mesh.nodes[std::size_t(s.node)];
      data["sensors"].push_back({{"name", s.name}, {"at", {x.x(), x.y(), x.z()}}});
    }
  if (const auto fields = fields_of(results, d); !fields.empty()) data["fields"] = fields;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : d.surface.nodes) box.extend(x);
  data["symbols"] = symbols_json(results, box.diagonal().norm());
  if (plays) data["first"] = *mode;
  data["glb"] = base64(glb_of(d.surface, shapes));
  std::string html = "<figure class=\"viewer\">\n" + drawing;
  if (plays) html += "<div class=\"still\">\n" + still + "</div>\n";
  html += json_script(json_in_page(data)) + "</figure>\n";
  return plays ? html : html + still;
}

} // namespace plica
