// JSON Schema (draft-07) of the input files, for completion and checks in editors. Made from the
// same field descriptions as the readers.
#pragma once

#include <string>

namespace plica {

std::string case_schema();
std::string measured_schema();
std::string benchmark_schema();

} // namespace plica
