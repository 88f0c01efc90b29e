#include "model/description/life_checks.hpp"

#include "model/description/time_analyses_checks.hpp"
#include "words/directions.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <set>

namespace plica {
namespace {

constexpr const char* key = "analyses.life";

class LifeChecks {
public:
  LifeChecks(const Case& data, CheckLog& log)
      : data_(data), life_(*data.analyses.life), log_(log) {}

  void all() {
    check_curve();
    check_what_is_there();
    each(life_.strokes, ".strokes", [&](const LifeStroke& s, const std::string& at) {
      const auto moves = s.shift.all();
      if (log_.fine(at) && std::all_of(moves.begin(), moves.end(), [](double x) { return x == 0; }))
        log_.add(at, "moves nothing", "axial, lateral_x, angular_z, ...: how far");
    });
    each(life_.histories, ".histories",
         [&](const LifeHistory& h, const std::string& at) { check_history(h, at); });
    if (!needs_response(life_)) return;
    if (!data_.analyses.response) {
      if (log_.fine("analyses.response"))
        log_.add(key, "acts by excitations of the response, and the case asks for none",
                 "give analyses.response with what moves or pushes");
      return;
    }
    each(life_.random, ".random", [&](const LifeRandom& r, const std::string& at) {
      excitation(r.of, at);
      if (log_.fine(at + ".of") && !is_random(r.of))
        log_.add(at + ".of", "'" + r.of + "' has no random part", "give it random");
    });
    each(life_.sweeps, ".sweeps",
         [&](const LifeSweep& s, const std::string& at) { check_sweep(s, at); });
    each(life_.dwells, ".dwells",
         [&](const LifeDwell& d, const std::string& at) { check_dwell(d, at); });
  }

private:
  template <class Duty, class F>
  void each(const std::vector<Duty>& duties, const std::string& list, const F& rule) {
    for (std::size_t i = 0; i < duties.size(); ++i) {
      const std::string at = item(key + list, i);
      log_.once(names_, duties[i].name, at + ".name", "duty");
      rule(duties[i], at);
    }
  }

  void check_curve() {
    const std::string at = std::string(key) + ".curve";
    if (!log_.fine(at)) return;
    for (const InputProblem& p : check(life_.curve)) log_.add(at + "." + p.key, p.wrong, p.allowed);
    const bool bellows = std::holds_alternative<BellowsCurve>(life_.curve.law);
    if (life_.deviation && is_design(life_.curve) && log_.fine(std::string(key) + ".deviation"))
      log_.add(std::string(key) + ".deviation",
               std::string("is that of a mean curve; ") +
                   (bellows ? "the curve of bellows" : "this one") + " is a design curve",
               "another curve, or no deviation");
    const bool published = std::holds_alternative<PublishedCurve>(life_.curve.law);
    if (!bellows && !published && life_.curve.source.empty())
      log_.add(at + ".source", "is missing: a life is printed with the source of its curve",
               "where its numbers are from, in words");
  }

  void check_what_is_there() {
    const bool nothing = life_.strokes.empty() && life_.histories.empty() && life_.random.empty() &&
                         life_.sweeps.empty() && life_.dwells.empty();
    if (nothing && log_.fine(key))
      log_.add(key, "has nothing that wears", "strokes, histories, random, sweeps or dwells");
    if (needs_statics(life_) && data_.caps.size() != 2 && log_.fine("caps"))
      log_.add(key,
               "moves the second of two caps, this case has " + std::to_string(data_.caps.size()),
               "give exactly two caps, or motions of ends in analyses.response");
  }

  void excitation(const std::string& of, const std::string& at) {
    log_.reference(at + ".of", "excitation", of, excitation_names(*data_.analyses.response));
  }

  bool is_random(const std::string& of) const {
    const Response& r = *data_.analyses.response;
    for (const Force& f : r.forces)
      if (f.name == of) return f.random.has_value();
    for (const Motion& m : r.motions)
      if (name_of(m) == of) return m.random || r.random;
    return r.random.has_value();
  }

