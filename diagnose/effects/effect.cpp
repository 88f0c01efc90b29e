#include "diagnose/effects/effect.hpp"

#include "run/results/normal_distribution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plica {

std::uint64_t Identity::next() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

namespace {

// Share of an unbounded prior below a value.
double share_below(const Prior& prior, double value) {
  if (prior.kind == PriorKind::normal) return normal_share((value - prior.centre) / prior.width);
  if (prior.kind == PriorKind::log_normal)
    return value > 0 ? normal_share(std::log(value / prior.centre) / prior.width) : 0;
  return std::clamp((value - prior.centre) / (prior.width - prior.centre), 0., 1.);
}

} // namespace

double value_of(const Prior& prior, double z) {
  if (prior.bounded()) {
    constexpr double end = 1e-12; // shares within which a quantile is a number
    const double from = share_below(prior, prior.low), to = share_below(prior, prior.high);
    const double share = std::clamp(from + (to - from) * normal_share(z), end, 1 - end);
    Prior free = prior;
    free.low = -std::numeric_limits<double>::infinity();
    free.high = -free.low;
    return std::clamp(value_of(free, normal_quantile(share)), prior.low, prior.high);
  }
  if (prior.kind == PriorKind::normal) return prior.centre + prior.width * z;
  if (prior.kind == PriorKind::log_normal) return prior.centre * std::exp(prior.width * z);
  const double share = normal_share(z);
  return prior.centre +
         (prior.width - prior.centre) * (prior.kind == PriorKind::uniform
                                             ? share
                                             : (1 - std::cos(std::numbers::pi * share)) / 2);
}

std::function<Eigen::VectorXd(double)>
coefficients_through(const std::function<Eigen::VectorXd(double)>& functions,
                     const std::vector<double>& samples) {
  const auto n = Eigen::Index(samples.size());
  Eigen::MatrixXd F(n, n);
  for (Eigen::Index j = 0; j < n; ++j) F.col(j) = functions(samples[std::size_t(j)]);
  const Eigen::MatrixXd inverse = F.inverse();
  return [functions, inverse](double value) { return Eigen::VectorXd(inverse * functions(value)); };
}

const std::vector<Effect>& effects() {
  static const std::vector<Effect> all{ply_slip(),
                                       joint_friction(),
                                       joint_stiffness(),
                                       fixture_flexibility(),
                                       boundary_compliance(),
                                       extra_support(),
                                       added_mass(),
                                       component_mass(),
                                       component_stiffness(),
                                       local_damage(),
                                       forming_thinning(),
                                       damping(),
                                       cross_axis_base_motion(),
                                       temperature(),
                                       rotated_sensor(),
                                       sensor_gain(),
                                       unweighed_mass(),
                                       installation_offset(),
                                       pressure()};
  return all;
}

bool asked_for(const Structure& s, const std::string& effect) {
  const DiagnosisRequest& asked = s.data.diagnose;
  return std::find(asked.effects.begin(), asked.effects.end(), effect) != asked.effects.end() ||
         std::any_of(asked.priors.begin(), asked.priors.end(),
                     [&](const PriorRequest& p) { return p.effect == effect; });
}

const Effect& effect_named(const std::string& name) {
  const std::vector<Effect>& all = effects();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Effect& e) { return e.name == name; });
  if (found == all.end()) throw std::out_of_range("no effect is called " + name);
  return *found;
}

} // namespace plica
