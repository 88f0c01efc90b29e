// Case files to begin with, every line explained; NAME stands for the name of the case.
#include "io/input/starter_case.hpp"

namespace plica {
namespace {

constexpr const char* bellows =
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

constexpr const char* decoupler =
    R"(# A decoupler between two pipes: a bellows with an interlock, welded to pipes of an exhaust line.
#
#   plica run NAME.yaml             stiffness, modes, response; open out/report.html
#   plica reduce NAME.yaml          the superelement for the code that holds the rest of the line
#
# The line runs along y, x is transverse, z vertical. Quantities take a unit; a plain number is SI.
case: NAME
title: A decoupler between two pipes

assumptions:
  - The numbers of this file are those of `plica init`, not of a part.
  - The pipes are beams; their ends meet the bellows in rigid caps, as weld rings do.

materials:
  steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}

parts:
  inlet:
    type: beam
    points: [[0, 0, 0], [0, 200 mm, 0]]
    elements: 10
    section: {shape: pipe, material: steel, radius: 40 mm, thickness: 1.5 mm}
  bellows:
    type: bellows
    material: steel
    start: 200 mm
    root_radius: 40 mm
    profile:
      - {shape: cuff, length: 4 mm}
      - {shape: U, count: 12, height: 6 mm, pitch: 6 mm}
      - {shape: cuff, length: 4 mm}
    wall: {plies: [0.2 mm, 0.2 mm], bond: 0.5}
    mesh: {accuracy: 2 %}
  interlock: {type: interlock, along: bellows, attachment: synchronous, mass: 0.1 kg, radius: 34 mm}
  outlet:
    type: beam
    points: [[0, 280 mm, 0], [0, 580 mm, 0]]
    elements: 15
    section: {shape: pipe, material: steel, radius: 40 mm, thickness: 1.5 mm}

caps:
  flange: {of: inlet.start, mass: 0.6 kg}
  weld_in: {of: [inlet.end, bellows.left]}
  weld_out: {of: [bellows.right, outlet.start]}
  end: {of: outlet.end, mass: 0.4 kg}

mount:
  flange: rigid # on the engine
  end: # hung in rubber
    stiffness: [30 N/mm, 30 N/mm, 60 N/mm, 0, 0, 0]
    damping: {loss_factor: 10 %}

sensors:
  - {name: before, at: [0, 200 mm, 0]}
  - {name: behind, at: [0, 280 mm, 0]}

analyses:
  modes: {band: [0, 800 Hz]}
  damping: {modal: 1 %}
  reduction: {cutoff: 1000 Hz} # superelements between the caps, so that variants are quick
  response:
    base: # the engine shakes the flange, the other end rests
      - {move: [flange], direction: y}
      - {move: [flange], direction: z}
    band: [5 Hz, 400 Hz]
)";

constexpr const char* line =
    R"(# An exhaust line on an engine: flange, decoupler, muffler, hangers; orders of the engine.
#
#   plica run NAME.yaml             modes, response, orders; open out/report.html
#
# The line runs along y, x is transverse, z vertical. Quantities take a unit; a plain number is SI.
case: NAME
title: An exhaust line on its engine

assumptions:
  - The numbers of this file are those of `plica init`, not of a line.
  - The muffler is a rigid body in the middle of a stiff pipe.

materials:
  steel: {E: 193 GPa, nu: 0.3, rho: 8000 kg/m3}

parts:
  front:
    type: beam
    points: [[0, 0, 0], [0, 150 mm, 0]]
    elements: 8
    section: {shape: pipe, material: steel, radius: 40 mm, thickness: 1.5 mm}
  bellows:
    type: bellows
    material: steel
    start: 150 mm
    root_radius: 40 mm
    profile:
      - {shape: cuff, length: 4 mm}
      - {shape: U, count: 12, height: 6 mm, pitch: 6 mm}
      - {shape: cuff, length: 4 mm}
    wall: {plies: [0.2 mm, 0.2 mm], bond: 0.5}
    mesh: {accuracy: 2 %}
  interlock: {type: interlock, along: bellows, attachment: synchronous, mass: 0.1 kg, radius: 34 mm}
  rear:
    type: beam
    points: [[0, 230 mm, 0], [0, 500 mm, 0], [0, 900 mm, 0], [0, 1300 mm, 0], [0, 1500 mm, 0]]
    elements: 8
    section: {shape: pipe, material: steel, radius: 40 mm, thickness: 1.5 mm}
  muffler: {type: mass, at: "rear.point[3]", mass: 9 kg, inertia: [0.2, 0.08, 0.2, 0, 0, 0]}

caps:
  engine: {of: front.start, mass: 0.8 kg}
  weld_in: {of: [front.end, bellows.left]}
  weld_out: {of: [bellows.right, rear.start]}
  hanger_front: {of: "rear.point[2]"}
  hanger_rear: {of: rear.end}

