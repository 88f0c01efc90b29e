// The report of an identification.
#pragma once

#include "lab/identification/identify.hpp"

#include <string>

namespace plica {

std::string identification_html(const Identification& found, const std::string& title);

} // namespace plica
