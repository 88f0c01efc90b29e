#include "mesher/iges_text.hpp"

#include "mesher/step_parser.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <sstream>

namespace plica {
namespace {

constexpr std::string_view letters = "SGDPT";

long whole(std::string_view field, int line, long otherwise) {
  const std::string text(trimmed(field));
  if (text.empty()) return otherwise;
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    step_error(line, "'" + text + "' where a whole number belongs");
  return value;
}

struct Line {
  int number = 0; // in the file
  std::string text;
};
using Sections = std::array<std::vector<Line>, 5>;

Sections sections_of(const std::string& text) {
  Sections sections;
  std::istringstream in(text);
  std::size_t section = 0;
  int number = 0;
  bool ended = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (ended) {
      if (!trimmed(line).empty()) step_error(number, "something follows the terminate line");
      continue;
    }
    // A zero ends what OpenCASCADE reads of a section, and the unit of length may stand behind it.
    if (std::any_of(line.begin(), line.end(),
                    [](char c) { return c >= 0 && c < ' ' && c != '\t'; }))
      step_error(number, "holds a control character: the file is damaged");
    constexpr std::size_t width = 80, letter = 72;
    line.resize(std::max(line.size(), width), ' ');
    const std::size_t own = letters.find(line[letter]);
    if (trimmed(line.substr(width)).size() > 0 || own == std::string_view::npos || own < section)
      step_error(number, "column 73 is no letter of a section (S, G, D, P, T) in their order");
    section = own;
    sections[own].push_back({number, line});
    const long is = whole(std::string_view(line).substr(letter + 1, 7), number, 0);
    if (is != long(sections[own].size()))
      step_error(number, std::string("line ") + letters[own] + std::to_string(is) + " where " +
                             letters[own] + std::to_string(sections[own].size()) +
                             " belongs: lines are missing, or twice");
    ended = own == 4;
  }
  if (!ended) step_error(number, "the terminate line is missing: the file was cut short");
  return sections;
}

void check_terminate(const Sections& sections) {
  const Line& last = sections[4].front();
  for (std::size_t s = 0; s < 4; ++s) {
    const std::string field = last.text.substr(8 * s, 8);
    const long count = field[0] == letters[s] ? whole(field.substr(1), last.number, -1) : -1;
    if (count != long(sections[s].size()))
      step_error(last.number, "counts '" + std::string(trimmed(field)) + "' where the file has " +
                                  std::to_string(sections[s].size()) + " lines " + letters[s]);
  }
}

struct Delimiters {
  char parameter = ',', record = ';';
};

// Values of a record; texts (5HPlica) as they are. Throws where it does not end with its record.
std::vector<std::string> values_of(std::string_view text, const Delimiters& d, int line) {
  std::vector<std::string> values(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const std::string count(trimmed(values.back()));
    if (c == 'H' && !count.empty() && count.find_first_not_of("0123456789") == count.npos &&
        count.size() < 6) {
      const std::size_t length = std::size_t(std::stol(count));
      if (i + length >= text.size()) step_error(line, "a text is longer than its record");
      values.back() += text.substr(i, length + 1);
      i += length;
    } else if (c == d.parameter)
      values.emplace_back();
    else if (c == d.record) {
      if (!trimmed(text.substr(i + 1)).empty()) step_error(line, "a record goes on after its end");
      return values;
    } else
      values.back() += c;
  }
  step_error(line, std::string("a record does not end with '") + d.record + "'");
}

std::string word_of(const std::string& value) {
  const std::size_t h = value.find('H');
  const std::string_view word(value);
  return std::string(trimmed(h == word.npos ? word : word.substr(h + 1)));
}

Delimiters check_global(const std::vector<Line>& lines) {
  if (lines.empty()) step_error(1, "there is no global section");
  const int line = lines[0].number;
  std::string text;
  for (const Line& l : lines) text += l.text.substr(0, 72);
  Delimiters d;
  if (text.starts_with("1H") && text.size() > 6) {
    d.parameter = text[2];
    const std::size_t next = 4;
    if (text.compare(next, 2, "1H") == 0) d.record = text[next + 2];
  }
  const std::vector<std::string> values = values_of(text, d, line);
  constexpr std::size_t unit = 13, name = 14, least = 19;
  if (values.size() < least)
    step_error(line, "the global section has " + std::to_string(values.size()) + " values");
  static const std::map<long, std::set<std::string>> units{
      {1, {"IN", "INCH"}}, {2, {"MM"}},  {4, {"FT"}}, {5, {"MI"}},  {6, {"M"}},
      {7, {"KM"}},         {8, {"MIL"}}, {9, {"UM"}}, {10, {"CM"}}, {11, {"UIN"}}};
  const long number = whole(values[unit], line, 1);
  std::string says = word_of(values[name]);
  for (char& c : says) c = char(std::toupper(static_cast<unsigned char>(c)));
  const auto known = units.find(number);
  constexpr long by_name = 3;
  if ((known == units.end() && number != by_name) ||
      (known != units.end() && !says.empty() && !known->second.contains(says)))
    step_error(line, "the unit has number " + std::to_string(number) + " and name '" + says +
                         "', which do not go together");
  return d;
}

void check_entities(const Sections& sections, const Delimiters& d) {
  const std::vector<Line>&directory = sections[2], &parameters = sections[3];
  if (directory.size() % 2 != 0)
    step_error(directory.back().number, "an entity of the directory has one line, not two");
  const auto field = [](const Line& line, std::size_t i) {
    return whole(std::string_view(line.text).substr(8 * i, 8), line.number, 0);
  };
  long next = 1; // line of the parameters
  std::map<long, long> type;
  for (std::size_t e = 0; e < directory.size(); e += 2) type[long(e) + 1] = field(directory[e], 0);
  for (std::size_t e = 0; e < directory.size(); e += 2) {
    const Line &first = directory[e], &second = directory[e + 1];
    const long kind = field(first, 0), from = field(first, 1), count = field(second, 3);
    if (kind != field(second, 0))
      step_error(second.number, "the two lines of an entity have different types");
    constexpr long matrix = 124, none = 0;
    if (const long turned = field(first, 6); turned != 0 && type[turned] != matrix)
      step_error(first.number, "an entity is placed by " + std::to_string(turned) +
                                   ", which is no transformation");
    if (kind == none && count == 0) continue; // left empty
    if (from < 1 || count < 1 || from + count - 1 > long(parameters.size()) || from != next)
      step_error(first.number, "its parameters are said to be lines P" + std::to_string(from) +
                                   " to P" + std::to_string(from + count - 1) + ", not from P" +
                                   std::to_string(next) + " on, of " +
                                   std::to_string(parameters.size()));
    next = from + count;
    std::string text;
    for (long p = from; p < next; ++p) {
      const Line& line = parameters[std::size_t(p) - 1];
      if (field(line, 8) != long(e) + 1)
        step_error(line.number, "belongs to entity " + std::to_string(field(line, 8)) +
                                    ", the directory says to " + std::to_string(e + 1));
      text += line.text.substr(0, 64);
    }
    const int line = parameters[std::size_t(from) - 1].number;
    const std::vector<std::string> values = values_of(text, d, line);
    if (whole(values[0], line, 0) != kind)
      step_error(line, "parameters of type " + std::string(trimmed(values[0])) +
                           ", the directory says " + std::to_string(kind));
  }
  if (next <= long(parameters.size()))
    step_error(parameters[std::size_t(next) - 1].number, "parameters that belong to no entity");
}

} // namespace

void check_iges_text(const std::string& text) {
  const Sections sections = sections_of(text);
  check_terminate(sections);
  check_entities(sections, check_global(sections[1]));
}

} // namespace plica
