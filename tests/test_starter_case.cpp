// The case file of `plica init` is read without a complaint and gives what its numbers must.
#include "io/input/case_file.hpp"
#include "io/input/starter_case.hpp"
#include "run/analyses/run.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace plica {
namespace {

namespace fs = std::filesystem;

TEST(StarterCase, is_a_case_that_runs) {
  const fs::path file = fs::temp_directory_path() / "plica_starter_case_my_pipe.yaml";
  std::ofstream(file) << starter_case("my_pipe");
  Case data = read_case(file.string(), "").data;
  fs::remove(file);
  EXPECT_EQ(data.name, "my_pipe");
  data.analyses.error_bars = false;
  data.analyses.response.reset();
  std::get<Bellows>(data.parts.front().body).mesh = {.around = 32, .arc = 2, .wall = 2};
  const Results results = run(data, [](const std::string&) {});
  ASSERT_TRUE(results.statics.has_value());
  // Both ends held, moved across: at most 12 EI / L^3 of a beam with EI = k_a L R^2 / 2, L the
  // length that is convoluted and R its mean radius; shear takes some of it.
  const double most = 6 * results.statics->k_axial * std::pow(0.043 / 0.072, 2);
  EXPECT_LT(results.statics->k_transverse_x, most);
  EXPECT_GT(results.statics->k_transverse_x, most / 2);
  ASSERT_FALSE(results.modes.empty());
  EXPECT_EQ(results.modes.front().shape, "axial");
}

} // namespace
} // namespace plica
