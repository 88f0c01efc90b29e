// The bellows of pipe A2: its default mesh, a fine mesh, and each refinement at its own order.
//
// Reference (an independent program of axisymmetric shells with harmonics, converged):
// 253.8 kN/m, 261.6 and 362.7 Hz with one wall; 65.9 kN/m, 133.7 and 187.4 Hz with two slipping
// plies. Accepted: 1 % at the default mesh, 0.5 % at a fine one.
#include "tests/bellows_case.hpp"
#include "tests/harmonic_model.hpp"

namespace plica::test {
namespace {

class PipeA2 : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bellows, PipeA2, testing::Values("a2_one_wall", "a2_slipping_plies"),
                         [](const auto& p) { return std::string(p.param); });

struct ReferenceA2 {
  double stiffness, axial, transverse;
};
ReferenceA2 reference_a2(const std::string& name) {
  return name == "a2_one_wall" ? ReferenceA2{253.8e3, 261.6, 362.7}
                               : ReferenceA2{65.9e3, 133.7, 187.4};
}

void expect_a2(const std::string& name, const MeshDensity& mesh, double tolerance) {
  const ReferenceA2 r = reference_a2(name);
  const Results results = run_silently(verification_case(name, mesh, 3));
  ASSERT_TRUE(results.verification.passed) << results.verification.reason;
  ASSERT_EQ(results.modes.size(), 3u);
  EXPECT_EQ(results.modes[0].shape, "axial");
  EXPECT_EQ(results.modes[1].shape, "transverse");
  EXPECT_LT(results.modes[2].frequency / results.modes[1].frequency - 1, 1e-6);
  compare(name, "axial stiffness", results.statics->k_axial, r.stiffness, tolerance);
  compare(name, "axial mode", results.modes[0].frequency, r.axial, tolerance);
  compare(name, "transverse pair", results.modes[1].frequency, r.transverse, tolerance);
}

TEST_P(PipeA2, default_mesh_is_within_one_percent) {
  expect_a2(GetParam(), {}, 0.01);
}

class PipeA2Slow : public PipeA2 {};
INSTANTIATE_TEST_SUITE_P(Bellows, PipeA2Slow, testing::Values("a2_one_wall", "a2_slipping_plies"),
                         [](const auto& p) { return std::string(p.param); });

TEST_P(PipeA2Slow, fine_mesh_is_within_half_a_percent) {
  expect_a2(GetParam(), {.around = 72, .arc = 8, .wall = 10}, 0.005);
}

struct Numbers { // axial stiffness, first axial mode, first transverse pair
  std::array<double, 3> value{};
};
constexpr std::array names{"axial stiffness", "axial mode", "transverse pair"};

Numbers numbers_of(const std::string& name, const MeshDensity& density) {
  const auto [mesh, shell] = bare_bellows(verification_case(name, density));
  return {{axial_stiffness(mesh, shell), axial_frequencies(mesh, shell, 1)[0],
           pair_frequencies(mesh, shell, 1, 1)[0]}};
}

TEST_P(PipeA2Slow, circumference_and_meridian_converge_each_at_order_two_without_cancelling) {
  const std::string name = GetParam();
  const ReferenceA2 r = reference_a2(name);
  const std::array reference{r.stiffness, r.axial, r.transverse};
  // Each refinement alone, the other mesh size kept: three meshes, each twice as fine as the last.
  // The facets lower mass and stiffness alike: most of the error round the axis cancels in the
  // axial frequency, where order two shows only from 48 elements on. Hence the stiffness beside it.
  const std::array around{numbers_of(name, {48, 4, 5}), numbers_of(name, {96, 4, 5}),
                          numbers_of(name, {192, 4, 5})};
  const std::array meridian{numbers_of(name, {24, 4, 5}), numbers_of(name, {24, 8, 10}),
                            numbers_of(name, {24, 16, 20})};
  const Numbers fine = numbers_of(name, {72, 8, 10});
  std::printf("%-18s %-16s %12s %12s %12s %8s\n", name.c_str(), "", "h", "h/2", "h/4", "order");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto order = [&](const char* what, const std::array<Numbers, 3>& f) {
      const double p =
          std::log2(std::abs((f[0].value[i] - f[1].value[i]) / (f[1].value[i] - f[2].value[i])));
      std::printf("%-18s %-16s %12.6g %12.6g %12.6g %8.3f\n", names[i], what, f[0].value[i],
                  f[1].value[i], f[2].value[i], p);
      EXPECT_GT(p, 1.7) << names[i] << ", " << what;
      EXPECT_LT(p, 2.3) << names[i] << ", " << what;
    };
    order("circumference", around);
    order("meridian", meridian);
    // Error of the fine mesh (72 around, 8 per quarter arc, 10 per wall) from each, to order two.
    const double round =
        (around[0].value[i] - around[1].value[i]) * (4. / 3) * (48. * 48) / (72 * 72);
    const double along = (meridian[1].value[i] - meridian[2].value[i]) * (4. / 3);
    const double limit = fine.value[i] - round - along;
    std::printf("%-18s fine %.6g = limit %.6g %+.3f %% circumference %+.3f %% meridian; reference "
                "%.6g, limit %+.3f %%\n",
                names[i], fine.value[i], limit, 100 * round / limit, 100 * along / limit,
                reference[i], 100 * (limit / reference[i] - 1));
    EXPECT_LT((std::abs(round) + std::abs(along)) / limit, 0.005) << names[i];
    EXPECT_LT(std::abs(limit / reference[i] - 1), 0.005) << names[i];
  }
}

TEST(PipeA2Numbers, one_order_alone_has_the_stiffness_of_the_run) {
  const MeshDensity coarse{24, 4, 5};
  const Numbers alone = numbers_of("a2_one_wall", coarse);
  const Results results = run_silently(without_modes(verification_case("a2_one_wall", coarse)));
  EXPECT_NEAR(alone.value[0] / results.statics->k_axial, 1, 1e-8);
}

} // namespace
} // namespace plica::test
