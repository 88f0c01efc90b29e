#include "model/description/response_checks.hpp"

#include "model/description/place_keys.hpp"
#include "model/description/time_analyses_checks.hpp"
#include "solve/random_response.hpp"
#include "words/directions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <set>

namespace plica {
namespace {

void check_band(const std::array<double, 2>& band, const std::string& key, CheckLog& log) {
  if (log.fine(key) && (band[0] <= 0 || band[1] <= band[0]))
    log.add(key, "is not a band", "give [from, to] with 0 < from < to");
}

// `band`: of the response, which must hold the whole table.
void check_noise(const Noise* noise, const std::array<double, 2>& band, const std::string& key,
                 CheckLog& log) {
  if (!noise) return;
  if (log.fine(key) && (noise->level > 0) == !noise->table.empty()) {
    log.add(key, noise->table.empty() ? "has neither level nor table" : "has a level and a table",
            "give level (constant over the band) or table ([frequency, density])");
    return;
  }
  const bool band_known = log.fine("analyses.response.band");
  for (std::size_t i = 0; i < noise->table.size(); ++i) {
    const std::string row = item(key + ".table", i);
    const auto& [hertz, density] = noise->table[i];
    if (!log.fine(row)) continue;
    if (band_known && (hertz < band[0] || hertz > band[1]))
      log.add(row, "lies outside of the band of the response", "widen analyses.response.band");
    if (i > 0 && log.fine(item(key + ".table", i - 1)) && hertz <= noise->table[i - 1][0])
      log.add(row, "is not above the frequency before it", "frequencies must increase");
    if (density <= 0)
      log.add(row, "has a density that is not above zero", "straight in a log-log plot needs that");
  }
}

std::vector<std::string> channel_names(const Case& data) {
  std::vector<std::string> names;
  for (const Sensor& s : data.sensors)
    for (const char* axis : axis_names) names.push_back(s.name + "." + axis);
  return names;
}

void check_damping(const Case& data, CheckLog& log) {
  const Damping& d = data.analyses.damping;
  const std::string key = "analyses.damping";
  if (d.coupled && d.loss_factors.empty() && log.fine(key + ".loss_factors"))
    log.add(key + ".coupled", "is said of loss factors, and there are none",
            "give loss_factors, or leave it out");
  for (std::size_t i = 0; i < d.ranges.size(); ++i)
    check_band(d.ranges[i].band, item(key + ".ranges", i) + ".band", log);
  for (std::size_t i = 0; i < d.modes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (d.modes[i].mode == d.modes[j].mode && d.modes[i].mode > 0)
        log.add(item(key + ".modes", i) + ".mode", "is given twice", "one value for a mode");
  std::vector<std::string> components;
  for (const Part& part : data.parts) {
    if (!std::holds_alternative<PointMass>(part.body)) components.push_back(part.name);
    if (const auto* liner = std::get_if<Interlock>(&part.body); liner && liner->contact)
      components.push_back(contact_place(part.name));
  }
  for (const Mount& m : data.mount)
    if (m.kind == MountKind::springs) components.push_back(mount_key(m.cap));
  for (const Cap& cap : data.caps) {
    if (cap.stiffness) components.push_back(cap_key(cap.name));
    for (const SprungEnd& e : cap.ends) components.push_back(sprung_end_key(cap.name, e.end));
  }
  std::set<std::string> damped;
  for (std::size_t i = 0; i < d.loss_factors.size(); ++i) {
    const std::string place = item(key + ".loss_factors", i) + ".of";
    log.reference(place, "component", d.loss_factors[i].of, components);
    log.once(damped, d.loss_factors[i].of, place, "loss factor");
  }
}

// One way in which ends move; `mounted`: caps that a mount holds.
void check_end_motion(const EndMotion& m, const std::string& key,
                      const std::vector<std::string>& mounted, CheckLog& log) {
  std::set<std::string> caps;
  for (const std::string& cap : m.move) {
    log.reference(key + ".move", "mounted cap", cap, mounted);
    log.once(caps, cap, key + ".move", "end");
  }
  if (m.amplitude == 0 && log.fine(key + ".amplitude"))
    log.add(key + ".amplitude",
            m.phase == 0 ? "is zero: the end rests" : "is zero, and the end has a phase",
            "leave the end out, or give an amplitude");
}

void check_motions(const Case& data, const Response& r, CheckLog& log) {
  const std::string base = "analyses.response.base";
  if (!log.fine("mount") || !log.fine("caps")) return;
  std::vector<std::string> mounted;
  for (const Mount& m : data.mount)
    if (m.kind != MountKind::free) mounted.push_back(m.cap);
  std::set<std::string> names;
  for (std::size_t i = 0; i < r.motions.size(); ++i) {
    const Motion& m = r.motions[i];
    const std::string key = item(base, r.bases.size() + i); // directions stand before them
    check_end_motion(m, key, mounted, log);
    for (std::size_t k = 0; k < m.with.size(); ++k)
      check_end_motion(m.with[k], item(key + ".with", k), mounted, log);
    log.once(names, name_of(m), key + ".name", "motion");
    check_noise(m.random ? &*m.random : nullptr, r.band, key + ".random", log);
  }
}

using Eigen::MatrixXcd;

// The coherences of the inputs, as far as they are good.
void check_coherence(const Together& t, const std::string& key, CheckLog& log) {
  std::vector<std::string> names;
  for (const InputShare& i : t.inputs) names.push_back(i.of);
  const auto index = [&](const std::string& of) {
    return std::find(names.begin(), names.end(), of) - names.begin();
  };
  MatrixXcd gamma = MatrixXcd::Identity(Eigen::Index(names.size()), Eigen::Index(names.size()));
  for (std::size_t i = 0; i < t.coherence.size(); ++i) {
    const InputCoherence& c = t.coherence[i];
    const std::string own = item(key + ".coherence", i);
    const auto before = log.problems.size();
    log.reference(own + ".a", "input", c.a, names);
    log.reference(own + ".b", "input", c.b, names);
    if (c.a == c.b && log.fine(own))
      log.add(own, "is of an input with itself, which is one", "two inputs");
    if (log.problems.size() > before || !log.fine(own)) return;
    if (gamma(index(c.a), index(c.b)) != 0.)
      log.add(own, "is given twice", "one coherence for a pair");
    gamma(index(c.a), index(c.b)) = std::polar(c.magnitude, c.phase);
    gamma(index(c.b), index(c.a)) = std::polar(c.magnitude, -c.phase);
  }
  if (const std::string wrong = not_a_spectrum(gamma); !wrong.empty())
    log.add(key + ".coherence", wrong, "coherences that signals can have together");
}

void check_spectra(const Together& t, const std::string& key, const Response& r, CheckLog& log) {
  const std::size_t n = t.inputs.size();
  for (std::size_t i = 0; i < t.spectra.size(); ++i) {
    const SpectrumMatrix& row = t.spectra[i];
    const std::string own = item(key + ".spectra", i);
    if (!log.fine(own)) return;
    if (log.fine("analyses.response.band") &&
        (row.frequency < r.band[0] || row.frequency > r.band[1]))
      log.add(own + ".frequency", "lies outside of the band of the response",
              "widen analyses.response.band");
    if (i > 0 && row.frequency <= t.spectra[i - 1].frequency)
      log.add(own + ".frequency", "is not above the frequency before it",
              "frequencies must increase");
    const std::string wanted = std::to_string(n * n) + " numbers, " + std::to_string(n) +
                               " rows of " + std::to_string(n) + " for these inputs";
    if (row.real.size() != n * n) {
      log.add(own + ".real", "has " + std::to_string(row.real.size()) + " numbers", wanted);
      continue;
    }
    if (!row.imaginary.empty() && row.imaginary.size() != n * n) {
      log.add(own + ".imaginary", "has " + std::to_string(row.imaginary.size()) + " numbers",
              wanted);
      continue;
    }
    MatrixXcd S = MatrixXcd::Zero(Eigen::Index(n), Eigen::Index(n));
    for (std::size_t a = 0; a < n * n; ++a)
      S(Eigen::Index(a / n), Eigen::Index(a % n)) = {row.real[a],
                                                     row.imaginary.empty() ? 0 : row.imaginary[a]};
    if (const std::string wrong = not_a_spectrum(S); !wrong.empty())
      log.add(own, wrong, "a cross-spectral matrix: S_ab the conjugate of S_ba, x' S x >= 0");
  }
  if (t.spectra.size() == 1)
    log.add(key + ".spectra", "holds at one frequency alone", "at least two, for a band");
}

void check_together(const Response& r, CheckLog& log) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < r.together.size(); ++i) {
    const Together& t = r.together[i];
    const std::string key = item("analyses.response.together", i);
    log.once(names, t.name, key + ".name", "group of inputs");
    std::set<std::string> inputs;
    for (std::size_t k = 0; k < t.inputs.size(); ++k) {
      const std::string own = item(key + ".inputs", k);
      log.reference(own + ".of", "excitation", t.inputs[k].of, excitation_names(r));
      log.once(inputs, t.inputs[k].of, own + ".of", "input");
      if (t.inputs[k].factor == 0 && log.fine(own))
        log.add(own + ".factor", "is zero: the input rests", "leave the input out");
    }
    const int ways =
        (t.correlation != InputCorrelation::none) + !t.coherence.empty() + !t.spectra.empty();
    if (ways > 1 && log.fine(key))
      log.add(key, "says in more than one way how its inputs go together",
              "one of correlation, coherence, spectra");
    else if (!t.coherence.empty())
      check_coherence(t, key, log);
    else
      check_spectra(t, key, r, log);
  }
}

// The random input of a name; null where it has none.
const Noise* random_input(const Response& r, const std::string& of) {
  const auto address = [](const auto& noise) -> const Noise* { return noise ? &*noise : nullptr; };
  for (const int base : r.bases)
    if (of == direction_names[std::size_t(base)]) return address(r.random);
  for (const Motion& m : r.motions)
    if (of == name_of(m)) return address(m.random ? m.random : r.random);
  for (const Force& f : r.forces)
    if (of == f.name) return address(f.random);
  return nullptr;
}

void check_tones(const Case& data, const Response& r, CheckLog& log) {
  for (std::size_t i = 0; i < r.tones.size(); ++i) {
    const Tone& tone = r.tones[i];
    const std::string key = item("analyses.response.tones", i);
    log.reference(key + ".of", "excitation", tone.of, excitation_names(r));
    check_band(tone.band, key + ".band", log);
    check_amplitude(key, tone.of, tone.acceleration.has_value(), tone.force.has_value(), data, log);
    if (!log.fine(key)) continue;
    if (log.fine("analyses.response.band") &&
        (tone.band[0] < r.band[0] || tone.band[1] > r.band[1]))
      log.add(key + ".band", "reaches out of the band of the response",
              "widen analyses.response.band");
    const std::vector<std::string> names = excitation_names(r);
    if (std::find(names.begin(), names.end(), tone.of) != names.end() && !random_input(r, tone.of))
      log.add(key + ".of", "'" + tone.of + "' has no random input that a sine could ride on",
              "give it random, or leave the tone out: the response itself shows a sine");
  }
}

// A name stands for one excitation.
void check_names_differ(const Response& r, CheckLog& log) {
  std::set<std::string> names;
  for (const int base : r.bases) names.insert(direction_names[std::size_t(base)]);
  for (const Motion& m : r.motions) names.insert(name_of(m));
  for (std::size_t i = 0; i < r.forces.size(); ++i)
    if (names.contains(r.forces[i].name))
      log.add(item("analyses.response.forces", i) + ".name",
              "'" + r.forces[i].name + "' is a motion of the response, too", "another name");
}

void check_response(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  const std::string key = "analyses.response";
  if (!a.response) return;
  const Response& r = *a.response;
  check_band(r.band, key + ".band", log);
  for (std::size_t i = 0; i < r.rms_bands.size(); ++i) {
    const std::string place = item(key + ".rms_bands", i);
    check_band(r.rms_bands[i], place, log);
    if (log.fine(place) && log.fine(key + ".band") &&
        (r.rms_bands[i][0] < r.band[0] || r.rms_bands[i][1] > r.band[1]))
      log.add(place, "reaches out of the band of the response", "widen analyses.response.band");
  }
  check_noise(r.random ? &*r.random : nullptr, r.band, key + ".random", log);
  check_motions(data, r, log);
  std::set<std::string> names;
  for (std::size_t i = 0; i < r.forces.size(); ++i) {
    const Force& force = r.forces[i];
    const std::string place = item(key + ".forces", i);
    log.once(names, force.name, place + ".name", "force");
    log.set_reference(place + ".at", force.at);
    check_noise(force.random ? &*force.random : nullptr, r.band, place + ".random", log);
  }
  check_names_differ(r, log);
  check_together(r, log);
  check_tones(data, r, log);
  for (std::size_t i = 0; i < r.cross.size(); ++i) {
    const std::string place = item(key + ".cross", i);
    log.reference(place + ".a", "channel", r.cross[i].a, channel_names(data));
    log.reference(place + ".b", "channel", r.cross[i].b, channel_names(data));
  }
  const bool moves = !r.bases.empty() || !r.motions.empty();
  if (!moves && r.forces.empty() && log.fine(key + ".base"))
    log.add(key, "has nothing that excites", "give base (directions), forces, or both");
  if (r.random && !moves)
    log.add(key + ".random", "is that of the base, which does not move", "give base (directions)");
  check_held(key, data, log);
  if (!a.modes)
    log.add(key, "is a sum of modes, and the case asks for none", "give analyses.modes");
  const Damping& d = a.damping;
  if (d.modal <= 0 && d.ranges.empty() && d.modes.empty() && d.loss_factors.empty() &&
      !has_damped_springs(data) && log.fine("analyses.damping"))
    log.add(key, "without damping has no finite peak", "give analyses.damping");
  if (data.sensors.empty() && log.fine("sensors"))
    log.add(key, "is that of the sensors, and the case has none", "give at least one sensor");
}

void check_stress(const Case& data, CheckLog& log) {
  const Analyses& a = data.analyses;
  if (!a.stress || !log.fine("analyses.stress")) return;
  if (!a.modes && !a.statics && !a.deck_loads)
    log.add("analyses.stress", "has neither modes nor a static analysis to recover stress from",
            "give analyses.modes, static: true or static: deck");
  for (std::size_t i = 0; a.response && i < a.stress->frequencies.size(); ++i)
    if (const double f = a.stress->frequencies[i];
        log.fine("analyses.response.band") && (f < a.response->band[0] || f > a.response->band[1]))
      log.add(item("analyses.stress.frequencies", i), "lies outside of the band of the response",
              "widen analyses.response.band");
  if (!a.stress->frequencies.empty() && !a.response)
    log.add("analyses.stress.frequencies", "is a harmonic response, and the case asks for none",
            "give analyses.response");
}

} // namespace

void check_held(const std::string& key, const Case& data, CheckLog& log) {
  const bool held = held_by_deck(data) || !data.supports.empty() ||
                    std::any_of(data.mount.begin(), data.mount.end(),
                                [](const Mount& m) { return m.kind != MountKind::free; });
  if (!held && log.fine("mount") && log.fine("supports"))
    log.add(key, "has nothing that holds the part, so it has no steady response",
            "give a mount or supports that leave no rigid motion free");
}

void check_responses(const Case& data, CheckLog& log) {
  check_damping(data, log);
  check_response(data, log);
  check_stress(data, log);
  check_time_analyses(data, log);
}

} // namespace plica
