#include "run/results/results.hpp"

#include "run/results/number_keys.hpp"
#include "words/directions.hpp"
#include "words/mode_kinds.hpp"

#include <algorithm>

namespace plica {

DirectCheck farthest(const std::vector<DirectCheck>& checks) {
  return *std::max_element(
      checks.begin(), checks.end(),
      [](const DirectCheck& a, const DirectCheck& b) { return a.difference < b.difference; });
}

std::map<std::string, double> headline(const Results& results) {
  std::map<std::string, double> numbers;
  numbers[number_key::mass] = results.model.mass;
  if (results.statics) numbers["k_axial"] = results.statics->k_axial;
  for (const ModeResult& mode : results.modes) {
    if (place_among(mode_kind::of_a_rod, mode.shape) < 0) continue;
    const auto [place, is_new] =
        numbers.try_emplace(number_key::of(NumberKind::frequency, mode.shape), mode.frequency);
    if (!is_new && mode.frequency < place->second) place->second = mode.frequency;
  }
  if (results.life)
    for (const DutyResult& duty : results.life->duties)
      if (duty.range > 0) numbers[number_key::of(NumberKind::stress_range, duty.name)] = duty.range;
  return numbers;
}

Eigen::MatrixXd vector_sum(const ResponseResult& response) {
  const Eigen::Index sensors = response.acceleration.cols() / 3;
  Eigen::MatrixXd sum(response.acceleration.rows(), sensors);
  for (Eigen::Index s = 0; s < sensors; ++s)
    sum.col(s) = response.acceleration.middleCols(3 * s, 3).rowwise().norm();
  return sum;
}

} // namespace plica
