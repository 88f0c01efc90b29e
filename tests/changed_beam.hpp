// A beam whose modes are percents off those of its model, measured before and after a change.
#pragma once

#include "diagnose/diagnose.hpp"
#include "diagnose/predict/predictor.hpp"
#include "diagnose/readings/readings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace plica::changed_beam {

// A steel beam along y of stretches of one length, bending in x and z, held at its start or free.
inline Case beam_of(int stretches, double length, double width, double depth, bool held) {
  Case c;
  c.name = "beam";
  c.materials["steel"] = {.E = 200e9, .nu = 0.3, .rho = 7850};
  BeamPart beam;
  for (int i = 0; i <= stretches; ++i) beam.points.push_back({0, length * i / stretches, 0});
  beam.elements = 6;
  beam.up = {0, 0, 1};
  beam.section.shape = BeamShape::rectangle;
  beam.section.material = "steel";
  beam.section.width = width;
  beam.section.depth = depth;
  c.parts.push_back({"beam", beam});
  if (held) {
    Cap root;
    root.name = "root";
    root.of = {"beam.start"};
    c.caps.push_back(root);
    c.mount.push_back({.cap = "root"});
  }
  c.analyses.modes = Modes{.count = 8};
  c.analyses.damping.modal = 0.01;
  return c;
}

// The beam of the tests of baselines: half a metre of 30 x 10 mm in five stretches, held.
inline Case held_beam() {
  return beam_of(5, 0.5, 0.03, 0.01, true);
}

// The same with one element to each stretch: a diagnosis of it takes a fifth of the time.
inline Case coarsely_meshed(Case c) {
  std::get<BeamPart>(c.parts[0].body).elements = 1;
  return c;
}

// With 120 g clamped to it 0.3 m along.
inline Case with_a_clamp(Case c) {
  PointMass mass;
  mass.at = "beam.point[4]";
  mass.mass = 0.12;
  c.parts.push_back({"clamp", mass});
  return c;
}

// Masses of 40, 50 and 60 g at points 2 to 4 of it: m1, m2, m3.
inline void add_masses(Case& c) {
  for (int k = 2; k <= 4; ++k) {
    PointMass mass;
    mass.at = "beam.point[" + std::to_string(k) + "]";
    mass.mass = 0.02 + 0.01 * k;
    c.parts.push_back({"m" + std::to_string(k - 1), mass});
  }
}

// The same beam with a mass, kg, at a new point of it, m along, that becomes its third.
inline Case with_third_point(Case c, double along, double mass) {
  std::vector<Triple>& points = std::get<BeamPart>(c.parts[0].body).points;
  points.insert(points.begin() + 2, {0, along, 0});
  PointMass body;
  body.at = "beam.point[3]";
  body.mass = mass;
  c.parts.push_back({"clamp", body});
  return c;
}

// Two halves of a clamped beam of 0.6 m that meet in the cap "joint", in springs or rigidly.
inline Case two_halves(const std::optional<Sextuple>& springs) {
  Case c = beam_of(4, 0.6, 0.025, 0.012, true);
  Part second = c.parts[0];
  std::get<BeamPart>(c.parts[0].body).points = {{0, 0, 0}, {0, 0.15, 0}, {0, 0.3, 0}};
  second.name = "beam2";
  std::get<BeamPart>(second.body).points = {{0, 0.3, 0}, {0, 0.45, 0}, {0, 0.6, 0}};
  c.parts.push_back(second);
  Cap joint;
  joint.name = "joint";
  joint.of = {"beam.end", "beam2.start"};
  joint.stiffness = springs;
  c.caps.push_back(joint);
  return c;
}

inline MeasuredMode bending(Axis axis, int order, const std::string& state, double frequency = 1) {
  MeasuredMode mode;
  mode.shape = MeasuredShape::transverse;
  mode.direction = axis;
  mode.order = order;
  mode.state = state;
  mode.frequency = frequency;
  return mode;
}

// Of one kind, with 1 % of damping, its frequency to be read of a model.
inline MeasuredMode damped_mode(MeasuredShape shape, Axis axis, int order) {
  MeasuredMode mode = bending(axis, order, "");
  mode.shape = shape;
  mode.damping = 0.01;
  return mode;
}

// Three modes in z and two in x of one state.
inline void add_modes(Measured& m, const std::string& state) {
  for (int order = 1; order <= 3; ++order) m.modes.push_back(bending(Axis::z, order, state));
  for (int order = 1; order <= 2; ++order) m.modes.push_back(bending(Axis::x, order, state));
}

// What a model reads for a test.
inline Eigen::VectorXd read_by(const Case& truth, const Measured& m) {
  const TestData test{.data = m, .responses = {}};
  const TestReadings readings = readings_of(test);
  return *Predictor(nominal_of(truth, m), readings, {})(Eigen::VectorXd());
}

// The entries of a test, those of readings[i] at exp(y[i]). Modes and their frequencies, the mass,
// static tests.
inline void take_readings(Measured& m, const Eigen::VectorXd& y) {
  const std::vector<Reading> readings = readings_of({.data = m, .responses = {}}).readings;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Reading& r = readings[i];
    const double value = std::exp(y[Eigen::Index(i)]);
    if (r.kind == ReadingKind::mass)
      for (MeasuredMass& w : m.weighings)
        if (w.state == r.state) w.value = value;
    if (r.kind == ReadingKind::frequency) m.modes[std::stoul(r.entry.substr(6))].frequency = value;
    if (r.kind == ReadingKind::stiffness) m.statics[std::stoul(r.entry.substr(7))].value = value;
  }
}

// Before and after. Each mode of the specimen is some percents off that of any model of the library
// here, and once mounted anew some thousandths off itself.
inline Measured before_and_after(const Case& before, const Case& after) {
  constexpr std::array model_error{0.031, -0.024, 0.017, -0.035, 0.012};
  constexpr std::array mounted_anew{0.002, -0.003, 0.001, 0.003, -0.002};
  Measured m;
  m.specimen = "beam";
  m.states = {{.name = "before", .baseline = true, .set = {}, .numbers = {}},
              {.name = "after", .baseline = false, .set = {}, .numbers = {}}};
  add_modes(m, "before");
  add_modes(m, "after");
  const Eigen::VectorXd first = read_by(before, m), second = read_by(after, m);
  for (std::size_t k = 0; k < 5; ++k) {
    m.modes[k].frequency = std::exp(first[Eigen::Index(k)] + model_error[k]);
    m.modes[5 + k].frequency =
        std::exp(second[Eigen::Index(5 + k)] + model_error[k] + mounted_anew[k]);
  }
  return m;
}

// Every value that it states lies within its own interval.
inline Diagnosis diagnosis_of(const Case& nominal, const Measured& m) {
  DiagnosisSettings settings;
  settings.plan_next = false;
  Diagnosis d = diagnose(nominal, {.data = m, .responses = {}}, settings);
  for (const NamedEffect& e : d.effects)
    for (const EstimatedParameter& p : e.parameters) {
      EXPECT_LE(p.interval[0], p.value) << e.name << ", " << p.name << ": " << d.headline;
      EXPECT_GE(p.interval[1], p.value) << e.name << ", " << p.name << ": " << d.headline;
    }
  return d;
}

} // namespace plica::changed_beam
