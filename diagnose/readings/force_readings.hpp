// Readings of responses to forces, of a hammer or a shaker: frequency, damping and height of the
// strong peaks of one channel, and what the other channels show over it at each.
//
// The channel is the driven one where it was measured. A mode shows under every force that moves
// it: readings know which of their peaks are of one mode, whose error they share.
#pragma once

#include "diagnose/readings/response_entry.hpp"

namespace plica {

class ForceReadings {
public:
  explicit ForceReadings(ReadingList& list) : list_(list) {}

  // An input that is a force.
  void add(const ResponseEntry& entry);
  // After the last: which peaks are of one mode.
  void number_modes();

private:
  struct Channel {
    std::string sensor;
    int axis = 0;
    std::vector<FittedPeak> peaks;
  };
  Channel main_channel(const ResponseEntry& entry) const;
  void add_others(const ResponseEntry& entry, const TestRun& run, int peak,
                  const FittedPeak& found);

  ReadingList& list_;
  std::map<std::string, std::pair<std::string, int>> seen_in_; // by the driven channel
};

} // namespace plica
