#include "io/write/write_correlation.hpp"

#include "io/files/json_text.hpp"
#include "io/report/correlation.hpp"
#include "io/tables/correlation_words.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
std::string pairs_csv(const Correlation& c, const TestData& a, const TestData& b) {
  std::string text = "test,simulation,paired by,test [Hz],simulation [Hz],frequency difference,in "
                     "sigma,test damping,simulation damping,MAC\n";
  for (const PairedMode& p : c.pairs) {
    const MeasuredMode &s = a.data.modes[p.simulated], &t = b.data.modes[p.measured];
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_cell(mode_name(t, p.measured)),
                        csv_cell(mode_name(s, p.simulated)), p.by, t.frequency, s.frequency,
                        p.frequency_error, csv_number(p.frequency_sigmas), csv_number(t.damping),
                        csv_number(s.damping), csv_number(p.mac));
  }
  return text;
}

std::string responses_csv(const Correlation& c) {
  std::string text = "response,reference,level,from [Hz],to [Hz],FRAC,best FRAC,stretch\n";
  for (const ComparedResponse& r : c.responses)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_cell(r.response), csv_cell(r.reference),
                        csv_number(r.level), r.low, r.high, r.frac, r.best_frac, r.stretch);
  return text;
}

} // namespace

std::string correlation_json(const Correlation& c, const TestData& a, const TestData& b) {
  Json json;
  json["simulated"] = a.data.source;
  json["measured"] = b.data.source;
  json["numbers"] = Json::array();
  for (const ComparedNumber& n : c.numbers)
    json["numbers"].push_back({{"quantity", n.quantity},
                               {"unit", n.unit},
                               {"simulated", n.simulated},
                               {"measured", n.measured},
                               {"sigma", json_number(n.sigma)}});
  json["pairs"] = Json::array();
  for (const PairedMode& p : c.pairs)
    json["pairs"].push_back({{"measured", p.measured + 1},
                             {"simulated", p.simulated + 1},
                             {"name", mode_name(b.data.modes[p.measured], p.measured)},
                             {"by", p.by},
                             {"frequency_measured", b.data.modes[p.measured].frequency},
                             {"frequency_simulated", a.data.modes[p.simulated].frequency},
                             {"frequency_error", p.frequency_error},
                             {"frequency_sigmas", json_number(p.frequency_sigmas)},
                             {"damping_error", json_number(p.damping_error)},
                             {"damping_sigmas", json_number(p.damping_sigmas)},
                             {"mac", json_number(p.mac)}});
  const auto counted = [](const std::vector<int>& list) {
    Json numbers = Json::array();
    for (const int i : list) numbers.push_back(i + 1);
    return numbers;
  };
  json["unpaired_measured"] = counted(c.unpaired_measured);
  json["unpaired_simulated"] = counted(c.unpaired_simulated);
  json["channels"] = c.channels;
  json["mac"] = Json::array();
  for (Index i = 0; i < c.mac.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < c.mac.cols(); ++j) row.push_back(c.mac(i, j));
    json["mac"].push_back(row);
  }
  json["comac"] = Json::object();
  for (Index q = 0; q < c.comac.size(); ++q) json["comac"][c.channels[q]] = c.comac[q];
  json["responses"] = Json::array();
  for (const ComparedResponse& r : c.responses)
    json["responses"].push_back({{"response", r.response},
                                 {"reference", r.reference},
                                 {"level", json_number(r.level)},
                                 {"band", {r.low, r.high}},
                                 {"frac", r.frac},
                                 {"best_frac", r.best_frac},
                                 {"stretch", r.stretch}});
  json["limits"] = c.limits;
  json["warnings"] = Json::array();
  for (const TestData* side : {&a, &b})
    for (const std::string& warning : warnings_of(*side)) json["warnings"].push_back(warning);
  return json_text(json);
}

std::vector<std::string> correlation_files() {
  return {"pairs.csv", "responses.csv", "correlation.html", "correlation.json"};
}

void write_correlation(const Correlation& c, const TestData& a, const TestData& b,
                       OutputFolder& out) {
  out.add("pairs.csv", pairs_csv(c, a, b));
  out.add("responses.csv", responses_csv(c));
  out.add("correlation.html", correlation_html(c, a, b));
  out.add("correlation.json", correlation_json(c, a, b));
}

} // namespace plica
