#include "tests/support/verification_line.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

namespace plica::test {
namespace {

// The file of a suite begins anew with every process; suites of parameters have a / in their names.
void keep(const std::string& folder, std::string suite, const std::string& line) {
  static std::set<std::string> begun;
  std::replace(suite.begin(), suite.end(), '/', '_');
  std::filesystem::create_directories(folder);
  const auto mode = begun.insert(suite).second ? std::ios::trunc : std::ios::app;
  std::ofstream(folder + "/" + suite + ".md", std::ios::out | mode) << line;
}

} // namespace

void print_for_table(const std::string& what, double value, double reference, double tolerance) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string suite = test->test_suite_name();
  const std::string line =
      fmt::format("| {}.{} | {} | {:.5g} | {:.5g} | {:+.2f} % | {:.2g} % |\n", suite, test->name(),
                  what, value, reference, 100 * (value / reference - 1), 100 * tolerance);
  std::fputs(line.c_str(), stdout);
  if (const char* folder = std::getenv("PLICA_TABLE")) keep(folder, suite, line);
}

} // namespace plica::test
