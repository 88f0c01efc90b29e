// What a run writes can be read again by those it is for: JSON and CSV readers, VTK.
#include "tests/sample_results.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include "io/report/report.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/json.hpp"
#include "io/tables/summary.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"
#include "io/write/vtu.hpp"
#include "io/write/write_results.hpp"
#include "run/results/computed_numbers.hpp"
#include "run/results/number_keys.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <tuple>

namespace {

using namespace plica;
using namespace plica::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ResultsJson, has_every_key_of_the_contract) {
  const Json json = Json::parse(results_json(sample()));
  for (const char* key : {"case", "plica_version", "model", "static", "modes", "verification",
                          "timing", "peak_memory", "title", "mesh_quality", "sensors", "comparison",
                          "variants", "assumptions", "warnings", "free_mass"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key : {"nodes", "elements", "dofs", "mass"}) {
    EXPECT_TRUE(json["model"][key].is_number()) << key;
  }
  for (const char* key : {"k_axial", "k_torsion"}) {
    EXPECT_TRUE(json["static"][key].is_number()) << key;
  }
  EXPECT_TRUE(json["static"]["k_transverse"]["x"].is_number());
  EXPECT_TRUE(json["static"]["k_bending"]["z"].is_number());
  EXPECT_EQ(json["static"]["end_stiffness"].size(), 12U);
  EXPECT_EQ(json["static"]["end_stiffness"][11].size(), 12U);
  EXPECT_EQ(json["modes"].size(), 7U);
  EXPECT_EQ(json["modes"][0]["effective_mass"].size(), 6U);
  EXPECT_EQ(json["modes"][0]["shape"], "axial");
  EXPECT_EQ(json["verification"]["inertia_count"], 7);
  EXPECT_EQ(json["verification"]["passed"], true);
}

TEST(ResultsJson, has_responses_stresses_and_error_bars) {
  const Json json = Json::parse(results_json(sample()));
  const Json& response = json["responses"][0];
  EXPECT_EQ(response["base"], "y");
  EXPECT_TRUE(response["force"].is_null());
  EXPECT_EQ(response["level"], 10);
  EXPECT_EQ(response["file"], "response_y.csv");
  EXPECT_EQ(response["peaks"][0]["sensor"], "mid");
  EXPECT_EQ(response["peaks"][0]["direction"], "y");
  EXPECT_EQ(response["random"]["bands"][0]["rms"][1]["value"], 105.5);
  EXPECT_EQ(json["stresses"][0]["von_mises"], 1e8);
  EXPECT_EQ(json["stresses"][0]["face"], "above");
  const Json& bar = json["error_bars"]["quantities"][0];
  EXPECT_EQ(bar["quantity"], "k_axial");
  EXPECT_EQ(bar["interval_90"][1], 80e3);
  EXPECT_EQ(bar["shares"]["parts.b.E"], 0.75);
}

TEST(ResultsJson, has_the_mesh_error_of_each_static_stiffness) {
  Results r = sample();
  r.mesh_choice = "refined";
  const Json json = Json::parse(results_json(r)), error = json["static"]["mesh_error"];
  EXPECT_EQ(error["k_axial"]["around"], -90);
  EXPECT_EQ(error["k_torsion"]["along"], 500);
  for (const char* pair : {"k_transverse", "k_bending"})
    for (const char* axis : {"x", "z"}) EXPECT_EQ(error[pair][axis]["along"], 0) << pair;
  EXPECT_EQ(json["model"]["mesh_choice"], "refined");
  r.error_bars = {};
  EXPECT_FALSE(Json::parse(results_json(r))["static"].contains("mesh_error"));
}

TEST(ResultsJson, gives_back_the_same_doubles) {
  Results r = sample();
  r.modes[0].frequency = std::nextafter(116.2, 117);
  r.modes[1].residual = 4.9406564584124654e-324;
  const Json json = Json::parse(results_json(r));
  EXPECT_EQ(json["static"]["k_axial"].get<double>(), r.statics->k_axial);
  EXPECT_EQ(json["modes"][0]["frequency"].get<double>(), r.modes[0].frequency);
  EXPECT_EQ(json["modes"][1]["residual"].get<double>(), r.modes[1].residual);
}

TEST(ResultsJson, writes_null_for_what_is_no_number) {
  Results r = sample();
  r.statics.reset();
  r.modes[0].damping = std::numeric_limits<double>::quiet_NaN();
  r.modes[0].effective_mass[2] = std::numeric_limits<double>::infinity();
  r.verification = {};
  const Json json = Json::parse(results_json(r));
  EXPECT_TRUE(json["static"].is_null());
  EXPECT_TRUE(json["modes"][0]["damping"].is_null());
  EXPECT_TRUE(json["modes"][0]["effective_mass"][2].is_null());
  EXPECT_TRUE(json["verification"]["inertia_count"].is_null());
}

TEST(ResultsJson, survives_text_that_is_no_utf8) {
  Results r = sample();
  r.title = "caf\xe9 \"tab\t\"";
  EXPECT_EQ(Json::parse(results_json(r))["title"], "caf\uFFFD \"tab\t\"");
}

TEST(ResultsCsv, quotes_commas_quotes_and_line_breaks_only) {
  EXPECT_EQ(csv_cell("plain text"), "plain text");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("1\" pipe"), "\"1\"\" pipe\"");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
}

