// Effects that are taken over into a case, and effects that somebody supposes.
#include "changed_beam.hpp"
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/suppose.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/write/explained_case.hpp"
#include "model/description/case_path.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

namespace plica {
namespace {

using Eigen::VectorXd;
namespace fs = std::filesystem;
const fs::path cases = fs::path(PLICA_SOURCE_DIR) / "cases";

// What a case's own test asks of its model: frequencies, stiffness, mass; responses left out.
struct Asked {
  Measured measured;
  TestReadings readings;
};
Asked asked_of(const CaseFile& file) {
  MeasuredFile test =
      read_measured_file((fs::path(file.path).parent_path() / "measured.yaml").string());
  resolve_states(test, file);
  Asked asked{.measured = std::move(test.data), .readings = {}};
  asked.measured.frf.clear();
  asked.measured.hold_out.clear();
  asked.readings = readings_of(TestData{.data = asked.measured, .responses = {}});
  return asked;
}

// Of a size to be expected, in standard deviations of the priors; along a part, at its end, where a
// node is.
VectorXd usual_values(const Hypothesis& h, double size) {
  VectorXd values(Eigen::Index(h.parameters.size()));
  for (std::size_t i = 0; i < h.parameters.size(); ++i)
    values[Eigen::Index(i)] = value_of(h.parameters[i].prior, size);
  for (const std::size_t place : h.along)
    values[Eigen::Index(place)] = h.parameters[place].prior.width;
  return values;
}

// Every effect that a case can say is, said so, what the diagnosis takes it for: each way of each
// effect at one place. `within`: of a log reading.
std::set<std::string> expect_alike(const std::string& path,
                                   const std::map<std::string, std::string>& coarser, double size,
                                   double within) {
  const CaseFile file = read_case(path, "", coarser);
  const Asked asked = asked_of(file);
  const Nominal nominal = nominal_of(file.data, asked.measured);
  const ChosenEffects chosen = chosen_effects(nominal.structure(asked.measured));
  std::set<std::string> tried, effects;
  for (const Hypothesis& h : chosen.hypotheses) {
    if (!h.in_case || !tried.insert(h.effect + " " + h.way).second) continue;
    const VectorXd values = usual_values(h, size);
    const auto model = Predictor(nominal, asked.readings, {&h})(values);
    std::map<std::string, std::string> changes = coarser;
    for (const CaseEdit& edit : h.in_case(file.data, values)) changes[edit.path] = edit.value;
    EXPECT_GT(changes.size(), coarser.size()) << h.effect << " at " << h.place;
    const Case explained = read_case(path, "", changes).data;
    const auto said =
        Predictor(nominal_of(explained, asked.measured), asked.readings, {})(VectorXd());
    EXPECT_TRUE(model && said) << h.effect << " at " << h.place;
    if (!model || !said) continue;
    effects.insert(h.effect);
    for (std::size_t i = 0; i < asked.readings.readings.size(); ++i) {
      const Reading& r = asked.readings.readings[i];
      const bool on_rig = r.kind == ReadingKind::mass || r.kind == ReadingKind::stiffness;
      if ((on_rig && !h.at_rig) || !std::isfinite((*model)[Eigen::Index(i)])) continue;
      EXPECT_NEAR((*model)[Eigen::Index(i)], (*said)[Eigen::Index(i)], within)
          << h.effect << " at " << h.place << " " << h.way << ": " << r.name;
    }
  }
  return effects;
}

// What a change of the model leaves out is what its reduction leaves out: 1e-4 of a frequency.
TEST(TakeOver, a_case_of_beams_says_an_effect_as_the_diagnosis_takes_it) {
  const std::set<std::string> lap =
      expect_alike((cases / "bolted_lap/bolted_lap.yaml").string(), {}, 0.4, 2e-4);
  for (const char* effect :
       {"joint_stiffness", "component_mass", "added_mass", "damping", "boundary_compliance",
        "fixture_flexibility", "temperature", "component_stiffness", "unweighed_mass"})
    EXPECT_TRUE(lap.contains(effect)) << effect;
  expect_alike((cases / "cantilever_masses/cantilever_masses.yaml").string(), {}, 0.4, 2e-4);
}

TEST(TakeOverSlow, a_case_of_a_bellows_does) {
  const std::set<std::string> effects =
      expect_alike((cases / "tutorial/tutorial.yaml").string(),
                   {{"parts.bellows.mesh.accuracy", "10 %"}}, -1.5, 2e-3);
  for (const char* effect : {"ply_slip", "forming_thinning", "unweighed_mass", "component_mass"})
    EXPECT_TRUE(effects.contains(effect)) << effect;
}

// Plies that slip and heat change the same walls: only together with their product are they what
// the case with both of them in it is.
TEST(TakeOver, two_effects_on_the_same_elements_are_what_the_case_with_both_is) {
  const std::string path = (cases / "tutorial/tutorial.yaml").string();
  std::map<std::string, std::string> changes{{"parts.bellows.mesh.accuracy", "10 %"}};
  const CaseFile file = read_case(path, "", changes);
  const Asked asked = asked_of(file);
  const Nominal nominal = nominal_of(file.data, asked.measured);
  const ChosenEffects chosen = chosen_effects(nominal.structure(asked.measured));
  const auto effect = [&](const char* name) {
    return &*std::find_if(chosen.hypotheses.begin(), chosen.hypotheses.end(),
                          [&](const Hypothesis& h) { return h.effect == name; });
  };
  const std::vector<const Hypothesis*> both{effect("ply_slip"), effect("temperature")};
  const VectorXd values = Eigen::Vector2d(0.3, 300); // of the bond, K: 11 % of the modulus
  Case now = file.data;
  for (std::size_t i = 0; i < both.size(); ++i) {
    for (const CaseEdit& edit : both[i]->in_case(now, values.segment(Eigen::Index(i), 1)))
      changes[edit.path] = edit.value;
    now = read_case(path, "", changes).data;
  }
  const auto said = Predictor(nominal_of(now, asked.measured), asked.readings, {})(VectorXd());
  ASSERT_TRUE(said);
  const auto largest_error = [&](const std::optional<VectorXd>& model) {
    double largest = 0;
    for (std::size_t i = 0; i < asked.readings.readings.size(); ++i)
      if (const ReadingKind kind = asked.readings.readings[i].kind;
          kind == ReadingKind::frequency || kind == ReadingKind::stiffness)
        largest = std::max(largest, std::abs((*model)[Eigen::Index(i)] - (*said)[Eigen::Index(i)]));
    return largest;
  };
  PredictorStore store(nominal, asked.readings);
  const double summed = largest_error(store.of(both)(values));
  store.solve_anew();
  const double anew = largest_error(store.of(both)(values));
  EXPECT_GT(summed, 0.02);
  EXPECT_LT(anew, 2e-3);
}

TEST(TakeOver, writes_a_case_that_reads_as_what_it_was_made_of) {
  const test::TemporaryFolder temporary("take_over");
  const fs::path& folder = temporary.path;
  const CaseFile file = read_case((cases / "bellow_a2/bellow_a2.yaml").string(), "pipe");
  const std::string text = yaml_of(file, {{"materials.steel.E", "1.9e11"}}, {}, folder);
  std::ofstream(folder / "explained.yaml") << text;
  const CaseFile again = read_case((folder / "explained.yaml").string());
  EXPECT_EQ(again.data.materials.at("steel").E, 1.9e11);
  ASSERT_EQ(again.data.parts.size(), file.data.parts.size());
  for (std::size_t i = 0; i < file.data.parts.size(); ++i)
    EXPECT_EQ(again.data.parts[i].name, file.data.parts[i].name);
  EXPECT_EQ(again.data.assumptions, file.data.assumptions);
  EXPECT_EQ(again.data.title, file.data.title);
  EXPECT_TRUE(again.data.models.empty());
  EXPECT_TRUE(fs::exists(folder / again.data.measured)) << again.data.measured;
  EXPECT_EQ(text.find(" \n"), std::string::npos);
}

TEST(TakeOver, names_the_signals_of_histories_and_knows_them_as_files_of_the_case) {
  const test::TemporaryFolder temporary("take_over_signals");
  const fs::path& folder = temporary.path;
  const CaseFile file = read_case((cases / "bellow_a2_life/bellow_a2_life.yaml").string());
  const std::vector<fs::path> files = files_of(file);
  EXPECT_GT(std::count(files.begin(), files.end(), cases / "bellow_a2_life/trip.csv"), 0);
  std::ofstream(folder / "explained.yaml") << yaml_of(file, {}, {}, folder);
  const CaseFile again = read_case((folder / "explained.yaml").string());
  const auto &before = file.data.analyses.life->histories.at(0).signals,
             &after = again.data.analyses.life->histories.at(0).signals;
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_EQ(after[i].signal.samples, before[i].signal.samples) << after[i].signal.file;
}

TEST(TakeOver, goes_into_the_case_as_it_was_read) {
  const test::TemporaryFolder temporary("take_over_kept");
  const fs::path path = temporary.path / "beam.yaml";
  fs::copy_file(cases / "cantilever_masses/cantilever_masses.yaml", path);
  fs::copy_file(cases / "cantilever_masses/measured.yaml", temporary.path / "measured.yaml");
  const CaseFile file = read_case(path.string());
  std::ofstream(path) << "case: another\n";
  ExplainedCase explained =
      explained_case(file, {{"parts.m1.mass", "0.3"}}, {}, {}, temporary.path);
  EXPECT_EQ(*number_at(explained.data, "parts.m1.mass"), 0.3);
  EXPECT_EQ(*number_at(explained.data, "parts.m2.mass"), 0.15);
}

// Two sets that the test cannot tell apart are not in it together: of each row the first effect is.
TEST(TakeOver, takes_one_of_the_sets_that_explain_a_test_alike) {
  const CaseFile file = read_case((cases / "cantilever_masses/cantilever_masses.yaml").string());
  const auto heavier = [](const std::string& part) {
    NamedEffect e{.name = "component_mass", .place = part, .way = "", .parameters = {}};
    e.in_case = [part](const Case&) { return CaseEdits{{"parts." + part + ".mass", "0.3"}}; };
    return e;
  };
  Diagnosis d;
  d.verdict = Verdict::several;
  d.effects = {heavier("m1"), heavier("m2"), heavier("m3")};
  d.ledger.rows = {{.effects = {d.effects[0], d.effects[2]}},
                   {.effects = {d.effects[1]}},
                   {.left = Remainder::unexplained}};
  ExplainedCase explained = explained_case(file, {}, d, {}, testing::TempDir());
  EXPECT_EQ(explained.in.size(), 2u);
  EXPECT_EQ(*number_at(explained.data, "parts.m1.mass"), 0.3);
  EXPECT_EQ(*number_at(explained.data, "parts.m2.mass"), 0.3);
  EXPECT_EQ(*number_at(explained.data, "parts.m3.mass"), 0.15);
  d.verdict = Verdict::unknown; // what comes nearest is in the ledger, and named by nobody
  d.effects.clear();
  EXPECT_TRUE(explained_case(file, {}, d, {}, testing::TempDir()).in.empty());
}

// A beam with one effect, taken over, is a beam without: nothing of the gap is left.
TEST(TakeOver, closes_the_gap_of_the_effect_that_is_named) {
  const test::TemporaryFolder temporary("take_over_beam");
  const fs::path& folder = temporary.path;
  const std::string path = (cases / "cantilever_masses/cantilever_masses.yaml").string();
  const CaseFile file = read_case(path);
  Asked asked = asked_of(file);
  const Case truth = read_case(path, "", {{"parts.m3.mass", "0.3"}}).data; // 0.15 drawn
  changed_beam::take_readings(asked.measured, changed_beam::read_by(truth, asked.measured));
  DiagnosisSettings settings;
  settings.plan_next = false;
  const TestData test{.data = asked.measured, .responses = {}};
  const Diagnosis d = diagnose(file.data, test, settings);
  ASSERT_EQ(d.verdict, Verdict::identified) << d.headline;
  const ExplainedCase explained = explained_case(file, {}, d, {}, folder);
  ASSERT_EQ(explained.in.size(), 1u) << d.headline;
  EXPECT_TRUE(explained.left_out.empty());
  EXPECT_NEAR(std::get<PointMass>(part_named(explained.data, "m3")->body).mass, 0.3, 0.01);
  EXPECT_NE(explained.text.find("# in it: component_mass at m3"), std::string::npos);
  const double before = suppose(file.data, test, {}, settings).gap;
  const double after = suppose(explained.data, test, {}, settings).gap;
  EXPECT_GT(before, 5);
  EXPECT_LT(after, 0.1 * before);
}

// A pipe of one's own with three causes at once: a weight that rides on the sensor, plies that
// slip, a mount that is softer. What its truth reads, a tenth of a percent off; nobody weighed it.
class PipeWithThreeCausesSlow : public testing::Test {
protected:
  static CaseFile pipe(std::map<std::string, std::string> changes) {
    changes["parts.bellows.mesh.accuracy"] = "10 %";
    changes.try_emplace("sensors[0].mass", "2 g");
    changes.try_emplace("mount.left", "{stiffness: [3e6, 3e6, 3e6, 6000, 6000, 6000]}");
    return read_case((cases / "tutorial/tutorial.yaml").string(), "", changes);
  }

