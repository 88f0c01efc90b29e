// Lines of an Abaqus deck as keywords with parameters and data lines; *INCLUDE is followed.
//
//   *SHELL SECTION, ELSET=WALL, MATERIAL=STEEL     keyword "SHELL SECTION", parameters by name
//   5.e-4, 5                                       a data line of two fields
//
// Case and spaces around fields do not matter: keywords and names of parameters are in capitals, a
// keyword that ends in a comma goes on in the next line, "**" begins a comment.
#pragma once

#include "io/decks/deck_error.hpp"

#include <filesystem>
#include <map>

namespace plica {

struct DataLine {
  DeckPosition at;
  std::vector<std::string> fields; // without spaces around them
};

struct Keyword {
  DeckPosition at;
  std::string name;
  std::map<std::string, std::string> parameters; // values as written
  std::vector<DataLine> data;
  std::string scope = {}; // instance that it belongs to; empty: the assembly, or a flat deck

  bool has(const std::string& parameter) const { return parameters.contains(parameter); }
  // Value in capitals; InputError when it is missing.
  std::string word(const std::string& parameter) const;
  std::string word_or(const std::string& parameter, const std::string& otherwise) const;
};

// Throws InputError for a file that cannot be read, includes that include each other, and a file
// without keywords. Lines before the first one are passed over, with a note.
std::vector<Keyword> read_keywords(const std::filesystem::path& file,
                                   std::vector<std::string>& notes);

// Text of a file that a card of a deck includes, of either code. Throws InputError at `from` when
// it cannot be read, lies deeper than twenty files, or is
// more than the thousandth: files that include two others each would double with every level.
std::string included_text(const std::filesystem::path& file, const DeckPosition& from,
                          const std::string& card, std::size_t depth, std::size_t files);

std::string in_capitals(std::string_view text);

// Fields as numbers; InputError with line and field number. An empty field beyond the end of a line
// or between commas is `otherwise` where there is one.
double number_in(const Keyword& keyword, const DataLine& line, std::size_t field);
double number_in(const Keyword& keyword, const DataLine& line, std::size_t field, double otherwise);
int whole_in(const Keyword& keyword, const DataLine& line, std::size_t field);

} // namespace plica