mount:
  engine: rigid
  hanger_front: 
    stiffness: [15 N/mm, 15 N/mm, 30 N/mm, 0, 0, 0]
    damping: {loss_factor: 12 %}
  hanger_rear:
    stiffness: [15 N/mm, 15 N/mm, 30 N/mm, 0, 0, 0]
    damping: {loss_factor: 12 %}

sensors:
  - {name: behind, at: [0, 230 mm, 0]}
  - {name: muffler, at: [0, 900 mm, 0]}
  - {name: tail, at: [0, 1500 mm, 0]}

analyses:
  modes: {band: [0, 500 Hz]}
  damping: {modal: 1 %}
  reduction: {cutoff: 3000 Hz} # far above the band: `response: {referee: 8}` says what it costs
  response:
    base: # the engine moves, the body behind the hangers rests
      - {move: [engine], direction: y}
      - {move: [engine], direction: z}
    level: 5 m/s2
    band: [2 Hz, 250 Hz]
    random: {level: 0.05 (m/s2)2/Hz}
  run_ups:
    - name: full_load
      table: [[0 s, 700 rpm], [20 s, 2400 rpm]]
      orders: # amplitudes in m/s2 over the speed
        - {order: 3, of: engine_z, table: [[700 rpm, 4], [2400 rpm, 9]]}
        - {order: 3, of: engine_y, table: [[700 rpm, 1], [2400 rpm, 2]], phase: 90 deg}
        - {order: 0.5, of: engine_z, acceleration: 0.5 m/s2}
  transients:
    - {name: tip_in, of: engine_y, pulse: {acceleration: 10 m/s2, duration: 60 ms}}
)";

constexpr const char* beam = R"(# A beam with a mass on it: the smallest case, for a first look.
#
#   plica run NAME.yaml             modes, response; open out/report.html
case: NAME
title: A beam with a mass

materials:
  steel: {E: 205 GPa, nu: 0.3, rho: 7850 kg/m3}

parts:
  beam:
    type: beam
    points: [[0, 0, 0], [0, 300 mm, 0], [0, 600 mm, 0]] # point[1], point[2], point[3]
    elements: 8 # between two points
    section: {shape: rectangle, material: steel, width: 25 mm, depth: 15 mm} # or pipe, solid, general
  weight: {type: mass, at: "beam.point[2]", mass: 150 g +- 2 %}

caps:
  clamp: {of: beam.start}
  tip: {of: beam.end}

mount: {clamp: rigid}

sensors:
  - {name: tip, at: [0, 600 mm, 0]}

analyses:
  modes: {count: 8}
  damping: {modal: 0.5 %}
  response:
    base: [z]
    forces: [{name: tap, at: "beam.point[2]", direction: z, amplitude: 10 N}]
    band: [5 Hz, 600 Hz]
)";

constexpr const char* measurements =
    R"(# What was measured on NAME.yaml; plica schema measured says every key.
#
#   plica run NAME.yaml --out out     computed beside measured, in the report
#   plica compare out measured.yaml   modes paired by their shapes
#   plica diagnose NAME.yaml          where a gap lies, and what may cause it
#   plica fit NAME.yaml               the case fitted to it, where the case has `fit`
specimen: NAME
source: made up by `plica init`; say here who measured what, and how

sensors: [{name: tip, at: [0, 600 mm, 0], axes: [x, y, z], mass: 5 g}]
mass: {value: 2.02 kg, sigma: 5 g} # with its sensors
modes: # frequencies with the standard deviation of reading and mounting
  - {frequency: 34.6 Hz, sigma: 0.1 Hz, damping: 0.5 %, shape: transverse, direction: z, order: 1}
  - {frequency: 57.4 Hz, sigma: 0.2 Hz, damping: 0.5 %, shape: transverse, direction: x, order: 1}
  - {frequency: 214 Hz, sigma: 0.7 Hz, damping: 0.5 %, shape: transverse, direction: z, order: 2}
)";

std::string named(std::string text, const std::string& name) {
  for (std::size_t at = text.find("NAME"); at != std::string::npos; at = text.find("NAME", at))
    text.replace(at, 4, name);
  return text;
}

} // namespace

std::vector<StarterFile> starter_files(Starter kind, const std::string& name) {
  const auto own = [&](const char* text) { return StarterFile{name + ".yaml", named(text, name)}; };
  switch (kind) {
  case Starter::bellows:
    return {own(bellows)};
  case Starter::decoupler:
    return {own(decoupler)};
  case Starter::line:
    return {own(line)};
  case Starter::beam:
    return {own(beam)};
  case Starter::measured: {
    StarterFile with_test = own(beam);
    with_test.text += "\nmeasured: measured.yaml\n";
    return {with_test, {"measured.yaml", named(measurements, name)}};
  }
  }
  return {};
}

} // namespace plica
