// Which measurement changes the ledger most, where shares and readings are linear in one number.
#include "changed_beam.hpp"
#include "diagnose/account/next_measurement.hpp"

#include <gtest/gtest.h>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double sigma_of_mass = 0.015;  // of ln mass
constexpr double sigma_of_scale = 0.005; // of such a reading
constexpr const char* scale_words = "weigh the specimen";
constexpr const char* sweep_words = "a sweep along z (1 m/s2)";

// A cantilever with masses of 0.15 kg in all, of which three modes in z and two in x are known.
class NextMeasurement : public testing::Test {
protected:
  NextMeasurement() {
    heavier_.changes = {{[](Model& model) {
      for (auto& mass : model.masses) mass.body.mass *= 2;
    }}};
    // ln mass is linear in its parameter.
    heavier_.coefficients = [total = nominal_.mass](const VectorXd& v) {
      constexpr double masses = 0.15;
      return VectorXd(VectorXd::Constant(1, total / masses * std::expm1(v[0])));
    };
    damped_.setup = [](TestSetup& setup, const VectorXd& v) { setup.damping = std::exp(v[0]); };
  }

  static Case beam() {
    Case c = changed_beam::beam_of(3, 0.6, 0.03, 0.005, true);
    changed_beam::add_masses(c);
    Sensor tip;
    tip.name = "tip";
    tip.at = {0, 0.6, 0};
    c.sensors.push_back(tip);
    return c;
  }
  static Measured modes() {
    Measured m;
    changed_beam::add_modes(m, "");
    return m;
  }
  static Hypothesis of(const char* effect, double width) {
    return {.effect = effect,
            .place = "here",
            .way = "",
            .parameters = {{"ln ratio", "", {PriorKind::normal, 0, width}}}};
  }

  // Two draws a standard deviation of the mass apart from its mean, over which its share and what
  // is unexplained move by these.
  RivalSet mass(double probability, double share, double unexplained) const {
    RivalSet r{.together = {&heavier_},
               .values = VectorXd::Zero(1),
               .probability = probability,
               .draws = {MatrixXd(1, 2), MatrixXd(2, 2)}};
    r.draws.z << -1, 1;
    r.draws.shares << 0.6 - share, 0.6 + share, 0.4 + unexplained, 0.4 - unexplained;
    return r;
  }
  // Twice the damping, as likely, and no more than half of the gap.
  RivalSet damping() const {
    return {.together = {&damped_},
            .values = VectorXd::Constant(1, std::log(2.)),
            .probability = 0.5,
            .draws = {MatrixXd::Constant(1, 2, std::log(2.)), MatrixXd::Constant(2, 2, 0.5)}};
  }

  std::vector<ProposedMeasurement> next(const std::vector<RivalSet>& rivals) const {
    const TestReadings test = readings_of({.data = measured_, .responses = {}});
    return next_measurements(nominal_, offered_beside(case_, nominal_, measured_, test, models_),
                             rivals, models_);
  }
  static const ProposedMeasurement& find(const std::vector<ProposedMeasurement>& all,
                                         const std::string& what) {
    for (const ProposedMeasurement& p : all)
      if (p.what == what) return p;
    throw std::out_of_range(what);
  }

  Case case_ = beam();
  Measured measured_ = modes();
  Nominal nominal_ = nominal_of(case_, measured_);
  std::shared_ptr<StateModels> models_ = std::make_shared<StateModels>(nominal_);
  Hypothesis heavier_ = of("component_mass", sigma_of_mass), damped_ = of("damping", 1);
};

// change^2 = C_sy (C_yy + R)^-1 C_ys, of each share.
TEST_F(NextMeasurement, expects_what_a_gaussian_of_shares_and_readings_gives) {
  constexpr double share = 0.2, unexplained = 0.1;
  const auto proposals = next({mass(1, share, unexplained)});
  const ProposedMeasurement& scale = find(proposals, scale_words);
  const double y = sigma_of_mass * sigma_of_mass, R = sigma_of_scale * sigma_of_scale;
  EXPECT_NEAR(scale.change, std::hypot(share, unexplained) * std::sqrt(y / (y + R)), 1e-4);
  EXPECT_EQ(scale.about, "component_mass at here");
  EXPECT_EQ(find(next({mass(1, unexplained, share)}), scale_words).about, "what is unexplained");
}

// With two sets the mass scatters in one of them only. The scale tells neither set from the other
// and costs a fifth of a sweep, which does.
TEST_F(NextMeasurement, ranks_by_change_per_cost_not_by_what_is_told_apart) {
  constexpr double share = 0.2, unexplained = 0.1, p = 0.5;
  const auto proposals = next({mass(p, share, unexplained), damping()});
  ASSERT_FALSE(proposals.empty());
  const ProposedMeasurement &scale = proposals.front(), &sweep = find(proposals, sweep_words);
  ASSERT_EQ(scale.what, scale_words);
  const double y = p * sigma_of_mass * sigma_of_mass, R = sigma_of_scale * sigma_of_scale;
  EXPECT_NEAR(scale.change, std::hypot(share, unexplained) * p * sigma_of_mass / std::sqrt(y + R),
              1e-4);
  EXPECT_LT(scale.change, sweep.change);
  EXPECT_GT(scale.change / scale.cost, sweep.change / sweep.cost);
  EXPECT_NEAR(scale.separation, 0, 1e-6);
  EXPECT_GT(sweep.separation, 20);
  EXPECT_EQ(sweep.separates, "component_mass from damping");
}

TEST_F(NextMeasurement, proposes_nothing_where_the_shares_are_known) {
  EXPECT_TRUE(next({mass(1, 0, 0)}).empty());
}

} // namespace
} // namespace plica