TEST(ResultsCsv, heads_have_units_and_cells_all_digits) {
  const Results r = sample();
  EXPECT_TRUE(modes_csv(r).starts_with("mode,frequency [Hz],damping [fraction of critical],"));
  EXPECT_NE(modes_csv(r).find("\n2,183.4,0.0111,transverse 1 in x,transverse,x,1,1,0.3479,"),
            std::string::npos);
  EXPECT_NE(static_csv(r).find("axial [N/m]"), std::string::npos);
  EXPECT_NE(static_csv(r).find("65872.123456789"), std::string::npos);
  EXPECT_NE(static_csv(r).find("mesh error torsion [Nm/rad]"), std::string::npos);
  EXPECT_TRUE(static_csv(r).ends_with(",500\n")) << static_csv(r);
  EXPECT_NE(comparison_csv(r).find("\n\"mass, weighed\",kg,1.7096,0.0005,1.7093,"),
            std::string::npos);
  const std::string variants = variants_csv(r);
  EXPECT_NE(variants.find("axial stiffness [N/m]"), std::string::npos);
  EXPECT_NE(variants.find("\"one wall, \"\"solid\"\"\",parts.bellows.wall.bond = 1; "),
            std::string::npos);
  EXPECT_TRUE(variants.ends_with(",253800,261.6,362.7,\n")) << "no mass in the last variant";
}

// Numbers of one line.
std::vector<double> numbers_of(const std::string& csv, int line) {
  std::istringstream stream(csv);
  std::string text, cell;
  for (int i = 0; i <= line; ++i) std::getline(stream, text);
  std::istringstream cells(text);
  std::vector<double> numbers;
  while (std::getline(cells, cell, ',')) numbers.push_back(std::stod(cell));
  return numbers;
}

TEST(ResultsCsv, motion_and_densities_follow_from_the_acceleration) {
  const ResponseResult r = sample().responses[0];
  const std::complex<double> a = r.acceleration(4, 1);
  const std::vector<double> response = numbers_of(response_csv(r), 5);
  ASSERT_EQ(response.size(), 8U); // frequency, three complex channels, the sum
  EXPECT_EQ(response[0], r.hertz[4]);
  EXPECT_EQ(response[3], a.real());
  EXPECT_NEAR(response[7], std::hypot(std::abs(a), 1e-6), 1e-14);
  const std::vector<double> motion = numbers_of(motion_csv(r), 5);
  ASSERT_EQ(motion.size(), 10U);
  const double omega = 2 * pi * r.hertz[4];
  EXPECT_NEAR(motion[4], 10 * std::abs(a), 1e-12);
  EXPECT_NEAR(motion[5], 10 * std::abs(a) / omega, 1e-12);
  EXPECT_NEAR(motion[6], 10 * std::abs(a) / omega / omega, 1e-12);
  const std::vector<double> random = numbers_of(random_csv(r), 5);
  ASSERT_EQ(random.size(), 7U); // frequency, input, three channels, one complex cross density
  EXPECT_EQ(random[3], r.random->density(4, 1));
}

