// Tolerances from their text to the interval they leave, and the error of the mesh.
#include "tests/bellows_case.hpp"

#include "model/description/case_path.hpp"
#include "run/study/error_bars.hpp"
#include "run/study/refine.hpp"
#include "words/tolerance.hpp"

namespace plica::test {
namespace {

TEST(ToleranceText, has_the_unit_of_the_value_unless_it_has_its_own) {
  const auto limits = [](const char* text, Dimension unit) {
    const TolerancedQuantity q = parse_toleranced(text, unit);
    EXPECT_TRUE(q.value.wrong.empty()) << text << ": " << q.value.wrong;
    EXPECT_TRUE(q.limits.has_value()) << text;
    return q.limits.value_or(TolerancedQuantity::Limits{});
  };
  for (const char* text : {"8 mm +- 1 mm", "8 mm +- 1", "8mm+-1mm", "8 mm ± 0.1 cm"}) {
    EXPECT_NEAR(limits(text, Dimension::length).low, 7e-3, 1e-15) << text;
    EXPECT_NEAR(limits(text, Dimension::length).high, 9e-3, 1e-15) << text;
  }
  EXPECT_NEAR(limits("193 GPa +- 5 %", Dimension::pressure).low, 0.95 * 193e9, 1);
  EXPECT_NEAR(limits("1 % +- 0.5 %", Dimension::ratio).high, 0.015, 1e-15);
  EXPECT_EQ(limits("3 kN [0.3, 30]", Dimension::force).low, 300);
  EXPECT_EQ(limits("3 kN [300 N, 30 kN]", Dimension::force).high, 30e3);
  EXPECT_TRUE(limits("3 kN [0.3, 30]", Dimension::force).interval);
  EXPECT_FALSE(parse_toleranced("3 kN", Dimension::force).limits.has_value());
}

TEST(ToleranceText, says_what_is_wrong) {
  for (const char* text :
       {"8 mm +- ", "8 mm +- 1 kg", "8 +- 1 mm", "8 mm +- -1 mm", "8 mm [7]", "8 mm [9, 10]",
        "8 mm [9, 7]", "8 mm [7, 9", "8 mm +- 1 mm mm", "+- 1"}) {
    const TolerancedQuantity q = parse_toleranced(text, Dimension::length);
    EXPECT_FALSE(q.value.wrong.empty()) << text;
  }
}

TEST(Quantile, splits_an_interval_at_its_value_on_a_log_scale) {
  const Tolerance even{.path = "", .value = 8, .low = 7, .high = 9};
  EXPECT_DOUBLE_EQ(quantile(even, 0.05), 7.1);
  EXPECT_DOUBLE_EQ(quantile(even, 0.5), 8);
  const Tolerance wide{.path = "", .value = 3, .low = 0.3, .high = 300, .interval = true};
  EXPECT_DOUBLE_EQ(quantile(wide, 0.5), 3);
  EXPECT_NEAR(quantile(wide, 0.25), 3 / std::sqrt(10.), 1e-12);
  EXPECT_NEAR(quantile(wide, 0.75), 30, 1e-12);
  const Tolerance from_zero{.path = "", .value = 1, .low = 0, .high = 4, .interval = true};
  EXPECT_DOUBLE_EQ(quantile(from_zero, 0.25), 0.5);
}

TEST(CasePath, reaches_numbers_of_parts_lists_and_maps) {
  Case data = verification_case("a2_slipping_plies");
  const auto at = [&](const std::string& path) {
    const double* number = number_at(data, path);
    return number ? *number : -1;
  };
  EXPECT_EQ(at("materials.steel.E"), 193e9);
  EXPECT_EQ(at("parts.bellows.profile[1].height"), 8e-3);
  EXPECT_EQ(at("parts.bellows.wall.plies[1]"), 0.25e-3);
  for (const char* wrong : {"parts.bellows.profile[9].height", "parts.bellow.root_radius",
                            "parts.bellows.profile[1].heigh", "parts.bellows.material", ""})
    EXPECT_EQ(number_at(data, wrong), nullptr) << wrong;
  *number_at(data, "parts.bellows.wall.plies[1]") = 1;
  EXPECT_EQ(bellows_of(data).wall.plies[1], 1);
}

TEST(Refinement, leaves_the_mesh_alone_at_one_and_keeps_cuffs_in_step) {
  const Case data = verification_case("a2_slipping_plies");
  const auto quads = [](const Case& c) { return build(c).model.mesh.quads.size(); };
  EXPECT_EQ(quads(refined(data, {})), quads(data));
  EXPECT_EQ(quads(refined(data, {.along = 2})), 2 * quads(data));
  EXPECT_EQ(quads(refined(data, {.around = 2})), 2 * quads(data));
}

// About the density that bellows get by default, against what one three times finer in both shows,
// which still misses a ninth: within a quarter of the two parts.
TEST(MeshError, of_a_bellows_is_estimated_with_its_sign) {
  Case data = verification_case("bellows_a", {32, 4, 5}, 4);
  const Results nominal = run_silently(for_headline(data));
  const ErrorBars errors = error_bars(data, nominal, [](const std::string&) {});
  const auto fine = headline(run_silently(for_headline(refined(data, {.along = 3, .around = 3}))));
  ASSERT_GT(errors.bars.size(), 1U); // beside the mass
  for (const ErrorBar& bar : errors.bars) {
    if (bar.key == "mass") continue;
    const double missing = 9. / 8 * (fine.at(bar.key) - bar.value);
    const double estimate = bar.mesh.along + bar.mesh.around;
    EXPECT_NEAR(estimate, missing, 0.25 * (std::abs(bar.mesh.along) + std::abs(bar.mesh.around)))
        << bar.key;
    EXPECT_FALSE(bar.interval.has_value());
  }
}

// A sensor between the nodes of the coarse mesh, and a shape that is not among the modes of a run.
TEST(ErrorBars, need_no_sensor_and_make_up_no_number) {
  Case data = verification_case("bellows_a", {40, 2, 3}, 4);
  const BuiltCase built = build(data);
  const Eigen::Vector3d node = built.model.mesh.nodes[built.model.mesh.rings[5].nodes[1]];
  data.sensors = {{.name = "mid", .at = {node.x(), node.y(), node.z()}}};
  data.tolerances = {{.path = "materials.steel.E", .value = 193e9, .low = 183e9, .high = 203e9}};
  Results nominal = run_silently(for_headline(data));
  ModeResult beyond = nominal.modes.back(); // the four modes of the other runs
  beyond.shape = "torsion";
  nominal.modes.push_back(beyond);
  nominal.shapes.push_back(Eigen::MatrixXd::Random(nominal.shapes[0].rows(), 6));
  const ErrorBars errors = error_bars(data, nominal, [](const std::string&) {});
  int torsion = 0;
  for (const ErrorBar& bar : errors.bars) {
    torsion += bar.key == "f_torsion";
    EXPECT_EQ(std::isnan(bar.mesh.along), bar.key == "f_torsion") << bar.key;
    EXPECT_EQ(bar.interval.has_value(), bar.key != "f_torsion") << bar.key;
  }
  EXPECT_EQ(torsion, 1);
}

// Everything scales with E: stiffness in proportion, frequencies with the root, the mass not at
// all.
TEST(ToleranceInterval, of_the_modulus_is_that_of_the_scaling) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 4);
  const double E = data.materials.at("steel").E;
  data.tolerances = {
      {.path = "materials.steel.E", .value = E, .low = 0.9 * E, .high = 1.1 * E},
      {.path = "materials.steel.rho", .value = 8000, .low = 8000 * 0.98, .high = 8000 * 1.02}};
  data.materials.at("steel").rho = 8000;
  const ErrorBars errors =
      error_bars(data, run_silently(for_headline(data)), [](const std::string&) {});
  for (const ErrorBar& bar : errors.bars) {
    ASSERT_TRUE(bar.interval.has_value());
    const double low = (*bar.interval)[0] / bar.value, high = (*bar.interval)[1] / bar.value;
    if (bar.key == "k_axial") { // 5 % and 95 % points of an even spread of 10 %
      EXPECT_NEAR(low, 0.91, 2e-3);
      EXPECT_NEAR(high, 1.09, 2e-3);
      EXPECT_NEAR(bar.shares[0], 1, 1e-6);
    } else if (bar.key == "mass") {
      EXPECT_NEAR(low, 0.982, 5e-4);
      EXPECT_NEAR(bar.shares[1], 1, 1e-6);
    } else { // variances as the squares of the spreads
      EXPECT_NEAR(bar.shares[0], 0.1 * 0.1 / (0.1 * 0.1 + 0.02 * 0.02), 0.01) << bar.key;
    }
  }
  EXPECT_LT(errors.interaction, 1e-4) << "the effects multiply";
}

} // namespace
} // namespace plica::test
