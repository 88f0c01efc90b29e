// The tables of the report, one function per section; each gives the HTML of its body, empty when
// the results have nothing for it.
#pragma once

#include "run/results/results.hpp"

#include <string>

namespace plica {

// Measured +- sigma beside computed, deviation in % and in sigma, and a strip per row with the
// measured error bar around zero and the computed value as a dot; empty if nothing was measured.
std::string comparison_html(const Results& results);
// The largest deviation from the test that is not an assumption, in a sentence with the mode that
// shows it; empty if nothing was measured.
std::string farthest_html(const Results& results);
std::string numbers_html(const Results& results);    // the headline numbers
std::string error_bars_html(const Results& results); // mesh and tolerances
std::string statics_html(const Results& results);
std::string modes_html(const Results& results); // with effective masses and their sum
std::string variants_comparison_html(const Results& results);
std::string variants_html(const Results& results);
std::string model_html(const Results& results); // size, mesh quality, sensors
std::string timing_html(const Results& results);

} // namespace plica
