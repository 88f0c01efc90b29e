// A good input of every reader of the program, small enough to be run a thousand times.
#pragma once

#include "tests/damaged/damage.hpp"

#include <map>
#include <string>
#include <vector>

namespace plica::test {

struct Sample {
  std::string name; // of the reader
  std::string file; // which is damaged
  std::string bytes;
  FormatRule rule;
  std::map<std::string, std::string> beside; // other files of its folder
  std::vector<std::string> arguments;        // of the program
  std::string result; // the file whose numbers are held against those of the good input
  int few = 25;       // rounds of the suite that runs with every test
};

const std::vector<Sample>& samples();

} // namespace plica::test
