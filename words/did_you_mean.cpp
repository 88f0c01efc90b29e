#include "words/did_you_mean.hpp"

#include "words/utf8.hpp"

#include <algorithm>
#include <cctype>

namespace plica {

namespace {

constexpr std::size_t longest_word = 200; // longer ones are not compared

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

} // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
  std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
  for (int i = 0; i <= n; ++i) d[i][0] = i;
  for (int j = 0; j <= m; ++j) d[0][j] = j;
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= m; ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[n][m];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.size() > longest_word) return "";
  const int limit = std::max(1, static_cast<int>(word.size()) / 3);
  std::string best;
  int best_distance = limit + 1;
  for (const std::string& candidate : candidates) {
    const int longer = static_cast<int>(std::max(word.size(), candidate.size()));
    const int difference =
        std::abs(static_cast<int>(word.size()) - static_cast<int>(candidate.size()));
    if (difference >= best_distance || longer > static_cast<int>(longest_word)) continue;
    const int distance = edit_distance(word, candidate);
    if (distance < best_distance && distance < longer) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       int most) {
  const std::string near = nearest_word(word, candidates);
  std::string text = near.empty() ? "" : "did you mean '" + near + "'?";
  if (candidates.empty() || (candidates.size() == 1 && !near.empty())) return text;
  if (static_cast<int>(candidates.size()) > most && !near.empty()) return text;
  if (!text.empty()) text += ' ';
  text += "allowed: ";
  const int n = std::min(most, static_cast<int>(candidates.size()));
  for (int i = 0; i < n; ++i) text += (i > 0 ? ", " : "") + candidates[i];
  if (static_cast<int>(candidates.size()) > n) text += ", ...";
  return text;
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::size_t end = std::min(text.size(), longest);
  while (end < text.size() && end > 0 && continues_letter(text[end])) --end;
  std::string result(text.substr(0, end));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return text.size() > end ? result + "..." : result;
}

} // namespace plica
