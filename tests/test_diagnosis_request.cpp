// What a case says of its diagnosis, and a test of its states.
#include "diagnose/effects/chosen_effects.hpp"
#include "io/input/measured_file.hpp"
#include "io/input/measured_states.hpp"
#include "lab/measured/states.hpp"
#include "model/description/case_path.hpp"
#include "tests/changed_beam.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

namespace plica {
namespace {

using namespace changed_beam;

std::string problem_of(const Case& data) {
  const Measured none;
  return test::first_problem_of([&] { chosen_effects(nominal_of(data, none).structure(none)); });
}

TEST(ChosenEffects, are_those_that_the_case_lets_in) {
  Case data = held_beam();
  data.diagnose.effects = {"added_mass", "extra_support"};
  data.diagnose.without = {"extra_support"};
  data.diagnose.places = {"beam.point[3]"};
  data.diagnose.priors = {
      {.effect = "added_mass", .parameter = "mass", .between = {0.01, 0.02}, .widening = {}}};
  Measured none;
  const ChosenEffects chosen = chosen_effects(nominal_of(data, none).structure(none));
  ASSERT_EQ(chosen.hypotheses.size(), 1U);
  EXPECT_EQ(chosen.hypotheses[0].effect, "added_mass");
  EXPECT_EQ(chosen.hypotheses[0].place, "beam.point[3]");
  EXPECT_GE(value_of(chosen.hypotheses[0].parameters[0].prior, -5), 0.01);
  EXPECT_LE(value_of(chosen.hypotheses[0].parameters[0].prior, 5), 0.02);
  EXPECT_EQ(chosen.words.size(), 4U);
}

// Twice as wide a prior reaches twice as far in its logarithm; what lies evenly between two bounds,
// of itself or of its logarithm, is refused: it would change nothing.
TEST(ChosenEffects, have_priors_as_wide_as_the_case_says) {
  Case data = held_beam();
  data.diagnose.effects = {"damping", "extra_support"};
  const Measured none;
  const auto ratio_at = [&](double z) {
    for (const Hypothesis& h : chosen_effects(nominal_of(data, none).structure(none)).hypotheses)
      if (h.effect == "damping") return value_of(h.parameters[0].prior, z);
    return 0.;
  };
  const double middle = ratio_at(0), before = ratio_at(1);
  const auto ask = [&](const std::string& effect, const std::string& parameter) {
    data.diagnose.priors = {
        {.effect = effect, .parameter = parameter, .between = {}, .widening = 2}};
  };
  ask("damping", "ratio");
  EXPECT_NEAR(ratio_at(1) / middle, std::pow(before / middle, 2), 1e-9);
  EXPECT_NEAR(ratio_at(0), middle, 1e-12);
  ask("extra_support", "k");
  EXPECT_EQ(problem_of(data), "diagnose.priors[0].widening: k lies evenly between two bounds");
  ask("extra_support", "at");
  EXPECT_EQ(problem_of(data), "diagnose.priors[0].widening: at lies evenly between two bounds");
}

// Springs of a rigid clamp have a prior that may be wider in each motion; that a clamp lets go of
// all lies evenly between bounds, and stays as it is.
TEST(ChosenEffects, are_widened_where_they_can_be) {
  Case data = changed_beam::two_halves({});
  data.diagnose.effects = {"joint_stiffness"};
  const Measured none;
  const auto reach = [&] {
    std::map<std::string, double> found;
    for (const Hypothesis& h : chosen_effects(nominal_of(data, none).structure(none)).hypotheses)
      if (h.place == "caps.joint") found[h.way] = value_of(h.parameters[0].prior, 1);
    return found;
  };
  const auto before = reach();
  data.diagnose.priors = {
      {.effect = "joint_stiffness", .parameter = "stiffness", .between = {}, .widening = 2}};
  const auto after = reach();
  ASSERT_TRUE(before.contains("bending") && before.contains("all directions"));
  EXPECT_GT(after.at("bending"), 1.5 * before.at("bending"));
  EXPECT_NEAR(after.at("all directions"), before.at("all directions"),
              1e-9 * before.at("all directions"));
}

TEST(ChosenEffects, refuse_what_is_none) {
  const Case data = held_beam();
  Case effect = data, place = data, parameter = data, nothing = data, empty = data;
  effect.diagnose.without = {"addedmass"};
  place.diagnose.places = {"bellow"};
  parameter.diagnose.priors = {
      {.effect = "temperature", .parameter = "T", .between = {0, 1}, .widening = {}}};
  nothing.diagnose.priors = {
      {.effect = "temperature", .parameter = "delta_T", .between = {}, .widening = {}}};
  empty.diagnose.priors = {
      {.effect = "temperature", .parameter = "delta_T", .between = {5, 1}, .widening = {}}};
  EXPECT_EQ(problem_of(effect), "diagnose.without[0]: there is no effect 'addedmass'");
  EXPECT_EQ(problem_of(place), "diagnose.places[0]: no effect has a place 'bellow'");
  EXPECT_EQ(problem_of(parameter),
            "diagnose.priors[0].parameter: temperature has no parameter 'T'");
  EXPECT_EQ(problem_of(nothing), "diagnose.priors[0]: changes nothing");
  EXPECT_EQ(problem_of(empty), "diagnose.priors[0].between: leaves nothing of the prior");
  EXPECT_EQ(problem_of(data), "no error");
}

// Problems of a measured.yaml, a line each.
std::vector<InputProblem> problems_of(const std::string& text) {
  const test::TemporaryFolder folder("baseline");
  const std::string path = folder.path / "measured.yaml";
  std::ofstream(path) << text;
  return test::input_problems([&] { read_measured(path); });
}

const std::string two_states = "specimen: beam\n"
                               "states:\n"
                               "  - {name: before, baseline: true}\n"
                               "  - {name: after}\n";

TEST(States, a_baseline_has_what_the_others_have) {
  const auto problems = problems_of(
      two_states +
      "modes:\n"
      "  - {frequency: 10 Hz, shape: transverse, direction: z, order: 1, state: before}\n"
      "  - {frequency: 9 Hz, shape: transverse, direction: z, order: 1, state: after}\n"
      "  - {frequency: 60 Hz, shape: transverse, direction: z, order: 2, state: after}\n");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 8);
  EXPECT_EQ(problems[0].key, "modes[2]");
  EXPECT_EQ(problems[0].wrong, "no baseline has a transverse mode 2 in z");
}

// What a diagnosis refuses besides.
std::vector<InputProblem> problems_of_states(const std::string& text) {
  const test::TemporaryFolder folder("states");
  const std::string path = folder.path / "measured.yaml";
  std::ofstream(path) << text;
  return test::input_problems([&] {
    const MeasuredFile file = read_measured_file(path);
    check_states_of_diagnosis(file.data, {.file = path, .problems = {}, .lines = file.lines});
  });
}

// A damping, a shape or a height that nobody measured before the change would be held against what
// the case assumes.
TEST(States, a_baseline_has_each_quantity_that_the_others_have) {
  const std::string mode = "  - {frequency: 10 Hz, shape: transverse, direction: z, state: ";
  const std::string peak =
      "  - {base: y, sensor: a, direction: y, level: [1 m/s2], frequency: [10 Hz], ";
  const std::string text = two_states + "sensors: [{name: a, at: [0, 0, 0]}]\nmodes:\n" + mode +
                           "before}\n" + mode +
                           "after, damping: 1 %,\n     vector: {channels: [a.z], real: [1]}}\n"
                           "peaks:\n" +
                           peak + "state: before}\n" + peak + "amplitude: [9], state: after}\n";
  EXPECT_TRUE(problems_of(text).empty()) << "a run may be held against it";
  const auto problems = problems_of_states(text);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].line, 8);
  EXPECT_EQ(problems[0].key, "modes[1].damping");
  EXPECT_EQ(problems[0].wrong, "no baseline has the damping of the transverse mode 1 in z");
  EXPECT_EQ(problems[1].line, 9);
  EXPECT_EQ(problems[1].key, "modes[1].vector");
  EXPECT_EQ(problems[2].line, 12);
  EXPECT_EQ(problems[2].key, "peaks[1].amplitude");
}

