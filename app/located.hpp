// Problems that are found after reading the case file get its name and the line of their key.
#pragma once

#include "app/command_line.hpp"
#include "io/input/case_file.hpp"
#include "solve/model_error.hpp"

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
  } catch (const ModelError& error) {
    InputProblem problem{
        .file = file.path, .line = 0, .key = "", .wrong = error.what(), .allowed = ""};
    for (const std::string& section : error.sections)
      if (const auto line = file.lines.find(section);
          problem.key.empty() && line != file.lines.end()) {
        problem.key = section;
        problem.line = line->second;
      }
    throw InputError({problem});
  }
}

// The case of the command line, in the state that was chosen; its variants too.
inline CaseFile read_chosen(const ChosenCase& chosen) {
  CaseFile file = read_case(chosen.path, chosen.model);
  if (chosen.state.empty()) return file;
  return located(file, [&] {
    CaseFile changed = file;
    changed.data = in_state(file.data, chosen.state);
    for (Case& variant : changed.variants) variant = in_state(variant, chosen.state);
    return changed;
  });
}

} // namespace plica
