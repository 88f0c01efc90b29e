#include "io/decks/bulk_data.hpp"

#include "io/decks/keywords.hpp"
#include "io/decks/nastran_cards.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace plica {
namespace {

constexpr std::size_t small_width = 8, large_width = 16;

struct Line {
  DeckPosition at;
  std::string text; // without comment, tabs as spaces to the next column of eight
};

std::string plain(const std::string& raw) {
  std::string text;
  for (char c : raw.substr(0, raw.find('$'))) {
    if (c == '\r') continue;
    if (c != '\t') {
      text += c;
      continue;
    }
    do text += ' ';
    while (text.size() % small_width != 0);
  }
  return text;
}

// All lines of the deck and its includes.
void collect(const std::filesystem::path& file, const DeckPosition& from, std::size_t depth,
             std::vector<Line>& lines) {
  std::istringstream stream(included_text(file, from, "INCLUDE", depth));
  DeckPosition at{file.string(), 0};
  for (std::string raw; std::getline(stream, raw);) {
    ++at.line;
    const std::string line = plain(raw);
    if (trimmed(line).empty()) continue;
    if (!in_capitals(trimmed(line)).starts_with("INCLUDE")) {
      lines.push_back({at, line});
      continue;
    }
    std::string name = trimmed(trimmed(line).substr(7));
    std::erase(name, '\'');
    std::erase(name, '"');
    collect(file.parent_path() / name, at, depth + 1, lines);
  }
}

bool is_continuation(const std::string& line) {
  return line[0] == '+' || line[0] == '*' || line[0] == ' ' || line[0] == ',';
}

// Fields after the first, and whether they are wide.
std::vector<std::string> fields_of(const std::string& line, bool& wide) {
  std::vector<std::string> fields;
  if (line.find(',') != std::string::npos) {
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(trimmed(field));
    wide = fields.front().find('*') != std::string::npos;
    fields.erase(fields.begin());
  } else {
    wide = line.substr(0, small_width).find('*') != std::string::npos;
    const std::size_t width = wide ? large_width : small_width;
    for (std::size_t at = small_width; at < std::min<std::size_t>(line.size(), 72); at += width)
      fields.push_back(trimmed(line.substr(at, std::min(width, 72 - at))));
  }
  fields.resize(wide ? 4 : 8); // what follows names the continuation
  return fields;
}

std::string name_of(const std::string& line) {
  std::string name = trimmed(line.substr(0, std::min(line.find(','), small_width)));
  std::erase(name, '*');
  return in_capitals(trimmed(name));
}

class CardReader {
public:
  explicit CardReader(const std::vector<Line>& lines) {
    const auto begin = std::find_if(lines.begin(), lines.end(), [](const Line& line) {
      return in_capitals(trimmed(line.text)).starts_with("BEGIN");
    });
    data.has_control = begin != lines.begin() && begin != lines.end();
    if (begin != lines.end())
      for (auto line = lines.begin(); line != begin; ++line) control(*line);
    for (auto line = begin == lines.end() ? lines.begin() : begin + 1; line != lines.end();
         ++line) {
      if (name_of(line->text) == "ENDDATA") break;
      bulk(*line);
    }
  }

  BulkData data;

private:
  void control(const Line& line) {
    const std::string text = in_capitals(trimmed(line.text));
    for (const char* name : {"SPC", "MPC"}) {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos || trimmed(text.substr(0, equals)) != name) continue;
      try {
        data.chosen[name].insert(std::stoi(text.substr(equals + 1)));
      } catch (const std::logic_error&) {
        deck_error(line.at, name, "is \"" + text.substr(equals + 1) + "\"", "the number of a set");
      }
    }
  }

  void bulk(const Line& line) {
    bool wide = false;
    const std::vector<std::string> fields = fields_of(line.text, wide);
    if (is_continuation(line.text)) {
      if (data.cards.empty()) {
        if (line.text.size() > 1 && line.text[0] == '*' &&
            std::isalpha(static_cast<unsigned char>(line.text[1])))
          deck_error(line.at, "", "is a keyword of Abaqus", "the suffix .inp for such a deck");
        deck_error(line.at, "", "continues no card", "a card before it");
      }
      std::vector<std::string>& all = data.cards.back().fields;
      if (!wide) all.resize((all.size() + 7) / 8 * 8);
      all.insert(all.end(), fields.begin(), fields.end());
      return;
    }
    Card card;
    card.at = line.at;
    card.name = name_of(line.text);
    card.fields = fields;
    data.cards.push_back(std::move(card));
  }
};

} // namespace

void Card::wrong(const std::string& what, const std::string& allowed) const {
  deck_error(at, name, what, allowed);
}

std::string Card::text(std::size_t field) const {
  return field < fields.size() ? fields[field] : "";
}

bool Card::is_real(std::size_t field) const {
  const std::string value = text(field);
  return value.find_first_of(".eEdD") != std::string::npos &&
         !std::isalpha(static_cast<unsigned char>(value[0]));
}

double Card::real(std::size_t field) const {
  try {
    const double value = nastran_number(text(field));
    if (std::isfinite(value)) return value;
  } catch (const std::logic_error&) {
  }
  wrong("field " + std::to_string(field + 2) + " is \"" + text(field) + "\"", "a number");
}

double Card::real(std::size_t field, double otherwise) const {
  return has(field) ? real(field) : otherwise;
}

int Card::whole(std::size_t field) const {
  const std::string value = text(field);
  if (value.empty() || value.size() > 9 ||
      value.find_first_not_of("-0123456789") != std::string::npos)
    wrong("field " + std::to_string(field + 2) + " is \"" + value + "\"", "a whole number");
  return std::stoi(value);
}

int Card::whole(std::size_t field, int otherwise) const {
  return has(field) ? whole(field) : otherwise;
}

std::vector<int> Card::dofs(std::size_t field) const {
  std::vector<int> all;
  for (char c : text(field)) {
    if (c < '1' || c > '6')
      wrong("field " + std::to_string(field + 2) + " is \"" + text(field) + "\"",
            "degrees of freedom 1 to 6, such as 123");
    all.push_back(c - '1');
  }
  return all;
}

std::vector<int> Card::list(std::size_t first) const {
  std::vector<int> all;
  for (std::size_t i = first; i < fields.size(); ++i) {
    if (!has(i)) continue;
    if (in_capitals(text(i)) != "THRU") {
      all.push_back(whole(i));
      continue;
    }
    const int last = whole(i + 1);
    if (all.empty() || last < all.back())
      wrong("THRU leads to " + std::to_string(last), "a number above the first");
    for (int n = all.back() + 1; n <= last; ++n) all.push_back(n);
    ++i;
  }
  return all;
}

BulkData read_bulk_data(const std::filesystem::path& file) {
  std::vector<Line> lines;
  collect(file, {file.string(), 0}, 0, lines);
  BulkData data = CardReader(lines).data;
  if (data.cards.empty()) deck_error({file.string(), 0}, "", "has no card", "a Nastran deck");
  return data;
}

} // namespace plica
