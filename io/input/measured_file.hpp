// Reads measured.yaml. Strict: throws InputError with all problems of the file at once.
#pragma once

#include "diagnose/measured.hpp"
#include "model/case.hpp"
#include "model/input_error.hpp"

#include <string>

namespace plica {

Measured read_measured(const std::string& path);

// Turns what the states set into numbers of the case. Throws InputError.
void resolve_states(Measured& measured, const Case& data, const std::string& path);

} // namespace plica
