// Writes data sets as universal files, in the columns of the standard and with lines that end in
// LF.
//
//   58     single E13.5, double E20.12, an uneven abscissa E13.5; x0, dx, z and the abscissa with a
//          sixth decimal where the value has one and the field keeps its blank
//   58b    for functions with `binary`: bit for bit
//   55     E13.5, with more decimals where the shape says so
//   2411, 164  all digits of a double
//
// Throws InputError when a data set cannot be written so that it reads again: NaN, sizes that do
// not agree, a name or number wider than its columns.
#pragma once

#include "io/universal/file.hpp"

#include <ostream>
#include <string>

namespace plica {

std::string universal_text(const UniversalFunction& f);
std::string universal_text(const UniversalShape& s);
std::string universal_text(const UniversalNodes& set);
std::string universal_text(const UniversalElements& set);
std::string universal_text(const UniversalTraceline& t);
std::string universal_text(const UniversalUnits& u);
std::string universal_text(const UniversalText& t);
std::string universal_text(const UniversalDataset& set);

// Appends the data set to the stream, which has to be opened as binary for 58b.
void write_universal(std::ostream& out, const UniversalDataset& set);

} // namespace plica
