// A liner that leans on the wall by springs at the places where it is tied.
#include "model/shape/build.hpp"
#include "run/study/match_modes.hpp"
#include "tests/bellows_case.hpp"
#include "tests/changed_beam.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

namespace plica::test {
namespace {

constexpr double coil_pitch = 6e-3;
constexpr int turns = 10;

// Bellows A with a second half of lower convolutions, which a liner of even stiffness does not
// follow; the liner is tied in the middle alone.
Case halves_with_liner(double EA, const std::optional<LinerContact>& contact) {
  Case data = without_modes(verification_case("bellows_a", {24, 2, 3}));
  std::vector<MeridianSection>& profile = bellows_of(data).profile;
  profile.push_back(profile.front());
  profile[0].count = profile[1].count = turns / 2;
  profile[1].height = 6e-3;
  data.parts.push_back({"liner", Interlock{.along = "bellows",
                                           .attachment = Attachment::stations,
                                           .stations = 1,
                                           .contact = contact,
                                           .EA = EA,
                                           .EI = 1,
                                           .GJ = 0.5,
                                           .mass = 0.1,
                                           .radius = 0.02}});
  return data;
}

double axial_stiffness(double EA, const std::optional<LinerContact>& contact) {
  return run_silently(halves_with_liner(EA, contact)).statics->k_axial;
}

// K(c) = K_0 + c b b' has k(c) = k(0) + (k(inf) - k(0)) c / (c + s), and 1 / s is what a unit force
// between wall and liner moves there with both ends held: of the liner, of length L and touched at
// a, a (L - a) / (L EA).
TEST(LinerContact, gives_way_as_one_spring_between_wall_and_liner_in_closed_form) {
  constexpr double length = turns * coil_pitch, at = length / 2, soft = 3e4, stiff = 4e5;
  const auto compliance = [&](double EA) {
    const double free = axial_stiffness(EA, LinerContact{.lateral = 1e5}),
                 tied = axial_stiffness(EA, std::nullopt);
    EXPECT_GT(tied, 1.01 * free);
    const auto s_of = [&](double c) {
      const double k = axial_stiffness(EA, LinerContact{.axial = c});
      return c * (tied - k) / (k - free);
    };
    const double s = s_of(soft);
    EXPECT_NEAR(s_of(stiff) / s, 1, 1e-5);
    return 1 / s;
  };
  const double of_the_liner = at * (length - at) / length * (1 / 1e3 - 1 / 4e3);
  EXPECT_NEAR((compliance(1e3) - compliance(4e3)) / of_the_liner, 1, 1e-5);
}

// What springs give falls with their stiffness, to a tie.
TEST(LinerContact, of_stiff_springs_comes_to_a_tie) {
  for (const Attachment attachment : {Attachment::stations, Attachment::synchronous}) {
    Case data = halves_with_liner(2e3, std::nullopt);
    data.analyses.modes = Modes{.count = 10};
    Interlock& liner = std::get<Interlock>(data.parts.back().body);
    liner.attachment = attachment;
    const Results tied = run_silently(data);
    const auto off = [&](double times) {
      liner.contact = LinerContact{.axial = 1e10 * times,
                                   .lateral = 1e10 * times,
                                   .bending = 1e6 * times,
                                   .torsion = 1e6 * times};
      const Results leans = run_silently(data);
      EXPECT_TRUE(leans.verification.passed) << leans.verification.reason;
      EXPECT_NEAR(leans.model.mass, tied.model.mass, 1e-12);
      EXPECT_EQ(leans.modes.size(), tied.modes.size());
      double most = 0;
      for (std::size_t i = 0; i < tied.modes.size(); ++i)
        most = std::max(most, std::abs(leans.modes[i].frequency / tied.modes[i].frequency - 1));
      return most;
    };
    const double once = off(1);
    EXPECT_LT(once, 2e-4);
    EXPECT_NEAR(off(10) / once, 0.1, 0.02);
  }
}

// Small motion sticks, a rig slips: springs of 20 and 50 kN/m at each of three places.
TEST(LinerContact, rubs_on_the_wall) {
  const auto leaning = [](double axial, bool rubs) {
    Case data = halves_with_liner(2e3, LinerContact{.axial = axial, .lateral = 1e5});
    data.analyses.modes = Modes{.count = 8};
    Interlock& liner = std::get<Interlock>(data.parts.back().body);
    liner.stations = 3;
    if (rubs) {
      liner.contact->friction.emplace();
      liner.contact->friction->axial.emplace().sliders = {{3e4, 5}};
    }
    return data;
  };
  const Results rubs = run_silently(leaning(2e4, true)), slips = run_silently(leaning(2e4, false)),
                sticks = run_silently(leaning(5e4, false));
  EXPECT_NEAR(rubs.statics->k_axial / slips.statics->k_axial, 1, 1e-6);
  ASSERT_TRUE(rubs.slipping);
  EXPECT_NEAR(rubs.slipping->k_axial_stuck / sticks.statics->k_axial, 1, 1e-6);
  EXPECT_GT(sticks.statics->k_axial, 1.001 * slips.statics->k_axial);
  ASSERT_EQ(rubs.modes.size(), sticks.modes.size());
  for (std::size_t i = 0; i < rubs.modes.size(); ++i)
    EXPECT_NEAR(rubs.modes[i].frequency / sticks.modes[i].frequency, 1, 1e-6) << i;
  const BuiltCase built = build_slipping(leaning(2e4, true), {});
  ASSERT_EQ(built.joints.size(), 3U);
  EXPECT_EQ(joint_name(built.joints.back()), "liner.contact axial, segment 3");
  const auto laws = laws_in(leaning(2e4, true), built.joints);
  ASSERT_TRUE(laws && laws->size() == 3U);
  EXPECT_NEAR(laws->front().stuck_stiffness(), 3e4, 1e-6);
}

// Where the ends of the bellows are roots, its own ends are tied there.
TEST(LinerContact, has_places_of_its_own) {
  Case data = halves_with_liner(2e3, LinerContact{.axial = 1e5, .lateral = 1e5});
  bellows_of(data).profile = {bellows_of(data).profile.front()};
  bellows_of(data).profile.front().count = 1;
  Interlock& liner = std::get<Interlock>(data.parts.back().body);
  for (const auto& [attachment, stations] :
       {std::pair{Attachment::synchronous, 0}, {Attachment::stations, 2}}) {
    liner.attachment = attachment;
    liner.stations = stations;
    EXPECT_NE(
        keyed_error_of([&] { build(data); }).find("parts.liner.contact: leans on the wall at "),
        std::string::npos)
        << stations;
  }
}

// Coils that hang on all four springs hold without stiffness between them.
TEST(LinerContact, holds_coils_that_nothing_joins) {
  Case data = halves_with_liner(
      0, LinerContact{.axial = 1e5, .lateral = 1e5, .bending = 10, .torsion = 10});
  data.analyses.modes = Modes{.count = 6};
  Interlock& liner = std::get<Interlock>(data.parts.back().body);
  liner.attachment = Attachment::synchronous;
  liner.EI = liner.GJ = 0;
  const Results r = run_silently(data);
  EXPECT_TRUE(r.verification.passed) << r.verification.reason;
  EXPECT_GT(r.modes.at(0).frequency, 10);
}

// On a finer mesh a mode is found again by its shape, in which wall and liner move against each
// other at nodes that share a place.
TEST(LinerContact, keeps_its_modes_apart_over_meshes) {
  Case data = halves_with_liner(1e4, LinerContact{.axial = 2e3, .lateral = 2e4, .bending = 1});
  data.analyses.modes = Modes{.count = 12};
  std::get<Interlock>(data.parts.back().body).stations = 6;
  Case finer = data;
  bellows_of(finer).mesh = {.around = 24, .arc = 3, .wall = 4};
  const Results coarse = run_silently(data), fine = run_silently(finer);
  const std::vector<SameMode> same = match_modes(coarse, fine);
  ASSERT_EQ(same.size(), 12U);
  for (std::size_t i = 0; i < same.size(); ++i)
    EXPECT_NEAR(same[i].frequency / coarse.modes[i].frequency, 1, 0.02) << i;
}

// A test of the bellows before and after what holds its liner became so many times as stiff.
Measured before_and_after(const Case& nominal, double times) {
  Measured m;
  m.specimen = "bellows";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  for (const char* state : {"before", "after"}) {
    for (int order = 1; order <= 3; ++order)
      m.modes.push_back(changed_beam::bending(Axis::z, order, state));
    for (int order = 1; order <= 3; ++order) {
      m.modes.push_back(changed_beam::bending(Axis::y, order, state));
      m.modes.back().shape = MeasuredShape::axial;
    }
  }
  Case after = nominal;
  LinerContact& contact = *std::get<Interlock>(after.parts.back().body).contact;
  for (double* k : {&contact.axial, &contact.lateral, &contact.bending, &contact.torsion})
    *k *= times;
  const Eigen::VectorXd first = changed_beam::read_by(nominal, m),
                        second = changed_beam::read_by(after, m);
  constexpr std::array off{0.011, -0.006, 0.008, -0.012, 0.004, 0.007},
      anew{0.001, -0.0015, 0.0005, 0.0015, -0.001, 0.0007};
  for (std::size_t k = 0; k < 6; ++k) {
    m.modes[k].frequency = std::exp(first[Eigen::Index(k)] + off[k]);
    m.modes[6 + k].frequency = std::exp(second[Eigen::Index(6 + k)] + off[k] + anew[k]);
  }
  return m;
}

TEST(LinerContact, that_came_loose_is_named_with_its_springs) {
  Case nominal = halves_with_liner(
      2e3, LinerContact{.axial = 2e5, .lateral = 2e5, .bending = 50, .torsion = 50});
  nominal.analyses.modes = Modes{.count = 12};
  nominal.analyses.damping.modal = 0.01;
  Interlock& liner = std::get<Interlock>(nominal.parts.back().body);
  liner.stations = 5;
  constexpr double left_of_it = 0.1;
  const Diagnosis d = changed_beam::diagnosis_of(nominal, before_and_after(nominal, left_of_it));
  ASSERT_FALSE(d.effects.empty()) << d.headline;
  const NamedEffect& e = d.effects.front();
  EXPECT_EQ(e.name, "joint_stiffness") << d.headline;
  EXPECT_EQ(e.place, "liner.contact") << d.headline;
  ASSERT_TRUE(e.in_case);
  EXPECT_FALSE(e.nodes.empty());
  const CaseEdits edits = e.in_case(nominal);
  ASSERT_FALSE(edits.empty());
  for (const auto& edit : edits)
    EXPECT_TRUE(edit.path.starts_with("parts.liner.contact.")) << edit.path;
}

} // namespace
} // namespace plica::test
