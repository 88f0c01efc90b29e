#include "io/input/starter_case.hpp"

namespace plica {

std::string starter_case(const std::string& name) {
  std::string text =
      R"(# A flexible pipe: a bellows with a strip-wound interlock inside and end caps.
#
#   plica check NAME.yaml               what is wrong with this file, if anything
#   plica run NAME.yaml --out out       stiffness, modes, response; open out/report.html
#   plica schema case                   every key there is, with its unit
#
# Quantities take a unit (0.25 mm, 193 GPa); a plain number is in SI. The pipe lies along y, x is
# transverse, z vertical. All lengths of the wall are those of its mid-surface. A number may have a
# tolerance (8 mm +- 0.5 mm): the results then have error bars.
case: NAME
title: A flexible pipe

assumptions: # what you took for granted; it stands in the report
  - The numbers of this file are those of `plica init`, not of a part.

materials:
  steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}

parts:
  bellows:
    type: bellows
    material: steel
    root_radius: 40 mm # of the straight ends
    profile: # from left to right; shapes: cuff, U, omega, disc, points
      - {shape: cuff, length: 4 mm}
      - {shape: U, count: 12, height: 6 mm +- 0.3 mm, pitch: 6 mm} # arc radii: a quarter of the pitch
      - {shape: cuff, length: 4 mm}
    wall:
      plies: [0.2 mm +- 0.01 mm, 0.2 mm +- 0.01 mm]
      bond: 0.5 # 0: the plies slip on each other; 1: they act as one wall
      thinning: none # or uniform, local: what forming leaves
    mesh: {accuracy: 2 %} # in stiffness; or counts: {around: 48, arc: 3, wall: 3}
  interlock:
    type: interlock
    along: bellows
    attachment: synchronous # moves with the bellows; `stations` and `caps` give it stiffness
    mass: 0.1 kg
    radius: 34 mm

caps:
  left: {of: bellows.left, mass: 0.15 kg}
  right: {of: bellows.right, mass: 0.15 kg}

mount: {left: rigid, right: rigid} # on the shaker table

sensors:
  - {name: mid, at: [0, 37 mm, 46 mm]} # on top of the crown nearest to the middle; `mass: 2 g` makes it one-sided, and slower

analyses:
  static: true # end stiffness between the two caps
  modes: {count: 12} # proved complete by a count of the eigenvalues below
  damping: {modal: 1 %}
  response: # to motion of the table along y, then x
    base: [y, x]
    level: 10 m/s2
    band: [100 Hz, 1500 Hz]

# What a scale, a rig and a shaker table gave stands in a file of its own (plica schema measured):
# measured: measured.yaml
)";
  for (std::size_t at = text.find("NAME"); at != std::string::npos; at = text.find("NAME", at))
    text.replace(at, 4, name);
  return text;
}

} // namespace plica