  void check_history(const LifeHistory& h, const std::string& at) {
    std::set<std::string> of;
    const bool ends = moves_end(h);
    for (std::size_t i = 0; i < h.signals.size(); ++i) {
      const std::string place = item(at + ".signals", i) + ".of";
      const std::string& name = h.signals[i].of;
      if (!log_.fine(place)) continue;
      if (!of.insert(name).second)
        log_.add(place, "'" + name + "' has a signal already", "one signal each");
      else if (ends && end_shift_index(name) < 0)
        log_.add(place, "'" + name + "' is no movement of the end, and another signal is",
                 "one history for movements, another for excitations");
      else if (!ends && data_.analyses.response)
        excitation(name, item(at + ".signals", i));
    }
    const auto& first = h.signals.empty() ? SampledSignal{} : h.signals[0].signal;
    for (std::size_t i = 1; i < h.signals.size(); ++i) {
      const SampledSignal& s = h.signals[i].signal;
      if (first.samples.size() == 0 || s.samples.size() == 0) continue;
      if (s.samples.size() != first.samples.size() ||
          std::abs(s.step - first.step) > 1e-6 * first.step)
        log_.add(item(at + ".signals", i), "has other times than the first signal",
                 "signals of one record");
    }
    if (first.samples.size() > 0 && first.samples.size() < 3)
      log_.add(at + ".signals[0].file", "has fewer than three samples", "a record");
    if (ends) check_size(h, at);
  }

  // Millimetres taken for metres, degrees for radians.
  void check_size(const LifeHistory& h, const std::string& at) {
    for (std::size_t i = 0; i < h.signals.size(); ++i) {
      const SampledSignal& s = h.signals[i].signal;
      if (s.samples.size() == 0) continue;
      const double most = s.samples.cwiseAbs().maxCoeff();
      const bool turn = end_shift_index(h.signals[i].of) >= 3;
      if (most > (turn ? 1 : 0.2))
        log_.add(item(at + ".signals", i),
                 "moves the end by up to " + short_text(most, 4) + (turn ? " rad" : " m"),
                 turn ? "at most 1 rad; a unit in the head of the file, or factor (0.0174533 for "
                        "degrees)"
                      : "at most 0.2 m; a unit in the head of the file, or factor (0.001 for "
                        "millimetres)");
    }
  }

  void check_sweep(const LifeSweep& s, const std::string& at) {
    excitation(s.of, at);
    if (log_.fine(at + ".of"))
      check_amplitude(at, s.of, s.acceleration.has_value(), s.force.has_value(), data_, log_);
    if (log_.fine(at + ".band") && s.band[1] <= s.band[0])
      log_.add(at + ".band", "is not a band", "give [from, to] with from below to");
    if (!s.friction) return;
    if (!has_friction(data_))
      log_.add(at + ".friction", "is asked for, and no joint of the case has any",
               "friction in a part, a joint or a mount, or no such key");
    const bool base = std::any_of(directions().begin(), directions().end(),
                                  [&](int d) { return s.of == direction_names[std::size_t(d)]; });
    if (!base)
      log_.add(at + ".friction", "is for motion of the base, and '" + s.of + "' is none",
               "a direction of the base");
  }

  const std::vector<int>& directions() const { return data_.analyses.response->bases; }

  void check_dwell(const LifeDwell& d, const std::string& at) {
    excitation(d.of, at);
    if (!log_.fine(at)) return;
    if (log_.fine(at + ".of"))
      check_amplitude(at, d.of, d.acceleration.has_value(), d.force.has_value(), data_, log_);
    if ((d.mode > 0) == (d.frequency > 0))
      log_.add(at, d.mode > 0 ? "has a mode and a frequency" : "has neither mode nor frequency",
               "give mode (its number) or frequency");
    if ((d.duration > 0) == (d.cycles > 0))
      log_.add(at, d.cycles > 0 ? "has a duration and cycles" : "has neither duration nor cycles",
               "give duration or cycles");
  }

  const Case& data_;
  const Life& life_;
  CheckLog& log_;
  std::set<std::string> names_;
};

} // namespace

void check_life(const Case& data, CheckLog& log) {
  if (data.analyses.life) LifeChecks(data, log).all();
}

} // namespace plica
