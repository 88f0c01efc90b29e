#include "lab/measured/test_data.hpp"

#include <algorithm>

namespace plica {

std::vector<const FrfSet*> all_responses(const TestData& test) {
  std::vector<const FrfSet*> all;
  for (const std::vector<FrfSet>& entry : test.responses)
    for (const FrfSet& set : entry) all.push_back(&set);
  return all;
}

std::vector<std::string> warnings_of(const TestData& test) {
  std::vector<std::string> all;
  for (const FrfSet* set : all_responses(test))
    for (const std::string& warning : set->warnings)
      if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
  return all;
}

} // namespace plica
