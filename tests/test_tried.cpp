// What is said of hypotheses that were tried: why they are rejected, and which readings do not
// follow them.
#include "changed_beam.hpp"
#include "diagnose/account/tried.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace plica {
namespace {

class Rejected : public testing::Test {
protected:
  Rejected() {
    limit_.chi2 = 60;
    limit_.chi2_of_means = 47.4;
    limit_.worst_block = 3.3;
    fit_.worst = {0.3, "damping in y"};
    fit_.fit.chi2 = 50;
    fit_.chi2_of_means = 40;
    fit_.gap_after = 1.6;
  }
  std::string why() const { return why_rejected(fit_, limit_); }

  Standards limit_;
  JudgedFit fit_;
};

// A block that lies well within its limit is not what failed.
TEST_F(Rejected, names_the_gate_that_is_not_passed) {
  EXPECT_EQ(why(), "leaves a gap of 1.6") << "with what it is allowed to be off it passes all";
  fit_.chi2_of_means = 48.8;
  EXPECT_EQ(why(), "the means over the levels (chi-square 48.8, limit 47.4)");
  fit_.fit.chi2 = 60.1;
  EXPECT_EQ(why(), "all readings together (chi-square 60.1, limit 60.0)");
  fit_.worst.first = 3.4;
  EXPECT_EQ(why(), "does not explain damping in y (z 3.4, limit 3.3)");
}

TEST_F(Rejected, is_what_is_adequate_only_by_its_prior_and_by_what_was_held_out) {
  fit_.adequate = true;
  EXPECT_EQ(why(), "");
  fit_.fails_held_out = true;
  EXPECT_EQ(why(), "does not predict the held-out readings");
  fit_.absurd = true;
  EXPECT_EQ(why(), "only with a value far out of its prior");
}

// What the account is of.
const TriedHypothesis& best_of(const Diagnosis& d) {
  return d.tried.at(d.best.value());
}

// A mass of 0.12 kg moves all modes by some percents. Where one of them falls by a fifth besides,
// which no effect does alone, that reading is let off and named.
TEST(DoesNotFollow, is_said_of_the_mode_that_an_effect_does_not_explain) {
  using namespace changed_beam;
  const Case nominal = coarsely_meshed(held_beam());
  Measured m = before_and_after(nominal, with_a_clamp(nominal));
  const Diagnosis all_follow = diagnosis_of(nominal, m);
  EXPECT_TRUE(best_of(all_follow).aside.empty());
  constexpr std::size_t after = 5, second_in_z = 1;
  m.modes[after + second_in_z].frequency *= 0.8;
  const Diagnosis d = diagnosis_of(nominal, m);
  const std::string reading = d.readings[second_in_z].name;
  const auto masses = std::find_if(d.tried.begin(), d.tried.end(), [](const TriedHypothesis& t) {
    return t.effects.size() == 1 && t.effects.front().name == "added_mass";
  });
  ASSERT_NE(masses, d.tried.end());
  EXPECT_EQ(masses->aside, std::vector<std::string>{reading});
}

} // namespace
} // namespace plica
