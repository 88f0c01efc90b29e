#include "io/universal/numbers.hpp"
#include "io/universal/records.hpp"
#include "words/short_text.hpp"

#include <algorithm>

namespace plica::universal {
namespace {

using Eigen::Index;

constexpr int most_nodes = 1000000; // of an element or a trace line

// -1 among the labels could not be told from the end.
bool none_negative(const std::vector<int>& labels) {
  return std::none_of(labels.begin(), labels.end(), [](int label) { return label < 0; });
}

// 8I10 on as many lines as it takes.
std::vector<int> read_labels(Lines& lines, const std::string& record, std::size_t wanted) {
  std::vector<int> labels;
  while (labels.size() < wanted) {
    const auto more = whole_numbers(next_record(lines, record, Lines::Wanted::numbers));
    if (!more || !none_negative(*more) || labels.size() + more->size() > wanted)
      lines.fail(record, in_quotes(lines.text()) + " are not the labels of its nodes",
                 std::to_string(wanted) + " integers, none negative");
    labels.insert(labels.end(), more->begin(), more->end());
  }
  return labels;
}

// Rods and beams have a record of their orientation. Some writers leave it out for rods; then the
// line behind the header has the nodes. Three numbers for a beam of three nodes may be either: they
// are nodes when the line after them is that of the next element or the end.
bool has_orientation(const UniversalElement& e, Lines& lines) {
  const bool beam = e.descriptor == 11 || (e.descriptor >= 21 && e.descriptor <= 24);
  constexpr std::size_t of_beam = 3, of_header = 6;
  const auto count = [](std::string_view line) {
    return whole_numbers(line).value_or(std::vector<int>()).size();
  };
  if (!beam || count(lines.text()) != of_beam) return false;
  const std::string after = lines.peek();
  return count(after) != of_header && !is_delimiter(after) && !after.empty();
}

UniversalElement read_element(Lines& lines) {
  const std::vector<double> r = numbers_of(lines, "record 1", {10, 10, 10, 10, 10, 10}, 6, 6);
  UniversalElement e;
  e.label = int(r[0]);
  e.descriptor = int(r[1]);
  e.property = int(r[2]);
  e.material = int(r[3]);
  e.colour = int(r[4]);
  if (r[5] < 1 || r[5] > most_nodes)
    lines.fail("record 1",
               "element " + std::to_string(e.label) + " has " + std::to_string(int(r[5])) +
                   " nodes",
               "1 or more");
  next_record(lines, "record 2", Lines::Wanted::numbers);
  std::string record = "record 2";
  if (has_orientation(e, lines)) {
    const std::vector<double> b = numbers_of(lines, record, {10, 10, 10}, 3, 3);
    e.beam = UniversalBeam{int(b[0]), int(b[1]), int(b[2])};
    record = "record 3";
  } else {
    lines.back();
  }
  e.nodes = read_labels(lines, record, std::size_t(r[5]));
  return e;
}

} // namespace

UniversalNodes read_nodes(Lines& lines, const SetHeader& header) {
  UniversalNodes set;
  set.line = header.line;
  set.double_precision = header.number != 15;
  while (next_entry(lines, "record 1", set.warnings)) {
    std::vector<double> r;
    if (set.double_precision) {
      r = numbers_of(lines, "record 1", {10, 10, 10, 10}, 4, 4);
      next_record(lines, "record 2");
      const std::vector<double> x = numbers_of(lines, "record 2", {25, 25, 25}, 0, 3);
      r.insert(r.end(), x.begin(), x.end());
    } else {
      r = numbers_of(lines, "record 1", {10, 10, 10, 10, 13, 13, 13}, 4, 7);
    }
    set.nodes.push_back({int(r[0]), int(r[1]), int(r[2]), int(r[3]), {r[4], r[5], r[6]}});
  }
  return set;
}

UniversalElements read_elements(Lines& lines, const SetHeader& header) {
  UniversalElements set;
  set.line = header.line;
  while (next_entry(lines, "record 1", set.warnings)) set.elements.push_back(read_element(lines));
  return set;
}

UniversalTraceline read_traceline(Lines& lines, const SetHeader& header) {
  UniversalTraceline t;
  t.line = header.line;
  next_record(lines, "record 1");
  const std::vector<double> r = numbers_of(lines, "record 1", {10, 10, 10}, 3, 3);
  t.number = int(r[0]);
  t.colour = int(r[2]);
  if (r[1] < 0 || r[1] > most_nodes)
    lines.fail("record 1", "the trace line has " + std::to_string(int(r[1])) + " nodes",
               "0 or more");
  const std::string_view id = next_record(lines, "record 2", Lines::Wanted::text);
  t.id = id.substr(0, id.find_last_not_of(" \t") + 1);
  while (next_entry(lines, "record 3", t.warnings)) {
    const auto more = whole_numbers(lines.text());
    if (!more)
      lines.fail("record 3", in_quotes(lines.text()) + " are not labels of nodes",
                 "integers, none negative");
    t.nodes.insert(t.nodes.end(), more->begin(), more->end());
  }
  if (Index(t.nodes.size()) != Index(r[1]))
    t.warnings.push_back({lines.number(), "the number of nodes is not the one stated", Index(r[1]),
                          Index(t.nodes.size())});
  return t;
}

UniversalUnits read_units(Lines& lines, const SetHeader& header) {
  UniversalUnits u;
  u.line = header.line;
  const std::string_view line = next_record(lines, "record 1");
  // I10,20A1,I10; tokens when shifted. Old files have no mode of temperature.
  const auto code = whole_columns(line, 0, 10), mode = whole_columns(line, 30, 10);
  if (code && mode && *code > 0) {
    u.code = *code;
    u.description = trimmed(columns(line, 10, 20));
    u.temperature_mode = *mode;
  } else {
    const auto t = tokens(line);
    const auto first = t.empty() ? std::nullopt : whole_number(t.front());
    if (!first || *first < 1)
      lines.fail("record 1", in_quotes(line) + " is not a code of units", "1 to 9");
    const auto last = t.size() > 1 ? whole_number(t.back()) : std::nullopt;
    u.code = *first;
    u.temperature_mode = last.value_or(0);
    const char* const begin = t.front().data() + t.front().size();
    const char* const end = last ? t.back().data() : line.data() + line.size();
    u.description = trimmed({begin, std::size_t(end - begin)});
  }
  std::vector<double> factors;
  while (factors.size() < 3 || next_entry(lines, "record 2", u.warnings)) {
    if (factors.size() < 3) next_record(lines, "record 2", Lines::Wanted::numbers);
    append_numbers(lines, "record 2", factors);
  }
  if (factors.size() != 4)
    u.warnings.push_back({lines.number(), "the number of factors is not that of the standard", 4,
                          Index(factors.size())});
  u.length = factors[0];
  u.force = factors[1];
  u.temperature = factors[2];
  u.temperature_offset = factors.size() > 3 ? factors[3] : 0;
  return u;
}

} // namespace plica::universal
