// Joints that give way in one direction, drawn with whatever large number stands for rigid.
#include "diagnose/effects/places.hpp"
#include "tests/changed_beam.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using namespace changed_beam;

// Two halves of a clamped beam that meet in springs.
Case two_halves(double bending_stiffness) {
  Case c = beam_of(4, 0.6, 0.025, 0.012, true);
  Part second = c.parts[0];
  std::get<BeamPart>(c.parts[0].body).points = {{0, 0, 0}, {0, 0.15, 0}, {0, 0.3, 0}};
  second.name = "beam2";
  std::get<BeamPart>(second.body).points = {{0, 0.3, 0}, {0, 0.45, 0}, {0, 0.6, 0}};
  c.parts.push_back(second);
  Cap joint;
  joint.name = "joint";
  joint.of = {"beam.end", "beam2.start"};
  joint.stiffness = {1e9, 1e9, 1e9, bending_stiffness, 1e6, bending_stiffness};
  c.caps.push_back(joint);
  return c;
}

TEST(JointDirections, what_gives_way_is_found_whatever_stands_for_rigid) {
  constexpr double loose = 3e3; // Nm/rad
  for (const double rigid : {1e4, 1e5, 1e6}) {
    const Case nominal = two_halves(rigid);
    const Diagnosis d = diagnosis_of(nominal, before_and_after(nominal, two_halves(loose)));
    ASSERT_FALSE(d.effects.empty()) << rigid << ": " << d.headline;
    const NamedEffect& e = d.effects.front();
    EXPECT_EQ(e.name, "joint_stiffness") << rigid << ": " << d.headline;
    EXPECT_EQ(e.place, "caps.joint") << rigid << ": " << d.headline;
    EXPECT_EQ(e.way, "bending") << rigid << ": " << d.headline;
    EXPECT_NEAR(e.parameters.front().value * rigid, loose, 0.25 * loose) << rigid;
  }
}

// Springs in a row: 2, 3 and 6 N/m give 1; what couples its motions has no stiffness of its own.
TEST(JointDirections, of_springs_in_a_row_add_their_compliance) {
  Model model;
  JointGroup group{.place = "row", .bushings = {}, .beams = {}};
  for (const double k : {2., 3., 6.}) {
    BushingElement spring;
    spring.bushing.law.diagonal() << 10 * k, k, 5 * k, 0, 4 * k, 0;
    group.bushings.push_back(int(model.bushings.size()));
    model.bushings.push_back(spring);
  }
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::axial), 1, 1e-12);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::lateral), 10, 1e-12);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::torsion), 4, 1e-12);
  EXPECT_EQ(stiffness_in(model, group, JointDirection::bending), 0);
  scale_group(model, group, 3, JointDirection::axial);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::axial), 3, 1e-12);
  EXPECT_NEAR(stiffness_in(model, group, JointDirection::lateral), 10, 1e-12);
  model.bushings[0].bushing.law(0, 1) = model.bushings[0].bushing.law(1, 0) = 1;
  EXPECT_EQ(stiffness_in(model, group, JointDirection::axial), 0);
}

} // namespace
} // namespace plica
