// Problems that are found after reading the case file get its name and the line of their key.
#pragma once

#include "io/input/case_file.hpp"

namespace plica {

template <class F> auto located(const CaseFile& file, F&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<InputProblem> problems = error.problems();
    for (InputProblem& p : problems) {
      if (!p.file.empty()) continue;
      p.file = file.path;
      const auto line = file.lines.find(p.key);
      if (line != file.lines.end()) p.line = line->second;
    }
    throw InputError(problems);
  }
}

} // namespace plica
