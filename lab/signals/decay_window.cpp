#include "lab/signals/decay_window.hpp"

#include "words/input_error.hpp"
#include "words/sample_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double hit_level = 0.3, hit_rise = 3, contact_end = 0.05, noise_reach = 1.5;
constexpr Index fewest = 32;

struct Hit {
  Index start = 0, free = 0; // first sample of the hit, first of the decay
};

// Sum of squares over the channels, each over its own mean square.
VectorXd square_of(const TimeRecord& record) {
  VectorXd square = VectorXd::Zero(record.samples.rows());
  for (Index c = 0; c < record.samples.cols(); ++c) {
    VectorXd x = record.samples.col(c);
    x.array() -= x.tail(std::max<Index>(1, x.size() / 10)).mean();
    if (x.squaredNorm() > 0) square += x.cwiseAbs2() / x.squaredNorm();
  }
  return square;
}

VectorXd levels_of(const VectorXd& square, Index block) {
  VectorXd level(square.size() / block);
  for (Index b = 0; b < level.size(); ++b)
    level[b] = std::sqrt(square.segment(b * block, block).mean());
  return level;
}

std::vector<Hit> hits_of(const VectorXd& square, const VectorXd& level, Index block) {
  std::vector<Hit> hits;
  const double highest = level.maxCoeff();
  const auto add = [&](Index b) {
    Index peak = 0;
    square.segment(b * block, std::min(3 * block, square.size() - b * block)).maxCoeff(&peak);
    hits.push_back({.start = b * block, .free = b * block + peak + 1});
  };
  Index last = -10;
  for (Index b = 1; b < level.size(); ++b) {
    const double before = std::min(level[b - 1], level[std::max<Index>(0, b - 2)]);
    if (level[b] < hit_level * highest || level[b] < hit_rise * before) continue;
    if (b > last + 3) add(b);
    last = b;
  }
  if (!hits.empty()) return hits;
  Index top = 0;
  level.maxCoeff(&top);
  add(top);
  return hits;
}

// Of the force: where it is above 0.3 of its peak, until it is below 5 % of it. Contacts that a
// block separates are one hit.
std::vector<Hit> hits_of_force(VectorXd force, Index block) {
  force.array() -= median({force.begin(), force.end()});
  force = force.cwiseAbs();
  const double peak = force.maxCoeff();
  std::vector<Hit> hits;
  for (Index i = 0; i < force.size(); ++i) {
    if (force[i] < hit_level * peak) continue;
    Index end = i;
    while (end < force.size() && force[end] > contact_end * peak) ++end;
    if (!hits.empty() && i < hits.back().free + block)
      hits.back().free = end;
    else
      hits.push_back({.start = i, .free = end});
    i = end;
  }
  return hits;
}

} // namespace

std::vector<DecayWindow> decay_windows(const TimeRecord& record, const std::string& force) {
  const auto channel = std::find(record.channels.begin(), record.channels.end(), force);
  const TimeRecord responses = without(record, force);
  const VectorXd square = square_of(responses);
  const Index samples = square.size(), block = std::max<Index>(8, samples / 200);
  const VectorXd level = levels_of(square, block);
  const std::vector<Hit> hits =
      force.empty() || channel == record.channels.end()
          ? hits_of(square, level, block)
          : hits_of_force(record.samples.col(channel - record.channels.begin()), block);
  const Index before = hits.front().start / block - 1;
  const double noise = before >= 5 ? std::sqrt(level.head(before).cwiseAbs2().mean())
                                   : level.tail(std::max<Index>(1, level.size() / 20)).mean();
  std::vector<DecayWindow> windows;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const Index end = h + 1 < hits.size() ? hits[h + 1].start - block : samples;
    const Index tenth = (end - hits[h].free) / 10;
    const std::string at = fmt::format("{:.4g} s", double(hits[h].free) / record.rate);
    if (tenth < 3)
      input_error("file", "holds next to nothing behind the hit at " + at,
                  "records that last until the vibration has died away");
    const double last = square.segment(end - tenth, tenth).mean();
    if (const double left = std::sqrt(last / square.segment(hits[h].free, tenth).mean());
        left > 0.5)
      input_error("file",
                  fmt::format("does not decay: behind {} the last tenth has {:.0f} % of the level "
                              "of the first",
                              at, 100 * left),
                  "a record that lasts until the vibration has died away, or excitation: "
                  "output_only");
    Index stop = (end - 1) / block;
    while (stop * block > hits[h].free + fewest &&
           level[std::min(stop, level.size() - 1)] < noise_reach * noise)
      --stop;
    const DecayWindow window{.first = hits[h].free,
                             .count = std::min(end, (stop + 1) * block) - hits[h].free};
    if (window.count < fewest)
      input_error("file",
                  fmt::format("the decay behind {} is over within {} samples", at, window.count),
                  "a higher sampling rate or a longer record: 32 samples at least");
    windows.push_back(window);
  }
  return windows;
}

} // namespace plica
