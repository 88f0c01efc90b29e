// The nearest known word to a misspelt one, by edit distance (insert, delete, replace, swap two
// neighbours; upper and lower case count as equal).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plica {

int edit_distance(std::string_view a, std::string_view b);

// Empty when none is near: more than a third of the letters differ. Of equally near candidates the
// first.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

// "did you mean 'x'?", or "allowed: a, b, c" with at most `most` candidates, or both.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       int most = 12);

// Text as it may stand in a message: one line, control characters replaced, at most 60 bytes.
std::string shown(std::string_view text);

} // namespace plica
