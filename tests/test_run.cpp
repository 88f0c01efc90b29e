// A whole run, from the parts of a case to its results, against closed forms.
#include "tests/bellows_case.hpp"

#include "model/input_error.hpp"

#include <numbers>

namespace plica::test {
namespace {

using std::numbers::pi;

constexpr double L = 0.8, EA = 4e6, EI = 900, GJ = 500, GA = 1e5;

// A straight beam along y between two caps, of general section.
Case tube(double mass_per_length) {
  BeamPart beam;
  beam.points = {{0, 0, 0}, {0, L, 0}};
  beam.elements = 16;
  beam.section.shape = BeamShape::general;
  beam.section.EA = EA;
  beam.section.EI = EI;
  beam.section.GJ = GJ;
  beam.section.GA = GA;
  beam.section.mass_per_length = mass_per_length;
  beam.section.rotary_inertia_per_length = 1e-6;
  beam.section.polar_inertia_per_length = 2e-6;
  Case data;
  data.name = "tube";
  data.parts = {{"tube", beam}};
  data.caps = {{.name = "left", .of = "tube.start"}, {.name = "right", .of = "tube.end"}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  return data;
}

TEST(EndStiffness, of_a_timoshenko_beam_is_the_closed_form) {
  const StaticStiffness k = *run_silently(tube(1)).statics;
  const double shear = 12 * EI / (GA * L * L);
  EXPECT_NEAR(k.k_axial / (EA / L), 1, 1e-9);
  for (double lateral : {k.k_transverse_x, k.k_transverse_z})
    EXPECT_NEAR(lateral / (12 * EI / (L * L * L * (1 + shear))), 1, 1e-9);
  for (double bending : {k.k_bending_x, k.k_bending_z}) EXPECT_NEAR(bending / (EI / L), 1, 1e-9);
  EXPECT_NEAR(k.k_torsion / (GJ / L), 1, 1e-9);
}

TEST(EndStiffness, is_symmetric_and_leaves_rigid_motions_free) {
  for (const Case& data : {tube(1), without_modes(verification_case("bellows_a", {24, 2, 3}))}) {
    const Results results = run_silently(data);
    const auto& K = results.statics->end_stiffness;
    EXPECT_LT((K - K.transpose()).norm(), 1e-9 * K.norm());
    const double length =
        data.name == "tube" ? L : results.meridian.back()[0] - results.meridian.front()[0];
    Eigen::Matrix<double, 12, 6> rigid; // both ends on one body that turns about the first
    rigid.setZero();
    rigid.topRows<6>().setIdentity();
    rigid.bottomRows<6>().setIdentity();
    rigid(6 + 2, 3) = length;  // rx moves the far end along z
    rigid(6 + 0, 5) = -length; // rz along -x
    EXPECT_LT((K * rigid).cwiseAbs().maxCoeff(), 1e-7 * K.cwiseAbs().maxCoeff());
  }
}

TEST(SpringMount, carries_a_stiff_tube_on_six_springs) {
  Case data = tube(1e-6);
  data.parts.front().body = [&] {
    BeamPart stiff = std::get<BeamPart>(tube(1e-6).parts.front().body);
    stiff.section.EA = stiff.section.EI = stiff.section.GJ = 1e6;
    stiff.elements = 2;
    stiff.section.GA.reset();
    return stiff;
  }();
  for (Cap& cap : data.caps) cap.mass = 2;
  for (Mount& mount : data.mount) {
    mount.kind = MountKind::springs;
    mount.stiffness = {1e4, 4e4, 9e4, 1, 1, 1};
  }
  data.analyses.modes = Modes{.count = 5};
  const Results results = run_silently(data);
  ASSERT_TRUE(results.verification.passed) << results.verification.reason;
  // Both ends together, and x and z also end against end, where the springs against turning (1
  // Nm/rad at each end, the masses 0.4 m from the middle) help a little.
  constexpr double turning = 1 / (L / 2 * L / 2);
  const std::array wanted{1e4, 1e4 + turning, 4e4, 9e4, 9e4 + turning};
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(results.modes[i].frequency / (std::sqrt(wanted[i] / 2) / (2 * pi)), 1, 1e-5) << i;
}

TEST(FreeMount, has_six_rigid_modes_and_the_bending_of_a_free_beam) {
  Case data = tube(2);
  std::get<BeamPart>(data.parts.front().body).section.GA.reset();
  for (Mount& mount : data.mount) mount.kind = MountKind::free;
  data.analyses.modes = Modes{.count = 10};
  const Results results = run_silently(data);
  ASSERT_TRUE(results.verification.passed) << results.verification.reason;
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(results.modes[i].shape, "rigid") << i;
    EXPECT_LT(results.modes[i].frequency, 1e-2) << i;
  }
  for (int i : {6, 7})
    EXPECT_NEAR(results.modes[i].frequency /
                    (std::pow(4.73004 / L, 2) * std::sqrt(EI / 2) / (2 * pi)),
                1, 1e-3);
}

// Lowest modes of a clamped tube, R = 0.1, L = 0.2, t = 0.002 m: five waves, then four, then six.
TEST(Labels, count_the_waves_of_shell_modes) {
  Case data = verification_case("cylinder_clamped", {}, 6);
  const Results results = run_silently(data);
  ASSERT_TRUE(results.verification.passed) << results.verification.reason;
  ASSERT_GE(results.modes.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(results.modes[i].shape, "shell") << i;
    EXPECT_EQ(results.modes[i].harmonic, (std::array{5, 4, 6})[i / 2]) << i;
  }
}

TEST(Labels, count_the_half_waves_of_a_bellows) {
  const Results results = run_silently(verification_case("a2_slipping_plies", {24, 2, 3}, 8));
  std::vector<std::string> names;
  for (const ModeResult& m : results.modes)
    names.push_back(m.shape + " " + std::to_string(m.order) + " " + m.direction);
  EXPECT_EQ(names[0], "axial 1 y");
  EXPECT_EQ(names[1], "transverse 1 x");
  EXPECT_EQ(names[2], "transverse 1 z");
  EXPECT_NE(std::find(names.begin(), names.end(), "axial 2 y"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "transverse 2 x"), names.end());
}

Case with_interlock(Attachment attachment, double stiffness) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 1);
  Interlock liner;
  liner.along = data.parts.front().name;
  liner.attachment = attachment;
  liner.stations = 3;
  liner.EA = stiffness;
  liner.EI = stiffness * 2e-4;
  liner.GJ = stiffness * 1e-4;
  liner.mass = 0.3;
  liner.radius = 0.02;
  data.parts.push_back({"liner", liner});
  return data;
}

