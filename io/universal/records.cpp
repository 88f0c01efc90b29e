#include "io/universal/records.hpp"

#include "io/universal/numbers.hpp"
#include "words/did_you_mean.hpp"

#include <algorithm>

namespace plica::universal {

using Wanted = Lines::Wanted;

std::string_view next_record(Lines& lines, const std::string& record, Wanted wanted) {
  if (!lines.next())
    lines.fail(record, "the file ends inside of the data set", "all records and a closing -1");
  if (lines.ends_set(wanted))
    lines.fail(record, "the data set ends before this record", "all records of the data set");
  return lines.text();
}

std::array<std::string, 5> read_ids(Lines& lines) {
  std::array<std::string, 5> ids;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string_view line =
        next_record(lines, "record " + std::to_string(i + 1), Wanted::text);
    ids[i] = line.substr(0, line.find_last_not_of(" \t") + 1);
  }
  return ids;
}

bool next_entry(Lines& lines, const std::string& record, std::vector<UniversalWarning>& warnings) {
  while (lines.next()) {
    if (lines.ends_set(Wanted::nothing)) return false;
    if (!is_blank(lines.text())) return true;
  }
  if (!lines.raw().ends_with('\n'))
    lines.fail(record, "the file ends inside of the data set", "a closing -1");
  warnings.push_back({.line = lines.number(),
                      .what = "the closing -1 is missing, what follows may be as well",
                      .stated = 0,
                      .found = 0});
  return false;
}

std::vector<double> numbers_of(const Lines& lines, const std::string& record,
                               std::initializer_list<int> widths, std::size_t wholes,
                               std::size_t least) {
  const auto values = numeric_record(lines.text(), widths, wholes, least);
  const auto beyond = [](double v) { return v < -2147483648. || v > 2147483647.; };
  if (values) {
    if (std::none_of(values->begin(), values->begin() + std::ptrdiff_t(wholes), beyond))
      return *values;
    lines.fail(record, in_quotes(lines.text()) + " has an integer beyond all counts",
               "at most 2147483647");
  }
  const std::string reals = std::to_string(widths.size() - wholes);
  lines.fail(record, in_quotes(lines.text()) + " is not this record",
             wholes == widths.size()
                 ? std::to_string(wholes) + " integers"
                 : std::to_string(wholes) + " integers and " + reals + " numbers");
}

int append_numbers(const Lines& lines, const std::string& record, std::vector<double>& values) {
  const std::string_view line = lines.text();
  const char* at = line.data();
  const char* const end = at + line.size();
  ScannedNumber number;
  int decimals = 0;
  Scan scan = scan_number(at, end, number);
  for (; scan == Scan::number; scan = scan_number(at, end, number)) {
    values.push_back(number.value);
    decimals = std::max(decimals, number.decimals);
  }
  if (scan == Scan::bad)
    lines.fail(record, in_quotes({at, std::size_t(end - at)}) + " is not a number",
               "finite numbers, e.g. -1.23456E+01");
  return decimals;
}

std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('%'));
}

bool is_label(std::string_view line) {
  const auto fields = tokens(without_comment(line));
  return fields.size() == 1 && whole_number(fields[0]).has_value();
}

std::string in_quotes(std::string_view text) {
  return "'" + shown(text) + "'";
}

UniversalText read_text(Lines& lines, const SetHeader& header) {
  UniversalText set{.line = header.line, .warnings = {}, .number = header.number, .text = {}};
  set.text = lines.raw();
  while (lines.next()) {
    if (lines.ends_set(Wanted::anything)) return set;
    set.text += lines.raw();
  }
  lines.fail("",
             "the file ends inside of the data set that line " + std::to_string(header.line) +
                 " opens",
             "a closing -1");
}

} // namespace plica::universal
