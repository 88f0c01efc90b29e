#include "io/lab_files/time_runs.hpp"

#include "io/lab_files/measured_data.hpp"
#include "lab/identification/free_decays.hpp"
#include "lab/identification/output_only.hpp"
#include "lab/measured/entries.hpp"
#include "lab/signals/decay_window.hpp"
#include "words/input_error.hpp"

#include <algorithm>

namespace plica {
namespace {

// Problems of an entry by its own keys, with file and line.
template <class F> auto of_entry(const TestOnFile& test, const std::string& entry, F&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<InputProblem> problems = error.problems();
    for (InputProblem& p : problems) {
      if (!p.file.empty()) continue;
      p.file = test.path.string();
      p.key = entry + "." + p.key;
      const auto line = test.lines.find(p.key), whole = test.lines.find(entry);
      if (line != test.lines.end())
        p.line = line->second;
      else if (whole != test.lines.end())
        p.line = whole->second;
    }
    throw InputError(std::move(problems));
  }
}

// Shapes need channels of one kind.
void check_kinds(const SignalSet& set, const std::string& force) {
  std::optional<std::size_t> first;
  for (std::size_t c = 0; c < set.channels.size(); ++c) {
    if (set.channels[c] == force || c >= set.powers.size() || !set.powers[c]) continue;
    if (!first)
      first = c;
    else if (*set.powers[c] != *set.powers[*first])
      input_error("channels",
                  set.channels[c] + " is " + name_of(*set.powers[c]) + ", " + set.channels[*first] +
                      " " + name_of(*set.powers[*first]),
                  "channels of one kind, `-` for the others");
  }
}

TimeRecord record_of(const MeasuredSignals& entry, const TestOnFile& test, const std::string& key) {
  SignalSet set = load_signals(entry, test.data, test.path.parent_path(), key);
  const TimeRecord record{.name = entry.file,
                          .rate = set.rate,
                          .channels = set.channels,
                          .samples = std::move(set.samples),
                          .warnings = set.warnings};
  of_entry(test, key, [&] {
    check_kinds(set, entry.reference);
    check_record(without(record, entry.reference));
    if (!entry.reference.empty() && std::find(record.channels.begin(), record.channels.end(),
                                              entry.reference) == record.channels.end())
      input_error("reference", "'" + entry.reference + "' is none of the channels of the file",
                  "the channel of the hammer, or nothing");
    if (entry.excitation == SignalKind::free_decay) decay_windows(record, entry.reference);
  });
  return record;
}

} // namespace

std::vector<TimeRun> time_runs(const TestOnFile& test) {
  std::vector<TimeRun> runs;
  for (std::size_t i = 0; i < test.data.signals.size(); ++i) {
    const MeasuredSignals& entry = test.data.signals[i];
    if (has_input(entry.excitation)) continue;
    const std::string key = entry_name("signals", i);
    TimeRecord record = record_of(entry, test, key);
    const auto home = std::find_if(runs.begin(), runs.end(), [&](const TimeRun& t) {
      return entry.excitation == SignalKind::free_decay && t.kind == entry.excitation &&
             t.state == entry.state && t.level == entry.level && t.force == entry.reference &&
             t.records[0].channels == record.channels;
    });
    if (home != runs.end())
      home->records.push_back(std::move(record));
    else
      runs.push_back({.kind = entry.excitation,
                      .records = {std::move(record)},
                      .force = entry.reference,
                      .state = entry.state,
                      .level = entry.level,
                      .key = key});
  }
  return runs;
}

Identification identified(const TimeRun& run, const TestOnFile& test,
                          const IdentifySettings& settings) {
  return of_entry(test, run.key, [&] {
    return run.kind == SignalKind::free_decay ? identify_decays(run.records, run.force, settings)
                                              : identify_output(run.records[0], settings);
  });
}

} // namespace plica
