// Which modes of a model are the peaks of a measured channel.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace plica {

// Peaks of a model in the order of measured ones: increasing, each at most once while there are
// enough, the sum of |ln f - ln f'| least. `first`: the measured ones are the first of the channel,
// whatever their frequencies.
std::vector<Eigen::Index> paired(const std::vector<double>& measured,
                                 const std::vector<double>& model, bool first);

// Below this share of the highest, a peak does not count as strong in a sweep of a table either;
// under a force every mode that moves the driven channel counts that is not near a node there.
inline constexpr double strong_on_table = 0.12, strong_under_force = 0.02;

// Modes that show as peaks of so many heights: at least `share` of the highest, and as many as were
// measured in any case; of several within their widths the highest. Those far out of the band that
// was measured do not count (band of no width: none was stated). `hertz` increases.
std::vector<Eigen::Index> strong_peaks(const Eigen::VectorXd& hertz, const Eigen::VectorXd& zeta,
                                       const Eigen::VectorXd& height,
                                       const std::array<double, 2>& band, std::size_t wanted,
                                       double share = strong_on_table);

} // namespace plica