TEST(States, something_is_measured_in_each) {
  const std::string mode = "  - {frequency: 10 Hz, shape: transverse, direction: z, state: ";
  const std::string text =
      two_states + "  - {name: later}\nmodes:\n" + mode + "before}\n" + mode + "after}\n";
  const auto problems = problems_of_states(text);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 5);
  EXPECT_EQ(problems[0].key, "states[2].name");
  EXPECT_EQ(problems[0].wrong, "nothing was measured in this state");
  const auto misspelt = problems_of(text + mode + "lather}\n");
  ASSERT_EQ(misspelt.size(), 1U) << "nothing follows from it";
  EXPECT_EQ(misspelt[0].key, "modes[2].state");
}

// What two modes far apart make as one is neither; what was measured again is one.
TEST(States, one_order_is_one_mode) {
  const std::string first = "specimen: beam\nmodes:\n"
                            "  - {frequency: 80.5 Hz, shape: transverse, direction: z}\n";
  const auto problems =
      problems_of(first + "  - {frequency: 297.7 Hz, shape: transverse, direction: z}\n");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 4);
  EXPECT_EQ(problems[0].key, "modes[1]") << "it states no order";
  EXPECT_EQ(problems[0].wrong, "is mode 1 at 297.7 Hz, as is the one of the same kind at 80.5 Hz");
  const std::string again = "  - {frequency: 95 Hz, shape: transverse, direction: z}\n";
  EXPECT_TRUE(
      problems_of(first + again + "  - {frequency: 105 Hz, shape: transverse, direction: z}\n")
          .empty())
      << "neighbours lie near each other";
  for (const char* fine : {"81 Hz, shape: transverse, direction: z", "297.7 Hz, shape: axial",
                           "297.7 Hz, shape: transverse, direction: x"})
    EXPECT_TRUE(problems_of(first + "  - {frequency: " + fine + "}\n").empty()) << fine;
}

