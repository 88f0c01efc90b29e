// Everything that `plica reduce` leaves behind: superelement.h5, the decks and matrices for other
// programs, certificate.json, and the certificate in words.
#pragma once

#include "model/reduce.hpp"

#include <filesystem>

namespace plica {

enum class Units { metres, millimetres }; // m kg s N, or mm t s N

// Throws std::runtime_error with path and reason; each file is whole or the old one.
void write_superelement(const ReducedCase& reduced, Units units,
                        const std::filesystem::path& folder);

// Up to where it is good, and what the case asks for beyond.
std::string reach_of(const ReducedCase& reduced);
std::string certificate_text(const ReducedCase& reduced);
std::string certificate_json(const ReducedCase& reduced);

} // namespace plica