  PipeWithThreeCausesSlow() : drawn_(pipe({})) {
    const Case truth = pipe({{"sensors[0].mass", "32 g"},
                             {"parts.bellows.wall.bond", "0.4"},
                             {"mount.left", "{stiffness: [1e6, 1e6, 1e6, 2000, 2000, 2000]}"}})
                           .data;
    measured_.specimen = "tutorial";
    for (int order = 1; order <= 4; ++order)
      for (Axis axis : {Axis::x, Axis::z})
        measured_.modes.push_back(changed_beam::bending(axis, order, ""));
    for (int order = 1; order <= 4; ++order) {
      MeasuredMode mode;
      mode.shape = MeasuredShape::axial;
      mode.order = order;
      mode.frequency = 1;
      measured_.modes.push_back(mode);
    }
    for (StaticDirection direction :
         {StaticDirection::axial, StaticDirection::transverse_x, StaticDirection::transverse_z}) {
      measured_.statics.emplace_back();
      measured_.statics.back().direction = direction;
      measured_.statics.back().value = 1;
    }
    VectorXd y = changed_beam::read_by(truth, measured_);
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] += 0.001 * std::sin(7 * double(i));
    changed_beam::take_readings(measured_, y);
  }

  CaseFile drawn_;
  Measured measured_;
};

// Their shares are not looked at: alone, 30 g there change the order of modes, so that the share of
// each hangs on a gram.
TEST_F(PipeWithThreeCausesSlow, has_all_three_named_with_their_sizes) {
  DiagnosisSettings settings;
  settings.plan_next = false;
  const Diagnosis d = diagnose(drawn_.data, {.data = measured_, .responses = {}}, settings);
  EXPECT_EQ(d.verdict, Verdict::several) << diagnosis_text(d);
  EXPECT_EQ(d.effects.size(), 3u) << d.headline;
  EXPECT_GT(d.ledger.explained, 0.95);
  const auto expect_named = [&](const char* effect, const char* place, double value) {
    for (const NamedEffect& e : d.effects) {
      if (e.name != effect || e.place != place) continue;
      EXPECT_LE(e.parameters[0].interval[0], value) << effect;
      EXPECT_GE(e.parameters[0].interval[1], value) << effect;
      return;
    }
    ADD_FAILURE() << effect << " at " << place << " is not in: " << d.headline;
  };
  expect_named("added_mass", "sensor.mid", 0.03);
  expect_named("ply_slip", "bellows", 0.4);
  expect_named("boundary_compliance", "mount.left", 1 / 3.);
}

class SupposedBeam : public testing::Test {
protected:
  SupposedBeam() {
    measured_.specimen = "beam";
    heavy_ = drawn_;
    *number_at(heavy_, "parts.m.mass") = 0.08;
    changed_beam::add_modes(measured_, "");
    changed_beam::take_readings(measured_, changed_beam::read_by(heavy_, measured_));
  }

