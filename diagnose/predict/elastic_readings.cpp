#include "diagnose/predict/elastic_readings.hpp"

#include "solve/modes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <tuple>

namespace plica {
namespace {

double hertz_of(const TestRun& run, const Reading& r) {
  if (run.input.any()) return run.peaks[std::size_t(r.peak)];
  return r.paired_as > 0 ? r.paired_as : r.value;
}

// What is counted together: modes of no shape along an axis of a run; modes that forces show, in a
// state.
using Counted = std::tuple<std::string, int, int>;
Counted counted_with(const TestRun& run, const Reading& r) {
  return run.input.any() ? Counted{run.state, -1, -1} : Counted{run.state, r.run, r.axis};
}
int number_of(const TestRun& run, const Reading& r) {
  return run.input.any() ? r.mode : r.order;
}

// Seen across where another run peaks, or wherever it is highest.
bool is_of_no_peak(const Reading& r) {
  return r.at_run >= 0 || r.highest;
}

class Rigid {
public:
  Rigid(const Nominal& nominal, const TestReadings& test) : nominal_(nominal), test_(test) {
    for (const Reading& r : test.readings)
      if (is_left_out(r)) numbers_[counted_with(run_of(r), r)].insert(number_of(run_of(r), r));
  }

  bool is_left_out(const Reading& r) const {
    if (r.run < 0) return false;
    const TestRun& run = run_of(r);
    if (!run.input.any() && r.shape != MeasuredShape::other) return false;
    if (run.input.any() && (run.planned() || is_of_no_peak(r))) return false;
    return hertz_of(run, r) < limit(run);
  }

  // Of what stays: as many fewer as were left out before it.
  void count_anew(Reading& r) const {
    if (r.run < 0) return;
    const TestRun& run = run_of(r);
    if (is_of_no_peak(r)) return;
    if (run.input.any()) r.peak -= peaks_below(run);
    const auto found = numbers_.find(counted_with(run, r));
    if (found == numbers_.end() || (!run.input.any() && r.shape != MeasuredShape::other)) return;
    int& number = run.input.any() ? r.mode : r.order;
    number -= int(std::distance(found->second.begin(), found->second.lower_bound(number)));
  }

  int peaks_below(const TestRun& run) const {
    if (!run.input.any() || run.planned()) return 0;
    return int(std::count_if(run.peaks.begin(), run.peaks.end(),
                             [&](double peak) { return peak < limit(run); }));
  }

  // Hz; zero where something holds the part.
  double limit(const TestRun& run) const {
    const ParametricModel& model = *nominal_.state(run.state).model;
    return model.leaves_rigid() ? frequency(model.lambda()[0]) / 2 : 0;
  }

private:
  const TestRun& run_of(const Reading& r) const { return test_.runs[std::size_t(r.run)]; }

  const Nominal& nominal_;
  const TestReadings& test_;
  std::map<Counted, std::set<int>> numbers_; // orders, or modes, that are left out
};

} // namespace

void leave_out_rigid_motions(const Nominal& nominal, TestReadings& test) {
  const Rigid rigid(nominal, test);
  std::vector<Reading> kept;
  std::vector<std::string> said;
  for (const Reading& r : test.readings) {
    if (!rigid.is_left_out(r)) {
      kept.push_back(r);
      rigid.count_anew(kept.back());
    } else if (r.kind == ReadingKind::frequency) {
      const TestRun& run = test.runs[std::size_t(r.run)];
      said.push_back(fmt::format("{:.4g} Hz of {} is no reading: below half of the first mode of "
                                 "the part, {:.4g} Hz, it swings as a rigid body",
                                 hertz_of(run, r), r.entry, 2 * rigid.limit(run)));
    }
  }
  std::vector<int> below;
  for (const TestRun& run : test.runs) below.push_back(rigid.peaks_below(run));
  for (std::size_t i = 0; i < test.runs.size(); ++i)
    test.runs[i].peaks.erase(test.runs[i].peaks.begin(), test.runs[i].peaks.begin() + below[i]);
  test.readings = std::move(kept);
  test.warnings.insert(test.warnings.end(), said.begin(), said.end());
}

} // namespace plica
