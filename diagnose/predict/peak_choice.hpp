// Which modes of a model are the peaks of a measured channel.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace plica {

// Modes of a model between two that are paired one behind the other: each costs this in ln f, what
// a model may be off. Those before the first and after the last cost nothing.
inline constexpr double passed_over = 0.02;
struct Between {
  std::vector<bool> counts; // of each mode of the model; none: it costs nothing to pass one over
  std::vector<int> missed;  // of each measured one: how many the test says lie between it and the
                            // one before it that it has not; none: not one
};

// Peaks of a model in the order of measured ones: increasing, each at most once while there are
// enough, the sum of |ln f - ln f'|, of the handicaps of those that are taken (none: no handicaps)
// and of what is passed over least. `first`: the measured ones are the first of the channel,
// whatever their frequencies.
std::vector<Eigen::Index> paired(const std::vector<double>& measured,
                                 const std::vector<double>& model, bool first,
                                 const std::vector<double>& handicaps = {},
                                 const Between& between = {});

// Below this share of the highest, a peak does not count as strong in a sweep of a table either;
// under a force every mode that moves the driven channel counts that is not near a node there.
inline constexpr double strong_on_table = 0.12, strong_under_force = 0.02;
// Weaker ones may still be meant, down to this share of that: a mode that a change makes weaker
// does not jump to another where it passes the limit.
inline constexpr double faint = 1. / 30;

// Modes that show as peaks of so many heights: at least `share` of the highest, and as many as were
// measured in any case; of several within their widths the highest. Those far out of the band that
// was measured do not count (band of no width: none was stated). `hertz` increases.
std::vector<Eigen::Index> strong_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& zeta,
                                       const Eigen::VectorXd& height,
                                       const std::array<double, 2>& band, std::size_t wanted,
                                       double share = strong_on_table);

// What it costs to take these modes for peaks, in terms of |ln f - ln f'|: one that is e times
// weaker than `share` of the highest of them, a tenth.
std::vector<double> handicaps(const Eigen::VectorXd& height, const std::vector<Eigen::Index>& modes,
                              double share);

} // namespace plica
