#include "run/study/run_shares.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace plica {
namespace {

// Seconds of a stage, by the way the case is solved (Route), in the order in which they come. A
// stage that a way does not have counts nothing there.
struct Known {
  std::string_view kind;
  std::array<double, 3> seconds;
};
constexpr std::array all_stages{
    Known{stages::mesh, {0.15, 0.2, 0.1}},         Known{stages::state, {1, 1, 5}},
    Known{stages::symmetry, {0.1, 0.1, 0.1}},      Known{stages::reduction, {0, 1.1, 0}},
    Known{stages::assembly, {0, 1.3, 0.9}},        Known{stages::factorisation, {0, 0, 1}},
    Known{stages::statics, {0.6, 0.1, 1.3}},       Known{stages::modes, {1.6, 0.1, 4.7}},
    Known{stages::recovery, {0, 3.5, 0}},          Known{stages::labels, {0.25, 3, 0.1}},
    Known{stages::complex_modes, {0.1, 0.1, 0.1}}, Known{stages::response, {0.05, 0.05, 0.05}},
    Known{stages::direct_solution, {1, 1, 5}},     Known{stages::dynamics, {0.5, 0.5, 0.5}},
    Known{stages::stress, {1.5, 1.5, 1.5}},        Known{stages::joints, {0.1, 0.1, 0.1}},
    Known{stages::levels_of, {3, 3, 3}},           Known{stages::life, {0.5, 0.5, 0.5}}};

double times_of(std::string_view stage, const Case& data) {
  const Analyses& a = data.analyses;
  const bool modes = a.modes.has_value(), response = modes && a.response.has_value();
  if (stage == stages::state) return data.state ? (data.state->buckling > 0 ? 2 : 1) : 0;
  if (stage == stages::reduction) return a.reduction ? 1 : 0;
  if (stage == stages::statics)
    return a.deck_loads || (a.statics.value_or(true) && data.caps.size() == 2) ? 1 : 0;
  if (stage == stages::factorisation || stage == stages::modes || stage == stages::labels ||
      stage == stages::recovery)
    return modes ? 1 : 0;
  if (stage == stages::complex_modes)
    return modes && (a.damping.coupled || has_damped_springs(data)) ? 1 : 0;
  if (stage == stages::response) return response ? 1 : 0;
  if (stage == stages::direct_solution) return response && a.response->referee > 0 ? 1 : 0;
  if (stage == stages::dynamics)
    return response ? double(a.transients.size() + a.run_ups.size()) : 0;
  if (stage == stages::stress) return a.stress ? 1 : 0;
  if (stage == stages::joints) return a.levels ? 1 : 0;
  if (stage == stages::levels_of)
    return a.levels ? double(a.levels->bases.size() + a.levels->forces.size()) : 0;
  if (stage == stages::life) return a.life ? 1 : 0;
  return 1;
}

} // namespace

RunShares::RunShares(const Case& data) {
  for (const Known& stage : all_stages) times_.push_back(times_of(stage.kind, data));
}

double RunShares::before(std::size_t stage) const {
  double work = 0;
  for (std::size_t i = 0; i < stage; ++i)
    work += times_[i] * all_stages[i].seconds[std::size_t(route_)];
  return work;
}

double RunShares::at(const Stage& stage) {
  if (stage.kind == stages::assembly && route_ == Route::by_symmetry) route_ = Route::full;
  if (stage.kind == stages::reduction) route_ = Route::reduced;
  const auto found = std::find_if(all_stages.begin(), all_stages.end(),
                                  [&](const Known& known) { return stage.kind == known.kind; });
  if (found == all_stages.end()) return share_;
  const double seconds = found->seconds[std::size_t(route_)];
  double done =
      before(std::size_t(found - all_stages.begin())) + seconds * std::clamp(stage.done, 0., 1.);
  if (stage.kind == stages::levels_of) done += level_runs_++ * seconds;
  return share_ = std::max(share_, done / before(all_stages.size()));
}

} // namespace plica
