// The fields of a card (bulk_data.hpp), each as what it has to be.
#include "io/decks/bulk_data.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/nastran_cards.hpp"

#include <cctype>
#include <cmath>
#include <stdexcept>

namespace plica {

void Card::wrong(const std::string& what, const std::string& allowed) const {
  deck_error(at, name, what, allowed);
}

std::string Card::origin() const {
  return name + " " + text(0) + " in line " + std::to_string(at.line);
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

} // namespace plica
