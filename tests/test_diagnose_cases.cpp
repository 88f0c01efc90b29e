// Shipped cases with tests whose cause is known or withheld, diagnosed as the program does.
#include "diagnose/diagnose.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"

#include <filesystem>
#include <gtest/gtest.h>

namespace plica {
namespace {

Diagnosis diagnosis_of(const std::string& name, const std::string& model = "") {
  const auto folder = std::filesystem::path(PLICA_SOURCE_DIR) / "cases" / name;
  const CaseFile file = read_case((folder / (name + ".yaml")).string(), model);
  MeasuredFile measured = read_measured_file((folder / "measured.yaml").string());
  resolve_states(measured, file);
  TestData test{.data = std::move(measured.data), .responses = {}};
  for (const MeasuredFrf& own : test.data.frf) {
    Measured one = test.data;
    one.frf = {own};
    test.responses.push_back(load_frfs(one, folder));
  }
  DiagnosisSettings settings;
  settings.plan_next = false;
  return diagnose(file.data, test, settings);
}

// The sealed road (tests/sealed) made these two; m3 was left away, the lap slips.
TEST(DiagnoseCases, finds_the_mass_that_the_cantilever_lacks) {
  const Diagnosis d = diagnosis_of("cantilever_masses");
  ASSERT_EQ(d.verdict, Verdict::identified) << d.headline;
  EXPECT_EQ(d.effects.front().name, "component_mass");
  EXPECT_EQ(d.effects.front().place, "m3");
  EXPECT_LT(d.effects.front().parameters.front().value, 0.1);
  EXPECT_GT(d.held_out->shrink(), 0.6);
}

TEST(DiagnoseCases, finds_the_slip_of_the_bolted_lap) {
  const Diagnosis d = diagnosis_of("bolted_lap");
  ASSERT_EQ(d.verdict, Verdict::identified) << d.headline;
  EXPECT_EQ(d.effects.front().name, "joint_friction");
  EXPECT_EQ(d.effects.front().place, "caps.lap");
  EXPECT_GT(d.held_out->shrink(), 0.6);
  EXPECT_GT(d.basis_error, 0);
  EXPECT_LT(d.basis_error, 2e-3); // what the uncertainty allows the model
  EXPECT_TRUE(std::any_of(d.warnings.begin(), d.warnings.end(), [](const std::string& w) {
    return w == "joint_friction at caps.lap: its law is fitted from 1 to 10 m/s2 (base z); at "
                "30 m/s2, which is held out, the law alone speaks";
  })) << d.warnings.size();
}

// A real frame whose cause nobody stated: a lower modulus is tempting and is exposed, and nothing
// is sure. A fixture of four parameters meets three frequencies, not the shapes; of the sets that
// meet both none is far ahead of the others.
TEST(DiagnoseCases, does_not_take_a_soft_frame_for_a_soft_material) {
  const Diagnosis d = diagnosis_of("three_storey_frame");
  EXPECT_TRUE(d.verdict == Verdict::unknown || d.verdict == Verdict::ambiguous) << d.headline;
  EXPECT_NE(d.headline.find("not far enough ahead"), std::string::npos) << d.headline;
  ASSERT_FALSE(d.compensators.empty());
  EXPECT_EQ(d.compensators.front().name, "Young's modulus");
  EXPECT_GT(d.compensators.front().prior_sigmas, 3);
}

// Ten levels of the thesis's hose against a linear model.
TEST(DiagnoseCasesSlow, finds_amplitude_dependence_at_a_joint_of_hose_b) {
  const Diagnosis d = diagnosis_of("hose_b", "connector");
  const auto best = std::find_if(d.tried.begin(), d.tried.end(),
                                 [](const TriedHypothesis& t) { return t.effects.size() == 1; });
  ASSERT_NE(best, d.tried.end());
  EXPECT_EQ(best->effects.front().name, "joint_friction") << d.headline;
}

} // namespace
} // namespace plica
