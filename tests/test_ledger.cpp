// What the gap is made of: shares that add up, effects together, what is left.
#include "changed_beam.hpp"
#include "diagnose/account/gap_problem.hpp"
#include "diagnose/account/ledger.hpp"
#include "diagnose/account/named_effects.hpp"
#include "model/description/case_path.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::VectorXd;

// A cantilever with three masses.
Case cantilever() {
  Case c = changed_beam::beam_of(3, 0.6, 0.03, 0.005, true);
  changed_beam::add_masses(c);
  return c;
}

// What the model of a case reads as a test: its mass and eight frequencies, not quite exactly.
Measured test_of(const Case& truth) {
  Measured m;
  m.specimen = "beam";
  for (int order = 1; order <= 4; ++order)
    for (Axis axis : {Axis::x, Axis::z}) m.modes.push_back(changed_beam::bending(axis, order, ""));
  m.weighings = {{.value = 1, .sigma = 0.0005, .repeats = {}}};
  VectorXd y = changed_beam::read_by(truth, m);
  constexpr std::array noise{0.0006, -0.0004, 0.0009, -0.0011, 0.0003, 0.0007, -0.0008, 0.0001};
  for (std::size_t k = 0; k < noise.size(); ++k) y[1 + Eigen::Index(k)] += noise[k];
  changed_beam::take_readings(m, y);
  return m;
}

Diagnosis diagnosis_of(const Case& truth) {
  return changed_beam::diagnosis_of(cantilever(), test_of(truth));
}

double sum_of(const Ledger& ledger) {
  return std::accumulate(ledger.rows.begin(), ledger.rows.end(), 0.,
                         [](double sum, const LedgerRow& row) { return sum + row.share; });
}

const LedgerRow& left(const Ledger& ledger, Remainder what) {
  for (const LedgerRow& row : ledger.rows)
    if (row.left == what) return row;
  throw std::out_of_range(word_of(what));
}

// Of the readings that are left, all together leave what no effect explains.
void expect_sound(const Ledger& ledger) {
  EXPECT_NEAR(sum_of(ledger), 1, 1e-9);
  double of_readings = 0, of_effects = 0;
  for (const auto& [reading, share] : ledger.left_in) of_readings += share;
  for (const LedgerRow& row : ledger.rows)
    if (!row.effects.empty()) of_effects += row.share;
  EXPECT_NEAR(of_readings, 1 - of_effects, 1e-9);
  EXPECT_NEAR(of_effects, ledger.explained, 1e-9);
  for (const LedgerRow& row : ledger.rows) {
    EXPECT_LE(row.interval[0], row.share);
    EXPECT_GE(row.interval[1], row.share);
    for (double end : row.interval) EXPECT_NEAR(100 * end, std::round(100 * end), 1e-9);
    EXPECT_TRUE(row.effects.empty() == row.left.has_value());
  }
}

TEST(Ledger, of_a_healthy_specimen_holds_what_is_left_alone) {
  const Diagnosis d = diagnosis_of(cantilever());
  EXPECT_EQ(d.verdict, Verdict::none) << d.headline;
  ASSERT_EQ(d.ledger.rows.size(), 4u);
  expect_sound(d.ledger);
  EXPECT_LT(d.ledger.gap, 1);
  EXPECT_NEAR(left(d.ledger, Remainder::unexplained).share, 0, 1e-12)
      << "less is left than expected";
}

TEST(Ledger, gives_nearly_all_to_the_one_effect_there_is) {
  Case truth = cantilever();
  *number_at(truth, "parts.m2.mass") = 1e-6;
  const Diagnosis d = diagnosis_of(truth);
  ASSERT_EQ(d.verdict, Verdict::identified) << d.headline;
  expect_sound(d.ledger);
  const LedgerRow& row = d.ledger.rows.front();
  ASSERT_EQ(row.effects.size(), 1u);
  EXPECT_EQ(row.effects.front().name, "component_mass");
  EXPECT_GT(row.share, 0.95);
  EXPECT_NEAR(d.ledger.gap, d.gap.before * d.gap.before, 1e-9 * d.ledger.gap);
}

// What comes nearest to a test that nothing explains is no more of the gap than it is probable.
TEST(Ledger, gives_what_is_not_settled_no_more_than_its_odds) {
  Measured m = test_of(cantilever());
  constexpr std::array off{0.09, -0.07, -0.08, 0.06, 0.07, -0.09, -0.06, 0.08};
  for (std::size_t k = 0; k < off.size(); ++k) m.modes[k].frequency *= 1 + off[k];
  const Diagnosis d = changed_beam::diagnosis_of(cantilever(), m);
  ASSERT_EQ(d.verdict, Verdict::unknown) << d.headline;
  expect_sound(d.ledger);
  const LedgerRow& unexplained = left(d.ledger, Remainder::unexplained);
  EXPECT_GT(unexplained.share, 0.5);
  EXPECT_GT(unexplained.interval[1], 0.95);
  for (const LedgerRow& row : d.ledger.rows) {
    if (row.effects.empty()) continue;
    EXPECT_LE(row.interval[0], 0);
    EXPECT_GE(row.interval[1], 0);
  }
}

