// Cards of Nastran: reals in 16 columns, small and large fields.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plica {

// A real in 16 columns with as many digits as fit, the exponent without its letter:
// 1.23456789012+5.
std::string nastran_real(double x);

// Reads 1.5+3, 1.5D+3 and 1.5e+3. Throws std::invalid_argument.
double nastran_number(std::string text);

// All of `text` as a whole number with a sign or without.
std::optional<int> whole_number_of(std::string_view text);

// A card with fields of 16 columns, four a line, or of 8 columns, eight a line. Empty fields at
// the end are left away.
std::string large_card(const std::string& name, const std::vector<std::string>& fields);
std::string small_card(const std::string& name, const std::vector<std::string>& fields);

} // namespace plica
