#include "run/analyses/referee.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXd;

// Flanks of the highest peaks, at most half of them, and the middles of equal stretches of the
// band.
std::vector<double> places(const Response& asked, const std::vector<ResponseResult>& responses) {
  std::vector<std::pair<double, double>> flanks; // height over the highest of its response, Hz
  for (const ResponseResult& r : responses) {
    double highest = 0;
    for (const ResponsePeak& p : r.peaks) highest = std::max(highest, p.amplitude);
    for (const ResponsePeak& p : r.peaks) {
      const double damping = std::isfinite(p.damping) ? std::max(p.damping, 1e-3) : 1e-2;
      const double f = p.frequency * (1 + damping);
      if (f < asked.band[1]) flanks.emplace_back(p.amplitude / highest, f);
    }
  }
  std::stable_sort(flanks.begin(), flanks.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> hertz;
  const auto count = std::size_t(asked.referee);
  for (const auto& [height, f] : flanks) {
    if (hertz.size() >= count / 2) break;
    if (std::none_of(hertz.begin(), hertz.end(),
                     [at = f](double other) { return std::abs(other / at - 1) < 1e-3; }))
      hertz.push_back(f);
  }
  const std::size_t even = count - hertz.size();
  for (std::size_t k = 0; k < even; ++k)
    hertz.push_back(asked.band[0] +
                    (asked.band[1] - asked.band[0]) * (double(k) + 0.5) / double(even));
  std::sort(hertz.begin(), hertz.end());
  return hertz;
}

} // namespace

void hold_against_direct_solution(const Response& asked, const SensorModel& model,
                                  const DirectProblem& problem, const DirectSolver& solver,
                                  std::vector<ResponseResult>& responses) {
  const std::vector<double> hertz = places(asked, responses);
  const std::vector<MatrixXcd> exact = solver(problem, hertz);
  for (std::size_t k = 0; k < hertz.size(); ++k)
    for (std::size_t e = 0; e < responses.size(); ++e) {
      const Eigen::RowVectorXcd by_modes =
          acceleration_of(model, problem.excited.list[e].parts, VectorXd::Constant(1, hertz[k]))
              .row(0);
      const Eigen::RowVectorXcd own = exact[k].row(Index(e));
      const double size = own.norm(), apart = (by_modes - own).norm();
      responses[e].direct.push_back({hertz[k], size > 0 ? apart / size : apart}); // nothing moves
    }
}

} // namespace plica
