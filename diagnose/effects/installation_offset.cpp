#include "diagnose/effects/in_state.hpp"
#include "model/description/place_keys.hpp"
#include "run/routes/route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plica {
namespace {

// Of an end that is bolted where the line happens to be: m, and N of the bolts that pull it there.
constexpr double usual_offset = 3e-3, usual_pull = 5e3;

constexpr std::array<const char*, 3> ways{"x", "axial", "z"};

EndOffset& offset_of(OperatingState& state, const std::string& cap) {
  const auto found = std::find_if(state.offset.begin(), state.offset.end(),
                                  [&](const EndOffset& o) { return o.cap == cap; });
  return found != state.offset.end() ? *found : state.offset.emplace_back(EndOffset{.cap = cap});
}

// Moved on from where the case has it.
CaseEdits moved_on(const Case& now, const std::string& cap, std::size_t direction, double by) {
  OperatingState state = now.state.value_or(OperatingState{});
  EndOffset& offset = offset_of(state, cap);
  offset.move[direction] += by;
  return {{"state.offset." + cap,
           fmt::format("{{move: [{}], turn: [{}]}}", fmt::join(offset.move, ", "),
                       fmt::join(offset.turn, ", "))}};
}

// One of two held ends stands off the place it has free of stress. Linear and square terms: along
// the pipe the wall is pulled, across it one side is as the other. Sampled where the part is
// pulled, as it may buckle where it is pressed. `stiffness`: against the motion, N/m.
Hypothesis moved_end(const std::string& cap, std::size_t direction, double stiffness) {
  const double sample = std::min(usual_offset, usual_pull / stiffness);
  const auto moved = [&](double by) {
    return [cap, direction, by](OperatingState& state) {
      offset_of(state, cap).move[direction] += by;
    };
  };
  const auto through = coefficients_through(
      [](double d) { return Eigen::VectorXd(Eigen::Vector2d(d, d * d)); }, {sample / 2, sample});
  return {.effect = "installation_offset",
          .place = mount_key(cap),
          .way = ways[direction],
          .parameters = {{"offset", "m", {PriorKind::normal, 0, sample}}},
          .case_changes = into_states({moved(sample / 2), moved(sample)}),
          .large = true,
          .coefficients = [through](const Eigen::VectorXd& v) { return through(v[0]); },
          .in_case =
              [cap, direction](const Case& now, const Eigen::VectorXd& v) {
                return moved_on(now, cap, direction, v[0]);
              }};
}

// Of the part between two caps, its ends kept from turning.
Matrix1212 stiffness_between(const Structure& s, const std::string& first,
                             const std::string& second) {
  Timing timing;
  const auto route = choose_route(
      s.built, s.data.analyses, [](const std::string&) {}, timing);
  const auto K = route->end_stiffness({s.built.cap_nodes.at(first), s.built.cap_nodes.at(second)});
  return K ? *K : Matrix1212(Matrix1212::Zero());
}

std::vector<Hypothesis> installation_offset_hypotheses(const Structure& s) {
  std::vector<std::string> held;
  for (const Mount& m : s.data.mount)
    if (m.kind != MountKind::free && cap_named(s.data, m.cap)) held.push_back(m.cap);
  std::vector<Hypothesis> found;
  if (held.size() != 2 || !s.data.supports.empty() || !asked_for(s, "installation_offset"))
    return found;
  const Matrix1212 K = stiffness_between(s, held[0], held[1]);
  for (std::size_t direction : {1, 0, 2})
    if (const double k = K(6 + Eigen::Index(direction), 6 + Eigen::Index(direction)); k > 0)
      found.push_back(moved_end(held[1], direction, k));
  return found;
}

} // namespace

Effect installation_offset() {
  return {.name = "installation_offset",
          .plain = "an end that is mounted {offset} off the place it has free of stress",
          .physics =
              "the part is stretched or bent by its installation, and the stress stiffens or "
              "softens it",
          .signature = "stretched, transverse modes rise and axial ones hardly move; across, modes "
                       "that were equal part",
          .look_alikes = {{"pressure", "a gauge, or vent the part"},
                          {"boundary_compliance", "an accelerometer on the held end"},
                          {"component_stiffness", "loosen one end and see how far it springs"}},
          .needs = "two held ends, and diagnose: effects or priors of the case that name it",
          .hypotheses = installation_offset_hypotheses};
}

} // namespace plica
