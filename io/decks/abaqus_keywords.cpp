#include "io/decks/abaqus_keywords.hpp"

namespace plica {

void LeftOut::note(const Keyword& k, const std::string& what, const std::string& allowed) {
  if (unknown_ == UnknownCards::error)
    deck_error(k.at, "*" + k.name, what, allowed + ", or unknown_cards: list");
  deck_.left_out.push_back(k.at.file + ":" + std::to_string(k.at.line) + ": *" + k.name + " " +
                           what);
}

const DataLine& data_line(const Keyword& k, std::size_t i) {
  if (i >= k.data.size())
    deck_error(k.at, "*" + k.name, "has " + std::to_string(k.data.size()) + " data lines",
               "at least " + std::to_string(i + 1));
  return k.data[i];
}

int dof_in(const Keyword& k, const DataLine& line, std::size_t field) {
  const int d = whole_in(k, line, field);
  if (d < 1 || d > 6)
    deck_error(line.at, "*" + k.name, "names degree of freedom " + std::to_string(d), "1 to 6");
  return d - 1;
}

std::optional<int> deck_number(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos || text.size() > 9)
    return std::nullopt;
  return std::stoi(text);
}

std::string origin(const Keyword& k, const std::string& name) {
  return "*" + k.name + (name.empty() ? "" : " " + name) + " in line " + std::to_string(k.at.line);
}

} // namespace plica
