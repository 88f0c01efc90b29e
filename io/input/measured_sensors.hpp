// What must hold of the sensors of a measured.yaml.
#pragma once

#include "io/input/field_reader.hpp"
#include "lab/measured/measured.hpp"

namespace plica {

void check_sensors(const Measured& m, ReadLog& log);

// A channel at which something drives the part sits on the part.
void check_driven(const Measured& m, const std::string& channel, const std::string& key,
                  ReadLog& log);

// The masses of the sensors on the part come to what the scale did not see.
void weigh_sensors(Measured& m, ReadLog& log);

} // namespace plica