TEST(ResultsVtu, holds_the_stress_of_both_faces) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  Results r = sample();
  r.stresses[0].name = "1 mm axial";
  const std::string text = stress_vtu(r);
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  vtkDataArray* above = reader->GetOutput()->GetPointData()->GetArray("static above: 1 mm axial");
  ASSERT_NE(above, nullptr);
  EXPECT_EQ(above->GetTuple1(0), 1e8);
}

TEST(ResultsVtu, is_read_back_by_vtk_with_cells_thickness_and_shapes) {
  const Results r = sample();
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(modes_vtu(r));
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  ASSERT_EQ(grid.GetNumberOfPoints(), static_cast<vtkIdType>(r.mesh.nodes.size()));
  ASSERT_EQ(grid.GetNumberOfCells(), static_cast<vtkIdType>(r.mesh.quads.size() + r.lines.size()));
  EXPECT_EQ(grid.GetCellData()->GetArray("thickness")->GetTuple1(0), 0.0005);
  ASSERT_EQ(grid.GetPointData()->GetNumberOfArrays(), 7);
  vtkDataArray* shape = grid.GetPointData()->GetArray("mode 02: 183.4 Hz");
  ASSERT_NE(shape, nullptr);
  const int node = r.mesh.rings[9].nodes[5];
  EXPECT_EQ(shape->GetComponent(node, 0), r.shapes[1](node, 0));
  EXPECT_EQ(grid.GetPoint(node)[1], r.mesh.nodes[node].y());
}

TEST(ResultsVtu, refuses_a_shape_of_another_mesh) {
  Results r = sample();
  r.shapes[3].conservativeResize(5, 6);
  EXPECT_THROW(modes_vtu(r), std::invalid_argument);
  EXPECT_THROW(report_html(r), std::invalid_argument);
}

TEST(TextTable, has_columns_as_wide_as_their_widest_cell) {
  EXPECT_EQ(text_table({{"", "unit", "Hz"}, {"bellows", "°C", "9.5", "note"}, {}, {"a", "", "100"}},
                       "<<><"),
            "            unit    Hz\n"
            "  bellows   °C     9.5   note\n"
            "\n"
            "  a                100\n");
  EXPECT_EQ(text_table({{"1", "10"}, {"200", "3"}}, ">"), "    1   10\n  200    3\n");
  EXPECT_EQ(text_table({}, "<"), "");
}

TEST(Summary, says_the_headline_the_proof_and_where_the_report_is) {
  const std::string text = summary_text(sample(), "out/report.html");
  EXPECT_TRUE(std::regex_search(
      text, std::regex(R"(axial stiffness +kN/m +54\.37 +0\.90 +65\.87 +\+21\.2 )")))
      << text;
  EXPECT_NE(text.find("transverse 1 in x"), std::string::npos);
  EXPECT_NE(text.find("inertia counts 7 modes below 410.2 Hz and 7 were found"), std::string::npos);
  EXPECT_TRUE(text.ends_with("Report: out/report.html\n"));
}

TEST(Headline, takes_the_lowest_mode_of_each_shape) {
  Results r = sample();
  std::swap(r.modes[0], r.modes[3]);
  const auto numbers = headline(r);
  EXPECT_EQ(numbers.at("f_axial"), 131.26);
  EXPECT_EQ(numbers.at("f_transverse"), 183.4);
  EXPECT_EQ(numbers.at("k_axial"), r.statics->k_axial);
  EXPECT_EQ(numbers.at("mass"), 1.7093);
  EXPECT_EQ(numbers.count("f_torsion"), 0U);
}

