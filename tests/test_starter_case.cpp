// The case file of `plica init` is read without a complaint and gives what its numbers must.
#include "io/input/case_file.hpp"
#include "io/input/starter_case.hpp"
#include "model/run.hpp"

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
  // Axial and transverse stiffness of a tube that bends as its axial springs do: k_t is below
  // 12 EI / L^3 with EI = k_a L R^2 / 2, R the mean radius, by what shear adds.
  const double k = results.statics->k_axial, R = 0.043, L = 0.080;
  EXPECT_LT(results.statics->k_transverse_x, 6 * k * R * R / (L * L) * 1.1);
  EXPECT_GT(results.statics->k_transverse_x, 3 * k * R * R / (L * L));
  ASSERT_FALSE(results.modes.empty());
  EXPECT_EQ(results.modes.front().shape, "axial");
}

} // namespace
} // namespace plica
