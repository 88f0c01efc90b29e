// The parts of universal data sets that several of them share. All readers below start behind the
// line of the number and leave the closing -1 as the current line.
#pragma once

#include "io/universal/lines.hpp"

namespace plica::universal {

struct SetHeader {
  int line = 0; // of the opening -1
  int number = 0;
  std::string text; // the line of the number
};

UniversalFunction read_function(Lines& lines, const SetHeader& header);
UniversalShape read_shape(Lines& lines, const SetHeader& header);
UniversalNodes read_nodes(Lines& lines, const SetHeader& header);
UniversalElements read_elements(Lines& lines, const SetHeader& header);
UniversalTraceline read_traceline(Lines& lines, const SetHeader& header);
UniversalUnits read_units(Lines& lines, const SetHeader& header);
UniversalText read_text(Lines& lines, const SetHeader& header);

// The five id lines, records 1 to 5.
std::array<std::string, 5> read_ids(Lines& lines);

// The next line, which must be there and must not close the data set.
std::string_view next_record(Lines& lines, const std::string& record,
                             Lines::Wanted wanted = Lines::Wanted::nothing);

// The same for lists whose length is not stated: false at the closing -1, or with a warning at the
// end of a file whose last line is whole. Blank lines are passed over.
bool next_entry(Lines& lines, const std::string& record, std::vector<UniversalWarning>& warnings);

// A record of numbers, the first `wholes` of them integers; see numeric_record.
std::vector<double> numbers_of(const Lines& lines, const std::string& record,
                               std::initializer_list<int> widths, std::size_t wholes,
                               std::size_t least);

// All numbers of the current line behind those of `values`; the largest number of decimals seen.
int append_numbers(const Lines& lines, const std::string& record, std::vector<double>& values);

// What stands before a %, behind which Code_Aster names the node once more.
std::string_view without_comment(std::string_view line);

// A line that is one integer: a node's label where values are expected.
bool is_label(std::string_view line);

// For messages: on one line and not long.
std::string in_quotes(std::string_view text);

// Points of a function from its numbers in the order of the file.
void take_points(UniversalFunction& f, const std::vector<double>& values);
int numbers_per_point(const UniversalFunction& f);

// Record 12 as IEEE numbers.
void read_binary_values(Lines& lines, const SetHeader& header, Eigen::Index stated,
                        UniversalFunction& f);

} // namespace plica::universal
