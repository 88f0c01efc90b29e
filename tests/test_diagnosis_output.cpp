// What a diagnosis leaves behind: the terminal, the ledger as a table and as a picture, its words.
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include "io/report/diagnosis.hpp"
#include "io/tables/diagnosis_words.hpp"
#include "io/tables/effect_words.hpp"
#include "io/tables/ledger_words.hpp"
#include "io/write/write_diagnosis.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace {

using namespace plica;
using namespace plica::test;

NamedEffect slipping_plies() {
  return {.name = "ply_slip",
          .place = "bellows",
          .way = "",
          .probability = 1,
          .parameters = {{"bond", "", 0.3983, {0.3424, 0.4869}, -0.3}},
          .anywhere = 0.99};
}

NamedEffect mass_of_20_g() {
  return {.name = "added_mass",
          .place = "sensor.mid",
          .way = "",
          .probability = 0.9,
          .parameters = {{"mass", "kg", 0.0201, {0.0182, 0.0234}, 0.2}},
          .anywhere = 0.9};
}

NamedEffect softer_joint(const std::string& place) {
  return {.name = "joint_stiffness",
          .place = place,
          .way = "",
          .probability = 0.8,
          .parameters = {{"ratio", "", 0.7, {0.6, 0.8}, 1}},
          .anywhere = 0.8};
}

NamedEffect more_damping() {
  return {.name = "damping",
          .place = "all",
          .way = "",
          .probability = 0.7,
          .parameters = {{"ratio", "", 1.2, {1.1, 1.3}, 1}},
          .anywhere = 0.7};
}

// What is left: of each kind some, the rest of 1 unexplained.
void add_what_is_left(Ledger& ledger) {
  double left = 1;
  for (const LedgerRow& row : ledger.rows) left -= row.share;
  ledger.explained = 1 - left;
  ledger.explained_interval = {0.8, 0.96};
  for (const Remainder kind : {Remainder::measurement, Remainder::mounting, Remainder::model})
    ledger.rows.push_back({.left = kind, .share = 0.01, .interval = {0, 0.02}});
  ledger.rows.push_back(
      {.left = Remainder::unexplained, .share = left - 0.03, .interval = {0.01, 0.1}});
  ledger.left_in = {{"frequency in y, peak 1", 0.05}, {"mass", 0.03}, {"damping in y", -0.01}};
}

LocatedGap block(ReadingKind kind, const std::string& direction, double z) {
  LocatedGap gap;
  gap.kind = kind;
  gap.direction = direction;
  gap.z = z;
  gap.significant = true;
  return gap;
}

LocatedGap component(const std::string& name, double z) {
  LocatedGap gap;
  gap.component = name;
  gap.z = z;
  return gap;
}

ProposedMeasurement proposed(const std::string& what, double change) {
  ProposedMeasurement m;
  m.what = what;
  m.change = change;
  m.about = "ply_slip at bellows";
  return m;
}

Diagnosis made_up_diagnosis(Verdict verdict, const std::vector<LedgerRow>& causes) {
  Diagnosis d;
  d.case_name = "pipe";
  d.headline = "ply_slip at bellows (odds 120:1 over no effect)";
  d.verdict = verdict;
  d.ledger.gap = 15.6;
  d.ledger.readings = 6;
  d.ledger.rows = causes;
  add_what_is_left(d.ledger);
  d.where = {block(ReadingKind::stiffness, "y", -7.1), block(ReadingKind::frequency, "y", -6.6),
             block(ReadingKind::frequency, "x", -6.3), component("bellows", 9.4),
             component("interlock", 5.9)};
  d.gap = {.before = 3.95, .after = 0.327, .interval = {0.58, 0.95}, .readings = 6};
  d.held_out = GapShrink{.before = 2.28, .after = 0.434, .interval = {0.7, 0.9}, .readings = 6};
  d.held_out_how = "each reading in turn";
  d.tried.emplace_back().effects = {slipping_plies()};
  d.best = 0;
  d.next = {proposed("a sweep along z", 0.14), proposed("static bending", 0.1)};
  d.probabilities = {{"ply_slip", 0.99}, {"none", 0.01}};
  d.inclusion = {{"ply_slip", 0.99, {{"bellows", 0.96}, {"hose, left", 0.03}}}};
  d.warnings = {"one warning"};
  for (const LedgerRow& row : causes)
    for (const NamedEffect& e : row.effects) d.effects.push_back(e);
  d.mesh.nodes = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};
  d.mesh.quads.emplace_back().nodes = {0, 1, 2, 3};
  return d;
}

