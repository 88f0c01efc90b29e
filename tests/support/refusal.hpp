// What a piece of work is refused with.
#pragma once

#include "words/input_error.hpp"

#include <functional>
#include <string>
#include <vector>

namespace plica::test {

inline std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// The same behind the key of the first problem.
inline std::string keyed_error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.problems()[0].key + ": " + error.what();
  }
  return "no error";
}

// All problems of it; none where the work goes through.
inline std::vector<InputProblem> input_problems(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

// The first of them, its key and what is wrong.
inline std::string first_problem_of(const std::function<void()>& work) {
  const std::vector<InputProblem> problems = input_problems(work);
  return problems.empty() ? "no error" : problems.front().key + ": " + problems.front().wrong;
}

} // namespace plica::test
