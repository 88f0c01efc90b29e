// What a run writes can be read again by those it is for: JSON and CSV readers, VTK, a browser.
#include "io/report.hpp"
#include "io/report_markup.hpp"
#include "io/report_surface.hpp"
#include "io/results_csv.hpp"
#include "io/results_json.hpp"
#include "io/results_text.hpp"
#include "io/results_vtu.hpp"
#include "io/summary.hpp"
#include "io/write_results.hpp"

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
#include <numbers>

namespace {

using namespace plica;
using Json = nlohmann::json;
namespace fs = std::filesystem;
constexpr double pi = std::numbers::pi;

// A corrugated tube along y between two plain cuffs, `per` rings per convolution.
Mesh corrugated_tube(int convolutions, int per, int around) {
  constexpr double pitch = 0.0066, cuff = 0.0042, low = 0.065, height = 0.008;
  Mesh mesh;
  const int rings = convolutions * per + 3;
  for (int i = 0; i < rings; ++i) {
    const double phase = std::clamp<double>(i - 1, 0, convolutions * per) / per;
    const double end = i == 0 ? -cuff / 2 : i == rings - 1 ? cuff / 2 : 0;
    Ring ring{
        cuff / 2 + end + phase * pitch, low + height * (1 - std::cos(2 * pi * phase)) / 2, {}};
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * pi * j / around;
      ring.nodes.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.emplace_back(ring.radius * std::cos(angle), ring.y, ring.radius * std::sin(angle));
    }
    mesh.rings.push_back(ring);
  }
  for (int i = 0; i + 1 < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      ShellQuad quad;
      quad.nodes = {mesh.rings[i].nodes[j], mesh.rings[i + 1].nodes[j],
                    mesh.rings[i + 1].nodes[(j + 1) % around],
                    mesh.rings[i].nodes[(j + 1) % around]};
      quad.directors.setZero();
      quad.thickness.setConstant(0.0005);
      mesh.quads.push_back(quad);
    }
  }
  return mesh;
}

// Half waves along the tube; n waves around for a shell mode.
Eigen::MatrixXd wave(const Mesh& mesh, const ModeResult& mode) {
  const double length = mesh.rings.back().y;
  Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(static_cast<int>(mesh.nodes.size()), 6);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Eigen::Vector3d& p = mesh.nodes[i];
    const double angle = std::atan2(p.z(), p.x());
    const double along = std::sin(std::max(mode.order, 1) * pi * p.y() / length);
    Eigen::Vector3d u(0, along, 0);
    if (mode.shape == "transverse")
      u = mode.direction == "x" ? Eigen::Vector3d(along, 0, 0) : Eigen::Vector3d(0, 0, along);
    if (mode.shape == "shell") {
      u = along * std::cos(mode.harmonic * angle) * Eigen::Vector3d(p.x(), 0, p.z()) / 0.07;
    }
    shape.row(static_cast<int>(i)).head<3>() = u.transpose();
  }
  return shape;
}

ModeResult mode_of(double frequency, const std::string& shape, const std::string& direction,
                   int order, int harmonic) {
  ModeResult mode;
  mode.frequency = frequency;
  mode.damping = 0.0111;
  mode.shape = shape;
  mode.direction = direction;
  mode.order = order;
  mode.harmonic = harmonic;
  mode.residual = 2.1e-10;
  if (shape == "axial") mode.effective_mass = {1e-19, 0.3512 / order, 0, 0, 2e-17, 0};
  if (direction == "x") mode.effective_mass = {0.3479, 0, 1e-17, 0, 0, 0.00112};
  if (direction == "z") mode.effective_mass = {1e-17, 0, 0.3479, 0.00112, 0, 0};
  return mode;
}

void add_words(Results& r) {
  r.case_name = "bellow_a2";
  r.title = "Bellows A2 <clamped> & \"welded\", 27 convolutions";
  r.plica_version = "0.1.0";
  r.assumptions = {"Height 8 mm: the thesis gives the mean radius to 1 mm only.",
                   "Two plies of 0.25 mm, slipping; the thesis says so of A1 only."};
  r.warnings = {"sensor 'mid' sits 1.3 mm from its place <script>alert(1)</script>"};
  r.comparison = {{"axial stiffness", "N/m", 54365, 900, 65872},
                  {"axial mode 1", "Hz", 116, 1, 131.26},
                  {"transverse mode 1", "Hz", 178, 1, 183.4},
                  {"mass, weighed", "kg", 1.7096, 0.0005, 1.7093}};
  r.variants = {{"height 7 mm",
                 {{"parts.bellows.profile[1].height", "7 mm"}},
                 {{"k_axial", 94100}, {"f_axial", 158.2}, {"f_transverse", 214}, {"mass", 1.69}}},
                {"one wall, \"solid\"",
                 {{"parts.bellows.wall.bond", "1"}, {"parts.bellows.wall.plies", "[0.5 mm]"}},
                 {{"k_axial", 253800}, {"f_axial", 261.6}, {"f_transverse", 362.7}}}};
  r.timing = {{"mesh", 0.31}, {"assembly", 0.92}, {"factor", 1.7}, {"modes", 3.44}, {"proof", 1.2}};
  r.peak_memory = 812e6;
}

