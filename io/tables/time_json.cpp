#include "io/tables/time_json.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/text.hpp"
#include "io/tables/time_csv.hpp"

namespace plica {

Json transients_json(const Results& results) {
  Json list = Json::array();
  for (const TransientResult& t : results.transients) {
    Json channels = Json::array();
    for (std::size_t c = 0; c < t.channels.size(); ++c)
      channels.push_back({{"sensor", t.channels[c].first},
                          {"direction", t.channels[c].second},
                          {"peak", json_number(t.extremes[c].value)},
                          {"time", json_number(t.extremes[c].time)},
                          {"rms", json_number(t.rms[Eigen::Index(c)])}});
    list.push_back({{"name", t.name},
                    {"input", t.input_title},
                    {"unit", t.unit},
                    {"step", json_number(t.step)},
                    {"samples", t.input.size()},
                    {"file", transient_file(t.name)},
                    {"shock_file", t.spectra ? Json(shock_file(t.name)) : Json(nullptr)},
                    {"quality", t.spectra ? json_number(t.spectra->quality) : Json(nullptr)},
                    {"channels", channels}});
  }
  return list;
}

Json run_ups_json(const Results& results) {
  Json list = Json::array();
  for (const RunUpResult& r : results.run_ups) {
    Json orders = Json::array(), crossings = Json::array();
    for (const OrderCut& cut : r.orders) orders.push_back(json_number(cut.order));
    for (const OrderCrossing& c : r.crossings) {
      const auto& [sensor, direction] = r.channels[std::size_t(c.channel)];
      crossings.push_back({{"order", json_number(c.order)},
                           {"mode", c.mode + 1},
                           {"speed", json_number(c.speed)},
                           {"frequency", json_number(c.frequency)},
                           {"sensor", sensor},
                           {"direction", direction},
                           {"amplitude", json_number(c.amplitude)},
                           {"haste", c.haste ? json_number(*c.haste) : Json(nullptr)},
                           {"reached", c.reached ? json_number(*c.reached) : Json(nullptr)}});
    }
    Json overall = Json::array();
    for (std::size_t c = 0; c < r.channels.size(); ++c) {
      Eigen::Index at = 0;
      const double largest = r.overall.col(Eigen::Index(c)).maxCoeff(&at);
      overall.push_back({{"sensor", r.channels[c].first},
                         {"direction", r.channels[c].second},
                         {"rms", json_number(largest)},
                         {"speed", json_number(r.speed[at])}});
    }
    list.push_back({{"name", r.name},
                    {"file", run_up_file(r.name)},
                    {"time_file", r.sweeps ? Json(run_up_time_file(r.name)) : Json(nullptr)},
                    {"orders", orders},
                    {"largest", overall},
                    {"crossings", crossings}});
  }
  return list;
}

} // namespace plica