TEST(Interlock, between_the_caps_adds_its_own_stiffness) {
  const Results bare = run_silently(without_modes(verification_case("bellows_a", {24, 2, 3})));
  const double length = bare.meridian.back()[0] - bare.meridian.front()[0];
  const Results both = run_silently(without_modes(with_interlock(Attachment::caps, 5e3)));
  EXPECT_NEAR((both.statics->k_axial - bare.statics->k_axial) / (5e3 / length), 1, 1e-6);
  EXPECT_NEAR((both.statics->k_torsion - bare.statics->k_torsion) / (0.5 / length), 1, 1e-4);
  EXPECT_NEAR(both.model.mass - bare.model.mass, 0.3, 1e-12);
}

// Ties between wall and liner can only stiffen; the weight is the same however it is tied.
TEST(Interlock, tied_along_the_wall_is_stiffer_and_weighs_the_same) {
  const Results caps = run_silently(without_modes(with_interlock(Attachment::caps, 5e3)));
  for (Attachment tied : {Attachment::stations, Attachment::synchronous}) {
    const Results results = run_silently(with_interlock(tied, 5e3));
    ASSERT_TRUE(results.verification.passed) << results.verification.reason;
    EXPECT_GT(results.statics->k_axial, caps.statics->k_axial * (1 - 1e-9));
    EXPECT_LT(results.statics->k_axial, caps.statics->k_axial * 1.02) << "a uniform bellows";
    EXPECT_NEAR(results.model.mass, caps.model.mass, 1e-12);
  }
}

// A stiff tube with the mass at its ends on springs: one DOF along y, whose sensor answers the base
// like the closed form (1 + 2 i zeta r) / (1 - r^2 + 2 i zeta r) without the damper's path.
TEST(BaseResponse, of_a_tube_on_springs_is_that_of_one_dof) {
  Case data = tube(1e-6);
  for (Cap& cap : data.caps) cap.mass = 2;
  for (Mount& mount : data.mount) {
    mount.kind = MountKind::springs;
    mount.stiffness = {1e4, 4e4, 9e4, 1, 1, 1};
  }
  constexpr double zeta = 0.02;
  data.analyses.modes = Modes{.count = 6};
  data.analyses.modal_damping = zeta;
  data.analyses.response = Response{.bases = {1}, .band = {1, 60}, .points = 100};
  data.sensors = {{.name = "end", .at = {0, L, 0}}};
  const Results results = run_silently(data);
  ASSERT_EQ(results.responses.size(), 1u);
  const ResponseResult& r = results.responses[0];
  ASSERT_EQ(r.channels.size(), 3u);
  const double f = std::sqrt(4e4 / 2) / (2 * pi);
  for (Eigen::Index i = 0; i < r.hertz.size(); ++i) {
    const double x = r.hertz[i] / f;
    const std::complex<double> wanted =
        1. + x * x / std::complex<double>(1 - x * x, 2 * zeta * x); // relative motion on the base
    EXPECT_LT(std::abs(r.transmissibility(i, 1) - wanted), 1e-3 * std::abs(wanted) + 1e-6);
    EXPECT_LT(std::abs(r.transmissibility(i, 0)), 1e-6) << "no motion across";
  }
  ASSERT_FALSE(r.peaks.empty());
  EXPECT_NEAR(r.peaks[0].frequency / f, 1, 2e-3);
  EXPECT_NEAR(r.peaks[0].damping / zeta, 1, 0.02);
}

TEST(Run, refuses_a_sensor_off_the_part_and_names_it) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 1);
  data.sensors = {{.name = "middle", .at = {0.2, 0.03, 0}}};
  try {
    run_silently(data);
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("middle"), std::string::npos) << e.what();
  }
}

} // namespace
} // namespace plica::test
