// Numbers of a case by their path in the case file: "parts.bellows.profile[1].height".
#pragma once

#include "model/description/case.hpp"
#include "words/field_types.hpp"

#include <string>

namespace plica {

// The number at that path, in SI; null when there is none, or when it was left out and is optional.
double* number_at(Case& data, const std::string& path);

// What it may be: unit and bounds; none when there is no such number.
std::optional<Quantity> quantity_at(Case& data, const std::string& path);

// Whether a value lies within these bounds.
bool allows(const Quantity& quantity, double value);

} // namespace plica
