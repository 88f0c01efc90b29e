#include "model/description/spring_damping.hpp"

#include <algorithm>
#include <numbers>

namespace plica {
namespace {

// Of the table, (k' / k) (1 + i eta), at a frequency.
std::complex<double> tabulated(const std::vector<std::array<double, 3>>& table, double hertz) {
  const auto above =
      std::find_if(table.begin(), table.end(), [&](const auto& row) { return row[0] > hertz; });
  const auto& high = above == table.end() ? table.back() : *above;
  const auto& low = above == table.begin() ? table.front() : *(above - 1);
  const double share = high[0] > low[0] ? (hertz - low[0]) / (high[0] - low[0]) : 0;
  const double ratio = low[1] + share * (high[1] - low[1]);
  const double eta = low[2] + share * (high[2] - low[2]);
  return ratio * std::complex<double>(1, eta);
}

} // namespace

std::complex<double> added_stiffness(const SpringDamping& d, int dof, double k,
                                     std::complex<double> s) {
  std::complex<double> ratio(0, d.loss_factor);
  for (const MaxwellBranch& m : d.maxwell) ratio += m.share * s * m.time / (1. + s * m.time);
  if (d.springpot) ratio += std::pow(s * d.springpot->time, d.springpot->exponent);
  if (!d.table.empty()) ratio += tabulated(d.table, s.imag() / (2 * std::numbers::pi)) - 1.;
  return k * ratio + (d.dashpot ? (*d.dashpot)[std::size_t(dof)] * s : 0.);
}

} // namespace plica