Resonator hanging_mass() {
  return {.found = {.name = "resonator",
                    .place = "bellows.convolution[5]",
                    .way = "on the mean motion",
                    .parameters = {{"mass", "kg", 0.0102, {0.0098, 0.0106}, 0.2},
                                   {"frequency", "Hz", 1450, {1440, 1461}, 0.1}},
                    .nodes = {1, 2}},
          .words = "10.2 g on a spring of its own, which resonates at 1450 Hz, at "
                   "bellows.convolution[5]",
          .gap_after = 1.25};
}

LedgerRow cause(std::vector<NamedEffect> effects, double share) {
  return {.effects = std::move(effects), .share = share, .interval = {share - 0.02, share + 0.02}};
}

Diagnosis of_five_effects() {
  LedgerRow list = cause({mass_of_20_g(), softer_joint("lap")}, 0.2);
  list.told_apart_by = "weigh the part";
  return made_up_diagnosis(Verdict::several,
                           {cause({slipping_plies()}, 0.5), list,
                            cause({softer_joint("interlock")}, 0.1), cause({more_damping()}, 0.05),
                            cause({softer_joint("caps")}, 0.05)});
}

Diagnosis of_one_effect() {
  return made_up_diagnosis(Verdict::identified, {cause({slipping_plies()}, 0.9)});
}

