// Damages to a file, as disks, editors, mail and people do them: one at random, repeatable by its
// seed.
#pragma once

#include <string>
#include <vector>

namespace plica::test {

struct Damaged {
  std::string bytes;
  std::string what; // its kind, for messages
};

Damaged damaged(const std::string& original, unsigned seed);

// Whether the damaged bytes are, by the letter of the format, another file that is as good as the
// first, so that no reader could tell: decided without any reader, by this rule.
//
//   text    every line, without its comment, has the words and numbers of one line of the original
//           in its order, numbers replaced by other finite numbers, words by other words of the
//           original (in capitals or not) or by units, and none more; `chained` formats (those that
//           count their lines or refer to them) have all their lines besides, in their order
//   binary  the length is that of the original and all bytes that differ lie in the payload, plain
//           numbers without a checksum, or in a part that is text and keeps the rule of texts
struct FormatRule {
  char comment = '\0'; // a line goes no further than it
  bool chained = false;
  std::vector<std::pair<std::size_t, std::size_t>> payload = {}; // of a binary file: [begin, end)
  std::pair<std::size_t, std::size_t> text = {0, 0};             // of a binary file
};

bool another_good_file(const std::string& original, const std::string& damaged,
                       const FormatRule& rule);

} // namespace plica::test
