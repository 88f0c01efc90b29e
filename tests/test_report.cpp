// The report: well formed whatever is missing, complete in itself, small.
#include "tests/sample_results.hpp"

#include "io/report/markup.hpp"
#include "io/report/phase.hpp"
#include "io/report/report.hpp"
#include "io/report/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace plica;
using namespace plica::test;

// Every opened tag is closed in order; the first offence, or nothing.
std::string unbalanced_tag(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
    std::size_t end = html.find('>', at);
    if (end == std::string::npos) return html.substr(at);
    if (html.compare(at, 7, "<script") == 0) { // what is in it is not HTML
      end = html.find("</script>", end);
      if (end == std::string::npos) return "<script>";
      at = end + 9;
      continue;
    }
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

// The page without what its scripts hold: tests/browser looks at those.
std::string without_scripts(std::string html) {
  for (std::size_t at = 0; (at = html.find("<script", at)) != std::string::npos; ++at)
    html.erase(at, html.find("</script>", at) - at);
  return html;
}

TEST(Report, escapes_text_of_the_case) {
  EXPECT_EQ(html_escape("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  const std::string html = report_html(sample());
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
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
  r.verification = {true, 410.2, 8, 7, 3.4e-10, 2.2e-14, 1.3e-9, false, "one mode is missing", ""};
  const std::string html = report_html(r);
  EXPECT_EQ(unbalanced_tag(html), "");
  EXPECT_NE(html.find("one mode is missing"), std::string::npos);
}

// 170 degrees to 190: the line reaches 180 half way, is broken and comes in at -180; half a turn,
// at a resonance, is drawn; what is not finite is a gap.
TEST(Report, breaks_a_phase_where_it_wraps) {
  const double pi = std::numbers::pi;
  PlotCurve magnitude{.x = Eigen::VectorXd::LinSpaced(6, 0, 5), .y = {}, .name = "a"};
  Eigen::VectorXd radians(6);
  radians << 170, -170, -175, 0, 180, std::nan("");
  const PlotCurve phase = phase_curve(magnitude, radians * pi / 180);
  ASSERT_EQ(phase.x.size(), 9);
  EXPECT_NEAR(phase.x[1], 0.5, 1e-12);
  EXPECT_NEAR(phase.y[1], 180, 1e-12);
  EXPECT_TRUE(std::isnan(phase.y[2]));
  EXPECT_NEAR(phase.y[3], -180, 1e-12);
  EXPECT_NEAR(phase.y[4], -170, 1e-9);
  EXPECT_TRUE(std::isnan(phase.y[8]));
  for (Eigen::Index i = 1; i < phase.y.size(); ++i)
    if (const double step = std::abs(phase.y[i] - phase.y[i - 1]); std::isfinite(step)) {
      EXPECT_LE(step, 180 + 1e-9);
    }
  const std::string html = phase_figure({.label = "r", .ordinate = ""}, {phase});
  EXPECT_EQ(html.find("nan"), std::string::npos);
  std::size_t pieces = 0;
  for (auto at = html.find("<polyline"); at != std::string::npos;
       at = html.find("<polyline", at + 1))
    ++pieces;
  EXPECT_EQ(pieces, 2u);
  // Between two ends of the scale nothing is to be drawn.
  radians << 180, -180, 180, -180, 180, -180;
  const PlotCurve flipping = phase_curve(magnitude, radians * pi / 180);
  for (Eigen::Index i = 1; i < flipping.y.size(); ++i)
    if (const double step = std::abs(flipping.y[i] - flipping.y[i - 1]); std::isfinite(step)) {
      EXPECT_LE(step, 180 + 1e-9);
    }
  EXPECT_TRUE(phase_figure({.label = "r", .ordinate = ""}, {}).empty());
}

// The largest deviation from the test stands before all else, the mode that shows it is drawn.
TEST(Report, begins_with_what_is_farthest_from_the_test) {
  const std::string html = report_html(sample());
  const std::size_t farthest = html.find("Farthest from the test: axial stiffness");
  ASSERT_NE(farthest, std::string::npos);
  EXPECT_LT(farthest, html.find("class=\"viewer\""));
  EXPECT_EQ(html.find("class=\"verdict"), html.rfind("class=\"verdict", farthest));
  EXPECT_NE(html.find("Drawn: mode 1, axial 1"), std::string::npos);
  EXPECT_NE(html.find("\"first\":0,\"glb\""), std::string::npos);
  EXPECT_NE(html.find("class=\"still\""), std::string::npos);
  Results r = sample();
  r.comparison.clear();
  EXPECT_EQ(report_html(r).find("\"first\":"), std::string::npos);
}

TEST(Report, draws_a_shape_with_holes) {
  Results r = sample();
  r.shapes[0](7, 1) = std::numeric_limits<double>::quiet_NaN();
  r.shapes[1].setZero();
  const std::string html = report_html(r);
  EXPECT_EQ(without_scripts(html).find("nan"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(html), "");
}

TEST(Report, needs_no_other_file) {
  const std::string html = without_scripts(report_html(sample()));
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

// A bushing between two nodes at one place.
TEST(Report, draws_a_part_that_has_no_extent) {
  Results point = sample();
  for (Eigen::Vector3d& x : point.mesh.nodes) x = {10, 15, 7};
  EXPECT_EQ(unbalanced_tag(report_html(point)), "");
}

TEST(Report, shows_responses_stress_and_error_bars) {
  const std::string html = report_html(sample());
  for (const char* part :
       {"Base moved in y", "131.3", "Under the random input of the case", "1 mm &lt;axial&gt;",
        "parts.a&lt;b.height 25 %", "What this model cannot show", "z &amp; x"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

} // namespace
