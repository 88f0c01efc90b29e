// What `plica compare` leaves behind: correlation.json, pairs.csv, responses.csv,
// correlation.html.
#pragma once

#include "compare/correlate.hpp"
#include "io/files/output_folder.hpp"

namespace plica {

std::vector<std::string> correlation_files();
void write_correlation(const Correlation& c, const TestData& simulated, const TestData& measured,
                       OutputFolder& out);

std::string correlation_json(const Correlation& c, const TestData& simulated,
                             const TestData& measured);

} // namespace plica
