// A folder of a test's own, gone when it ends.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace plica::test {

struct TemporaryFolder {
  std::filesystem::path path;

  explicit TemporaryFolder(const std::string& kind) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path = std::filesystem::path(testing::TempDir()) / ("plica_" + kind + "_" + test->name());
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

} // namespace plica::test
