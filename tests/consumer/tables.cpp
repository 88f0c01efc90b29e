// The numbers of a run as words, as a table and as JSON, which keeps every bit.
#include "expect.hpp"
#include "plica/io/tables/csv.hpp"
#include "plica/io/tables/json.hpp"
#include "plica/io/tables/result_path.hpp"
#include "plica/io/tables/summary.hpp"
#include "plica/io/tables/text.hpp"

int main() {
  using namespace plica;
  Results results;
  results.case_name = "rod";
  ModeResult mode;
  mode.frequency = 0.1 + 0.2; // 0.3 would be other bits
  mode.shape = "transverse";
  mode.direction = "x";
  mode.order = 1;
  results.modes = {mode};

  const Json json = Json::parse(results_json(results));
  expect(number_in(json, "modes[0].frequency") == 0.1 + 0.2, "every bit of the frequency");
  expect(!number_in(json, "modes[1].frequency"), "there is no second mode");
  expect(modes_csv(results).find("0.30000000000000004") != std::string::npos, "all digits in CSV");
  expect(summary_text(results).find(mode_label(mode)) != std::string::npos, "the mode in words");

  const auto same = [](const std::string& text, const std::string& expected) {
    expect(text == expected, ("\"" + text + "\" is \"" + expected + "\"").c_str());
  };
  same(mode_label(mode), "transverse 1 in x");
  same(significant(54365.4, 4), "54365");
  same(significant(116.2345, 4), "116.2");
  same(with_sign(-0.04, 1), "0.0");
  same(grouped(125856, " "), "125 856");
  same(csv_cell("say \"no\", twice"), "\"say \"\"no\"\", twice\"");
  same(csv_cell("=1+1"), "'=1+1");
  return differs;
}
