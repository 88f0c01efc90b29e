#include "diagnose/predict/elastic_readings.hpp"

#include "solve/modes.hpp"
#include "words/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace plica {
namespace {

bool is_of_no_shape(const TestRun& run, const Reading& r) {
  return !run.input.any() && r.shape == MeasuredShape::other;
}

double hertz_of(const TestRun& run, const Reading& r) {
  if (run.input.any()) return run.peaks[std::size_t(r.peak)];
  return r.paired_as > 0 ? r.paired_as : r.value;
}

class Rigid {
public:
  Rigid(const Nominal& nominal, const TestReadings& test) : nominal_(nominal), test_(test) {
    for (const Reading& r : test.readings) {
      if (r.run < 0 || !is_of_no_shape(run_of(r), r)) continue;
      const auto list = std::pair{r.state, r.axis};
      const auto [lowest, made] = lowest_.try_emplace(list, r.order);
      if (!made) lowest->second = std::min(lowest->second, r.order);
      if (is_left_out(r)) left_out_[list] = std::max(left_out_[list], r.order);
    }
  }

  bool is_left_out(const Reading& r) const {
    if (r.run < 0) return false;
    const TestRun& run = run_of(r);
    if (!run.input.any()) return is_of_no_shape(run, r) && hertz_of(run, r) < limit(run);
    if (run.planned()) return false;
    if (r.highest) return peaks_below(run) > 0 || (limit(run) > 0 && run.band[0] < limit(run));
    if (r.at_run >= 0) return peaks_below(test_.runs[std::size_t(r.at_run)]) > 0;
    return hertz_of(run, r) < limit(run);
  }

  // Of what stays. Below an order that is left out there are rigid motions alone, whether the test
  // lists them or not; in another state, too, where its orders begin as high.
  void count_anew(Reading& r) const {
    if (r.run < 0) return;
    const TestRun& run = run_of(r);
    if (run.input.any()) {
      if (r.at_run < 0 && !r.highest) r.peak -= peaks_below(run);
      return;
    }
    if (!is_of_no_shape(run, r)) return;
    const auto own = left_out_.find({r.state, r.axis});
    if (own != left_out_.end()) {
      r.order = std::max(1, r.order - own->second);
      return;
    }
    int elsewhere = 0;
    for (const auto& [list, order] : left_out_)
      if (list.second == r.axis) elsewhere = std::max(elsewhere, order);
    if (lowest_.at({r.state, r.axis}) > elsewhere) r.order -= elsewhere;
  }

  int peaks_below(const TestRun& run) const {
    if (!run.input.any() || run.planned()) return 0;
    const double end = limit(run);
    return int(std::count_if(run.peaks.begin(), run.peaks.end(),
                             [end](double peak) { return peak < end; }));
  }

  // Hz; zero where something holds the part.
  double limit(const TestRun& run) const {
    const ParametricModel& model = *nominal_.state(run.state).model;
    if (!model.leaves_rigid()) return 0;
    const double first = frequency(model.lambda()[0]);
    return std::clamp(std::sqrt(frequency(model.highest_rigid()) * first), first / 5, first / 2);
  }

private:
  const TestRun& run_of(const Reading& r) const { return test_.runs[std::size_t(r.run)]; }

  const Nominal& nominal_;
  const TestReadings& test_;
  // Of modes without shape, by state and axis: the highest order that is left out, the lowest there
  // is.
  std::map<std::pair<std::string, int>, int> left_out_, lowest_;
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
      said.push_back(fmt::format(
          "{:.4g} Hz of {} is no reading: below {:.3g} Hz the part swings as a rigid body",
          hertz_of(run, r), r.entry, rigid.limit(run)));
    }
  }
  if (kept.empty() && !test.readings.empty())
    input_error(test.readings.front().entry,
                "is how the part swings as a rigid body, as is all that was measured",
                "modes in which it bends or stretches");
  std::vector<int> below;
  for (const TestRun& run : test.runs) below.push_back(rigid.peaks_below(run));
  for (std::size_t i = 0; i < test.runs.size(); ++i)
    test.runs[i].peaks.erase(test.runs[i].peaks.begin(), test.runs[i].peaks.begin() + below[i]);
  test.readings = std::move(kept);
  test.warnings.insert(test.warnings.end(), said.begin(), said.end());
}

} // namespace plica
