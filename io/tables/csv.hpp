// The tables of a run as comma-separated values (RFC 4180 quoting, lines end with LF), one header
// line with units in brackets. SI units, Hz; a number that does not exist is an empty cell; doubles
// keep all their digits.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

std::string modes_csv(const Results& results);
std::string response_csv(const ResponseResult& response); // real, imaginary; sum of each sensor
std::string motion_csv(const ResponseResult& response);   // amplitudes at the level
std::string random_csv(const ResponseResult& response);   // densities; needs response.random
std::string stress_csv(const Results& results);
std::string error_bars_csv(const Results& results);
// Frequency, damping and the shape at the sensors, complex; needs results.complex_modes.
std::string complex_modes_csv(const Results& results);
std::string static_csv(const Results& results);     // no rows without static stiffness
std::string comparison_csv(const Results& results); // measured beside computed
std::string variants_csv(const Results& results);   // first row: the nominal case

// One cell, in quotes when it holds a comma, a quote or a line break. A text that begins as a
// formula of a spreadsheet (= + - @) gets an apostrophe before it.
std::string csv_cell(const std::string& text);

// All digits of a number; empty for one that does not exist or is not finite.
std::string csv_number(const std::optional<double>& x);

} // namespace plica