std::string written_file(const Diagnosis& d, const std::string& name) {
  const TemporaryFolder folder("diagnosis");
  written(folder.path, [&](OutputFolder& out) { write_diagnosis(d, "Pipe", "0.1", out); });
  std::ifstream stream(folder.path / name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
}

// The most there can be: five effects, all kinds of what is left, readings, places, a measurement.
TEST(DiagnosisTerminal, says_all_in_fifteen_lines) {
  const std::string text = diagnosis_text(of_five_effects());
  const std::string first = text.substr(0, text.find("\n\n") + 1);
  EXPECT_EQ(std::count(first.begin(), first.end(), '\n'), 15) << first;
  expect_parts(first,
               {"pipe: Several causes together, 90 % of the gap [80, 96]: plies of the wall",
                "; and 2 more; 7 % is not explained\n", "bond 0.398 (0.342 to 0.487)", "[48, 52]",
                "probability 99 %", "mass 20.1 (18.2 to 23.4) g; or a joint with",
                "; to tell them apart: weigh the part\n",
                "what is left sits in frequency in y, peak 1 5 %, mass 3 %",
                "Where (z): stiffness in y -7.1; ", "bellows +9.4",
                "3.95 before, 0.327 after; held out 2.28 before, 0.434 after",
                "Measure next: a sweep along z (about ply_slip at bellows; changes the ledger "
                "by 14 %)"});
  expect_parts(text.substr(first.size()),
               {"Evidence: ply_slip at bellows (odds 120:1", "\nWhere: 3 of 3 blocks",
                "\nEffects (SI)\n", "\nHow far with", "\nNext measurement\n", "static bending"});
}

TEST(DiagnosisTerminal, begins_with_the_verdict_in_plain_words) {
  EXPECT_EQ(plain_verdict(of_one_effect()),
            "Plies of the wall that slip on each other, at bellows: "
            "90 % of the gap [88, 92]; 7 % is not explained");
  const auto of = [](Verdict verdict, const std::vector<LedgerRow>& rows) {
    return plain_verdict(made_up_diagnosis(verdict, rows));
  };
  EXPECT_TRUE(of(Verdict::none, {}).starts_with("The model as it is explains the test"));
  EXPECT_TRUE(of(Verdict::mostly, {cause({slipping_plies()}, 0.6)})
                  .starts_with("Mostly plies of the wall"));
  EXPECT_TRUE(of(Verdict::unknown, {cause({more_damping()}, 0.3)})
                  .starts_with("Cause not found; nearest comes damping that is +20 % off the case "
                               "everywhere: 30 % of the gap"));
  EXPECT_EQ(of(Verdict::unknown, {}), "Cause not found: nothing that is known here comes nearer to "
                                      "the test than the model as it is; 97 % is not explained");
  EXPECT_TRUE(
      of(Verdict::ambiguous, {cause({slipping_plies()}, 0.6)}).starts_with("Perhaps plies"));
  const std::string list =
      of(Verdict::ambiguous, {cause({slipping_plies(), mass_of_20_g()}, 0.968)});
  expect_parts(list, {"One of: plies of the wall that slip on each other, at bellows; or 20 g that "
                      "nobody weighed, at sensor.mid: ",
                      ", whichever it is; less than 1 % is not explained"});
}

TEST(DiagnosisTerminal, ends_the_verdict_with_what_is_no_effect_here) {
  Diagnosis d = made_up_diagnosis(Verdict::unknown, {cause({more_damping()}, 0.3)});
  d.resonator = hanging_mass();
  EXPECT_TRUE(plain_verdict(d).ends_with(
      "; what is no effect here would do as well: 10.2 g on a spring of its own, which resonates "
      "at 1450 Hz, at bellows.convolution[5]"))
      << plain_verdict(d);
  d.resonator->is_ahead = true;
  const std::string better = "; what is no effect here would do better: 10.2 g on a spring";
  EXPECT_NE(plain_verdict(d).find(better), std::string::npos) << plain_verdict(d);
  d.ledger.rows.erase(d.ledger.rows.begin());
  EXPECT_NE(plain_verdict(d).find(better), std::string::npos) << "where nothing comes nearer";
}

TEST(DiagnosisTerminal, says_how_sure_an_effect_is_and_that_it_sits_there) {
  NamedEffect mass = mass_of_20_g();
  mass.probability = 0.31;
  mass.anywhere = 0.39;
  const Diagnosis d = made_up_diagnosis(Verdict::ambiguous, {cause({mass}, 0.6)});
  expect_parts(ledger_text(d.ledger), {"; probability 39 %, 31 % there\n"});
}

// Of a spring that holds rigidly only the lower end is known; what was stated has no interval.
TEST(DiagnosisTerminal, gives_numbers_in_units_a_person_uses) {
  EXPECT_EQ(estimate_words({"offset", "m", 0.0021, {0.0018, 0.0024}, 0}), "2.10 (1.80 to 2.40) mm");
  EXPECT_EQ(estimate_words({"angle", "rad", 0.1, {0.05, 0.15}, 0}), "5.73 (2.86 to 8.59)°");
  EXPECT_EQ(estimate_words({"k", "N/m", 1e9, {3.1e7, 1e12}, 0}), "at least 31 MN/m");
  EXPECT_EQ(estimate_words({"mass", "kg", 0.02, {}, 0}), "20.0 g");
}

// A line for each row of the ledger, so that shares add up; what stands for one another below it.
TEST(DiagnosisCsv, has_shares_and_values_with_intervals) {
  std::istringstream text(written_file(of_five_effects(), "diagnosis_ledger.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 1U + 5 + 1 + 4 + 3);
  EXPECT_EQ(lines[0],
            "what,share of the gap,share 90 % from,share 90 % to,probability,effect,place,"
            "parameter,value,value 90 % from,value 90 % to,unit,share left in the reading,"
            "told apart by");
  EXPECT_EQ(lines[1], "\"plies of the wall that slip on each other, at bellows\",0.5,0.48,0.52,"
                      "0.99,ply_slip,bellows,bond,0.3983,0.3424,0.4869,,,");
  expect_parts(lines[2], {"\"one of: 20 g that nobody weighed, at sensor.mid; or a joint", ",0.2,",
                          ",added_mass,sensor.mid,mass,20.1", ",g,,weigh the part"});
  EXPECT_EQ(lines[3], ",,,,,joint_stiffness,lap,ratio,0.7,0.6,0.8,,,");
  EXPECT_EQ(lines[7], "what measuring leaves open,0.01,0,0.02,,,,,,,,,,");
  EXPECT_EQ(lines[11], "\"left in frequency in y, peak 1\",,,,,,,,,,,,0.05,");
  for (const std::string& line : {lines[0], lines[3], lines[7]})
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 13) << line;
}

TEST(DiagnosisCsv, has_each_effect_anywhere_and_at_each_place) {
  EXPECT_EQ(written_file(of_one_effect(), "diagnosis_inclusion.csv"),
            "effect,place,probability\nply_slip,anywhere,0.99\nply_slip,bellows,0.96\n"
            "ply_slip,\"hose, left\",0.03\n");
}

TEST(DiagnosisReport, begins_in_plain_words_with_a_waterfall) {
  const std::string html = diagnosis_html(of_five_effects(), "Pipe");
  const std::size_t banner = html.find("Several causes together, 90 % of the gap");
  ASSERT_NE(banner, std::string::npos);
  EXPECT_LT(banner, html.find("What the gap is made of"));
  EXPECT_LT(html.find("What the gap is made of"), html.find("odds 120:1"));
  expect_parts(html,
               {"<b>1</b> plies of the wall that slip on each other, at bellows",
                "ply_slip at bellows: bond 0.398 (0.342 to 0.487)",
                "added_mass at sensor.mid: mass 20.1 (18.2 to 23.4) g", "stroke-dasharray",
                "the gap of the nominal case", "To measure next: a sweep along z",
                "frequency in y, peak 1: 5 % of the gap", "to tell them apart: weigh the part",
                "bellows 96.0\u00a0%, hose, left 3.0\u00a0%"});
  expect_parts(html, {"gap before", "gap, fitted"}); // its root, G being its square
  EXPECT_EQ(html.find("G before"), std::string::npos);
}

// What acts everywhere has no place on the part, and a case that explains its test no effect.
TEST(DiagnosisReport, draws_the_part_also_where_nothing_is_marked) {
  for (const Diagnosis& d : {made_up_diagnosis(Verdict::identified, {cause({more_damping()}, 0.9)}),
                             made_up_diagnosis(Verdict::none, {})})
    EXPECT_NE(diagnosis_html(d, "Pipe").find("<figure class=\"viewer\">"), std::string::npos);
}

TEST(DiagnosisReport, shows_what_is_no_effect_here_above_all_else_and_on_the_part) {
  Diagnosis d = made_up_diagnosis(Verdict::unknown, {cause({more_damping()}, 0.3)});
  EXPECT_EQ(diagnosis_html(d, "Pipe").find("on a spring"), std::string::npos);
  d.resonator = hanging_mass();
  const std::string html = diagnosis_html(d, "Pipe");
  EXPECT_LT(html.find("would do as well: 10.2 g on a spring of its own"),
            html.find("What the gap is made of"));
  expect_parts(html,
               {"a mass on a spring of its own, at bellows.convolution[5]: mass 10.2 (9.80 to "
                "10.6) g, frequency 1450 (1440 to 1461) Hz; it leaves a gap of 1.25",
                ">on a spring<"});
  d.resonator->found.parameters.push_back({"small", "", 2.5e-6, {2e-6, 3e-6}, 0});
  EXPECT_EQ(diagnosis_html(d, "Pipe").find("&lt;sup"), std::string::npos)
      << "powers of ten are raised";
}

TEST(DiagnosisJson, has_what_is_no_effect_here_apart_from_effects) {
  Diagnosis d = made_up_diagnosis(Verdict::unknown, {cause({more_damping()}, 0.3)});
  EXPECT_TRUE(nlohmann::json::parse(diagnosis_json(d, "0.1")).at("resonator").is_null());
  d.resonator = hanging_mass();
  const auto json = nlohmann::json::parse(diagnosis_json(d, "0.1")).at("resonator");
  EXPECT_EQ(json.at("place"), "bellows.convolution[5]");
  EXPECT_EQ(json.at("value").at("mass"), 0.0102);
  EXPECT_EQ(json.at("interval").at("frequency"), (std::vector<double>{1440, 1461}));
  EXPECT_EQ(json.at("unit").at("frequency"), "Hz");
  EXPECT_EQ(json.at("far_ahead"), false);
  EXPECT_FALSE(json.contains("probability")) << "it is no effect of the library";
}

TEST(DiagnosisJson, has_a_place_on_a_bellows_in_metres) {
  NamedEffect damage{
      .name = "local_damage", .place = "bellows.convolution[5]", .way = "", .parameters = {}};
  const auto first_of = [](const NamedEffect& e) {
    const Diagnosis d = made_up_diagnosis(Verdict::identified, {cause({e}, 0.9)});
    EXPECT_EQ(plain_verdict(d).find("0.0330 m along") != std::string::npos, e.along.has_value());
    return nlohmann::json::parse(diagnosis_json(d, "0.1"))["ledger"]["rows"][0]["effects"][0];
  };
  EXPECT_FALSE(first_of(damage).contains("along"));
  damage.along = {.value = 0.033, .interval = {0.03, 0.036}};
  EXPECT_EQ(first_of(damage)["along"]["value"], 0.033);
  EXPECT_EQ(first_of(damage)["along"]["interval"], (std::vector<double>{0.03, 0.036}));
}

TEST(DiagnosisReport, has_the_first_of_the_spots_of_a_wall_and_how_far_they_reach) {
  NamedEffect touch{
      .name = "extra_support", .place = "duct.spot[0][0][0]", .way = "", .parameters = {}};
  for (int k = 1; k <= 8; ++k)
    touch.other_places.push_back("duct.spot[" + std::to_string(k) + "][0][0]");
  const auto report_of = [](const NamedEffect& e) {
    return diagnosis_html(made_up_diagnosis(Verdict::identified, {cause({e}, 0.9)}), "Duct");
  };
  EXPECT_EQ(report_of(touch).find(" more;"), std::string::npos);
  expect_parts(report_of(touch), {"duct.spot[8][0][0]; probability"});
  touch.within = 0.03;
  expect_parts(report_of(touch),
               {", within 0.030 m", "duct.spot[5][0][0] and 3 more; probability"});
  EXPECT_EQ(report_of(touch).find("duct.spot[6]"), std::string::npos);
}

TEST(DiagnosisReport, says_what_its_probabilities_are_of) {
  const auto of = [](const Weighing& weighing) {
    Diagnosis d = made_up_diagnosis(Verdict::mostly, {cause({slipping_plies()}, 0.6)});
    d.weighing = weighing;
    return diagnosis_html(d, "Pipe");
  };
  using enum Weighing::Over;
  expect_parts(of({.over = singles}), {"were one of them all there is."});
  expect_parts(of({.over = standing_sets}), {"over the sets that explain the test."});
  expect_parts(of({.over = all_sets}), {"averaged over all sets that were tried."});
  expect_parts(
      of({.over = all_sets, .limited = true}),
      {"averaged over all sets that were tried, and no more than the share of the gap that "
       "what leads closes."});
}

// Readers of the words of before are told so by the version.
TEST(DiagnosisJson, has_a_version_and_a_ledger_of_the_contract) {
  const auto json = nlohmann::json::parse(diagnosis_json(of_five_effects(), "0.1"));
  EXPECT_EQ(json["version"], 2);
  EXPECT_EQ(json["verdict"], "several");
  const auto& ledger = json["ledger"];
  for (const char* key : {"gap", "readings", "explained", "explained_interval", "rows", "left_in"})
    EXPECT_TRUE(ledger.contains(key)) << key;
  double sum = 0;
  for (const auto& row : ledger["rows"]) {
    for (const char* key : {"what", "left", "effects", "share", "interval", "told_apart_by"})
      EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(row["effects"].empty(), row["left"] != "");
    sum += row["share"].get<double>();
  }
  EXPECT_NEAR(sum, 1, 1e-9);
  EXPECT_EQ(ledger["rows"][0]["effects"][0]["anywhere"], 0.99);
  EXPECT_EQ(ledger["rows"][8]["left"], "unexplained");
  EXPECT_EQ(ledger["rows"][1]["told_apart_by"], "weigh the part");
  EXPECT_EQ(ledger["rows"][0]["told_apart_by"], "");
  EXPECT_EQ(json["inclusion"][0]["effect"], "ply_slip");
  EXPECT_EQ(json["inclusion"][0]["probability"], 0.99);
  EXPECT_EQ(json["inclusion"][0]["places"][1]["place"], "hose, left");
  EXPECT_EQ(json["inclusion"][0]["places"][1]["probability"], 0.03);
  EXPECT_EQ(ledger["left_in"][0]["reading"], "frequency in y, peak 1");
}

} // namespace
