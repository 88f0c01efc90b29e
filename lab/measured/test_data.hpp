// A test in memory: what measured.yaml says, with the responses it names.
#pragma once

#include "lab/measured/frf_set.hpp"
#include "lab/measured/measured.hpp"

namespace plica {

struct TestData {
  Measured data;
  std::vector<std::vector<FrfSet>> responses; // a list for each entry of data.frf that is used
};

// Those of all entries, in their order; they live as long as `test`.
std::vector<const FrfSet*> all_responses(const TestData& test);

// What is doubtful in the files of the responses, each thing once.
std::vector<std::string> warnings_of(const TestData& test);

} // namespace plica
