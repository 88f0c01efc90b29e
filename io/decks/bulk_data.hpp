// Lines of a Nastran deck as cards: free, small and large fields, continuations, INCLUDE, and what
// case control chooses.
#pragma once

#include "io/decks/deck_error.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace plica {

// Fields from the second on, without spaces, eight for every line of the card: fields[8] is the
// second field of the first continuation. Beyond the end they are empty.
class Card {
public:
  DeckPosition at;
  std::string name;
  std::vector<std::string> fields;
  int super = 0; // superelement of the part (BEGIN SUPER) that it stands in

  std::string text(std::size_t field) const;
  bool has(std::size_t field) const { return !text(field).empty(); }
  // InputError with line and number of the field (from 2, as in the manuals).
  double real(std::size_t field) const;
  double real(std::size_t field, double otherwise) const;
  int whole(std::size_t field) const;
  int whole(std::size_t field, int otherwise) const;
  std::vector<int> dofs(std::size_t field) const; // "1236" -> 0 1 2 5
  // Whole numbers from a field to the end, "1 THRU 5" spelt out.
  std::vector<int> list(std::size_t first) const;
  bool is_real(std::size_t field) const; // a number with a point or exponent

  std::string origin() const; // for messages: "CBAR 12 in line 34"
  [[noreturn]] void wrong(const std::string& what, const std::string& allowed) const;
};

// K2GG = KAAX, 2.0*KBODY: matrices that case control adds, each with a factor.
struct DirectMatrices {
  DeckPosition at;
  std::string card; // K2GG and its like
  std::vector<std::pair<double, std::string>> chosen;
};

// ASSIGN INPUTT4='super.op4',UNIT=101
struct AssignedMatrices {
  DeckPosition at;
  std::filesystem::path path;
  int unit = 0; // 0: none is stated
};

// What one subcase chooses: LOAD, SPC, MPC, TEMP (as a load), INITIAL (temperatures), DEFORM.
struct Subcase {
  int number = 0;
  std::map<std::string, int> chosen;
};

struct BulkData {
  std::vector<Card> cards;
  bool has_control = false; // case control before BEGIN BULK
  std::map<std::string, std::vector<int>>
      chosen;                            // by "SPC", "MPC"; that of the first subcase leads
  std::vector<Subcase> subcases;         // the first: what stands above them all
  std::set<std::string> control_not_had; // SYM, SUBCOM, P2G ...: would change the loads
  std::vector<DirectMatrices> matrices;
  std::vector<AssignedMatrices> assigned;
  std::vector<std::string> notes;
};

// A file without BEGIN BULK is bulk data altogether. Throws InputError.
BulkData read_bulk_data(const std::filesystem::path& file);

} // namespace plica
