// Results of a corrugated tube, made by formula, with something in every part.
#pragma once

#include "run/results/results.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica::test {

constexpr double pi = std::numbers::pi;

// A corrugated tube along y between two plain cuffs, `per` rings per convolution.
inline Mesh corrugated_tube(int convolutions, int per, int around) {
  constexpr double pitch = 0.0066, cuff = 0.0042, low = 0.065, height = 0.008;
  Mesh mesh;
  const int rings = convolutions * per + 3;
  for (int i = 0; i < rings; ++i) {
    const double phase = std::clamp<double>(i - 1, 0, convolutions * per) / per;
    const double end = i == 0 ? -cuff / 2 : i == rings - 1 ? cuff / 2 : 0;
    Ring ring{
        cuff / 2 + end + phase * pitch, low + height * (1 - std::cos(2 * pi * phase)) / 2, {}};
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * pi * j / around;
      ring.nodes.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.emplace_back(ring.radius * std::cos(angle), ring.y, ring.radius * std::sin(angle));
    }
    mesh.rings.push_back(ring);
  }
  for (int i = 0; i + 1 < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      ShellQuad quad;
      quad.nodes = {mesh.rings[i].nodes[j], mesh.rings[i + 1].nodes[j],
                    mesh.rings[i + 1].nodes[(j + 1) % around],
                    mesh.rings[i].nodes[(j + 1) % around]};
      quad.directors.setZero();
      quad.thickness.setConstant(0.0005);
      mesh.quads.push_back(quad);
    }
  }
  return mesh;
}

// Half waves along the tube; n waves around for a shell mode.
inline Eigen::MatrixXd wave(const Mesh& mesh, const ModeResult& mode) {
  const double length = mesh.rings.back().y;
  Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(static_cast<int>(mesh.nodes.size()), 6);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Eigen::Vector3d& p = mesh.nodes[i];
    const double angle = std::atan2(p.z(), p.x());
    const double along = std::sin(std::max(mode.order, 1) * pi * p.y() / length);
    Eigen::Vector3d u(0, along, 0);
    if (mode.shape == "transverse")
      u = mode.direction == "x" ? Eigen::Vector3d(along, 0, 0) : Eigen::Vector3d(0, 0, along);
    if (mode.shape == "shell") {
      u = along * std::cos(mode.harmonic * angle) * Eigen::Vector3d(p.x(), 0, p.z()) / 0.07;
    }
    shape.row(static_cast<int>(i)).head<3>() = u.transpose();
  }
  return shape;
}

inline ModeResult mode_of(double frequency, const std::string& shape, const std::string& direction,
                          int order, int harmonic) {
  ModeResult mode;
  mode.frequency = frequency;
  mode.damping = 0.0111;
  mode.shape = shape;
  mode.direction = direction;
  mode.order = order;
  mode.harmonic = harmonic;
  mode.residual = 2.1e-10;
  if (shape == "axial") mode.effective_mass = {1e-19, 0.3512 / order, 0, 0, 2e-17, 0};
  if (direction == "x") mode.effective_mass = {0.3479, 0, 1e-17, 0, 0, 0.00112};
  if (direction == "z") mode.effective_mass = {1e-17, 0, 0.3479, 0.00112, 0, 0};
  return mode;
}

inline void add_words(Results& r) {
  r.case_name = "bellow_a2";
  r.title = "Bellows A2 <clamped> & \"welded\", 27 convolutions";
  r.plica_version = "0.1.0";
  r.assumptions = {"Height 8 mm: the thesis gives the mean radius to 1 mm only.",
                   "Two plies of 0.25 mm, slipping; the thesis says so of A1 only."};
  r.warnings = {"sensor 'mid' sits 1.3 mm from its place <script>alert(1)</script>"};
  r.comparison = {
      {"axial stiffness", "N/m", 54365, 900, 65872, "static[0]", ComparedKind::stiffness, 0},
      {"axial mode 1", "Hz", 116, 1, 131.26},
      {"transverse mode 1", "Hz", 178, 1, 183.4},
      {"mass, weighed", "kg", 1.7096, 0.0005, 1.7093, "mass", ComparedKind::mass}};
  r.variants = {{"height 7 mm",
                 {{"parts.bellows.profile[1].height", "7 mm"}},
                 {{"k_axial", 94100}, {"f_axial", 158.2}, {"f_transverse", 214}, {"mass", 1.69}},
                 {}},
                {"one wall, \"solid\"",
                 {{"parts.bellows.wall.bond", "1"}, {"parts.bellows.wall.plies", "[0.5 mm]"}},
                 {{"k_axial", 253800}, {"f_axial", 261.6}, {"f_transverse", 362.7}},
                 {}}};
  r.timing = {{"mesh", 0.31}, {"assembly", 0.92}, {"factor", 1.7}, {"modes", 3.44}, {"proof", 1.2}};
  r.peak_memory = 812e6;
}

