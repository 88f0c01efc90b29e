// Signals of one run, sampled together, and whether modes can follow from them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace plica {

struct TimeRecord {
  std::string name; // "hit_1.csv"
  double rate = 0;  // Hz
  std::vector<std::string> channels;
  Eigen::MatrixXd samples; // time x channels, in SI
  std::vector<std::string> warnings;
};

// Without one channel. The record itself where there is none of this name.
TimeRecord without(const TimeRecord& record, const std::string& channel);

// Throws InputError (key "file", "channels" or "rate", without a file) for samples that are not
// finite, a channel that never moves or stands at one end of its range again and again (clipped),
// and for signals of which half the power lies within the last tenth below half the sampling rate.
// Single faults of no mode are not looked for.
void check_record(const TimeRecord& record);

// Frequency below which 99.9 % of the power lies that stands out of the noise floor (four times the
// median line), over all channels, each by its own power; half the sampling rate at most, Hz.
double highest_frequency(const TimeRecord& record);

} // namespace plica
