// Errors of the user's input, all of a file at once.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace plica {

struct InputProblem {
  std::string file;
  int line = 0;        // from 1; 0 = the whole file
  std::string key;     // path of the key, e.g. "parts.bellows.wall.plies[1]"
  std::string wrong;   // what is wrong
  std::string allowed; // what would be right, with a did-you-mean where there is one
};

// "file:line: key: wrong; allowed"
std::string to_string(const InputProblem& problem);

class InputError : public std::runtime_error {
public:
  explicit InputError(std::vector<InputProblem> problems);
  const std::vector<InputProblem>& problems() const { return problems_; }

private:
  std::vector<InputProblem> problems_;
};

// One problem of the case, named by its key; whoever read the file adds file and line.
[[noreturn]] void input_error(const std::string& key, const std::string& wrong,
                              const std::string& allowed);

} // namespace plica
