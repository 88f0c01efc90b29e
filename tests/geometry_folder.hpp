// A folder of files of geometry, gone after the test, and what meshing says of each.
#pragma once

#include "mesh/generation/surface_mesher.hpp"
#include "mesh/generation/worker.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace plica::test {

class GeometryFolder : public testing::Test {
protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
    for (const char* name : {"PLICA_MESHER", "PLICA_MESH_SECONDS", "PLICA_MESH_MEMORY"})
      unsetenv(name);
    allow_workers();
  }

  std::filesystem::path at(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(at(name), std::ios::binary) << text;
  }
  std::string text_of(const std::string& name) const {
    std::ifstream in(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // What is said of the file; empty where it is meshed.
  std::string refusal(const std::string& name, const SurfaceMeshing& meshing) const {
    try {
      mesh_surface_file(at(name), meshing);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("plica_damage_" +
       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

} // namespace plica::test
