// Everything that `plica reduce` leaves behind: superelement.h5, the decks and matrices for other
// programs, certificate.json, certificate.html, and the certificate in words.
#pragma once

#include "io/files/output_folder.hpp"
#include "io/superelements/labels.hpp"
#include "run/study/reduce.hpp"

namespace plica {

enum class Units { metres, millimetres }; // m kg s N, or mm t s N

std::vector<std::string> superelement_files(bool damped);

// Numbers, names and place of the element in the files; of HDF5, MATLAB and Matrix Market the
// place.
struct SuperelementFormat {
  Units units = Units::metres;
  ElementLabels labels = {}; // origin in m
};

// InputError with path and reason, and for labels that do not fit.
void write_superelement(const ReducedCase& reduced, const SuperelementFormat& format,
                        OutputFolder& out);

std::string certificate_json(const ReducedCase& reduced);

} // namespace plica
