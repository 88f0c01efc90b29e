// A line of docs/verification_table.md: what a test found and what a source outside the code says.
#pragma once

#include <cstdio>
#include <gtest/gtest.h>
#include <string>

namespace plica::test {

inline void print_for_table(const std::string& what, double value, double reference,
                            double tolerance) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::printf("| %s.%s | %s | %.5g | %.5g | %+.2f %% | %.2g %% |\n", test->test_suite_name(),
              test->name(), what.c_str(), value, reference, 100 * (value / reference - 1),
              100 * tolerance);
}

} // namespace plica::test