// As `plica identify` lists modes whose kind its channels do not tell.
TEST(States, modes_of_no_kind_are_counted_by_frequency) {
  const test::TemporaryFolder folder("others");
  const std::string path = folder.path / "measured.yaml";
  std::ofstream(path) << "specimen: frame\nmodes:\n  - {frequency: 31 Hz, shape: other}\n"
                         "  - {frequency: 12 Hz, shape: other}\n"
                         "  - {frequency: 9 Hz, shape: other, base: x}\n";
  const Measured m = read_measured(path);
  EXPECT_EQ(m.modes[0].order, 2);
  EXPECT_EQ(m.modes[1].order, 1);
  EXPECT_EQ(m.modes[2].order, 1) << "known by its frequency";
}

// Two modes taken for each other: the second of a kind cannot lie above the third.
TEST(States, orders_of_modes_rise_with_their_frequencies) {
  const std::string modes =
      "modes:\n"
      "  - {frequency: 80.5 Hz, shape: transverse, direction: z, order: 1}\n"
      "  - {frequency: 580.7 Hz, shape: transverse, direction: z, order: 2}\n"
      "  - {frequency: 150 Hz, shape: transverse, direction: x, order: 3}\n"
      "  - {frequency: 297.7 Hz, shape: transverse, direction: z, order: 3}\n";
  const auto problems = problems_of("specimen: beam\n" + modes);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 6);
  EXPECT_EQ(problems[0].key, "modes[3].order");
  EXPECT_EQ(problems[0].wrong, "order 3 at 297.7 Hz, order 2 of the same kind at 580.7 Hz");
}

// What is wrong with a test of a beam, with its key.
std::string refusal_of(const Measured& m) {
  return test::first_problem_of([&] { diagnosis_of(held_beam(), m); });
}

TEST(DiagnosisRequest, what_leaves_nothing_to_explain_is_refused_at_its_key) {
  EXPECT_EQ(refusal_of({}), "specimen: nothing was measured of it that a diagnosis reads");
  Measured m;
  m.modes = {bending(Axis::z, 1, "", 30)};
  m.hold_out = {"modes[0]"};
  EXPECT_EQ(refusal_of(m), "hold_out: all that was measured is held out");
  m.hold_out.clear();
  m.modes[0].order = 12;
  EXPECT_EQ(refusal_of(m), "modes[0]: the model gives none of the measured quantities");
  m.modes[0].order = 30;
  EXPECT_EQ(refusal_of(m), "modes[0].order: is 30, and the model has 16 modes in all");
}

TEST(DiagnosisRequest, what_drove_the_part_has_a_place_on_it) {
  Measured m;
  m.modes = {bending(Axis::z, 1, "", 30)};
  m.modes[0].drive = "far.z";
  m.modes[0].force = 2;
  EXPECT_EQ(
      refusal_of(m),
      "modes[0].drive: it was driven at 'far', which is no sensor of the case, nor one of the "
      "test on the part");
  m.sensors = {{.name = "far", .at = {0, 0.3, 0}}};
  EXPECT_EQ(refusal_of(m), "no error") << "the test says where it is";
}

// A state's number that the case has not: at its line, with what may be meant.
TEST(States, set_numbers_of_the_case) {
  const test::TemporaryFolder folder("states");
  const CaseFile file = read_case(PLICA_SOURCE_DIR "/cases/lap_beam/lap_beam.yaml");
  const std::string path = folder.path / "measured.yaml";
  std::ofstream(path) << "specimen: lap_beam\nstates:\n  - name: heavier\n"
                         "    set: {materials.steal.rho: 7900 kg/m3}\nmodes:\n"
                         "  - {frequency: 80 Hz, shape: transverse, state: heavier}\n";
  MeasuredFile measured = read_measured_file(path);
  try {
    resolve_states(measured, file);
    FAIL() << "the case has such a number";
  } catch (const InputError& error) {
    const InputProblem& p = error.problems().front();
    EXPECT_EQ(p.line, 4) << error.what();
    EXPECT_EQ(p.key, "states[0].set");
    EXPECT_EQ(p.wrong, "the case has no number at 'materials.steal.rho'");
    EXPECT_EQ(p.allowed, "did you mean 'materials.steel.rho'?");
  }
}

