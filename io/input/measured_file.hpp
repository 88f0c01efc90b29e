// Reads measured.yaml. Strict: throws InputError with all problems of the file at once.
#pragma once

#include "diagnose/measured.hpp"
#include "model/input_error.hpp"

#include <string>

namespace plica {

Measured read_measured(const std::string& path);

} // namespace plica
