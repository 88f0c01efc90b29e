// What is wrong in a deck, with the file and line of the card.
#pragma once

#include "words/input_error.hpp"

#include <string>
#include <vector>

namespace plica {

struct DeckPosition {
  std::string file;
  int line = 0;
};

[[noreturn]] inline void deck_error(const DeckPosition& at, const std::string& card,
                                    const std::string& wrong, const std::string& allowed) {
  throw InputError({{at.file, at.line, card, wrong, allowed}});
}

// What is wrong in cards that do not depend on each other, to be said at once.
class DeckProblems {
public:
  // Runs f and keeps what it throws.
  template <class F> void collect(F&& f) {
    constexpr std::size_t most = 100000;
    try {
      f();
    } catch (const InputError& error) {
      found_.insert(found_.end(), error.problems().begin(), error.problems().end());
      if (found_.size() >= most) raise();
    }
  }

  // Throws InputError when there are any; to be called before what builds on these cards. Of a card
  // that fails the same way again and again the first two are said, and how many more there are.
  void raise() const;
  std::size_t count() const { return found_.size(); }
  // The same where there are so many that what follows would only follow from them.
  void raise_unless_few() const {
    constexpr std::size_t few = 50;
    if (found_.size() > few) raise();
  }

private:
  std::vector<InputProblem> found_;
};

} // namespace plica
