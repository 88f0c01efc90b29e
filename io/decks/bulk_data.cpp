#include "io/decks/bulk_data.hpp"

#include "io/decks/keywords.hpp"
#include "io/decks/nastran_cards.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace plica {
namespace {

constexpr std::size_t small_width = 8, large_width = 16;
constexpr int most_replicas = 100000; // of a line

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

// Number of the line CEND, with which the executive control ends; 0 without.
int executive_lines(const std::string& text) {
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string word = in_capitals(trimmed(plain(line)));
    if (word == "CEND") return number;
    if (word.starts_with("BEGIN") || word.starts_with("GRID")) return 0;
  }
  return 0;
}

// All lines of the deck and its includes.
void collect(const std::filesystem::path& file, const DeckPosition& from, std::size_t depth,
             std::size_t& files, std::vector<Line>& lines, std::vector<std::string>& notes) {
  const std::string whole = included_text(file, from, "INCLUDE", depth, ++files);
  const int executive = executive_lines(whole);
  std::istringstream stream(whole);
  DeckPosition at{file.string(), 0};
  for (std::string raw; std::getline(stream, raw);) {
    ++at.line;
    const std::string line = plain(raw);
    if (trimmed(line).empty() || trimmed(line) == "&") continue;
    if (!in_capitals(trimmed(line)).starts_with("INCLUDE")) {
      lines.push_back({at, line});
      continue;
    }
    if (at.line < executive) {
      notes.push_back("INCLUDE of the executive control in line " + std::to_string(at.line) +
                      " is passed over: alterations of the solution (DMAP) are not followed");
      continue;
    }
    std::string name(trimmed(trimmed(line).substr(7)));
    std::erase(name, '\'');
    std::erase(name, '"');
    collect(file.parent_path() / name, at, depth + 1, files, lines, notes);
  }
}

// The first field: to the comma, or of eight columns. Blanks may stand before a name.
std::string first_field(const std::string& line) {
  const std::size_t comma = line.find(',');
  return std::string(trimmed(line.substr(0, comma == std::string::npos ? small_width : comma)));
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
    for (std::string field; std::getline(stream, field, ',');)
      all.fields.emplace_back(trimmed(field));
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
      all.fields.emplace_back(trimmed(line.substr(at, std::min(width, 72 - at))));
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

// Behind the equals sign: names, or factor*name.
std::vector<std::pair<double, std::string>> chosen_matrices(const DeckPosition& at,
                                                            const std::string& text) {
  std::vector<std::pair<double, std::string>> all;
  std::string list = text.substr(text.find('=') + 1);
  for (char& c : list)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  std::istringstream words(list);
  for (std::string word; words >> word;) {
    const std::size_t star = word.find('*');
    double factor = 1;
    try {
      if (star != std::string::npos) factor = nastran_number(word.substr(0, star));
    } catch (const std::logic_error&) {
      deck_error(at, "K2GG", "has the factor \"" + word + "\"", "a number * a name");
    }
    all.emplace_back(factor, star == std::string::npos ? word : word.substr(star + 1));
  }
  return all;
}

// INPUTT4='super.op4', UNIT=101 of an ASSIGN; nothing of any other.
std::optional<AssignedMatrices> assigned_matrices(const DeckPosition& at, const std::string& text) {
  const std::string capitals = in_capitals(text);
  const auto file = capitals.find("INPUTT4");
  if (!capitals.starts_with("ASSIGN") || file == std::string::npos) return std::nullopt;
  const auto open = text.find_first_of("'\"", file);
  const auto close = open == std::string::npos ? open : text.find(text[open], open + 1);
  if (close == std::string::npos)
    deck_error(at, "ASSIGN", "names no file", "INPUTT4='file.op4', UNIT=101");
  const std::filesystem::path folder = std::filesystem::path(at.file).parent_path();
  AssignedMatrices assigned{at, folder / text.substr(open + 1, close - open - 1), 0};
  if (const auto unit = capitals.find("UNIT", close); unit != std::string::npos) {
    const auto digits = capitals.find_first_of("0123456789", unit);
    const auto end = capitals.find_first_not_of("0123456789", digits);
    if (digits != std::string::npos)
      assigned.unit = whole_number_of(capitals.substr(digits, end - digits)).value_or(0);
  }
  return assigned;
}

// Of BEGIN SUPER=101, BEGIN SUPER 101; 0 of BEGIN BULK.
int superelement_of(const std::string& begin) {
  const auto digits = begin.find_last_not_of("0123456789 ");
  return digits == std::string::npos
             ? 0
             : whole_number_of(trimmed(begin.substr(digits + 1))).value_or(0);
}

// Replication: "=" as the card before, "==" so from here on, "*(x)" that of the card before and x.
// The first field of a card that is replicated is "="; "=(n)" repeats the last one n times.
bool replicates(const std::string& first) {
  return first.starts_with("=");
}

std::string increased(const DeckPosition& at, const std::string& before, std::string by) {
  std::erase_if(by, [](char c) { return c == '*' || c == '(' || c == ')'; });
  const auto whole = whole_number_of(before), step = whole_number_of(by);
  if (whole && step) return std::to_string(long(*whole) + *step);
  try {
    const double sum = nastran_number(before) + nastran_number(by);
    return nastran_real(std::abs(sum) < 1e-12 * std::abs(nastran_number(by)) ? 0 : sum);
  } catch (const std::logic_error&) {
    deck_error(at, "=", "adds \"" + by + "\" to \"" + before + "\"", "numbers of one kind");
  }
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
      if (name_of(line->text) == "BEGIN") super_ = superelement_of(line->text);
      bulk(*line);
    }
  }

  BulkData data;

