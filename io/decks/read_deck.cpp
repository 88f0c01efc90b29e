#include "io/decks/read_deck.hpp"

#include "io/decks/deck_error.hpp"
#include "io/decks/keywords.hpp"
#include "io/decks/read_abaqus.hpp"
#include "io/decks/read_nastran.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <mutex>
#include <sstream>
#include <tuple>

namespace plica {
namespace {

// Some Nastran decks are called .inp: no line of theirs before BEGIN BULK or the first card is a
// keyword of Abaqus.
bool is_abaqus(const std::filesystem::path& file) {
  if (deck_format(file) != DeckFormat::abaqus) return false;
  std::istringstream stream(included_text(file, {file.string(), 0}, "", 0, 0));
  for (std::string line; std::getline(stream, line);) {
    const std::string text = in_capitals(trimmed(line));
    if (text.starts_with('*') && !text.starts_with("**")) return true;
    if (text.starts_with("BEGIN") || text.starts_with("CEND") || text.starts_with("GRID"))
      return false;
  }
  return true;
}

} // namespace

std::shared_ptr<const DeckModel> read_deck(const std::filesystem::path& file,
                                           UnknownCards unknown) {
  using Key = std::tuple<std::string, std::filesystem::file_time_type, UnknownCards>;
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const DeckModel>> known;
  std::error_code none; // of a file that is not there, which reading says
  const Key key{file.string(), std::filesystem::last_write_time(file, none), unknown};
  const std::lock_guard lock(mutex);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  auto deck = std::make_shared<DeckModel>(is_abaqus(file) ? read_abaqus(file, unknown)
                                                          : read_nastran(file, unknown));
  deck->files.insert(file.string());
  if (deck->nodes.empty()) deck_error({file.string(), 0}, "", "has no node", "a model");
  return known[key] = std::move(deck);
}

} // namespace plica
