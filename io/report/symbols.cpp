#include "io/report/symbols.hpp"

#include "io/report/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace plica {
namespace {

using Eigen::Vector2d;

constexpr double spring_width = 14, hatch = 12; // units of the view box

// A zigzag from a to b.
std::string coil(const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a, across = Vector2d(-along.y(), along.x()).normalized();
  std::string path = fmt::format("<path class=\"symbol\" d=\"M{:.0f} {:.0f}", a.x(), a.y());
  constexpr int turns = 8;
  for (int k = 1; k < 2 * turns; ++k) {
    const double side = k % 2 == 0 ? 0 : (k % 4 == 1 ? spring_width : -spring_width);
    const Vector2d p = a + along * k / (2. * turns) + side * across;
    fmt::format_to(std::back_inserter(path), "L{:.0f} {:.0f}", p.x(), p.y());
  }
  return path + fmt::format("L{:.0f} {:.0f}\"/>", b.x(), b.y());
}

// Hatched ground under a point.
std::string ground(const Vector2d& at) {
  std::string path =
      fmt::format("<path class=\"symbol\" d=\"M{:.0f} {:.0f}h60", at.x() - 30, at.y());
  for (int k = 0; k < 5; ++k)
    fmt::format_to(std::back_inserter(path), "M{:.0f} {:.0f}l-{} {}", at.x() - 30 + 15 * k, at.y(),
                   hatch, hatch);
  return path + "\"/>";
}

} // namespace

double ball_radius(double mass, double size) {
  const double radius = std::cbrt(3 * mass / (4 * std::numbers::pi * 1500));
  return std::clamp(radius, 0.008 * size, 0.05 * size);
}

std::string symbol_marks(const Results& results, const View& view, const Frame& frame,
                         double size) {
  std::string marks, names;
  std::set<std::pair<std::string, int>> named;
  for (const Symbol& s : results.symbols) {
    const auto placed = [&](int node) {
      return frame.place(view.project(results.mesh.nodes[std::size_t(node)]));
    };
    const Vector2d at = placed(s.node);
    Vector2d name = at + Vector2d(22, 44);
    if (s.kind == SymbolKind::mass) {
      const double radius = frame.scale * ball_radius(s.mass, size);
      marks += fmt::format("<circle class=\"body\" cx=\"{:.0f}\" cy=\"{:.0f}\" r=\"{:.0f}\"/>",
                           at.x(), at.y(), radius);
      name = at + Vector2d(0.7 * radius + 10, 0.7 * radius + 30);
    } else if (s.kind == SymbolKind::held) {
      marks += ground(at);
    } else if (s.kind == SymbolKind::ground_spring || s.other < 0) {
      const Vector2d foot = at + Vector2d(0, 110);
      marks += coil(at, foot) + ground(foot);
      name = foot + Vector2d(40, 10);
    } else if (const Vector2d other = placed(s.other); (other - at).norm() > 20) {
      marks += coil(at, other);
      name = (at + other) / 2 + Vector2d(22, 44);
    } else {
      marks += fmt::format("<path class=\"symbol\" d=\"M{:.0f} {:.0f}l14 14l-14 14l-14 -14z\"/>",
                           at.x(), at.y() - 14);
    }
    const bool sensor =
        std::any_of(results.sensors.begin(), results.sensors.end(), [&](const SensorResult& own) {
          return own.name == s.name && own.node >= 0 && (placed(own.node) - at).norm() < 30;
        });
    if (!s.name.empty() && !sensor && named.emplace(s.name, s.node).second)
      names += fmt::format("<text class=\"tag\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>", name.x(),
                           name.y(), html_escape(s.name));
  }
  return marks.empty() ? "" : "<g font-size=\"34\">" + marks + names + "</g>\n";
}

} // namespace plica
