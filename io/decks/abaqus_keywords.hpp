// Which keyword is read by whom, and with which parameters.
#pragma once

#include "io/decks/keywords.hpp"
#include "model/description/case.hpp"
#include "model/description/deck_model.hpp"

#include <functional>
#include <optional>
#include <set>

namespace plica {

struct KeywordHandler {
  std::function<void(const Keyword&)> read;
  std::set<std::string> parameters; // others are not known
};
using KeywordHandlers = std::map<std::string, KeywordHandler>;

// Notes what is not followed, or throws: as the user wants it.
class LeftOut {
public:
  LeftOut(UnknownCards unknown, DeckModel& deck) : unknown_(unknown), deck_(deck) {}
  void note(const Keyword& keyword, const std::string& what, const std::string& allowed);

private:
  UnknownCards unknown_;
  DeckModel& deck_;
};

// Kinds of keywords that no handler is for.
enum class KeywordKind {
  passed, // says what to compute, what to write, what is hot or yields: no stiffness, no mass
  structural,
  unknown
};
KeywordKind kind_of_keyword(const std::string& name);
std::vector<std::string> passed_or_structural_keywords();
bool is_solid_type(const std::string& type); // of *ELEMENT: solids, plane and axisymmetric ones
bool is_idle_type(const std::string& type);  // without stiffness and mass: dashpots, rigid surfaces

const DataLine& data_line(const Keyword& keyword, std::size_t i); // InputError when there are fewer
int dof_in(const Keyword& keyword, const DataLine& line, std::size_t field); // 0..5
std::string origin(const Keyword& keyword, const std::string& name);         // for messages
std::optional<int> deck_number(const std::string& text); // of a node or element; none: a name

} // namespace plica
