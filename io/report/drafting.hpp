// Lines and dimensions of a technical drawing as SVG elements, in view-box units.
#pragma once

#include <string>

namespace plica {

std::string drawn_line(double x1, double y1, double x2, double y2, const std::string& css_class);

// Dimension line with arrows at both ends; the text above it.
std::string horizontal_dimension(double x1, double x2, double y, const std::string& text);

// The text beside it.
std::string vertical_dimension(double x, double y1, double y2, const std::string& text,
                               bool text_on_left);

// A length in mm: four digits, without zeros at the end.
std::string drawn_length(double metres);

} // namespace plica
