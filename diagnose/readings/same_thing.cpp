#include "diagnose/readings/same_thing.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace plica {
namespace {

// Sensor and axis that a component of a shape is of.
std::pair<std::string, int> channel_of(const TestReadings& test, const Reading& r) {
  const ReadShape& shape = test.shapes[std::size_t(r.of_shape)];
  return {shape.sensors[std::size_t(r.channel)], shape.axes[std::size_t(r.channel)]};
}

} // namespace

bool same_thing(const TestReadings& test, const Reading& a, const Reading& b) {
  if (a.kind != b.kind || a.direction != b.direction || (a.run < 0) != (b.run < 0)) return false;
  if (is_of_rig(a))
    return a.axis == b.axis && a.stroke == b.stroke && a.rig.hertz == b.rig.hertz &&
           a.rig.driving_point == b.rig.driving_point && a.rig.ends == b.rig.ends;
  if (a.run < 0) return true;
  if (a.kind == ReadingKind::component && channel_of(test, a) != channel_of(test, b)) return false;
  const TestRun &r = test.runs[std::size_t(a.run)], &s = test.runs[std::size_t(b.run)];
  const bool of_mode = a.kind == ReadingKind::frequency || a.kind == ReadingKind::damping;
  if (of_mode && (a.mode >= 0 || b.mode >= 0)) return a.mode == b.mode;
  if (r.input != s.input || a.axis != b.axis) return false;
  if (!r.input.any()) return a.shape == b.shape && a.order == b.order;
  return r.axis == s.axis && a.mode == b.mode && (a.mode >= 0 || a.peak == b.peak) &&
         a.sensor == b.sensor && (a.at_run >= 0) == (b.at_run >= 0) && a.highest == b.highest;
}

std::vector<int> numbered(const TestReadings& test,
                          const std::function<bool(const Reading&, const Reading&)>& alike) {
  const std::size_t n = test.readings.size();
  std::vector<int> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (numbers[i] != numbers[j] && alike(test.readings[i], test.readings[j]))
        std::replace(numbers.begin(), numbers.end(), numbers[i], numbers[j]);
  return numbers;
}

} // namespace plica
