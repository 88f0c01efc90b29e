// Grammar of ISO 10303-21:2002, chapter 5 to 10: entity instances of the data sections.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace plica {

struct StepValue {
  enum class Kind { number, text, word, reference, none, list, record };
  Kind kind = Kind::none;
  std::string_view text;        // of a number; the name of a word or record
  int reference = 0;            // of #n
  std::vector<StepValue> items; // of a list or a record
};

struct StepEntity {
  int number = 0, line = 0;
  std::vector<StepValue> records; // one; several of a complex entity

  const StepValue* record(std::string_view name) const; // nullptr: none
};

// Throws std::runtime_error "line 12: ...".
void parse_step(std::string_view text, const std::function<void(const StepEntity&)>& found);

[[noreturn]] void step_error(int line, const std::string& what);

} // namespace plica
