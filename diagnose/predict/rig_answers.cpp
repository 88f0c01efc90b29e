// Dynamic stiffness and loss that a rig would read of a state.
#include "diagnose/predict/state_answers.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Complex = std::complex<double>;

} // namespace

// What the group has less than when it is stuck: its sliders at the stretch that the end gives
// them, which grows as they give way.
Complex StateAnswers::softer_by(const Reading& reading, const RigDynamics& rig) const {
  Softening softening = acting_.softening;
  constexpr int along_the_pipe = 1;
  if (reading.axis != along_the_pipe) softening.distance *= softening.across;
  const double stuck = acting_.rig[acting_.group->change] + acting_.group->present;
  const Sliders sliders(softening);
  Complex softer = 0;
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round) {
    const Complex kept = sliders.kept(reading.stroke * rig.stretch(reading.axis, softer.real()));
    softer = stuck * softening.share * Complex(1 - kept.real(), -softening.loss * kept.imag());
  }
  return softer;
}

double StateAnswers::rig_answer(const Reading& reading) {
  auto own = rigs_.find(reading.rig.ends);
  if (own == rigs_.end())
    own = rigs_
              .try_emplace(reading.rig.ends,
                           Rig{.dynamics = RigDynamics(own_, reading.rig.ends, acting_.rig,
                                                       acting_.setup.damping, acting_.group)})
              .first;
  Rig& rig = own->second;
  const int axis = reading.axis;
  const bool slips = acting_.group && reading.stroke > 0;
  const std::pair slip{slips ? reading.stroke : 0., slips ? axis : 0};
  if (slips && !rig.softer.contains(slip)) rig.softer[slip] = softer_by(reading, rig.dynamics);
  const auto [known, made] =
      rig.at.try_emplace({reading.rig.hertz, slip.first, slip.second}, std::nullopt);
  if (made) known->second = rig.dynamics.at(reading.rig.hertz, slips ? rig.softer[slip] : 0.);
  if (!known->second) return not_given;
  const Complex1212& Z = *known->second;
  const Complex k = reading.rig.driving_point ? Z(axis, axis) : -Z(6 + axis, axis);
  if (reading.kind == ReadingKind::loss) return std::log(std::abs(k.imag()) / std::abs(k));
  return std::log(reading.rig.storage ? std::abs(k.real()) : std::abs(k));
}

} // namespace plica
