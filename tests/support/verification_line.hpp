// A line of docs/verification_table.md: what a test found and what a source outside the code says.
#pragma once

#include <string>

namespace plica::test {

// Prints the line of the running test; where the environment names a folder PLICA_TABLE, it stands
// there too, in the file of the suite.
void print_for_table(const std::string& what, double value, double reference, double tolerance);

} // namespace plica::test
