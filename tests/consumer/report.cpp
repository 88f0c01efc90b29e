// The page of a run: what a case is called cannot become a tag, and nothing is fetched from
// outside.
#include "plica/io/report/report.hpp"
#include "expect.hpp"
#include "plica/io/report/drafting.hpp"
#include "plica/io/report/markup.hpp"

int main() {
  using namespace plica;
  Results results;
  results.case_name = "rod";
  results.title = "<script>alert(1)</script> & \"more\"";
  ModeResult mode;
  mode.frequency = 116.2345;
  mode.shape = "axial";
  mode.order = 1;
  results.modes = {mode};
  const std::string page = report_html(results);
  const auto has = [&](const char* text) { return page.find(text) != std::string::npos; };
  expect(page.starts_with("<!DOCTYPE html>") && has("</html>"), "a page of HTML");
  expect(has("<section id=\"modes\"") && has("116.2"), "the mode in its section");
  expect(!has("<script>alert") && has("&lt;script&gt;alert(1)&lt;/script&gt; &amp; "), "escaped");
  expect(!has("src=\"http") && !has("href=\"http") && !has("@import"), "one page without others");

  const auto same = [](const std::string& text, const std::string& expected) {
    expect(text == expected, ("\"" + text + "\" is \"" + expected + "\"").c_str());
  };
  same(html_number(-54365, 4), "\u221254365");
  same(html_number(NAN, 4), dash);
  same(html_unit("m/s2"), "m/s²");
  same(drawn_length(0.00658), "6.58");
  return differs;
}
