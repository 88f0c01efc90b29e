// A whole run, from the parts of a case to its results, against closed forms.
#include "tests/tube_case.hpp"

#include "run/routes/route.hpp"
#include "words/input_error.hpp"

#include <numbers>
#include <set>

namespace plica::test {
namespace {

using std::numbers::pi;

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

// Two tubes end to end joined by a cap: one tube of twice the length; with a soft joint in between,
// springs in series.
TEST(Joint, of_two_parts_is_rigid_or_a_spring) {
  Case data = tube(1);
  BeamPart second = std::get<BeamPart>(data.parts[0].body);
  second.points = {{0, L, 0}, {0, 2 * L, 0}};
  data.parts.push_back({"more", second});
  data.caps = {{.name = "left", .of = {"tube.start"}}, {.name = "right", .of = {"more.end"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.caps.push_back({.name = "clamp", .of = {"tube.end", "more.start"}});
  data.analyses.statics = false;
  const auto axial = [](const Case& c) {
    const BuiltCase built = build(c);
    std::map<std::string, double> timing;
    const auto route = full_route(
        built, "", [](const std::string&) {}, timing);
    return end_stiffness(
               (*route->end_stiffness({built.cap_nodes.at("left"), built.cap_nodes.at("right")}))
                   .bottomRightCorner<6, 6>())
        .axial;
  };
  EXPECT_NEAR(axial(data) / (EA / (2 * L)), 1, 1e-9);
  data.caps.back().stiffness = Sextuple{1e8, 1e6, 1e8, 1e6, 1e6, 1e6};
  EXPECT_NEAR(axial(data) / (1 / (2 * L / EA + 1e-6)), 1, 1e-9);
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

// Asked for few modes all are rigid, and are called so.
TEST(FreeMount, has_rigid_modes_alone_when_few_are_asked_for) {
  Case data = tube(2);
  for (Mount& mount : data.mount) mount.kind = MountKind::free;
  data.analyses.modes = Modes{.count = 3};
  const Results results = run_silently(data);
  ASSERT_EQ(results.modes.size(), 6U);
  for (const ModeResult& mode : results.modes) EXPECT_EQ(mode.shape, "rigid");
}

// Two tubes beside each other, one stiffer: their modes have the same names but for the part.
TEST(Labels, of_modes_called_the_same_name_the_part) {
  Case data = tube(2);
  BeamPart other = std::get<BeamPart>(data.parts[0].body);
  other.section.EI = 2 * EI;
  data.parts.push_back({"stiff", other});
  data.caps.clear();
  data.mount.clear();
  for (const char* set : {"tube.start", "tube.end", "stiff.start", "stiff.end"})
    data.supports.push_back({set, {0, 1, 2, 3, 4, 5}});
  data.analyses.modes = Modes{.count = 4};
  const Results results = run_silently(data);
  ASSERT_EQ(results.modes.size(), 4U);
  for (int i : {0, 1}) EXPECT_EQ(results.modes[i].place, "tube") << i;
  for (int i : {2, 3}) EXPECT_EQ(results.modes[i].place, "stiff") << i;
  ASSERT_EQ(results.warnings.size(), 1U);
  EXPECT_NE(results.warnings[0].find("2 pieces"), std::string::npos);
}

// A heavy end makes both lowest bending modes of a cantilever one half wave.
TEST(Labels, of_modes_called_the_same_in_one_part_are_numbered) {
  Case data = tube(2);
  data.mount = {{.cap = "left"}};
  data.caps[1].mass = 50;
  data.caps[1].inertia = {5, 5, 5, 0, 0, 0};
  data.analyses.modes = Modes{.count = 8};
  std::set<std::string> names;
  for (const ModeResult& m : run_silently(data).modes)
    EXPECT_TRUE(names.insert(m.shape + m.direction + std::to_string(m.order) + m.place).second)
        << m.shape << ' ' << m.direction << ' ' << m.order << ' ' << m.place;
  EXPECT_TRUE(names.contains("transversex1no. 2"));
}

// A massless beam between two held ends with a body in the middle: six modes, and no seventh.
TEST(Modes, are_no_more_than_what_has_mass) {
  Case data = tube(0);
  BeamPart& beam = std::get<BeamPart>(data.parts[0].body);
  beam.section.rotary_inertia_per_length = beam.section.polar_inertia_per_length = 0;
  beam.points = {{0, 0, 0}, {0, L / 2, 0}, {0, L, 0}};
  data.parts.push_back(
      {"ball", PointMass{.at = "tube.point[2]", .mass = 3, .inertia = {1, 1, 1, 0, 0, 0}}});
  data.analyses.modes = Modes{.count = 6};
  const Results results = run_silently(data);
  ASSERT_TRUE(results.verification.passed) << results.verification.reason;
  ASSERT_EQ(results.modes.size(), 6U);
  EXPECT_NEAR(results.modes[5].frequency, std::sqrt(4 * EA / L / 3) / (2 * pi),
              1e-9 * results.modes[5].frequency);
  data.analyses.modes = Modes{.count = 7};
  const Results all = run_silently(data);
  EXPECT_EQ(all.modes.size(), 6U);
  ASSERT_EQ(all.warnings.size(), 1U);
  EXPECT_NE(all.warnings[0].find("there are 6 modes, fewer than asked for"), std::string::npos);
}

// A node that a support holds and a cap ties is named with the cap.
TEST(Clash, of_a_cap_and_a_support_is_said_at_the_cap) {
  Case data = tube(1);
  data.supports.push_back({"tube.start", {0, 1, 2}});
  try {
    run_silently(data);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().at(0).key, "caps.left.of") << error.what();
  }
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
// Noise between two frequencies that are not on the grid: the RMS of the input is exact.
// All strain energy sits in the two mounts, half in each: eta = mean, zeta = eta / 2.
TEST(Sensor, mass_rides_on_its_node) {
  Case data = tube(1);
  const double bare = run_silently(data).model.mass;
  data.sensors = {{.name = "mid", .at = {0, L / 2, 0}, .mass = 0.05}};
  EXPECT_NEAR(run_silently(data).model.mass - bare, 0.05, 1e-12);
}

TEST(Labels, do_not_take_a_liner_that_turns_on_its_own_for_the_wall) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 6);
  data.parts.push_back({"liner", Interlock{.along = "bellows",
                                           .attachment = Attachment::caps,
                                           .EA = 1e6,
                                           .EI = 500,
                                           .GJ = 0.01,
                                           .mass = 0.05,
                                           .radius = 0.02}});
  const Results results = run_silently(data);
  ASSERT_TRUE(results.verification.passed) << results.verification.reason;
  EXPECT_EQ(results.modes[0].shape, "mode") << results.modes[0].frequency;
  EXPECT_EQ(headline(results).count("f_torsion"), 0u);
}

TEST(Symmetry, gives_the_numbers_of_the_full_mesh) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 12);
  data.caps[1].mass = 0.2;
  data.mount[1].kind = MountKind::free;
  const BuiltCase built = build(data);
  const Eigen::Vector3d at = built.model.mesh.nodes[built.model.mesh.rings[30].nodes[2]];
  data.sensors = {{.name = "crown", .at = {at.x(), at.y(), at.z()}}};
  data.analyses.damping.modal = 0.02;
  data.analyses.response = Response{.bases = {0, 1, 3}, .band = {5, 900}, .points = 60};
  Force ring;
  ring.name = "ring";
  ring.at = "bellows.crown[3]";
  ring.direction = 2;
  data.analyses.response->forces = {ring};
  data.analyses.stress = Stress{.frequencies = {100}};
  data.analyses.symmetry = Symmetry::required;
  const Results fast = run_silently(data);
  data.analyses.symmetry = Symmetry::off;
  const Results full = run_silently(data);
  EXPECT_EQ(fast.route, "rotational symmetry, 24 sectors");
  EXPECT_LT((fast.statics->end_stiffness - full.statics->end_stiffness).norm(),
            1e-8 * full.statics->end_stiffness.norm());
  EXPECT_NEAR(fast.model.mass, full.model.mass, 1e-10);
  EXPECT_EQ(fast.model.dofs, full.model.dofs);
  ASSERT_EQ(fast.modes.size(), full.modes.size());
  for (std::size_t i = 0; i < full.modes.size(); ++i) {
    EXPECT_NEAR(fast.modes[i].frequency / full.modes[i].frequency, 1, 1e-8) << i;
    EXPECT_EQ(fast.modes[i].shape + fast.modes[i].direction,
              full.modes[i].shape + full.modes[i].direction);
    for (int d = 0; d < 6; ++d)
      EXPECT_NEAR(fast.modes[i].effective_mass[d], full.modes[i].effective_mass[d],
                  1e-5 * full.free_mass[d]);
    const double off = std::min((fast.shapes[i] - full.shapes[i]).norm(),
                                (fast.shapes[i] + full.shapes[i]).norm()); // largest twice: +-
    EXPECT_LT(off, 1e-4 * full.shapes[i].norm()) << i;
  }
  ASSERT_EQ(fast.responses[0].hertz.size(), full.responses[0].hertz.size());
  for (std::size_t k = 0; k < full.responses.size(); ++k)
    EXPECT_LT((fast.responses[k].acceleration - full.responses[k].acceleration).norm(),
              1e-6 * full.responses[k].acceleration.norm())
        << full.responses[k].excitation;
  ASSERT_EQ(fast.stresses.size(), full.stresses.size());
  for (std::size_t k = 0; k < full.stresses.size(); ++k)
    EXPECT_NEAR(fast.stresses[k].largest / full.stresses[k].largest, 1, 1e-4)
        << full.stresses[k].name;
}

TEST(Symmetry, required_of_a_part_without_it_is_an_error) {
  Case data = tube(1);
  data.analyses.symmetry = Symmetry::required;
  try {
    run_silently(data);
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("does not repeat around its axis"), std::string::npos)
        << e.what();
  }
}

TEST(Run, refuses_a_dent_that_misses_the_wall) {
  Case data = verification_case("bellows_a", {24, 2, 3}, 1);
  bellows_of(data).dents = {{.at = {0.026, 0.5, 0}, .depth = 1e-3, .radius = 5e-3}};
  try {
    run_silently(data);
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("dents[0]: has fewer than three nodes of the wall"),
              std::string::npos)
        << e.what();
  }
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
