#include "io/report/picture.hpp"

#include "io/report/colour.hpp"
#include "io/report/drawn_shapes.hpp"
#include "io/report/markup.hpp"
#include "io/report/scene.hpp"
#include "io/report/surface.hpp"
#include "io/report/symbols.hpp"
#include "io/report/tubes.hpp"
#include "io/tables/text.hpp"
#include "words/directions.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

constexpr int quad_budget = 5000; // about half of them hidden, and not written
constexpr int line_budget = 1000;

// Elements to draw, and the points they use (for the frame and the outline).
struct Selection {
  std::vector<std::array<int, 4>> quads; // corners: nodes, and behind them the points of tubes
  std::vector<std::array<int, 2>> lines; // beams without a section to draw
  std::vector<DrawnPoint> round;         // points of tubes
  std::vector<Eigen::Vector3d> used;
  double size = 0; // diagonal of the box round them
};

Selection select(const Results& results) {
  Selection selection;
  selection.quads = drawn_quads(results.mesh, quad_budget);
  const std::size_t step = 1 + results.lines.size() / line_budget;
  for (std::size_t i = 0; i < results.lines.size(); i += step)
    if (!has_tube(results, i)) selection.lines.push_back(results.lines[i]);
  Eigen::AlignedBox3d box;
  const auto use = [&](int node) {
    selection.used.push_back(results.mesh.nodes[node]);
    box.extend(results.mesh.nodes[node]);
  };
  for (const auto& quad : selection.quads) std::for_each(quad.begin(), quad.end(), use);
  for (const auto& line : selection.lines) std::for_each(line.begin(), line.end(), use);
  add_tubes(results, int(results.mesh.nodes.size()), selection.round, selection.quads);
  for (const DrawnPoint& point : selection.round) {
    selection.used.push_back(place_of(results, point));
    box.extend(selection.used.back());
  }
  for (const Symbol& symbol : results.symbols) use(symbol.node);
  if (!box.isEmpty()) selection.size = box.diagonal().norm();
  return selection;
}

std::vector<Eigen::Vector3d> points_of(const Results& results, const Selection& selection) {
  std::vector<Eigen::Vector3d> points = results.mesh.nodes;
  for (const DrawnPoint& point : selection.round) points.push_back(place_of(results, point));
  return points;
}

std::string svg_open(const Frame& frame, const std::string& label) {
  return fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", frame.width,
                     frame.height, html_escape(label));
}

// Arrows along x, y, z in the lower right corner.
std::string triad(const View& view, const Frame& frame) {
  const Eigen::Vector2d middle(frame.width - 140, frame.height - 90);
  std::string svg = "<g stroke-width=\"4\" font-size=\"36\">";
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector2d along = view.project(Eigen::Vector3d::Unit(axis));
    const Eigen::Vector2d tip = middle + 80 * Eigen::Vector2d(along.x(), -along.y());
    const Eigen::Vector2d name = middle + 112 * Eigen::Vector2d(along.x(), -along.y());
    svg += fmt::format("<line stroke=\"currentColor\" x1=\"{:.0f}\" y1=\"{:.0f}\" x2=\"{:.0f}\" "
                       "y2=\"{:.0f}\"/><text text-anchor=\"middle\" x=\"{:.0f}\" y=\"{:.0f}\">{}"
                       "</text>",
                       middle.x(), middle.y(), tip.x(), tip.y(), name.x(), name.y() + 11,
                       axis_word(axis));
  }
  return svg + "</g>\n";
}

std::string sensor_marks(const Results& results, const View& view, const Frame& frame,
                         double letters) {
  const double r = letters / 3; // of the mark
  std::string svg = fmt::format("<g font-size=\"{:.0f}\">", letters);
  for (const SensorResult& sensor : results.sensors) {
    if (sensor.node < 0 || sensor.node >= static_cast<int>(results.mesh.nodes.size())) continue;
    const Eigen::Vector2d at = frame.place(view.project(results.mesh.nodes[sensor.node]));
    svg += fmt::format("<circle class=\"pin\" cx=\"{0:.0f}\" cy=\"{1:.0f}\" r=\"{2:.0f}\"/>"
                       "<text class=\"tag\" x=\"{3:.0f}\" y=\"{4:.0f}\">{5}</text>",
                       at.x(), at.y(), r, at.x() + 2 * r, at.y() + r, html_escape(sensor.name));
  }
  return svg + "</g>\n";
}

