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

// `visit` takes every signal, what it acts by, the component of the end's movement it is (-1: it is
// of an excitation) and its key.
template <class A, class Visit> void each_signal(A& a, const Visit& visit) {
  for (std::size_t i = 0; i < a.transients.size(); ++i)
    if (auto& t = a.transients[i]; t.signal)
      visit(*t.signal, t.of, -1, "analyses.transients[" + std::to_string(i) + "].signal");
  if (!a.life) return;
  for (std::size_t h = 0; h < a.life->histories.size(); ++h)
    for (std::size_t i = 0; i < a.life->histories[h].signals.size(); ++i) {
      auto& s = a.life->histories[h].signals[i];
      visit(s.signal, s.of, end_shift_index(s.of),
            "analyses.life.histories[" + std::to_string(h) + "].signals[" + std::to_string(i) +
                "]");
    }
}

} // namespace

void read_signals(Case& data, const std::filesystem::path& folder) {
  std::vector<InputProblem> problems;
  const auto& response = data.analyses.response;
  each_signal(data.analyses,
              [&](SampledSignal& signal, const std::string& of, int shift, const std::string& key) {
                if (signal.file.empty() || (shift < 0 && !response)) return;
                const UnitPowers wanted = shift < 0   ? unit_of(of, *response)
                                          : shift < 3 ? powers::displacement
                                                      : powers::angle;
                try {
                  read_signal(signal, wanted, folder, key);
                } catch (const InputError& error) {
                  problems.insert(problems.end(), error.problems().begin(), error.problems().end());
                }
              });
  if (!problems.empty()) throw InputError(std::move(problems));
}

std::vector<SignalFile> signal_files(const Analyses& analyses) {
  std::vector<SignalFile> files;
  each_signal(analyses,
              [&](const SampledSignal& signal, const std::string&, int, const std::string& key) {
                files.push_back({signal.file, key});
              });
  return files;
}

} // namespace plica
