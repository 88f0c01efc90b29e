#include "app/run_shares.hpp"

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
constexpr std::array stages{
    Stage{"mesh", {0.15, 0.2, 0.1}},         Stage{"state", {1, 1, 5}},
    Stage{"symmetry", {0.1, 0.1, 0.1}},      Stage{"reduction", {0, 1.1, 0}},
    Stage{"assembly", {0, 1.3, 0.9}},        Stage{"factorisation", {0, 0, 1}},
    Stage{"statics", {0.6, 0.1, 1.3}},       Stage{"modes", {1.6, 0.1, 4.7}},
    Stage{"recovery", {0, 3.5, 0}},          Stage{"labels", {0.25, 3, 0.1}},
    Stage{"complex modes", {0.1, 0.1, 0.1}}, Stage{"response", {0.05, 0.05, 0.05}},
    Stage{"direct solution", {1, 1, 5}},     Stage{"transients and run-ups", {0.5, 0.5, 0.5}},
    Stage{"stress", {1.5, 1.5, 1.5}},        Stage{"reduced model of the joints", {0.1, 0.1, 0.1}},
    Stage{"levels of ", {3, 3, 3}},          Stage{"life", {0.5, 0.5, 0.5}}};

double times_of(std::string_view stage, const Case& data) {
  const Analyses& a = data.analyses;
  const bool modes = a.modes.has_value(), response = modes && a.response.has_value();
  if (stage == "state") return data.state ? (data.state->buckling > 0 ? 2 : 1) : 0;
  if (stage == "reduction") return a.reduction ? 1 : 0;
  if (stage == "statics") return a.statics.value_or(true) && data.caps.size() == 2 ? 1 : 0;
  if (stage == "factorisation" || stage == "modes" || stage == "labels" || stage == "recovery")
    return modes ? 1 : 0;
  if (stage == "complex modes")
    return modes && (a.damping.coupled || has_damped_springs(data)) ? 1 : 0;
  if (stage == "response") return response ? 1 : 0;
  if (stage == "direct solution") return response && a.response->referee > 0 ? 1 : 0;
  if (stage == "transients and run-ups")
    return response ? double(a.transients.size() + a.run_ups.size()) : 0;
  if (stage == "stress") return a.stress ? 1 : 0;
  if (stage == "reduced model of the joints") return a.levels ? 1 : 0;
  if (stage == "levels of ")
    return a.levels ? double(a.levels->bases.size() + a.levels->forces.size()) : 0;
  if (stage == "life") return a.life ? 1 : 0;
  return 1;
}

} // namespace

RunShares::RunShares(const Case& data) {
  for (const Stage& stage : stages) times_.push_back(times_of(stage.name, data));
}

double RunShares::before(std::size_t stage) const {
  double work = 0;
  for (std::size_t i = 0; i < stage; ++i)
    work += times_[i] * stages[i].seconds[std::size_t(route_)];
  return work;
}

double RunShares::at(const std::string& stage) {
  if (stage == "assembly" && route_ == Route::by_symmetry) route_ = Route::full;
  if (stage == "reduction") route_ = Route::reduced;
  const auto found = std::find_if(stages.begin(), stages.end(), [&](const Stage& known) {
    return stage.starts_with(known.name);
  });
  if (found == stages.end()) return share_;
  const auto number = std::size_t(found - stages.begin());
  double done = before(number);
  if (const std::string loaded = "state, "; stage.starts_with(loaded))
    done += found->seconds[std::size_t(route_)] *
            std::clamp(std::atof(stage.c_str() + loaded.size()) / 100, 0., 1.);
  if (stage.starts_with("levels of ")) done += families_++ * found->seconds[std::size_t(route_)];
  return share_ = std::max(share_, done / before(stages.size()));
}

} // namespace plica
