// Everything that `plica reduce` leaves behind: superelement.h5, the decks and matrices for other
// programs, certificate.json, certificate.html, and the certificate in words.
#pragma once

#include "io/files/output_folder.hpp"
#include "run/study/reduce.hpp"

namespace plica {

enum class Units { metres, millimetres }; // m kg s N, or mm t s N

std::vector<std::string> superelement_files(bool damped);

// InputError with path and reason.
void write_superelement(const ReducedCase& reduced, Units units, OutputFolder& out);

std::string certificate_json(const ReducedCase& reduced);

} // namespace plica
