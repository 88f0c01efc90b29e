#include "words/input_error.hpp"

namespace plica {

namespace {

std::string joined(const std::vector<InputProblem>& problems) {
  std::string text;
  for (const InputProblem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += to_string(problem);
  }
  return text;
}

} // namespace

std::string to_string(const InputProblem& problem) {
  std::string text = problem.file;
  if (problem.line > 0) text += ":" + std::to_string(problem.line);
  if (!text.empty()) text += ": ";
  if (!problem.key.empty()) text += problem.key + ": ";
  text += problem.wrong;
  if (!problem.allowed.empty()) text += "; " + problem.allowed;
  return text;
}

InputError::InputError(std::vector<InputProblem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {}

void input_error(const std::string& key, const std::string& wrong, const std::string& allowed) {
  throw InputError({{.file = "", .line = 0, .key = key, .wrong = wrong, .allowed = allowed}});
}

} // namespace plica
