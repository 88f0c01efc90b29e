// Numbers in sentences and words out of lines, for the rooms that need no library for it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace plica {

std::string short_text(double x, int digits = 2);                 // 1.3e-07
std::string short_text(const Eigen::Vector3d& x, int digits = 4); // [0, 0.25, -1e-05]

// The shortest text that reads back as the same number.
std::string all_digits(double x);

// Without blanks, tabs and ends of lines around it; a view of the same text.
std::string_view trimmed(std::string_view text);

} // namespace plica
