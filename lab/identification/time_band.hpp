// What identifications from time signals have in common.
#pragma once

#include "lab/identification/identify.hpp"

namespace plica {

// Throws InputError (key "rate") for a band that ends above 0.45 of the sampling rate.
void check_band(const IdentifySettings& settings, double rate);

// Throws InputError (key "file") where the spectrum has fewer than two lines in the band.
void check_lines(std::size_t lines, double low, double high);

// No mode; modes that overlap and look alike; shapes far from real; one channel; much that is left
// unexplained of `what`.
void add_common_warnings(Identification& found, const std::string& what);

} // namespace plica
