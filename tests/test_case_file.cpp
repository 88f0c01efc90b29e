// The case file: what is wrong in it is said exactly, what is right in it is read.
//
// tests/broken_cases holds one file per mistake and, beside it, the exact text of the error; names
// that begin with "measured_" are files of measured data, except measured_missing.yaml.
#include "io/input/benchmark_file.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/input/yaml_path.hpp"
#include "io/input/yaml_tree.hpp"
#include "lab/measured/measured_fields.hpp"
#include "model/description/node_sets.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/did_you_mean.hpp"
#include "words/units.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <sstream>

namespace plica {
namespace {

namespace fs = std::filesystem;

const fs::path source = PLICA_SOURCE_DIR;
const fs::path a2 = source / "cases/bellow_a2/bellow_a2.yaml";

std::vector<fs::path> yaml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool is_measured(const fs::path& path) {
  const std::string name = path.filename();
  return name == "measured.yaml" ||
         (name.starts_with("measured_") && name != "measured_missing.yaml");
}

// The problems of a file, one per line, with its name without folder; empty if it is good.
std::string problems_of(const fs::path& path) {
  try {
    if (is_measured(path))
      read_measured(path);
    else if (is_benchmark(path))
      read_benchmark(path);
    else
      read_case(path);
  } catch (const InputError& error) {
    std::string text;
    for (InputProblem problem : error.problems()) {
      problem.file = fs::path(problem.file).filename();
      text += to_string(problem) + "\n";
    }
    return text;
  }
  return "";
}

TEST(BrokenCase, every_file_gives_exactly_the_expected_error) {
  int files = 0;
  for (const fs::path& path : yaml_files(source / "tests/broken_cases")) {
    fs::path expected = path;
    expected.replace_extension(".expected");
    EXPECT_EQ(problems_of(path), text_of(expected)) << path;
    EXPECT_FALSE(text_of(expected).empty()) << expected << " is missing or empty";
    ++files;
  }
  EXPECT_GE(files, 45);
}

TEST(BrokenCase, missing_file_and_directory_are_named) {
  EXPECT_EQ(problems_of(source / "nowhere.yaml"),
            "nowhere.yaml: file not found; give the path of a YAML file\n");
  EXPECT_EQ(problems_of(source / "cases"), "cases: is a directory; give the path of a YAML file\n");
}

// A file cut anywhere or with a byte changed is read, or refused by its own lines.
TEST(BrokenCase, cut_or_with_a_changed_byte_is_read_or_refused_by_its_lines) {
  const std::string good = text_of(a2);
  const test::TemporaryFolder folder("cut_case");
  const fs::path path = folder.path / "case.yaml";
  fs::copy_file(a2.parent_path() / "measured.yaml", folder.path / "measured.yaml");
  int read = 0, refused = 0;
  const auto try_text = [&](const std::string& text) {
    std::ofstream(path) << text;
    const std::string problems = problems_of(path);
    ++(problems.empty() ? read : refused);
    std::istringstream lines(problems);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(line.starts_with("case.yaml:")) << line;
  };
  for (std::size_t n = 0; n < good.size(); n += 61) try_text(good.substr(0, n));
  for (std::size_t i = 1500; i < good.size(); i += 17) {
    std::string changed = good;
    changed[i] = "[]{}:,-\"'#&*!|>%@`\n0.x"[i % 22];
    try_text(changed);
  }
  std::printf("%d read, %d refused\n", read, refused);
  EXPECT_GT(read, 100); // comments, numbers, sections that are not missed
  EXPECT_GT(refused, 100);
}

TEST(ShippedCases, all_are_read_without_a_problem) {
  int cases = 0;
  for (const fs::path& path : yaml_files(source / "cases")) {
    EXPECT_EQ(problems_of(path), "") << path;
    ++cases;
  }
  EXPECT_GE(cases, 17);
}

TEST(ShippedCases, measured_data_belong_to_the_case_beside_them) {
  int compared = 0;
  for (const fs::path& path : yaml_files(source / "cases")) {
    if (is_measured(path) || is_benchmark(path)) continue;
    const Case data = read_case(path).data;
    EXPECT_EQ(data.name, path.stem().string());
    if (data.measured.empty()) continue;
    EXPECT_EQ(read_measured(path.parent_path() / data.measured).specimen, data.name);
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

TEST(ReadCase, a2_has_the_numbers_of_its_file_in_si) {
  const CaseFile file = read_case(a2);
  const Case& data = file.data;
  EXPECT_EQ(data.materials.at("steel").E, 193e9);
  const auto& bellows = std::get<Bellows>(data.parts.at(0).body);
  EXPECT_DOUBLE_EQ(bellows.root_radius, 0.065);
  ASSERT_EQ(bellows.profile.size(), 3u);
  EXPECT_EQ(bellows.profile[1].shape, SectionShape::u);
  EXPECT_EQ(bellows.profile[1].count, 27);
  EXPECT_EQ(bellows.wall.plies, (std::vector<double>{0.25e-3, 0.25e-3}));
  EXPECT_EQ(bellows.wall.bond, 0);
  EXPECT_EQ(bellows.mesh.accuracy, 0.01);
  EXPECT_EQ(std::get<Interlock>(data.parts.at(1).body).attachment, Attachment::synchronous);
  ASSERT_EQ(data.mount.size(), 2u);
  EXPECT_EQ(data.mount[0].kind, MountKind::rigid);
  EXPECT_EQ(data.analyses.modes->count, 12);
  EXPECT_EQ(data.variants.at(2).set.at("parts.bellows.wall.plies"), "[0.5 mm]");
}

TEST(ReadCase, every_key_knows_its_line) {
  const CaseFile file = read_case(a2);
  std::ifstream stream(a2);
  std::vector<std::string> lines{""};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto line = [&](const char* key) { return lines.at(file.lines.at(key)); };
  EXPECT_NE(line("parts.bellows.profile[1].height").find("height: 8 mm"), std::string::npos);
  EXPECT_NE(line("parts.bellows.wall.plies[1]").find("0.25 mm"), std::string::npos);
  EXPECT_NE(line("mount.left").find("left: rigid"), std::string::npos);
}

TEST(ReadCase, overrides_replace_and_add_values) {
  const Case data = read_case(a2, {},
                              {{"parts.bellows.profile[1].height", "7 mm"},
                               {"parts.bellows.wall.plies", "[0.5 mm]"},
                               {"parts.interlock.GJ", "14 N m2"}})
                        .data;
  const auto& bellows = std::get<Bellows>(data.parts.at(0).body);
  EXPECT_DOUBLE_EQ(bellows.profile[1].height, 7e-3);
  EXPECT_EQ(bellows.wall.plies.size(), 1u);
  EXPECT_EQ(std::get<Interlock>(data.parts.at(1).body).GJ, 14);
}

TEST(ReadCase, every_variant_of_the_shipped_cases_can_be_read_by_itself) {
  int variants = 0;
  for (const fs::path& path : yaml_files(source / "cases")) {
    if (is_measured(path) || is_benchmark(path)) continue;
    const Case nominal = read_case(path).data;
    std::vector<std::string> models{""};
    for (const AlternativeModel& model : nominal.models) models.push_back(model.name);
    for (const std::string& model : models)
      for (const Variant& variant : read_case(path, model).data.variants) {
        EXPECT_EQ(read_case(path, model, variant.set).data.name, nominal.name)
            << path << " " << variant.name;
        ++variants;
      }
  }
  EXPECT_GE(variants, 3); // those of bellow_a2
}

TEST(ReadCase, a_model_replaces_the_sections_it_has_and_keeps_the_others) {
  const Case shell = read_case(a2).data, pipe = read_case(a2, "pipe").data;
  EXPECT_EQ(pipe.model, "pipe");
  ASSERT_EQ(pipe.parts.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<EquivalentPipe>(pipe.parts[0].body));
  EXPECT_EQ(pipe.caps[0].mass, 0);
  EXPECT_GT(shell.caps[0].mass, 0);
  EXPECT_EQ(pipe.mount.size(), shell.mount.size());
  EXPECT_EQ(pipe.sensors[0].name, "mid");
  EXPECT_TRUE(pipe.tolerances.empty());
  EXPECT_EQ(shell.tolerances.size(), 3U);
  EXPECT_FALSE(pipe.fit);
  EXPECT_TRUE(read_case(a2, "pipe_fitted").data.fit);
  try {
    read_case(a2, "pip");
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("did you mean 'pipe'?"), std::string::npos) << e.what();
  }
}

// A fitted number with a tolerance has its limits as bounds; variants and tolerances beyond the
// bounds are no matter of the fit.
TEST(ReadCase, takes_the_bounds_of_a_fit_from_a_tolerance) {
  const test::TemporaryFolder folder("fit_case");
  const fs::path path = folder.path / "case.yaml";
  std::string text = text_of(a2);
  text = text.substr(0, text.find("\nmodels:")) +
         "\nfit:\n  parameters:\n"
         "    - {path: \"parts.bellows.profile[1].height\"}\n"
         "    - {path: parts.interlock.mass, bounds: [0.3 kg, 0.5 kg]}\n"
         "  ties:\n"
         "    - {path: caps.right.mass, of: {caps.left.mass: 1}}\n"
         "    - {path: caps.left.mass, constant: 0.39, of: {parts.interlock.mass: -0.5}}\n";
  std::ofstream(path) << text;
  EXPECT_EQ(problems_of(path), "");
  const Case data = read_case(path).data;
  ASSERT_TRUE(data.fit);
  EXPECT_NEAR(data.fit->parameters[0].bounds[0], 7e-3, 1e-12);
  EXPECT_NEAR(data.fit->parameters[0].bounds[1], 9e-3, 1e-12);
  EXPECT_EQ(data.fit->ties[0].path, "caps.left.mass"); // before the one that follows it
  std::ofstream(path) << text
                      << "    - {path: parts.interlock.radius, of: {parts.interlock.radius: 2}}\n";
  EXPECT_NE(problems_of(path).find("in a circle"), std::string::npos);
}

TEST(ReadBenchmark, says_what_is_wrong) {
  const test::TemporaryFolder folder("benchmark");
  const fs::path path = folder.path / "benchmark.yaml";
  std::ofstream(path) << "benchmark: b\ntables:\n  - table: 1\n    title: t\n    case: no.yaml\n"
                         "    columns: [{name: pipe}]\n"
                         "    rows: [{label: a, quantity: mass, only: pip, colour: red}]\n";
  EXPECT_TRUE(is_benchmark(path));
  EXPECT_FALSE(is_benchmark(a2));
  const std::string problems = problems_of(path);
  for (const char* text :
       {"there is no file 'no.yaml'", "did you mean 'pipe'", "colour: unknown key"})
    EXPECT_NE(problems.find(text), std::string::npos) << problems;
}

TEST(ReadCase, an_override_that_does_not_exist_is_an_error) {
  try {
    read_case(a2, {}, {{"parts.belows.root_radius", "60 mm"}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'bellows'?"), std::string::npos);
  }
}

TEST(ReadMeasured, hose_b_has_the_ten_levels) {
  const Measured data = read_measured(source / "cases/hose_b/measured.yaml");
  ASSERT_EQ(data.peaks.size(), 2u);
  EXPECT_EQ(data.peaks[0].level.size(), 10u);
  EXPECT_EQ(data.peaks[0].frequency.back(), 78);
  EXPECT_EQ(data.statics.at(2).value, 17380);
  EXPECT_FALSE(data.statics.at(0).sigma.has_value());
}

TEST(Units, quantities_are_read_into_si) {
  const auto value = [](const char* text, Dimension dimension) {
    const ParsedQuantity q = parse_quantity(text, dimension);
    EXPECT_EQ(q.wrong, "") << text;
    return q.value;
  };
  EXPECT_DOUBLE_EQ(value("0.25 mm", Dimension::length), 0.25e-3);
  EXPECT_DOUBLE_EQ(value("0.25mm", Dimension::length), 0.25e-3);
  EXPECT_DOUBLE_EQ(value("+2e-3", Dimension::length), 2e-3);
  EXPECT_DOUBLE_EQ(value(".5 um", Dimension::length), 0.5e-6);
  EXPECT_DOUBLE_EQ(value("193 GPa", Dimension::pressure), 193e9);
  EXPECT_DOUBLE_EQ(value("54.4 kN/m", Dimension::stiffness), 54400);
  EXPECT_DOUBLE_EQ(value("2 %", Dimension::ratio), 0.02);
  EXPECT_DOUBLE_EQ(value("7 Nm/rad", Dimension::rotational_stiffness), 7);
  EXPECT_DOUBLE_EQ(value("1 Nm/deg", Dimension::rotational_stiffness), 57.29577951308232);
  EXPECT_DOUBLE_EQ(value("7850 kg/m3", Dimension::density), 7850);
  EXPECT_DOUBLE_EQ(value("7850 kg/m^3", Dimension::density), 7850);
  EXPECT_DOUBLE_EQ(value("7850 kg/m³", Dimension::density), 7850);
  EXPECT_DOUBLE_EQ(value("1 kg/m", Dimension::mass_per_length), 1);
  EXPECT_DOUBLE_EQ(value("180 deg", Dimension::angle), std::numbers::pi);
  EXPECT_DOUBLE_EQ(value("1.5 kHz", Dimension::frequency), 1500);
  EXPECT_DOUBLE_EQ(value("5 g", Dimension::mass), 5e-3);
  EXPECT_DOUBLE_EQ(value("1 g", Dimension::acceleration), 9.80665);
  EXPECT_DOUBLE_EQ(value("2 kg*m2", Dimension::inertia), 2);
  EXPECT_DOUBLE_EQ(value("10 kN", Dimension::force), 1e4);
  EXPECT_DOUBLE_EQ(value("3 N m2", Dimension::section_stiffness), 3);
}

TEST(Units, what_is_no_quantity_is_refused_with_the_allowed_units) {
  for (const char* text : {"", " ", "mm", "1,5 mm", "0x10", "1e999", "nan", "-inf", ".inf",
                           "1 mm mm", "--1", "+-1", "1 kg", "1 MM2", "1 mm/s", "1e", "1 \n2"})
    EXPECT_NE(parse_quantity(text, Dimension::length).wrong, "") << text;
  EXPECT_EQ(parse_quantity("5 kg", Dimension::length).wrong, "'5 kg' is a mass");
  EXPECT_EQ(parse_quantity("5 Mpa", Dimension::pressure).allowed,
            "did you mean 'MPa'? allowed: a pressure in Pa, kPa, MPa, GPa, N/mm2, bar or mbar "
            "(plain number: Pa)");
}

TEST(DidYouMean, distances_are_those_of_single_edits) {
  EXPECT_EQ(edit_distance("height", "height"), 0);
  EXPECT_EQ(edit_distance("heigth", "height"), 1); // two letters swapped
  EXPECT_EQ(edit_distance("hight", "height"), 1);
  EXPECT_EQ(edit_distance("Height", "height"), 0);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(DidYouMean, only_near_words_are_suggested) {
  const std::vector<std::string> words{"height", "pitch", "count"};
  EXPECT_EQ(nearest_word("heigt", words), "height");
  EXPECT_EQ(nearest_word("colour", words), "");
  EXPECT_EQ(nearest_word("", words), "");
  EXPECT_EQ(nearest_word(std::string(100000, 'a'), words), "");
  EXPECT_EQ(suggestion("x", words), "allowed: height, pitch, count");
}

TEST(YamlTree, written_values_are_read_back_as_they_were) {
  for (const char* text :
       {"{a: 1, b: [x, \"y: z\", ~], c: {d: 0.25 mm}}", "[\"- a\", \"\", \"true\", \"a\\nb\"]",
        "-5 mm", "\"# no comment\"", "[54.4 kN/m, 193 GPa, 2 %]", "\"null\"", "\"{\""}) {
    std::vector<InputProblem> problems;
    const std::string once = to_yaml(parse_yaml(text, "", problems));
    const std::string twice = to_yaml(parse_yaml(once, "", problems));
    EXPECT_TRUE(problems.empty()) << once;
    EXPECT_EQ(once, twice);
    EXPECT_EQ(once, text);
  }
}

TEST(SetNames, are_those_of_the_parts) {
  const std::vector<std::string> names = set_names(read_case(a2).data);
  for (const char* name : {"bellows.left", "bellows.convolution[27]", "bellows.root[28]",
                           "bellows.cuff.right", "interlock.start"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_EQ(std::find(names.begin(), names.end(), "bellows.crown[28]"), names.end());
}

} // namespace
} // namespace plica