TEST(Headline, has_a_unit_for_each_result) {
  for (const auto& [path, unit] :
       std::map<std::string, std::string>{{"mass", "kg"},
                                          {"model.mass", "kg"},
                                          {"k_axial", "N/m"},
                                          {"headline.k_axial", "N/m"},
                                          {"static.k_transverse.x", "N/m"},
                                          {"static.k_bending.z", "Nm/rad"},
                                          {"k_torsion", "Nm/rad"},
                                          {"f_torsion", "Hz"},
                                          {"modes[0].frequency", "Hz"},
                                          {"life_road", "Pa"},
                                          {"headline.life_road", "Pa"},
                                          {"damage", ""},
                                          {"life.spots[0].damage", ""},
                                          {"modes[0].residual", ""}})
    EXPECT_EQ(unit_of_result(path), unit) << path;
}

TEST(NumberKeys, say_what_they_are_of) {
  using enum NumberKind;
  for (const auto& [key, kind, rest] : {std::tuple{"k_axial", stiffness, "axial"},
                                        {"f_transverse", frequency, "transverse"},
                                        {"life_road", stress_range, "road"},
                                        {"damage_road", damage, "road"},
                                        {"life_damage", stress_range, "damage"}}) {
    EXPECT_EQ(number_key::kind_of(key), kind) << key;
    EXPECT_EQ(number_key::rest_of(key), rest) << key;
    EXPECT_EQ(number_key::of(kind, rest), key);
  }
  EXPECT_EQ(number_key::kind_of("damage"), damage);
  EXPECT_EQ(number_key::kind_of("mass"), mass);
  for (const char* other : {"damages", "parts.k_axial", "lifetime"})
    EXPECT_EQ(number_key::kind_of(other), NumberKind::other) << other;
}

TEST(Numbers, keep_integer_digits_and_drop_what_is_not_finite) {
  EXPECT_EQ(significant(54365.4, 3), "54365");
  EXPECT_EQ(significant(116.2, 4), "116.2");
  EXPECT_EQ(significant(2.1e-9, 2), "2.1e-09");
  EXPECT_EQ(significant(std::nan(""), 3), "-");
  EXPECT_EQ(grouped(-1234567, " "), "-1 234 567");
}

TEST(WriteResults, writes_all_files_and_the_same_bytes_twice) {
  const TemporaryFolder folder("output");
  const fs::path out = folder.path / "new" / "out";
  const auto write = [&] {
    written(out, [](OutputFolder& files) { write_results(sample(), files); });
  };
  write();
  std::map<std::string, std::string> first;
  for (const auto& file : fs::directory_iterator(out)) {
    first[file.path().filename().string()] = content_of(file.path());
  }
  EXPECT_EQ(first.size(), 18u);
  for (const char* name :
       {"results.json", "simulated.yaml", "responses.uff", "modes.csv", "static.csv",
        "comparison.csv", "variants.csv", "modes.vtu", "report.html", "response_y.csv",
        "motion_y.csv", "random_y.csv", "stress.csv", "stress_places.csv", "stress_meridian.csv",
        "stress.vtu", "error_bars.csv", manifest_name}) {
    EXPECT_FALSE(first[name].empty()) << name;
  }
  write();
  for (const auto& [name, content] : first) EXPECT_EQ(content_of(out / name), content) << name;
}

TEST(WriteResults, says_which_folder_cannot_be_written) {
  const TemporaryFolder folder("output");
  const fs::path file = folder.path / "a_file";
  std::ofstream(file) << "old";
  for (const fs::path& out : {file, file / "below"}) {
    try {
      written(out, [](OutputFolder& files) { write_results(sample(), files); });
      ADD_FAILURE() << out;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(out.string()), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(content_of(file), "old");
}

TEST(WriteResults, leaves_old_files_alone_when_one_cannot_be_written) {
  const TemporaryFolder folder("output");
  std::ofstream(folder.path / "results.json") << "old";
  fs::create_directories(folder.path / "report.html");
  EXPECT_THROW(written(folder.path, [](OutputFolder& out) { write_results(sample(), out); }),
               InputError);
  EXPECT_EQ(content_of(folder.path / "results.json"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()), 2);
}

} // namespace
