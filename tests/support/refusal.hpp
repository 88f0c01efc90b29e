// What a piece of work is refused with.
#pragma once

#include "words/input_error.hpp"

#include <functional>
#include <string>

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

} // namespace plica::test
