#include "app/run_shares.hpp"

#include "run/stages.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace plica {
namespace {

// Seconds of a stage, by the way the case is solved (Route), in the order in which they come. A
// stage that a way does not have counts nothing there.
struct Stage {
  std::string_view name; // or how it begins
  std::array<double, 3> seconds;
};
constexpr std::array all_stages{
    Stage{stages::mesh, {0.15, 0.2, 0.1}},         Stage{stages::state, {1, 1, 5}},
    Stage{stages::symmetry, {0.1, 0.1, 0.1}},      Stage{stages::reduction, {0, 1.1, 0}},
    Stage{stages::assembly, {0, 1.3, 0.9}},        Stage{stages::factorisation, {0, 0, 1}},
    Stage{stages::statics, {0.6, 0.1, 1.3}},       Stage{stages::modes, {1.6, 0.1, 4.7}},
    Stage{stages::recovery, {0, 3.5, 0}},          Stage{stages::labels, {0.25, 3, 0.1}},
    Stage{stages::complex_modes, {0.1, 0.1, 0.1}}, Stage{stages::response, {0.05, 0.05, 0.05}},
    Stage{stages::direct_solution, {1, 1, 5}},     Stage{stages::dynamics, {0.5, 0.5, 0.5}},
    Stage{stages::stress, {1.5, 1.5, 1.5}},        Stage{stages::joints, {0.1, 0.1, 0.1}},
    Stage{stages::levels_of, {3, 3, 3}},           Stage{stages::life, {0.5, 0.5, 0.5}}};

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
  for (const Stage& stage : all_stages) times_.push_back(times_of(stage.name, data));
}

double RunShares::before(std::size_t stage) const {
  double work = 0;
  for (std::size_t i = 0; i < stage; ++i)
    work += times_[i] * all_stages[i].seconds[std::size_t(route_)];
  return work;
}

double RunShares::at(const std::string& stage) {
  if (stage == stages::assembly && route_ == Route::by_symmetry) route_ = Route::full;
  if (stage == stages::reduction) route_ = Route::reduced;
  const auto found = std::find_if(all_stages.begin(), all_stages.end(), [&](const Stage& known) {
    return stage.starts_with(known.name);
  });
  if (found == all_stages.end()) return share_;
  const auto number = std::size_t(found - all_stages.begin());
  double done = before(number);
  if (const std::string loaded = stages::state_at; stage.starts_with(loaded))
    done += found->seconds[std::size_t(route_)] *
            std::clamp(std::atof(stage.c_str() + loaded.size()) / 100, 0., 1.);
  if (stage.starts_with(stages::levels_of))
    done += level_runs_++ * found->seconds[std::size_t(route_)];
  return share_ = std::max(share_, done / before(all_stages.size()));
}

} // namespace plica