// A colour scale with the words of its quarters.
std::string legend(const std::array<std::string, 5>& words) {
  std::string svg = "<svg class=\"legend\" viewBox=\"0 0 352 44\" role=\"img\" aria-label=\"colour "
                    "scale\"><defs><linearGradient id=\"viridis\">";
  for (int stop = 0; stop <= 8; ++stop) {
    svg += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>", stop / 8.0, viridis(stop / 8.0));
  }
  svg += "</linearGradient></defs><rect x=\"6\" y=\"2\" width=\"340\" height=\"14\" "
         "fill=\"url(#viridis)\"/><g font-size=\"13\">";
  for (int tick = 0; tick <= 4; ++tick) {
    svg += fmt::format("<text x=\"{}\" y=\"34\" text-anchor=\"{}\">{}</text>", 6 + 85 * tick,
                       tick == 0   ? "start"
                       : tick == 4 ? "end"
                                   : "middle",
                       html_escape(words[std::size_t(tick)]));
  }
  return svg + "</g></svg>\n";
}

std::string mode_figure(const Results& results, std::size_t mode, const Selection& selection,
                        const View& view, const Frame& frame) {
  const Eigen::MatrixXd& shape = results.shapes[mode];
  double largest = 0;
  const int nodes = int(results.mesh.nodes.size());
  const Eigen::MatrixXd round = motion_of(selection.round, shape);
  const auto size_at = [&](int point) {
    return point < nodes ? shape.row(point).head<3>().norm() : round.row(point - nodes).norm();
  };
  for (const auto& quad : selection.quads) {
    for (const int node : quad) largest = std::max(largest, size_at(node));
  }
  for (const auto& line : selection.lines) {
    for (const int node : line) largest = std::max(largest, size_at(node));
  }
  if (!(largest > 0)) largest = 1;
  Scene scene{points_of(results, selection), selection.quads, selection.lines, {}};
  const double scale = drawn_motion * selection.size / largest;
  for (int point = 0; point < static_cast<int>(scene.points.size()); ++point) {
    const Eigen::Vector3d u = point < nodes
                                  ? Eigen::Vector3d(shape.row(point).head<3>().transpose())
                                  : Eigen::Vector3d(round.row(point - nodes).transpose());
    if (u.allFinite()) scene.points[std::size_t(point)] += scale * u;
  }
  scene.colour = [&](const int* corners, int count, double shade) {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += size_at(corners[i]);
    return viridis(sum / count / largest, 0.7 + 0.35 * shade);
  };
  const ModeResult& result = results.modes[mode];
  const std::string name = fmt::format("{:.1f} Hz, {}", result.frequency, mode_label(result));
  return svg_open(frame, fmt::format("mode {}: {}", mode + 1, name)) + drawn(scene, view, frame) +
         outline(selection.used, view, frame) +
         fmt::format("</svg><figcaption><b>{}</b>  {:.1f} Hz, {}</figcaption></figure>\n", mode + 1,
                     result.frequency, html_escape(mode_label(result)));
}

} // namespace

std::string part_picture(const Results& results, double letters) {
  const Selection selection = select(results);
  if (selection.used.empty()) return "";
  const View view = view_of(selection.used);
  const double margin = results.symbols.empty() ? 0.02 : 0.07; // for springs and names
  Frame frame = frame_round(view, selection.used, margin * selection.size, 1780);
  frame.width += 320; // for the triad, beside names
  Scene scene{points_of(results, selection), selection.quads, selection.lines, {}};
  scene.colour = [](const int*, int, double shade) { return steel(0.3 + 0.8 * shade); };
  return "<figure class=\"part\">" + svg_open(frame, "the part in oblique projection") +
         drawn(scene, view, frame) + symbol_marks(results, view, frame, selection.size) +
         sensor_marks(results, view, frame, letters) + triad(view, frame) + "</svg></figure>\n";
}