// One sensor answers in y with a peak at 131 Hz, in x a millionth of that, under random input too.
inline ResponseResult sample_response() {
  ResponseResult r;
  r.excitation = "y";
  r.level = 10;
  r.unit = "m/s2";
  r.hertz = Eigen::VectorXd::LinSpaced(50, 10, 500);
  r.channels = {{"mid", "x"}, {"mid", "y"}, {"mid", "z"}};
  r.acceleration.setZero(50, 3);
  for (int i = 0; i < 50; ++i) {
    const double x = r.hertz[i] / 131.26;
    r.acceleration(i, 1) = 1. / std::complex<double>(1 - x * x, 0.02 * x);
    r.acceleration(i, 0) = 1e-6;
  }
  r.shown = {1};
  r.peaks = {{.channel = 1, .frequency = 131.26, .amplitude = 50.1, .damping = 0.01}};
  RandomResult random{.input = Eigen::VectorXd::Ones(50),
                      .density = r.acceleration.cwiseAbs2(),
                      .bands = {{{10, 500}, 22.1, Eigen::Vector3d(1e-6, 105.5, 0)}},
                      .cross = {{0, 1, Eigen::VectorXcd::Ones(50)}},
                      .tones = {}};
  r.random = random;
  return r;
}

inline Results sample(int convolutions = 3, int per = 8, int around = 24) {
  Results r;
  add_words(r);
  r.mesh = corrugated_tube(convolutions, per, around);
  r.model = {static_cast<int>(r.mesh.nodes.size()), static_cast<int>(r.mesh.quads.size()),
             6 * static_cast<int>(r.mesh.nodes.size()), 1.7093};
  r.quality = {0.0021, 3.4, 2.1, 0.83};
  r.statics.emplace();
  r.statics->k_axial = 65872.123456789012;
  r.statics->k_transverse_x = r.statics->k_transverse_z = 91230;
  r.statics->k_bending_x = r.statics->k_bending_z = 141.2;
  r.statics->k_torsion = 142300;
  r.statics->end_stiffness.setIdentity();
  r.modes = {mode_of(131.26, "axial", "y", 1, 0),     mode_of(183.4, "transverse", "x", 1, 1),
             mode_of(183.4, "transverse", "z", 1, 1), mode_of(262.1, "axial", "y", 2, 0),
             mode_of(341.7, "shell", "", 0, 3),       mode_of(341.7, "shell", "", 0, 3),
             mode_of(400.9, "transverse", "x", 2, 1)};
  for (const ModeResult& mode : r.modes) r.shapes.push_back(wave(r.mesh, mode));
  r.free_mass = {0.4331, 0.4331, 0.4331, 0.00201, 0.00173, 0.00201};
  r.effective_mass_sum = {0.4101, 0.4198, 0.4101, 0.0017, 0.0011, 0.0017};
  r.verification = {true, 410.2, 7, 7, 3.4e-10, 2.2e-14, 1.3e-9, true, "", ""};
  r.sensors = {{"mid", static_cast<int>(r.mesh.nodes.size()) / 2 + around / 8, 0.0013}};
  r.lines = {{r.mesh.rings.front().nodes[0], r.mesh.rings[1].nodes[0]}};
  for (const Ring& ring : r.mesh.rings) r.meridian.push_back({ring.y, ring.radius});
  r.responses = {sample_response()};
  const Eigen::VectorXd stress = Eigen::VectorXd::LinSpaced(r.model.nodes, 0, 1e8);
  r.stresses = {{.kind = StressKind::statics,
                 .name = "1 mm <axial>",
                 .largest = 1e8,
                 .at = {0.01, 0.02, 0.03},
                 .face = "above",
                 .largest_beam = 3e6,
                 .beam_at = {0, 0.1, 0},
                 .below = stress,
                 .above = stress.reverse()}};
  r.error_bars = {.bars = {{.key = "k_axial",
                            .value = r.statics->k_axial,
                            .mesh = {.along = 200, .around = -90},
                            .interval = {{50e3, 80e3}},
                            .shares = {0.25, 0.75}}},
                  .statics = {{.along = 200, .around = -90}, {}, {}, {}, {}, {.along = 500}},
                  .modes = {},
                  .stresses = {},
                  .places = {},
                  .along = true,
                  .around = true,
                  .tolerances = {"parts.a<b.height", "parts.b.E"},
                  .interaction = 0.003};
  r.unanswered = {"z & x"};
  return r;
}

} // namespace plica::test
