#include "io/report/viewer.hpp"

#include "io/files/json_text.hpp"
#include "io/report/colour.hpp"
#include "io/report/drawn_shapes.hpp"
#include "io/report/fields.hpp"
#include "io/report/markup.hpp"
#include "io/report/surface.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace plica {
namespace {

constexpr int quad_budget = 7000;
constexpr std::size_t most_modes = 12, most_fields = 24;

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3), ' ');
  text.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()),
                                         bytes.size(),
                                         reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

// The thinned mesh, its own nodes numbered anew, and which of the model's they are.
struct Drawn {
  Surface surface;
  std::vector<int> nodes;
};

Drawn drawn(const Results& results) {
  Drawn d;
  std::vector<int> number(results.mesh.nodes.size(), -1);
  const auto own = [&](int node) {
    int& n = number[std::size_t(node)];
    if (n < 0) {
      n = int(d.nodes.size());
      d.nodes.push_back(node);
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
  return d;
}

std::vector<SurfaceShape> shapes_of(const Results& results, const Drawn& d) {
  std::vector<SurfaceShape> shapes = drawn_shapes(results);
  if (shapes.size() > most_modes) shapes.resize(most_modes);
  for (SurfaceShape& s : shapes) s.displacement = s.displacement(d.nodes, Eigen::all).eval();
  return shapes;
}

// Shares as 16 bits each, little endian, in the order of the drawn nodes.
std::string shares_of(const Eigen::VectorXd& shares, const Drawn& d) {
  std::string bytes;
  for (const int node : d.nodes) {
    const double share = std::isfinite(shares[node]) ? std::clamp(shares[node], 0., 1.) : 0.;
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

} // namespace

std::string part_viewer(const Results& results, const std::string& drawing) {
  const Drawn d = drawn(results);
  if (d.surface.nodes.empty()) return drawing;
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
  data["glb"] = base64(glb_of(d.surface, shapes));
  return "<figure class=\"viewer\">\n" + drawing + json_script(json_in_page(data)) + "</figure>\n";
}

} // namespace plica