  static Case drawn() {
    Case c = changed_beam::beam_of(3, 0.6, 0.03, 0.005, true);
    PointMass mass;
    mass.at = "beam.point[3]";
    mass.mass = 0.05;
    c.parts.push_back({"m", mass});
    return c;
  }

  Ledger supposed(const std::vector<SupposedEffect>& effects) const {
    return suppose(drawn_, {.data = measured_, .responses = {}}, {effects}, {});
  }

  std::string refused(const SupposedEffect& effect) const {
    return test::first_problem_of([&] { supposed({effect}); });
  }

  Case drawn_ = drawn(), heavy_;
  Measured measured_;
};

// 0.05 kg drawn, 0.08 there: all of the gap; half of the excess: three quarters of it, as the gap
// is the square of what is left, nearly.
TEST_F(SupposedBeam, explains_what_it_is_worth) {
  const Ledger all = supposed({{"component_mass", "m", "", {{"ratio", "1.6"}}}});
  EXPECT_NEAR(all.rows.front().share, 1, 1e-3);
  const Ledger half = supposed({{"component_mass", "m", "", {{"ratio", "1.3"}}}});
  EXPECT_NEAR(half.rows.front().share, 0.75, 0.06);
  const Ledger wrong = supposed({{"component_mass", "m", "", {{"ratio", "0.8"}}}});
  EXPECT_LT(wrong.rows.front().share, 0) << "the other way";
  const Ledger none = supposed({});
  EXPECT_EQ(none.rows.size(), 4u);
  EXPECT_EQ(none.gap, all.gap);
  // Two that say the same: each takes half of what they share.
  const Ledger two = supposed({{"component_mass", "m", "", {{"ratio", "1.3"}}},
                               {"added_mass", "beam", "", {{"mass", "15 g"}, {"at", "400 mm"}}}});
  EXPECT_NEAR(two.rows[0].share, 0.5, 0.02);
  EXPECT_NEAR(two.rows[1].share, 0.5, 0.02);
}

TEST_F(SupposedBeam, names_what_the_library_does_not_have) {
  EXPECT_EQ(refused({"component_mas", "m", "", {}}),
            "effects[0].effect: 'component_mas' is not tried in this case");
  EXPECT_EQ(refused({"component_mass", "n", "", {{"ratio", "1"}}}),
            "effects[0].place: component_mass has no place 'n'");
  EXPECT_EQ(refused({"component_mass", "m", "x", {{"ratio", "1"}}}),
            "effects[0].way: 'x' is none of its ways at m");
  EXPECT_EQ(refused({"component_mass", "m", "", {{"ratios", "1"}, {"ratio", "1"}}}),
            "effects[0].value.ratios: component_mass has no such parameter");
  EXPECT_EQ(refused({"component_mass", "m", "", {}}), "effects[0].value.ratio: is missing");
  EXPECT_EQ(refused({"added_mass", "beam", "", {{"mass", "15 N"}, {"at", "0.4"}}}),
            "effects[0].value.mass: '15 N' is a force");
}

} // namespace
} // namespace plica