TEST(States, something_is_measured_after_the_baseline_and_a_mass_says_when) {
  Measured alone;
  alone.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}}};
  alone.modes = {bending(Axis::z, 1, "before", 10)};
  EXPECT_EQ(refusal_of(alone), "states[0].baseline: nothing was measured but in baselines");
  EXPECT_EQ(measured_as_drawn(alone).modes.size(), 1U) << "a run has something to be held against";
  const auto mass = problems_of(
      two_states + "mass: {value: 1 kg}\n"
                   "modes:\n"
                   "  - {frequency: 10 Hz, shape: transverse, direction: z, state: before}\n"
                   "  - {frequency: 9 Hz, shape: transverse, direction: z, state: after}\n");
  ASSERT_EQ(mass.size(), 1U);
  EXPECT_EQ(mass[0].key, "mass");
  EXPECT_EQ(mass[0].line, 5);
}

// One weighing, or a list of them: each belongs to a state that is there.
TEST(States, are_those_of_weighings_too) {
  const std::string modes =
      "modes:\n"
      "  - {frequency: 10 Hz, shape: transverse, direction: z, state: before}\n"
      "  - {frequency: 9 Hz, shape: transverse, direction: z, state: after}\n";
  const auto problem = [&](const std::string& mass) {
    const auto all = problems_of(two_states + modes + mass);
    return all.size() == 1 ? std::to_string(all[0].line) + ": " + all[0].key + " " + all[0].wrong
                           : std::to_string(all.size()) + " problems";
  };
  const std::string list = "mass:\n  - {value: 1 kg, state: before}\n";
  EXPECT_EQ(problem("mass: {value: 1 kg, state: before}\n"), "0 problems");
  EXPECT_EQ(problem(list + "  - {value: 1 kg, state: after}\n"), "0 problems");
  EXPECT_EQ(problem("mass: {value: 1 kg, state: befor}\n"),
            "8: mass.state there is no state 'befor'");
  EXPECT_EQ(problem(list + "  - {value: 1 kg, state: befor}\n"),
            "10: mass[1].state there is no state 'befor'");
  EXPECT_EQ(problem("mass:\n  - {value: 1 kg, state: befor}\n"),
            "9: mass[0].state there is no state 'befor'");
  EXPECT_EQ(problem(list + "  - {value: 1 kg}\n"),
            "10: mass[1] does not say in which state it was weighed");
  EXPECT_EQ(problem("mass: []\n"), "8: mass has 0 items");
  EXPECT_EQ(problem("mass: 1 kg\n").find("8: mass is "), 0U) << problem("mass: 1 kg\n");
  EXPECT_EQ(problem(list + "hold_out: [mass]\n"), "0 problems") << "a list of one is `mass`";
  EXPECT_EQ(problem(list + "hold_out: [\"mass[0]\"]\n"),
            "10: hold_out[0] there is no entry 'mass[0]'");
}

TEST(States, a_run_is_compared_with_what_belongs_to_the_drawing) {
  Measured m;
  m.states = {
      {.name = "before", .baseline = true, .set = {}, .numbers = {}},
      {.name = "loaded", .baseline = true, .set = {{"parts.m.mass", "1 kg"}}, .numbers = {}},
      {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  m.modes = {bending(Axis::z, 1, "after", 9), bending(Axis::z, 1, "loaded", 8),
             bending(Axis::z, 1, "before", 10), bending(Axis::z, 2, "before", 60)};
  m.peaks.resize(2);
  m.peaks[0].state = "after";
  m.peaks[1].state = "before";
  m.weighings.resize(2);
  m.weighings[0].state = "after";
  m.weighings[1].state = "before";
  m.hold_out = {"modes[0]", "modes[3]", "peaks[0]", "peaks[1].frequency[2]", "mass[0]", "mass[1]"};
  const Measured own = measured_as_drawn(m);
  ASSERT_EQ(own.modes.size(), 2U);
  EXPECT_EQ(own.modes[0].frequency, 10);
  EXPECT_EQ(own.weighings.size(), 1U);
  EXPECT_EQ(own.hold_out, (std::vector<std::string>{"modes[1]", "peaks[0].frequency[2]", "mass"}));

  for (MeasuredState& s : m.states) s.baseline = false;
  m.modes.push_back(bending(Axis::z, 1, "", 11));
  ASSERT_EQ(measured_as_drawn(m).modes.size(), 1U);
  EXPECT_EQ(measured_as_drawn(m).modes[0].frequency, 11);
}

} // namespace
} // namespace plica
