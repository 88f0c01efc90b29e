#include "model/description/time_analyses_checks.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace plica {
namespace {

void check_spectrum(const SpectrumRequest& s, const std::string& key, CheckLog& log) {
  if (log.fine(key + ".band") && (s.band[0] <= 0 || s.band[1] <= s.band[0]))
    log.add(key + ".band", "is not a band", "give [from, to] with 0 < from < to");
}

void check_transient(const Transient& t, const std::string& key, const Case& data, CheckLog& log) {
  log.reference(key + ".of", "excitation", t.of, excitation_names(*data.analyses.response));
  if (log.fine(key + ".signal") && log.fine(key + ".pulse") &&
      t.signal.has_value() == t.pulse.has_value())
    log.add(key, t.pulse ? "has a signal and a pulse" : "has neither signal nor pulse",
            "give signal (samples of a file) or pulse (a standard shock)");
  if (t.pulse && log.fine(key + ".pulse"))
    check_amplitude(key + ".pulse", t.of, t.pulse->acceleration.has_value(),
                    t.pulse->force.has_value(), data, log);
  if (t.spectrum) check_spectrum(*t.spectrum, key + ".spectrum", log);
}

// Rows of [x, ...] with increasing x.
template <class Table>
void check_increasing(const Table& table, const std::string& key, const char* what, CheckLog& log) {
  for (std::size_t i = 1; i < table.size(); ++i)
    if (log.fine(item(key, i)) && log.fine(item(key, i - 1)) && table[i][0] <= table[i - 1][0])
      log.add(item(key, i), std::string("is not above the ") + what + " before it",
              std::string("each ") + what + " above the one before");
}

void check_order(const EngineOrder& o, const std::string& key, const RunUp& run_up,
                 const Case& data, CheckLog& log) {
  const Response& r = *data.analyses.response;
  log.reference(key + ".of", "excitation", o.of, excitation_names(r));
  check_increasing(o.table, key + ".table", "speed", log);
  const bool constant = o.acceleration || o.force;
  if (log.fine(key) && constant == !o.table.empty())
    log.add(key, constant ? "has an amplitude and a table of them" : "has no amplitude",
            "give acceleration or force (the same at every speed), or a table over the speed");
  else if (constant)
    check_amplitude(key, o.of, o.acceleration.has_value(), o.force.has_value(), data, log);
  const auto [low, high] = speeds(run_up);
  if (log.fine(key + ".order") && log.fine("analyses.response.band") &&
      (o.order * low < r.band[0] || o.order * high > r.band[1]))
    log.add(key + ".order",
            "runs from " + std::to_string(std::lround(o.order * low)) + " to " +
                std::to_string(std::lround(o.order * high)) +
                " Hz, out of the band of the response",
            "widen analyses.response.band");
}

void check_run_up(const RunUp& r, const std::string& key, const Case& data, CheckLog& log) {
  const bool range = r.speed[1] > 0;
  if (log.fine(key + ".speed") && log.fine(key + ".table") && range == !r.table.empty()) {
    log.add(key, range ? "has a speed and a table of it" : "has neither speed nor table",
            "give speed ([from, to]) or table ([time, speed])");
    return;
  }
  check_increasing(r.table, key + ".table", "time", log);
  const auto [low, high] = speeds(r);
  if (log.fine(key + ".speed") && log.fine(key + ".table") && !(low > 0 && high > low))
    log.add(key + (range ? ".speed" : ".table"), "runs through no range of speeds",
            "speeds above zero, from below to");
  for (std::size_t i = 0; i < r.orders.size(); ++i)
    check_order(r.orders[i], item(key + ".orders", i), r, data, log);
}

} // namespace

void check_amplitude(const std::string& key, const std::string& of, bool acceleration, bool force,
                     const Case& data, CheckLog& log) {
  const Response& r = *data.analyses.response;
  if (!log.fine(key)) return;
  if (acceleration == force) {
    log.add(key, force ? "has an acceleration and a force" : "has no amplitude",
            "give acceleration (of a base or of ends) or force");
    return;
  }
  const bool is_force =
      std::any_of(r.forces.begin(), r.forces.end(), [&](const Force& f) { return f.name == of; });
  if (is_force != force)
    log.add(key,
            std::string("has ") + (force ? "a force" : "an acceleration") + ", and '" + of +
                "' is " + (is_force ? "a force" : "a motion"),
            is_force ? "give force" : "give acceleration");
}

void check_time_analyses(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  const bool asked = !a.transients.empty() || !a.run_ups.empty();
  if (!asked) return;
  if (!a.response) {
    if (log.fine("analyses.response"))
      log.add(a.transients.empty() ? "analyses.run_ups" : "analyses.transients",
              "act as excitations of the response, and the case asks for none",
              "give analyses.response with what moves or pushes");
    return;
  }
  std::set<std::string> transients, run_ups;
  for (std::size_t i = 0; i < a.transients.size(); ++i) {
    const std::string key = item("analyses.transients", i);
    log.once(transients, a.transients[i].name, key + ".name", "transient");
    check_transient(a.transients[i], key, data, log);
  }
  for (std::size_t i = 0; i < a.run_ups.size(); ++i) {
    const std::string key = item("analyses.run_ups", i);
    log.once(run_ups, a.run_ups[i].name, key + ".name", "run-up");
    check_run_up(a.run_ups[i], key, data, log);
  }
}

} // namespace plica