namespace {

// From the side on which the point lies.
View view_towards(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point) {
  const View view = view_of(points);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  if ((point - box.center()).dot(view.to_reader()) > -1e-6 * box.diagonal().norm()) return view;
  return {-view.right, view.up, -view.towards};
}

} // namespace

std::string field_picture(const Results& results, const ShownField& field) {
  const Selection selection = select(results);
  if (selection.used.empty()) return "";
  const View view = view_towards(selection.used, Eigen::Vector3d::Map(field.at.data()));
  const Frame frame = frame_round(view, selection.used, 0.06 * selection.size, 1780);
  const Eigen::VectorXd& shares = field.spot_above ? field.above : field.below;
  const int nodes = static_cast<int>(results.mesh.nodes.size());
  Scene scene{points_of(results, selection), selection.quads, selection.lines, {}};
  scene.colour = [&](const int* corners, int count, double shade) {
    if (count < 4 || corners[0] >= nodes) return steel(shade); // beams have no faces
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += shares[corners[i]];
    return viridis(sum / count, 0.7 + 0.35 * shade);
  };
  const Eigen::Vector2d at = frame.place(view.project(Eigen::Vector3d::Map(field.at.data())));
  const bool left = at.x() > 0.6 * frame.width; // of the mark, so that the name stays inside
  return "<figure class=\"part\">" + svg_open(frame, field.name) + drawn(scene, view, frame) +
         fmt::format("<g font-size=\"34\"><circle class=\"pin\" cx=\"{:.0f}\" cy=\"{:.0f}\" "
                     "r=\"13\"/><text class=\"tag\" text-anchor=\"{}\" x=\"{:.0f}\" "
                     "y=\"{:.0f}\">{}</text></g></svg>\n",
                     at.x(), at.y(), left ? "end" : "start", at.x() + (left ? -24 : 24),
                     at.y() + 12, html_escape(field.spot)) +
         legend({field.scale[0], "", "", "", field.scale[1] + " " + field.unit}) +
         fmt::format("<figcaption>{}, {} face, seen from the side of the hot spot: {}.</figcaption>"
                     "</figure>\n",
                     html_escape(field.name), field.spot_above ? "outer" : "inner",
                     html_escape(field.spot));
}

std::string mode_picture(const Results& results, std::size_t mode) {
  if (mode >= results.shapes.size()) return "";
  const Selection selection = select(results);
  if (selection.used.empty()) return "";
  const View view = view_of(selection.used);
  return "<figure>" +
         mode_figure(results, mode, selection, view,
                     frame_round(view, selection.used, 1.1 * drawn_motion * selection.size, 1000));
}

std::string mode_pictures(const Results& results, int most) {
  require_one_row_per_node(results);
  const Selection selection = select(results);
  std::size_t count = std::min(results.modes.size(), results.shapes.size());
  count = std::min(count, static_cast<std::size_t>(std::max(most, 0)));
  if (selection.used.empty() || count == 0) return "";
  const View view = view_of(selection.used);
  const Frame frame = frame_round(view, selection.used, 1.1 * drawn_motion * selection.size, 1000);
  std::string html = "<div class=\"modes\">\n";
  for (std::size_t mode = 0; mode < count; ++mode) {
    html += fmt::format("<figure data-mode=\"{}\">", mode) +
            mode_figure(results, mode, selection, view, frame);
  }
  return html + "</div>\n<figure>" + legend({"0", "0.25", "0.5", "0.75", "1"}) +
         "<figcaption>Displacement / its largest value in the mode. Drawn with the largest at 5 % "
         "of the size of the part; dashed: outline at rest.</figcaption></figure>\n";
}

} // namespace plica
