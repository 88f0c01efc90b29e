// The case that a command is given, with the test beside it: read with what --set, --model and
// --measured say; problems found after reading it get its file and the line of their key.
#pragma once

#include "app/command_line.hpp"
#include "io/input/measured_file.hpp"
#include "solve/model_error.hpp"

namespace plica {

// What a run of a case with --set says of itself.
inline std::vector<std::string> set_by_hand(const CaseFile& file) {
  std::vector<std::string> words;
  for (const auto& [path, value] : file.set)
    words.push_back("Set on the command line: " + path + " = " + value);
  return words;
}

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
inline CaseFile read_case(const ChosenCase& chosen) {
  CaseFile file = read_case_with(chosen.path, chosen.model, chosen.set);
  if (chosen.state.empty()) return file;
  return located(file, [&] {
    CaseFile changed = file;
    changed.data = in_state(file.data, chosen.state);
    for (Case& variant : changed.variants) variant = in_state(variant, chosen.state);
    return changed;
  });
}

// A case and the test that it is held against: `measured`, or else the one that it names.
struct TestedCase {
  CaseFile file;
  std::optional<MeasuredFile> test;
};

// `file` as `read` gives it; InputError with the problems of both files at once.
template <class Read>
TestedCase with_test(const Read& read, const ChosenCase& chosen, const std::string& measured = {}) {
  const auto case_file = [&] {
    try {
      return read();
    } catch (const InputError& error) {
      std::vector<InputProblem> problems = error.problems();
      add_problems_of_test(chosen.path, chosen.model, chosen.set, measured, problems);
      throw InputError(std::move(problems));
    }
  };
  TestedCase tested{.file = case_file(), .test = {}};
  tested.test = test_of(tested.file, measured);
  return tested;
}

inline TestedCase read_tested_case(const ChosenCase& chosen, const std::string& measured = {}) {
  return with_test([&] { return read_case(chosen); }, chosen, measured);
}

} // namespace plica
