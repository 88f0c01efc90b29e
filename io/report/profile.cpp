#include "io/report/profile.hpp"

#include "io/report/drafting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace plica {
namespace {

using Points = std::vector<std::array<double, 2>>;

struct Profile {
  Points points;
  double left = 0, right = 0, low = 0, high = 0; // bounds of y and r
  double thickness = 0;                          // mean of the shell
  std::vector<std::size_t> crowns, roots;        // largest and smallest radius, in order
};

// Places where r turns, by more than 2 % of its whole range (flats count once, in their middle).
void find_turns(Profile& profile) {
  const double threshold = 0.02 * (profile.high - profile.low);
  if (!(threshold > 1e-9 * profile.high)) return;
  const Points& p = profile.points;
  std::size_t highest = 0, lowest = 0;
  int direction = 0; // of the last confirmed move
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (p[i][1] > p[highest][1]) highest = i;
    if (p[i][1] < p[lowest][1]) lowest = i;
    if (direction <= 0 && p[i][1] > p[lowest][1] + threshold) {
      if (direction < 0) profile.roots.push_back(lowest);
      direction = 1;
      highest = i;
    } else if (direction >= 0 && p[i][1] < p[highest][1] - threshold) {
      if (direction > 0) profile.crowns.push_back(highest);
      direction = -1;
      lowest = i;
    }
  }
}

Profile profile_of(const Results& results) {
  Profile profile;
  profile.points = results.meridian;
  const auto by_y = [](const auto& a, const auto& b) { return a[0] < b[0]; };
  const auto by_r = [](const auto& a, const auto& b) { return a[1] < b[1]; };
  const auto [left, right] =
      std::minmax_element(profile.points.begin(), profile.points.end(), by_y);
  const auto [low, high] = std::minmax_element(profile.points.begin(), profile.points.end(), by_r);
  profile.left = (*left)[0];
  profile.right = (*right)[0];
  profile.low = (*low)[1];
  profile.high = (*high)[1];
  double sum = 0;
  for (const ShellQuad& quad : results.mesh.quads) sum += quad.thickness.mean();
  if (!results.mesh.quads.empty()) sum /= static_cast<double>(results.mesh.quads.size());
  profile.thickness = sum;
  find_turns(profile);
  return profile;
}

// Window of the drawing: y0, r0 lower left corner, `scale` view-box units per m.
struct Window {
  double y0 = 0, r0 = 0, scale = 1, margin_left = 0, margin_top = 0, height = 0;
  double x(double y) const { return margin_left + scale * (y - y0); }
  double y(double r) const { return margin_top + height - scale * (r - r0); }
};

std::string meridian_path(const Profile& profile, const Window& window, std::size_t first,
                          std::size_t last) {
  std::string path;
  for (std::size_t i = first; i <= last; ++i) {
    const auto [y, r] = profile.points[i];
    fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? "M" : "L",
                   window.x(y), window.y(r));
  }
  const double stroke = std::max(1.5, window.scale * profile.thickness);
  return fmt::format("<path class=\"wall\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", stroke, path);
}

std::string svg(double width, double height, const std::string& label, const std::string& body) {
  return fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" font-size=\"13\" role=\"img\" "
                     "aria-label=\"{}\">\n{}</svg>\n",
                     width, height, label, body);
}

std::string half_section(const Profile& p) {
  constexpr double width = 640, side = 96, top = 40, bottom = 16;
  Window window{p.left, 0, 1, side, top, 0};
  window.scale = std::min((width - 2 * side) / std::max(p.right - p.left, 1e-9), 340 / p.high);
  window.height = window.scale * p.high;
  window.margin_top += window.scale * p.thickness / 2;
  window.margin_left = (width - window.scale * (p.right - p.left)) / 2;
  const double x1 = window.x(p.left), x2 = window.x(p.right), axis = window.y(0);
  std::string body = meridian_path(p, window, 0, p.points.size() - 1);
  body += drawn_line(x1 - 12, axis, x2 + 12, axis, "axis");
  for (const double x : {x1, x2}) body += drawn_line(x, axis, x, 18, "thin");
  body += horizontal_dimension(x1, x2, 24, drawn_length(p.right - p.left));
  const auto low = std::find_if(p.points.begin(), p.points.end(),
                                [&](const auto& point) { return point[1] == p.low; });
  body += drawn_line(x1 - 36, window.y(p.low), window.x((*low)[0]), window.y(p.low), "thin");
  body += vertical_dimension(x1 - 28, window.y(p.low), axis, "r " + drawn_length(p.low), true);
  if (p.high - p.low > 1e-6 * p.high) {
    const std::size_t top_point = p.crowns.empty() ? p.points.size() - 1 : p.crowns.back();
    body += drawn_line(window.x(p.points[top_point][0]), window.y(p.high), x2 + 36,
                       window.y(p.high), "thin");
    body += vertical_dimension(x2 + 28, window.y(p.high), axis, "r " + drawn_length(p.high), false);
  }
  return svg(width, axis + bottom, "half section of the shell", body);
}

// From the start to the second root: cuff, if short, and the first convolutions.
std::string convolution_detail(const Profile& p) {
  if (p.crowns.size() < 2 || p.roots.empty()) return "";
  constexpr double width = 320, left = 62, right = 16, top = 40, bottom = 30;
  const auto& crown = p.points[p.crowns[0]];
  const auto& next = p.points[p.crowns[1]];
  const auto root = p.points[p.roots[0]];
  const double pitch = next[0] - crown[0];
  const double from = std::max(p.left, crown[0] - 0.75 * pitch), to = next[0] + 0.75 * pitch;
  std::size_t first = 0, last = p.points.size() - 1;
  while (first < p.crowns[0] && p.points[first][0] < from) ++first;
  while (last > p.crowns[1] && p.points[last][0] > to) --last;
  Window window{from, p.low, 1, left, top, 0};
  window.scale = (width - left - right) / (to - from);
  window.scale = std::min(window.scale, 260 / (p.high - p.low));
  window.height = window.scale * (p.high - p.low);
  const double low = window.y(root[1]), high = window.y(crown[1]);
  std::string body = meridian_path(p, window, first, last);
  for (const auto& point : {crown, next}) {
    body += drawn_line(window.x(point[0]), high, window.x(point[0]), 18, "thin");
  }
  body += horizontal_dimension(window.x(crown[0]), window.x(next[0]), 24, drawn_length(pitch));
  body += drawn_line(left - 22, low, window.x(root[0]), low, "thin");
  body += drawn_line(left - 22, high, window.x(crown[0]), high, "thin");
  body += vertical_dimension(left - 14, high, low, drawn_length(crown[1] - root[1]), true);
  return svg(width, low + bottom, "first convolutions, enlarged", body);
}

} // namespace

std::string profile_drawing(const Results& results) {
  if (results.meridian.size() < 2) return "";
  const Profile profile = profile_of(results);
  if (!(profile.high > 0)) return "";
  std::string caption = "Half section of the mid-surface, dimensions in mm, equal scales";
  if (!profile.crowns.empty()) {
    caption += fmt::format("; {} convolution{}", profile.crowns.size(),
                           profile.crowns.size() == 1 ? "" : "s");
  }
  if (profile.thickness > 0) {
    caption += fmt::format("; wall {} mm on average, drawn to scale where it can be seen",
                           drawn_length(profile.thickness));
  }
  return "<figure>\n<div class=\"drawings\">\n" + half_section(profile) +
         convolution_detail(profile) + "</div>\n<figcaption>" + caption +
         ".</figcaption></figure>\n";
}

} // namespace plica
