// One input of an `frf` entry, as readings are made of it.
#pragma once

#include "diagnose/readings/reading_list.hpp"
#include "diagnose/readings/response_peaks.hpp"

namespace plica {

struct ResponseEntry {
  std::size_t number = 0; // of the entry
  const MeasuredFrf* stated = nullptr;
  const FrfSet* set = nullptr;
  int reference = 0;

  Input input() const;
  // Of a channel; -1 = not there.
  Eigen::Index column(const std::string& sensor, int axis) const;
  // Sensors of the channels, each once.
  std::vector<std::string> sensors() const;
  // Accelerations over the input.
  Eigen::VectorXcd response(Eigen::Index column) const;
  // Whether it was measured as far as this relative distance to either side of a frequency.
  bool covers(double hertz, double distance) const;
  // Largest response within a relative distance of a frequency.
  double largest(Eigen::Index column, double hertz, double distance) const;
  // Of a response at a resonance that was fitted to another.
  double height_at(Eigen::Index column, const FittedPeak& peak) const;
  // Relative noise of a response near its peaks, as stated; else none.
  double stated_noise(double amplitude) const;

  // A run of these responses, still without peaks.
  TestRun run() const;
  // Of a peak of a run, where it shows.
  Reading blank(const TestRun& run, int number, int peak) const;
};

// Frequency, damping and height of a peak of a run.
void add_peak(const ResponseEntry& entry, const TestRun& run, int number, int peak,
              const FittedPeak& found, ReadingList& list);

double highest_of(const std::vector<FittedPeak>& peaks);

} // namespace plica
