// A straight tube between two caps, for runs against closed forms.
#pragma once

#include "tests/bellows_case.hpp"

namespace plica::test {

constexpr double L = 0.8, EA = 4e6, EI = 900, GJ = 500, GA = 1e5;

// A straight beam along y between two caps, of general section.
inline Case tube(double mass_per_length) {
  BeamPart beam;
  beam.points = {{0, 0, 0}, {0, L, 0}};
  beam.elements = 16;
  beam.section.shape = BeamShape::general;
  beam.section.EA = EA;
  beam.section.EI = EI;
  beam.section.GJ = GJ;
  beam.section.GA = GA;
  beam.section.mass_per_length = mass_per_length;
  beam.section.rotary_inertia_per_length = 1e-6;
  beam.section.polar_inertia_per_length = 2e-6;
  Case data;
  data.name = "tube";
  data.parts = {{"tube", beam}};
  data.caps = {{.name = "left", .of = {"tube.start"}}, {.name = "right", .of = {"tube.end"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  return data;
}

// Two masses on springs in all directions, joined by a stiff tube; one sensor at its end.
inline Case sprung_tube(double k) {
  Case data = tube(1e-6);
  for (Cap& cap : data.caps) cap.mass = 2;
  for (Mount& mount : data.mount) {
    mount.kind = MountKind::springs;
    mount.stiffness = {0.25 * k, k, 2.25 * k, 1, 1, 1};
  }
  data.analyses.modes = Modes{.count = 6};
  data.analyses.damping.modal = 0.02;
  data.sensors = {{.name = "end", .at = {0, L, 0}}};
  return data;
}

inline Motion motion_of(const std::string& cap, int direction, double amplitude = 1,
                        double phase = 0) {
  Motion motion;
  motion.move = {cap};
  motion.direction = direction;
  motion.amplitude = amplitude;
  motion.phase = phase;
  return motion;
}

inline EndMotion end_of(const Motion& motion) {
  return motion;
}

// A mass in the middle of a massless bar between two mounts, watched there.
inline Case mass_between(double k_left, double k_right, double mass, double zeta) {
  Case data = tube(1e-6);
  std::get<BeamPart>(data.parts[0].body).points = {{0, 0, 0}, {0, L / 2, 0}, {0, L, 0}};
  data.parts.push_back({"weight", PointMass{.at = "tube.point[2]", .mass = mass}});
  for (std::size_t i = 0; i < 2; ++i) {
    data.mount[i].kind = MountKind::springs;
    const double k = i == 0 ? k_left : k_right;
    data.mount[i].stiffness = {k, k, k, k, k, k};
  }
  data.sensors = {{.name = "mid", .at = {0, L / 2, 0}}};
  data.analyses.statics = false;
  data.analyses.modes = Modes{.count = 3};
  data.analyses.damping.modal = zeta;
  data.analyses.error_bars = false;
  return data;
}

} // namespace plica::test