Results sample(int convolutions = 3, int per = 8, int around = 24) {
  Results r;
  add_words(r);
  r.mesh = corrugated_tube(convolutions, per, around);
  r.model = {static_cast<int>(r.mesh.nodes.size()), static_cast<int>(r.mesh.quads.size()),
             6 * static_cast<int>(r.mesh.nodes.size()), 1.7093};
  r.quality = {0.0021, 3.4, 2.1, 0.83};
  r.statics.emplace();
  r.statics->k_axial = 65872.123456789012;
  r.statics->k_transverse_x = r.statics->k_transverse_z = 91230;
  r.statics->k_bending_x = r.statics->k_bending_z = 141.2;
  r.statics->k_torsion = 142300;
  r.statics->end_stiffness.setIdentity();
  r.modes = {mode_of(131.26, "axial", "y", 1, 0),     mode_of(183.4, "transverse", "x", 1, 1),
             mode_of(183.4, "transverse", "z", 1, 1), mode_of(262.1, "axial", "y", 2, 0),
             mode_of(341.7, "shell", "", 0, 3),       mode_of(341.7, "shell", "", 0, 3),
             mode_of(400.9, "transverse", "x", 2, 1)};
  for (const ModeResult& mode : r.modes) r.shapes.push_back(wave(r.mesh, mode));
  r.free_mass = {0.4331, 0.4331, 0.4331, 0.00201, 0.00173, 0.00201};
  r.effective_mass_sum = {0.4101, 0.4198, 0.4101, 0.0017, 0.0011, 0.0017};
  r.verification = {true, 410.2, 7, 7, 3.4e-10, 2.2e-14, true, ""};
  r.sensors = {{"mid", static_cast<int>(r.mesh.nodes.size()) / 2 + around / 8, 0.0013}};
  r.lines = {{r.mesh.rings.front().nodes[0], r.mesh.rings[1].nodes[0]}};
  for (const Ring& ring : r.mesh.rings) r.meridian.push_back({ring.y, ring.radius});
  return r;
}

