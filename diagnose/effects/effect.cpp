#include "diagnose/effects/effect.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plica {

double value_of(const Prior& prior, double z) {
  if (prior.kind == PriorKind::normal) return prior.centre + prior.width * z;
  if (prior.kind == PriorKind::log_normal) return prior.centre * std::exp(prior.width * z);
  const double share = std::erfc(-z / std::sqrt(2.)) / 2;
  return prior.centre + (prior.width - prior.centre) * share;
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
  static const std::vector<Effect> all{
      {"ply_slip",
       "the plies of the wall slip on each other more, or less, than the case says",
       "all elastic modes and the static stiffness fall alike, the mass stays",
       {"forming_thinning: weigh, measure the thickness by ultrasound",
        "temperature: repeat after a soak",
        "joint_stiffness: a sweep at a lower level, strain of other modes"},
       ply_slip},
      {"joint_friction",
       "a joint slips: its stiffness falls and its damping changes with amplitude",
       "frequencies fall with the level, damping rises and falls again",
       {"ply_slip: the static stiffness at a small and a large stroke",
        "joint_stiffness: further levels", "damping: a free decay at a low level"},
       joint_friction},
      {"joint_stiffness",
       "a joint between two parts is softer or stiffer than the case says",
       "modes that strain the joint move, at every level alike",
       {"joint_friction: further levels", "ply_slip: modes that do not strain the joint",
        "boundary_compliance: an accelerometer on the held end"},
       joint_stiffness},
      {"fixture_flexibility",
       "a held end stands on a fixture with mass and a resonance of its own",
       "the lowest modes fall, a further resonance appears, the held end moves",
       {"boundary_compliance: an accelerometer on the fixture",
        "added_mass: a response of the fixture alone"},
       fixture_flexibility},
      {"boundary_compliance",
       "a held end gives way elastically",
       "the lowest modes fall most, the static stiffness of the rig stays",
       {"fixture_flexibility: an accelerometer on the fixture",
        "joint_stiffness: the static stiffness of the rig",
        "unweighed_mass: an accelerometer on the held end"},
       boundary_compliance},
      {"extra_support",
       "something touches the structure between its held ends",
       "modes that move the spot rise, the others and the static stiffness stay",
       {"joint_stiffness: other modes", "component_mass: weigh the part"},
       extra_support},
      {"added_mass",
       "a mass at a spot that the scale did not see: a sensor, a clamp, a deposit",
       "modes that move the spot fall, mass and static stiffness stay",
       {"component_mass: weigh the part", "unweighed_mass: a second sensor of the same mass",
        "boundary_compliance: the antinodes of further modes"},
       added_mass},
      {"component_mass",
       "a part is heavier or lighter than drawn, and the scale sees it",
       "mass and the modes that move the part",
       {"unweighed_mass: weigh again", "added_mass: weigh with everything on it"},
       component_mass},
      {"local_damage",
       "a dent or crack takes stiffness from one side of one place",
       "x and z differ, a motion along one shows along the other",
       {"rotated_sensor: turn the sensor", "cross_axis_base_motion: an accelerometer on the table",
        "joint_stiffness: turn the specimen by 90 degrees"},
       local_damage},
      {"forming_thinning",
       "the wall is thinner towards the crown, as forming leaves it",
       "the stiffness falls, and the mass a little",
       {"ply_slip: weigh, measure the thickness", "temperature: weigh"},
       forming_thinning},
      {"damping",
       "all damping is higher or lower than the case says, at every level",
       "peaks and their widths, not their frequencies",
       {"joint_friction: further levels", "sensor_gain: the width of the peaks"},
       damping},
      {"cross_axis_base_motion",
       "the table also moves along another axis than it was told",
       "cross responses that follow the other axis",
       {"local_damage: an accelerometer on the table", "rotated_sensor: turn the sensor"},
       cross_axis_base_motion},
      {"temperature",
       "the specimen is warmer or colder than the material data",
       "frequencies, static stiffness and damping move together",
       {"ply_slip: a thermometer", "damping: repeat after a soak"},
       temperature},
      {"rotated_sensor",
       "a sensor is turned about one of its axes",
       "its cross channels show the main motion, those of other sensors do not",
       {"local_damage: turn the sensor, look at a second one",
        "cross_axis_base_motion: an accelerometer on the table"},
       rotated_sensor},
      {"sensor_gain",
       "a sensor reads too much or too little",
       "all its amplitudes, no frequency, no width of a peak",
       {"damping: the width of the peaks", "added_mass: exchange the sensor"},
       sensor_gain},
      {"unweighed_mass",
       "mass spread over a part that the scale did not see: a fluid, a coating",
       "all modes of the part fall, mass and static stiffness stay",
       {"boundary_compliance: an accelerometer on the held end",
        "fixture_flexibility: a response of the fixture", "added_mass: further modes"},
       unweighed_mass},
  };
  return all;
}

const Effect& effect_named(const std::string& name) {
  const std::vector<Effect>& all = effects();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Effect& e) { return e.name == name; });
  if (found == all.end()) throw std::out_of_range("no effect is called " + name);
  return *found;
}

} // namespace plica
