#include "diagnose/effects/in_state.hpp"
#include "model/description/operating_state_checks.hpp"

#include <algorithm>

namespace plica {
namespace {

constexpr double usual_pressure = 0.5e5, most_pressure = 4e5; // Pa, of exhaust gas

// Inside all bellows, whose ends are closed.
std::vector<Hypothesis> pressure_hypotheses(const Structure& s) {
  const bool any = std::any_of(s.data.parts.begin(), s.data.parts.end(), [](const Part& part) {
    return std::holds_alternative<Bellows>(part.body);
  });
  if (!any || !open_ends(s.data).empty() || !asked_for(s, "pressure")) return {};
  const auto through =
      coefficients_through([](double p) { return Eigen::VectorXd(Eigen::Vector2d(p, p * p)); },
                           {usual_pressure, 2 * usual_pressure});
  return {{.effect = "pressure",
           .place = "all",
           .way = "",
           .parameters = {{"pressure",
                           "Pa",
                           {PriorKind::log_normal, usual_pressure, 1, 0, most_pressure}}},
           .case_changes =
               into_states({[](OperatingState& state) { state.pressure += usual_pressure; },
                            [](OperatingState& state) { state.pressure += 2 * usual_pressure; }}),
           .large = true,
           .coefficients = [through](const Eigen::VectorXd& v) { return through(v[0]); },
           .in_case = [](const Case& now, const Eigen::VectorXd& v) -> CaseEdits {
             return {{"state.pressure", yaml_of((now.state ? now.state->pressure : 0) + v[0])}};
           }}};
}

} // namespace

Effect pressure() {
  return {
      .name = "pressure",
      .plain = "gas of {pressure} inside, which nobody stated",
      .physics = "pressure inside presses the wall between held ends as a load presses a column",
      .signature = "transverse modes fall, axial ones and the wall's own hardly move",
      .look_alikes = {{"installation_offset", "the same with the part vented"},
                      {"temperature", "a thermometer"}},
      .needs = "bellows closed by caps, and diagnose: effects or priors of the case that name it",
      .hypotheses = pressure_hypotheses};
}

} // namespace plica
