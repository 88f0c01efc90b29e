// How a command hands over what it found.
#pragma once

#include "io/files/output_folder.hpp"
#include "io/input/case_file.hpp"

namespace plica {

// Lets the files appear and removes those of an earlier run of the command that this one does not
// write; says what stays because it was changed.
void hand_over(OutputFolder& out);

// What the case most likely does not mean, on standard error: beside the reason of a failure.
void say_doubts(const Case& data);

// The work of a case; when it fails its doubts are said, too.
template <class F> auto with_doubts(const CaseFile& file, F&& work) {
  try {
    return work();
  } catch (const std::exception&) {
    say_doubts(file.data);
    throw;
  }
}

} // namespace plica