struct TemporaryFolder {
  fs::path path;
  TemporaryFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path = fs::path(testing::TempDir()) / (std::string("plica_output_") + test->name());
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~TemporaryFolder() { fs::remove_all(path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Every opened tag is closed in order; the first offence, or nothing.
std::string unbalanced_tag(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return html.substr(at);
    const bool closes = html[at + 1] == '/', is_empty = html[end - 1] == '/';
    const std::size_t from = at + 1 + closes;
    const std::string name = html.substr(from, html.find_first_of(" />", from) - from);
    if (closes) {
      if (open.empty() || open.back() != name) return "</" + name + ">";
      open.pop_back();
    } else if (!is_empty && name != "meta" && name != "!DOCTYPE") {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : "<" + open.back() + ">";
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
  EXPECT_NE(comparison_csv(r).find("\n\"mass, weighed\",kg,1.7096,0.0005,1.7093,"),
            std::string::npos);
  const std::string variants = variants_csv(r);
  EXPECT_NE(variants.find("axial stiffness [N/m]"), std::string::npos);
  EXPECT_NE(variants.find("\"one wall, \"\"solid\"\"\",parts.bellows.wall.bond = 1; "),
            std::string::npos);
  EXPECT_TRUE(variants.ends_with(",253800,261.6,362.7,\n")) << "no mass in the last variant";
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

TEST(Report, escapes_text_of_the_case) {
  EXPECT_EQ(html_escape("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  const std::string html = report_html(sample());
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;alert(1)&lt;/script&gt;"), std::string::npos);
  EXPECT_NE(html.find("Bellows A2 &lt;clamped&gt; &amp; &quot;welded&quot;"), std::string::npos);
}

TEST(Report, closes_every_tag_whatever_is_missing) {
  EXPECT_EQ(unbalanced_tag(report_html(sample())), "");
  EXPECT_EQ(unbalanced_tag(report_html(Results{})), "");
  Results r = sample();
  r.shapes.clear();
  r.meridian = {{0, 0.065}, {0.1, 0.065}};
  r.comparison.clear();
  r.mesh.rings.clear();
  r.verification = {true, 410.2, 8, 7, 3.4e-10, 2.2e-14, false, "one mode is missing"};
  const std::string html = report_html(r);
  EXPECT_EQ(unbalanced_tag(html), "");
  EXPECT_NE(html.find("one mode is missing"), std::string::npos);
}

TEST(Report, draws_a_shape_with_holes) {
  Results r = sample();
  r.shapes[0](7, 1) = std::numeric_limits<double>::quiet_NaN();
  r.shapes[1].setZero();
  const std::string html = report_html(r);
  EXPECT_EQ(html.find("nan"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(html), "");
}

TEST(Report, needs_no_other_file) {
  const std::string html = report_html(sample());
  for (const char* part : {"http:", "https:", "src=", "@import", "<link", "url(//"}) {
    EXPECT_EQ(html.find(part), std::string::npos) << part;
  }
}

TEST(Report, of_a_fine_mesh_keeps_every_convolution_and_stays_below_3_MB) {
  const Results fine = sample(40, 24, 96);
  const auto quads = drawn_quads(fine.mesh, 4000);
  EXPECT_LE(quads.size(), 4000U);
  int crowns = 0, roots = 0;
  for (const auto& quad : quads) {
    const Eigen::Vector3d& node = fine.mesh.nodes[quad[1]];
    const double radius = std::hypot(node.x(), node.z());
    crowns += radius > 0.0729;
    roots += radius < 0.0651;
  }
  EXPECT_GE(crowns, 40 * 36);
  EXPECT_GE(roots, 39 * 36);
  EXPECT_LT(report_html(fine).size(), 3000000U);
}

TEST(Report, thins_out_a_fine_mesh_without_rings) {
  Results fine = sample(20, 16, 64);
  fine.mesh.rings.clear();
  const auto quads = drawn_quads(fine.mesh, 4000);
  EXPECT_LE(quads.size(), 4000U);
  EXPECT_GT(quads.size(), 1500U);
}

TEST(Summary, says_the_headline_the_proof_and_where_the_report_is) {
  const std::string text = summary_text(sample(), "out/report.html");
  EXPECT_NE(text.find("axial stiffness    kN/m     54.37    0.90     65.87        +21.2"),
            std::string::npos)
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

TEST(Numbers, keep_integer_digits_and_drop_what_is_not_finite) {
  EXPECT_EQ(significant(54365.4, 3), "54365");
  EXPECT_EQ(significant(116.2, 4), "116.2");
  EXPECT_EQ(significant(2.1e-9, 2), "2.1e-09");
  EXPECT_EQ(significant(std::nan(""), 3), "-");
  EXPECT_EQ(grouped(-1234567, " "), "-1 234 567");
}

TEST(WriteResults, writes_all_files_and_the_same_bytes_twice) {
  const TemporaryFolder folder;
  const fs::path out = folder.path / "new" / "out";
  write_results(sample(), out);
  std::map<std::string, std::string> first;
  for (const auto& file : fs::directory_iterator(out)) {
    first[file.path().filename().string()] = content_of(file.path());
  }
  EXPECT_EQ(first.size(), 7U);
  for (const char* name : {"results.json", "modes.csv", "static.csv", "comparison.csv",
                           "variants.csv", "modes.vtu", "report.html"}) {
    EXPECT_FALSE(first[name].empty()) << name;
  }
  write_results(sample(), out);
  for (const auto& [name, content] : first) EXPECT_EQ(content_of(out / name), content) << name;
}

TEST(WriteResults, says_which_folder_cannot_be_written) {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "a_file";
  std::ofstream(file) << "old";
  for (const fs::path& out : {file, file / "below"}) {
    try {
      write_results(sample(), out);
      ADD_FAILURE() << out;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(out.string()), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(content_of(file), "old");
}

TEST(WriteResults, leaves_old_files_alone_when_one_cannot_be_written) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "results.json") << "old";
  fs::create_directories(folder.path / "report.html");
  EXPECT_THROW(write_results(sample(), folder.path), std::runtime_error);
  EXPECT_EQ(content_of(folder.path / "results.json"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()), 2);
}

} // namespace
