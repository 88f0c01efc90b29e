#include "io/report/drafting.hpp"

#include "io/tables/text.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

// Tip at (x, y), pointing along the unit vector (dx, dy).
std::string arrow(double x, double y, double dx, double dy) {
  return fmt::format("<path class=\"arrow\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}z\"/>\n",
                     x, y, x - 8 * dx - 3 * dy, y - 8 * dy - 3 * dx, x - 8 * dx + 3 * dy,
                     y - 8 * dy + 3 * dx);
}

} // namespace

std::string drawn_line(double x1, double y1, double x2, double y2, const std::string& css) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", css, x1, y1,
      x2, y2);
}

std::string drawn_length(double metres) {
  std::string text = significant(1e3 * metres, 4);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string horizontal_dimension(double x1, double x2, double y, const std::string& text) {
  return drawn_line(x1, y, x2, y, "thin") + arrow(x1, y, -1, 0) + arrow(x2, y, 1, 0) +
         fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                     (x1 + x2) / 2, y - 7, text);
}

std::string vertical_dimension(double x, double y1, double y2, const std::string& text,
                               bool text_on_left) {
  return drawn_line(x, y1, x, y2, "thin") + arrow(x, y1, 0, y1 < y2 ? -1 : 1) +
         arrow(x, y2, 0, y1 < y2 ? 1 : -1) +
         fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n",
                     text_on_left ? x - 7 : x + 7, (y1 + y2) / 2 + 4,
                     text_on_left ? "end" : "start", text);
}

} // namespace plica
