#include "io/decks/bulk_data.hpp"

#include "io/decks/keywords.hpp"
#include "io/decks/nastran_cards.hpp"

#include <algorithm>
#include <charconv>
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
             std::size_t& files, std::vector<Line>& lines) {
  std::istringstream stream(included_text(file, from, "INCLUDE", depth, ++files));
  DeckPosition at{file.string(), 0};
  for (std::string raw; std::getline(stream, raw);) {
    ++at.line;
    const std::string line = plain(raw);
    if (trimmed(line).empty() || trimmed(line) == "&") continue;
    if (!in_capitals(trimmed(line)).starts_with("INCLUDE")) {
      lines.push_back({at, line});
      continue;
    }
    std::string name = trimmed(trimmed(line).substr(7));
    std::erase(name, '\'');
    std::erase(name, '"');
    collect(file.parent_path() / name, at, depth + 1, files, lines);
  }
}

// The first field: to the comma, or of eight columns. Blanks may stand before a name.
std::string first_field(const std::string& line) {
  const std::size_t comma = line.find(',');
  return trimmed(line.substr(0, comma == std::string::npos ? small_width : comma));
}

bool is_continuation(const std::string& line) {
  const std::string first = first_field(line);
  return first.empty() || first[0] == '+' || first[0] == '*';
}

struct LineFields {
  std::vector<std::string> fields; // behind the first, as many as a line has
  std::string continuation;        // what names the next line: the tenth field
  bool wide = false;
};

LineFields fields_of(const Line& source) {
  const std::string& line = source.text;
  LineFields all;
  all.wide = first_field(line).find('*') != std::string::npos;
  const std::size_t count = all.wide ? 4 : 8;
  if (line.find(',') != std::string::npos) {
    std::istringstream stream(line.substr(line.find(',') + 1));
    for (std::string field; std::getline(stream, field, ',');) all.fields.push_back(trimmed(field));
    while (all.fields.size() > count + 1 && all.fields.back().empty()) all.fields.pop_back();
    if (all.fields.size() > count) all.continuation = all.fields[count];
    const bool number = !all.continuation.empty() &&
                        (std::isdigit(static_cast<unsigned char>(all.continuation[0])) ||
                         all.continuation[0] == '-' || all.continuation[0] == '.');
    if (number || all.fields.size() > count + 1)
      deck_error(source.at, first_field(line),
                 "has \"" + all.fields[number ? count : count + 1] + "\" behind its " +
                     std::to_string(count) + " fields",
                 "the rest on a line that continues it");
  } else {
    const std::size_t width = all.wide ? large_width : small_width;
    for (std::size_t at = small_width; at < std::min<std::size_t>(line.size(), 72); at += width)
      all.fields.push_back(trimmed(line.substr(at, std::min(width, 72 - at))));
    if (line.size() > 72) all.continuation = trimmed(line.substr(72, small_width));
  }
  all.fields.resize(count);
  return all;
}

std::string name_of(const std::string& line) {
  std::string name = first_field(line);
  std::erase(name, '*');
  name = trimmed(name);
  return in_capitals(name.substr(0, name.find(' ')));
}

// All of `text` as a whole number with a sign or without.
std::optional<int> whole_number_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
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
    if (text.starts_with("SUBCASE")) ++subcases_;
    for (const char* matrix : {"K2GG", "M2GG", "K2PP", "M2PP", "K42GG"})
      if (text.starts_with(matrix) && text.find('=') != std::string::npos)
        data.matrices.push_back({line.at, matrix});
    for (const char* name : {"SPC", "MPC"}) {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos || trimmed(text.substr(0, equals)) != name) continue;
      const std::string number = trimmed(text.substr(equals + 1));
      const auto set = whole_number_of(number);
      if (!set) deck_error(line.at, name, "is \"" + number + "\"", "the number of a set");
      std::vector<int>& chosen = data.chosen[name];
      chosen.insert(subcases_ > 1 ? chosen.end() : chosen.begin(), *set);
    }
  }

  void bulk(const Line& line) {
    LineFields read = fields_of(line);
    const std::string first = first_field(line.text);
    if (is_continuation(line.text)) {
      const std::string name = without_marks(first);
      if (data.cards.empty()) refuse_beginning(line);
      const auto awaited = awaited_.find(name);
      if (!name.empty() && awaited != awaited_.end()) {
        open_ = awaited->second;
        awaited_.erase(awaited);
      } else if (!name.empty() && !last_awaits_.empty())
        deck_error(line.at, data.cards.back().name,
                   "is continued by \"" + first + "\", the line before it by \"" + last_awaits_ +
                       "\"",
                   "the name of a continuation that a line of the deck ends with");
      std::vector<std::string>& all = data.cards[open_].fields;
      if (!read.wide) all.resize((all.size() + 7) / 8 * 8);
      all.insert(all.end(), read.fields.begin(), read.fields.end());
    } else {
      Card card;
      card.at = line.at;
      card.name = name_of(line.text);
      card.fields = std::move(read.fields);
      open_ = data.cards.size();
      data.cards.push_back(std::move(card));
    }
    const std::string& next = read.continuation;
    last_awaits_ = next.starts_with('+') || next.starts_with('*') ? next : "";
    if (!without_marks(next).empty()) awaited_[without_marks(next)] = open_;
    if (without_marks(next).empty()) last_awaits_.clear();
  }

  static std::string without_marks(const std::string& name) {
    const std::size_t begin = name.find_first_not_of("+*");
    return begin == std::string::npos ? "" : name.substr(begin);
  }

  [[noreturn]] static void refuse_beginning(const Line& line) {
    if (line.text.size() > 1 && line.text[0] == '*' &&
        std::isalpha(static_cast<unsigned char>(line.text[1])))
      deck_error(line.at, "", "is a keyword of Abaqus", "the suffix .inp for such a deck");
    deck_error(line.at, "", "continues no card", "a card before it");
  }

  std::map<std::string, std::size_t> awaited_; // cards by the names of lines that continue them
  std::string last_awaits_;                    // named by the line before
  std::size_t open_ = 0;                       // card that a line without a name continues
  int subcases_ = 0;
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
  const auto value = whole_number_of(text(field));
  if (!value || std::abs(*value) > 999999999)
    wrong("field " + std::to_string(field + 2) + " is \"" + text(field) + "\"", "a whole number");
  return *value;
}

int Card::whole(std::size_t field, int otherwise) const {
  return has(field) ? whole(field) : otherwise;
}

std::vector<int> Card::dofs(std::size_t field) const {
  std::vector<int> all;
  for (char c : text(field)) {
    if (c == ' ') continue;
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
    constexpr int longest = 10000000;
    if (all.empty() || last < all.back() || last - all.back() > longest)
      wrong("THRU leads to " + std::to_string(last),
            "a number above the first, by at most " + std::to_string(longest));
    for (int n = all.back() + 1; n <= last; ++n) all.push_back(n);
    ++i;
    if (in_capitals(text(i + 1)) == "BY") i += 2;
  }
  return all;
}

BulkData read_bulk_data(const std::filesystem::path& file) {
  std::vector<Line> lines;
  std::size_t files = 0;
  collect(file, {file.string(), 0}, 0, files, lines);
  BulkData data = CardReader(lines).data;
  if (data.cards.empty()) deck_error({file.string(), 0}, "", "has no card", "a Nastran deck");
  return data;
}

} // namespace plica
