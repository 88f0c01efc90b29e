#include "mesher/surface_frame.hpp"
#include "mesher/surface_words.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace plica {
namespace {

std::string small_letters(std::string_view word) {
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

class StlText {
public:
  explicit StlText(const std::string& text) : lines_(lines_of_words(text)) {}

  void check() {
    const bool ended = std::any_of(lines_.begin(), lines_.end(), [](const TextLine& line) {
      return !line.words.empty() && begins(line, "endsolid");
    });
    if (!ended) surface_error(0, "ends before its endsolid: it was cut short");
    while (const TextLine* line = next()) {
      if (!begins(*line, "solid")) due(*line, "solid");
      while ((line = next()) && begins(*line, "facet")) facet(*line);
      if (!line) surface_error(0, "ends before its endsolid: it was cut short");
      if (!begins(*line, "endsolid")) due(*line, "facet or endsolid");
    }
  }

private:
  const TextLine* next() {
    while (at_ < lines_.size() && lines_[at_].words.empty()) ++at_;
    return at_ < lines_.size() ? &lines_[at_++] : nullptr;
  }
  static bool begins(const TextLine& line, const char* word) {
    return small_letters(line.words[0]) == word;
  }
  [[noreturn]] static void due(const TextLine& line, const std::string& word) {
    surface_error(line.number, shown_word(line.words[0]) + " where " + word + " is due");
  }
  const TextLine& wanted(const char* first, std::size_t words) {
    const TextLine* line = next();
    if (!line) surface_error(0, "ends inside of a facet: it was cut short");
    if (!begins(*line, first)) due(*line, first);
    if (line->words.size() != words)
      surface_error(line->number, std::string(first) + " with " +
                                      std::to_string(line->words.size()) + " words, not " +
                                      std::to_string(words));
    return *line;
  }

  // Normals are not read: some writers leave them 0 or nan.
  void facet(const TextLine& line) {
    if (line.words.size() != 5 || small_letters(line.words[1]) != "normal")
      surface_error(line.number, "a facet without normal and three numbers");
    wanted("outer", 2);
    for (int corner = 0; corner < 3; ++corner) {
      const TextLine& vertex = wanted("vertex", 4);
      for (std::size_t i = 1; i <= 3; ++i) finite_number(vertex, i);
    }
    wanted("endloop", 1);
    wanted("endfacet", 1);
  }

  std::vector<TextLine> lines_;
  std::size_t at_ = 0;
};

} // namespace

void check_stl(const std::string& bytes) {
  constexpr std::size_t head = 84, triangle = 50, count_at = 80;
  std::uint32_t count = 0;
  if (bytes.size() >= head) std::memcpy(&count, bytes.data() + count_at, sizeof count);
  if (bytes.size() >= head && bytes.size() == head + triangle * std::size_t(count)) return;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool text = first != std::string::npos && small_letters(bytes.substr(first, 5)) == "solid";
  if (text && bytes.find('\0') == std::string::npos) return StlText(bytes).check();
  if (bytes.size() < head)
    surface_error(0, "is no STL: neither a text that begins with solid nor a count of triangles");
  surface_error(0, "has " + std::to_string(bytes.size()) + " bytes; its count of " +
                       std::to_string(count) + " triangles says " +
                       std::to_string(head + triangle * std::size_t(count)));
}

} // namespace plica
