#include "io/decks/keywords.hpp"

#include "io/files/files.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace plica {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) {
    std::erase(field, '"');
    fields.emplace_back(trimmed(field));
  }
  return fields;
}

class KeywordReader {
public:
  std::vector<Keyword> keywords;
  std::vector<DeckPosition> before; // lines before the first keyword

  void read(const std::filesystem::path& file, const DeckPosition& from) {
    std::istringstream stream(included_text(file, from, "*INCLUDE", ++depth_, ++files_));
    DeckPosition at{file.string(), 0};
    bool open = false; // a keyword that goes on
    for (std::string line; std::getline(stream, line);) {
      ++at.line;
      if (at.line == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3); // of an editor
      line = trimmed(line);
      if (line.empty() || line.starts_with("**")) continue;
      if (open) {
        open = line.ends_with(',');
        add_parameters(split(line), 0);
        if (!open) include(file);
      } else if (line.starts_with('*')) {
        open = line.ends_with(',');
        begin(at, split(line));
        if (!open) include(file);
      } else {
        if (keywords.empty()) {
          before.push_back(at);
          continue;
        }
        keywords.back().data.push_back({at, split(line)});
      }
    }
    --depth_;
  }

private:
  void begin(const DeckPosition& at, const std::vector<std::string>& fields) {
    Keyword keyword{.at = at,
                    .name = in_capitals(fields.front().substr(1)),
                    .parameters = {},
                    .data = {},
                    .scope = {}};
    keyword.name = trimmed(keyword.name);
    keywords.push_back(std::move(keyword));
    add_parameters(fields, 1);
  }

  void add_parameters(const std::vector<std::string>& fields, std::size_t first) {
    for (std::size_t i = first; i < fields.size(); ++i) {
      if (fields[i].empty()) continue;
      const std::size_t equals = fields[i].find('=');
      const std::string name = in_capitals(trimmed(fields[i].substr(0, equals)));
      const std::string value(equals == std::string::npos
                                  ? ""
                                  : trimmed(std::string_view(fields[i]).substr(equals + 1)));
      const auto [known, is_new] = keywords.back().parameters.try_emplace(name, value);
      if (!is_new && known->second != value)
        deck_error(keywords.back().at, "*" + keywords.back().name,
                   "has " + name + " twice, " + known->second + " and " + value, "one of them");
    }
  }

  // A file is read in place of the *INCLUDE that names it, which may stand amid data, or as the
  // data of the keyword.
  void include(const std::filesystem::path& file) {
    Keyword& last = keywords.back();
    const auto input = last.parameters.find("INPUT");
    const bool include = last.name == "INCLUDE";
    if (input == last.parameters.end()) {
      if (include) deck_error(last.at, "*INCLUDE", "names no file", "INPUT=file");
      return;
    }
    std::string name = input->second;
    std::erase(name, '"');
    const DeckPosition at = last.at;
    last.parameters.erase(input);
    if (include) keywords.pop_back();
    read(file.parent_path() / name, at);
  }

  std::size_t depth_ = 0, files_ = 0;
};

const std::string& field_of(const Keyword& keyword, const DataLine& line, std::size_t field) {
  if (field >= line.fields.size() || line.fields[field].empty())
    deck_error(line.at, "*" + keyword.name, "field " + std::to_string(field + 1) + " is missing",
               "a number");
  return line.fields[field];
}

} // namespace

std::string included_text(const std::filesystem::path& file, const DeckPosition& from,
                          const std::string& card, std::size_t depth, std::size_t files) {
  constexpr std::size_t most_nested = 20, most_files = 1000;
  if (depth > most_nested) deck_error(from, card, "files include each other", "a file that ends");
  if (files > most_files)
    deck_error(from, card, "more than 1000 files are included", "fewer files, each once");
  try {
    return read_whole(file);
  } catch (const std::runtime_error&) {
    deck_error(from, card, "there is no file " + file.string() + " that can be read",
               "a path from the folder of the deck");
  }
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return capitals;
}

std::string Keyword::word(const std::string& parameter) const {
  const auto found = parameters.find(parameter);
  if (found == parameters.end() || found->second.empty())
    deck_error(at, "*" + name, "has no " + parameter, parameter + "=...");
  std::string value = found->second;
  std::erase(value, '"');
  return in_capitals(value);
}

std::string Keyword::word_or(const std::string& parameter, const std::string& otherwise) const {
  return has(parameter) ? word(parameter) : otherwise;
}

std::vector<Keyword> read_keywords(const std::filesystem::path& file,
                                   std::vector<std::string>& notes) {
  KeywordReader reader;
  reader.read(file, {file.string(), 0});
  if (reader.keywords.empty() && !reader.before.empty())
    deck_error(reader.before.front(), "",
               "is no keyword: the file does not begin as an Abaqus deck", "a line such as *NODE");
  if (!reader.before.empty())
    notes.push_back(std::to_string(reader.before.size()) +
                    " lines before the first keyword are passed over");
  if (reader.keywords.empty())
    deck_error({file.string(), 0}, "", "has no keyword", "an Abaqus deck");
  return std::move(reader.keywords);
}

double number_in(const Keyword& keyword, const DataLine& line, std::size_t field) {
  std::string text = field_of(keyword, line, field);
  std::replace(text.begin(), text.end(), 'D', 'e');
  std::replace(text.begin(), text.end(), 'd', 'e');
  if (text.starts_with('+')) text.erase(0, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    deck_error(line.at, "*" + keyword.name,
               "field " + std::to_string(field + 1) + " is \"" + line.fields[field] + "\"",
               "a number");
  return value;
}

double number_in(const Keyword& keyword, const DataLine& line, std::size_t field,
                 double otherwise) {
  if (field >= line.fields.size() || line.fields[field].empty()) return otherwise;
  return number_in(keyword, line, field);
}

int whole_in(const Keyword& keyword, const DataLine& line, std::size_t field) {
  const double value = number_in(keyword, line, field);
  if (value != std::floor(value) || std::abs(value) > 2e9)
    deck_error(line.at, "*" + keyword.name,
               "field " + std::to_string(field + 1) + " is \"" + line.fields[field] + "\"",
               "a whole number");
  return static_cast<int>(value);
}

} // namespace plica
