#include "model/shape/constraint_clash.hpp"

#include "words/input_error.hpp"

#include <array>

namespace plica {
namespace {

// Of a constraint that build() makes; empty for others.
std::string key_of(const std::string& origin) {
  struct Maker {
    std::string_view says, before, after;
  };
  constexpr std::array makers{Maker{"spider of cap ", "caps.", ".of"},
                              Maker{"rigid body of mass ", "parts.", ".at"},
                              Maker{"tie of interlock ", "parts.", ".attachment"},
                              Maker{"end of interlock ", "parts.", ".along"}};
  for (const Maker& m : makers)
    if (origin.starts_with(m.says))
      return std::string(m.before) + origin.substr(m.says.size()) + std::string(m.after);
  return "";
}

bool holds_a_deck(const std::string& origin) {
  return origin.find(": *BOUNDARY") != std::string::npos ||
         origin.find(": SPC") != std::string::npos;
}

} // namespace

void refuse_clash(const ConstraintError& error) {
  std::string key, allowed = "every degree of freedom tied or held once";
  for (const std::string& origin : error.origins) {
    if (key.empty()) key = key_of(origin);
    if (holds_a_deck(origin))
      allowed = "held: false at the part of the deck, if the case holds these nodes instead, or "
                "other nodes";
  }
  input_error(key, error.what(), allowed);
}

DofMap eliminate_constraints(const Model& model) {
  try {
    return eliminate(model);
  } catch (const ConstraintError& error) {
    refuse_clash(error);
  }
}

} // namespace plica
