#include "io/input/time_signal.hpp"

#include "io/lab_files/lab_units.hpp"
#include "io/lab_files/measured_data.hpp"
#include "words/did_you_mean.hpp"
#include "words/input_error.hpp"

#include <algorithm>

namespace plica {
namespace {

// What an excitation is measured in.
UnitPowers unit_of(const std::string& of, const Response& response) {
  for (const Force& f : response.forces)
    if (f.name == of) return f.direction < 3 ? powers::force : powers::moment;
  for (const Motion& m : response.motions)
    if (name_of(m) == of)
      return m.direction < 3 ? powers::acceleration : powers::angular_acceleration;
  return of.starts_with('r') ? powers::angular_acceleration : powers::acceleration;
}

std::string listed(const std::vector<std::string>& channels) {
  std::string text;
  for (const std::string& c : channels) text += (text.empty() ? "" : ", ") + shown(c);
  return text;
}

void read_signal(SampledSignal& signal, const UnitPowers& wanted,
                 const std::filesystem::path& folder, const std::string& key) {
  MeasuredSignals entry;
  entry.file = signal.file;
  entry.rate = signal.rate;
  const SignalSet set = load_signals(entry, {}, folder, key);
  std::size_t column = 0;
  if (!signal.channel.empty() || set.channels.size() > 1) {
    const auto found = std::find(set.channels.begin(), set.channels.end(), signal.channel);
    if (found == set.channels.end())
      input_error(key + ".channel",
                  signal.channel.empty()
                      ? "is missing: the file has " + std::to_string(set.channels.size())
                      : "'" + shown(signal.channel) + "' is none of the file",
                  "one of " + listed(set.channels));
    column = std::size_t(found - set.channels.begin());
  }
  if (const auto& is = set.powers[column]; is && *is != wanted)
    input_error(key + ".channel",
                "is in units of " + name_of(*is) + ", and the excitation is " + name_of(wanted),
                "a signal of " + name_of(wanted));
  signal.step = 1 / set.rate;
  signal.samples = signal.factor * set.samples.col(Eigen::Index(column));
  if (!signal.samples.allFinite())
    input_error(key + ".file", "has samples that are no numbers", "a record without gaps");
}

// Every signal with what it must be measured in and its key.
struct WantedSignal {
  SampledSignal& signal;
  UnitPowers unit;
  std::string key;
};

std::vector<WantedSignal> signals_of(Analyses& a) {
  std::vector<WantedSignal> all;
  for (std::size_t i = 0; a.response && i < a.transients.size(); ++i)
    if (Transient& t = a.transients[i]; t.signal)
      all.push_back({*t.signal, unit_of(t.of, *a.response),
                     "analyses.transients[" + std::to_string(i) + "].signal"});
  if (!a.life) return all;
  for (std::size_t h = 0; h < a.life->histories.size(); ++h)
    for (std::size_t i = 0; i < a.life->histories[h].signals.size(); ++i) {
      LifeSignal& s = a.life->histories[h].signals[i];
      const int shift = end_shift_index(s.of);
      if (shift < 0 && !a.response) continue;
      all.push_back({s.signal,
                     shift < 0   ? unit_of(s.of, *a.response)
                     : shift < 3 ? powers::displacement
                                 : powers::angle,
                     "analyses.life.histories[" + std::to_string(h) + "].signals[" +
                         std::to_string(i) + "]"});
    }
  return all;
}

} // namespace

void read_signals(Case& data, const std::filesystem::path& folder) {
  std::vector<InputProblem> problems;
  for (const WantedSignal& wanted : signals_of(data.analyses)) {
    if (wanted.signal.file.empty()) continue;
    try {
      read_signal(wanted.signal, wanted.unit, folder, wanted.key);
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

} // namespace plica