private:
  void control(const Line& line) {
    const std::string text = in_capitals(trimmed(line.text));
    if (data.subcases.empty()) data.subcases.emplace_back();
    assign(line);
    if (text.starts_with("PARAM") && text.find(',') != std::string::npos) bulk(line);
    if (text.starts_with("SUBCASE")) {
      ++subcases_;
      const auto number = whole_number_of(trimmed(text.substr(std::string("SUBCASE").size())));
      data.subcases.push_back({number.value_or(subcases_), {}});
    }
    choose(text);
    for (const char* name : {"SYM", "SYMCOM", "SYMSEQ", "SUBCOM", "SUBSEQ", "REPCASE", "P2G"})
      if (text.starts_with(name) && text.find_first_of(" =") == std::string_view(name).size())
        data.control_not_had.insert(name);
    for (const char* matrix : {"K2GG", "M2GG", "K2PP", "M2PP", "K42GG"})
      if (text.starts_with(matrix) && text.find('=') != std::string::npos)
        data.matrices.push_back({line.at, matrix, chosen_matrices(line.at, text)});
    for (const char* name : {"SPC", "MPC"}) {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos || trimmed(text.substr(0, equals)) != name) continue;
      const std::string number(trimmed(text.substr(equals + 1)));
      const auto set = whole_number_of(number);
      if (!set) deck_error(line.at, name, "is \"" + number + "\"", "the number of a set");
      std::vector<int>& chosen = data.chosen[name];
      chosen.insert(subcases_ > 1 ? chosen.end() : chosen.begin(), *set);
    }
  }

  // A statement that ends in a comma goes on in the next line.
  void assign(const Line& line) {
    statement_ += trimmed(line.text);
    if (statement_.ends_with(',')) return;
    if (auto assigned = assigned_matrices(line.at, statement_))
      data.assigned.push_back(std::move(*assigned));
    statement_.clear();
  }

  void choose(const std::string& text) {
    const std::size_t equals = text.find('='); // without one no number is found below
    std::string name(trimmed(text.substr(0, equals)));
    if (name == "TEMPERATURE" || name.ends_with("(LOAD)") || name.ends_with("(BOTH)"))
      name = "TEMP";
    if (name.ends_with("(INIT)") || name.ends_with("(INITIAL)")) name = "INITIAL";
    static const std::set<std::string> kinds{"LOAD", "SPC", "MPC", "TEMP", "INITIAL", "DEFORM"};
    if (!kinds.contains(name)) return;
    if (const auto set = whole_number_of(trimmed(text.substr(equals + 1))))
      data.subcases.back().chosen[name] = *set;
  }

  void bulk(const Line& line) {
    LineFields read = fields_of(line);
    const std::string first = first_field(line.text);
    if (replicates(first)) return replicate(line, first, read);
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
      card.super = super_;
      open_ = data.cards.size();
      rules_.clear();
      data.cards.push_back(std::move(card));
    }
    const std::string& next = read.continuation;
    last_awaits_ = next.starts_with('+') || next.starts_with('*') ? next : "";
    if (!without_marks(next).empty()) awaited_[without_marks(next)] = open_;
    if (without_marks(next).empty()) last_awaits_.clear();
  }

  void replicate(const Line& line, const std::string& first, const LineFields& read) {
    if (data.cards.empty()) refuse_beginning(line);
    int times = 1;
    if (first != "=") {
      std::string number = first.substr(1);
      std::erase_if(number, [](char c) { return c == '(' || c == ')'; });
      const auto count = whole_number_of(number);
      if (!count || *count < 1 || *count > most_replicas ||
          data.cards.size() > 30 * std::size_t(most_replicas))
        deck_error(line.at, first, "is no number of replicas", "= or =(n)");
      times = *count;
    }
    const bool has_rules = std::any_of(read.fields.begin(), read.fields.end(),
                                       [](const std::string& f) { return !f.empty(); });
    if (has_rules) rules_ = read.fields;
    if (rules_.empty())
      deck_error(line.at, first, "replicates nothing", "=, *(x) or == in its fields");
    for (int i = 0; i < times; ++i) {
      Card next = data.cards.back();
      if (next.fields.size() > read.fields.size() && next.fields.size() > 8)
        deck_error(line.at, first, "replicates a card of several lines", "cards of one line");
      next.at = line.at;
      for (std::size_t f = 0; f < rules_.size() && rules_[f] != "=="; ++f) {
        if (f >= next.fields.size()) next.fields.resize(f + 1);
        if (rules_[f].starts_with('*'))
          next.fields[f] = increased(line.at, next.fields[f], rules_[f]);
        else if (rules_[f] != "=")
          next.fields[f] = rules_[f];
      }
      data.cards.push_back(std::move(next));
    }
    open_ = data.cards.size() - 1;
    last_awaits_.clear();
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
  std::vector<std::string> rules_;             // of the last replica
  std::size_t open_ = 0;                       // card that a line without a name continues
  std::string statement_;                      // of the executive control, as far as it goes
  int subcases_ = 0, super_ = 0;
};

} // namespace

BulkData read_bulk_data(const std::filesystem::path& file) {
  std::vector<Line> lines;
  std::size_t files = 0;
  std::vector<std::string> notes;
  collect(file, {file.string(), 0}, 0, files, lines, notes);
  BulkData data = CardReader(lines).data;
  data.notes = std::move(notes);
  if (data.cards.empty()) deck_error({file.string(), 0}, "", "has no card", "a Nastran deck");
  return data;
}

} // namespace plica
