// Numbers as universal files have them: Fortran's E and D exponents, either case or none
// ("1.00000-100"), numbers that touch ("-1.0E+00-2.0E+00"), records in fixed columns or free.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace plica::universal {

struct ScannedNumber {
  double value = 0;
  int decimals = 0, exponent_digits = 0;
  bool whole = true; // neither point nor exponent
};

enum class Scan { number, end, bad };

// The next number of [at, end), blanks, tabs and commas before it skipped. bad: something else
// stands there (at stays before it), among it NaN, Inf and stars, or the number is beyond double.
Scan scan_number(const char*& at, const char* end, ScannedNumber& number);

// The line holds numbers and nothing else, at least one.
bool is_numeric(std::string_view line);

// A field that is nothing but an integer, blanks around it; nothing as well when beyond int.
std::optional<int> whole_number(std::string_view field);

// All integers of a line, free or in columns of ten.
std::optional<std::vector<int>> whole_numbers(std::string_view line);

std::vector<std::string_view> tokens(std::string_view line);

// Columns [at, at + width) as far as the line has them.
std::string_view columns(std::string_view line, std::size_t at, std::size_t width);

// An integer of fixed columns: right-justified, or blank, which is 0. What is not right-justified
// has been shifted.
std::optional<int> whole_columns(std::string_view line, std::size_t at, std::size_t width);

// A record of numbers with these widths, the first `wholes` of them integers: free when the line
// has just as many tokens, else in its columns, else free with at least `least` numbers and 0 for
// the others.
std::optional<std::vector<double>> numeric_record(std::string_view line,
                                                  std::initializer_list<int> widths,
                                                  std::size_t wholes, std::size_t least);

// The number of the line that opens a data set: "58", "   58b  1  2 ...".
std::optional<int> data_set_number(std::string_view line);

} // namespace plica::universal
