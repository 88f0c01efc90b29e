#include "diagnose/effects/effect.hpp"

namespace plica {
namespace {

std::vector<Hypothesis> damping_hypotheses(const Structure&) {
  return {{.effect = "damping",
           .place = "all",
           .way = "",
           .parameters = {{"ratio", "", {PriorKind::log_normal, 1, 0.6}}},
           .setup = [](TestSetup& setup, const Eigen::VectorXd& v) { setup.damping *= v[0]; },
           .in_case = [](const Case& now,
                         const Eigen::VectorXd& v) { return with_damping(now, v[0]); }}};
}

} // namespace

Effect damping() {
  return {.name = "damping",
          .plain = "damping that is {ratio+} off the case everywhere",
          .physics = "all damping is higher or lower than the case says, at every level",
          .signature = "peaks and their widths, not their frequencies",
          .look_alikes = {{"joint_friction", "further levels"},
                          {"sensor_gain", "the width of the peaks"}},
          .needs = "",
          .hypotheses = damping_hypotheses};
}

} // namespace plica
