// A folder of files of geometry, gone after the test, and what meshing says of each.
#pragma once

#include "mesh/generation/surface_mesher.hpp"
#include "mesh/generation/worker.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace plica::test {

class GeometryFolder : public testing::Test {
protected:
  void TearDown() override {
    for (const char* name : {"PLICA_MESHER", "PLICA_MESH_SECONDS", "PLICA_MESH_MEMORY"})
      unsetenv(name);
    allow_workers();
  }

  std::filesystem::path at(const std::string& name) const { return folder_.path / name; }
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
  const TemporaryFolder folder_{"geometry"};
};

} // namespace plica::test