// The same effect at two places and another one, each found with its size.
TEST(Ledger, shares_the_gap_among_three_effects_at_once) {
  Case truth = cantilever();
  *number_at(truth, "parts.m1.mass") = 0.07;  // 0.04 drawn
  *number_at(truth, "parts.m3.mass") = 0.09;  // 0.06 drawn
  constexpr double stiff = 1e10, soft = 2000; // the beam: 3 EI / L = 310 and 11,000 Nm/rad
  truth.mount.front() = {.cap = "root",
                         .kind = MountKind::springs,
                         .stiffness = {stiff, stiff, stiff, soft, soft, soft}};
  const Diagnosis d = diagnosis_of(truth);
  expect_sound(d.ledger);
  EXPECT_EQ(d.verdict, Verdict::several) << d.headline;
  const auto row = [&](const std::string& effect, const std::string& place) {
    for (const LedgerRow& r : d.ledger.rows)
      for (const NamedEffect& e : r.effects)
        if (e.name == effect && e.place == place) return r;
    ADD_FAILURE() << effect << " at " << place << " is not in: " << d.headline;
    return LedgerRow{.effects = {NamedEffect{}}, .interval = {}};
  };
  const auto expect_value = [&](const LedgerRow& r, double value) {
    ASSERT_EQ(r.effects.front().parameters.size(), 1u);
    const EstimatedParameter& p = r.effects.front().parameters.front();
    EXPECT_LE(p.interval[0], value) << p.name;
    EXPECT_GE(p.interval[1], value) << p.name;
  };
  expect_value(row("component_mass", "m1"), 0.07 / 0.04);
  expect_value(row("component_mass", "m3"), 0.09 / 0.06);
  expect_value(row("boundary_compliance", "mount.root"), soft);
}

TEST(Ledger, shows_what_takes_the_place_of_an_effect_in_sets_that_explain_as_well) {
  const auto effect = [](const char* name, const char* place) {
    return NamedEffect{.name = name, .place = place, .way = "", .parameters = {}};
  };
  const NamedEffect mass = effect("added_mass", "tip"), heavy = effect("added_mass", "middle"),
                    hot = effect("temperature", "all"), soft = effect("joint_stiffness", "lap");
  const auto groups = alternatives({{mass, hot}, {soft, mass}, {hot, heavy}, {mass, hot}});
  ASSERT_EQ(groups.size(), 2u);
  ASSERT_EQ(groups[0].size(), 2u);
  EXPECT_EQ(groups[0][0].place, "tip");
  EXPECT_EQ(groups[0][1].place, "middle");
  ASSERT_EQ(groups[1].size(), 2u);
  EXPECT_EQ(groups[1][0].name, "temperature");
  EXPECT_EQ(groups[1][1].name, "joint_stiffness");
}

// A beam that loses more stiffness than it has stands nowhere: what such draws would be is left
// out, and the account is that of the others.
TEST(Ledger, is_of_what_is_stable) {
  Case softer = cantilever();
  softer.materials["steel"].E *= 0.9;
  const Measured m = test_of(softer);
  const Case nominal_case = cantilever();
  const TestData test{.data = m, .responses = {}};
  const std::unique_ptr<GapProblem> problem = stated_gap(nominal_case, test, {});
  const FitContext context = problem->context();
  const Hypothesis lost{.effect = "lost stiffness",
                        .place = "beam",
                        .way = "",
                        .parameters = {{"lost", "", {PriorKind::normal, 0, 1}}},
                        .changes = {{.apply =
                                         [](Model& model) {
                                           for (BeamElement& b : model.beams)
                                             for (double* k : {&b.section.EA, &b.section.EI_y,
                                                               &b.section.EI_z, &b.section.GJ})
                                               *k *= 2;
                                         }}},
                        .coefficients = [](const VectorXd& v) { return VectorXd(-v); }};
  HypothesisFit fit = fit_of(context, {&lost});
  ASSERT_TRUE(fit.solved);
  EXPECT_NEAR(fit.values[0], 0.1, 0.02);
  constexpr int draws = 40;
  fit.draws = Eigen::MatrixXd::Constant(1, draws, fit.z[0]);
  const HypothesisFit none = nominal_fit(context);
  const Ledger stable = ledger_of(context, none, {{.fit = &fit}});
  for (int k = 0; k < draws; k += 3) fit.draws(0, k) = 1.5;
  const Ledger some = ledger_of(context, none, {{.fit = &fit}});
  ASSERT_FALSE(some.rows.empty());
  EXPECT_GT(some.rows[0].share, 0.9);
  EXPECT_NEAR(some.rows[0].share, stable.rows[0].share, 1e-9);
  EXPECT_NEAR(sum_of(some), 1, 1e-9);
  const ShareDraws kept = share_draws(context, none, fit, draws);
  EXPECT_GT(kept.z.cols(), 0);
  EXPECT_LT(kept.z.cols(), draws);
  EXPECT_LT(kept.z.maxCoeff(), 1);

  fit.draws.setConstant(1.5);
  const Ledger nothing = ledger_of(context, none, {{.fit = &fit}});
  EXPECT_NEAR(sum_of(nothing), 1, 1e-9) << "nothing stands, and nothing is lost";
}

} // namespace
} // namespace plica
