#include "diagnose/weigh/scatter.hpp"
#include "diagnose/effects/beam_stiffness.hpp"

#include "diagnose/effects/joint_groups.hpp"
#include "diagnose/effects/places.hpp"
#include "diagnose/weigh/thickness_fields.hpp"
#include "model/description/case_path.hpp"
#include "model/description/place_keys.hpp"
#include "model/description/toleranced_damping.hpp"
#include "run/results/normal_distribution.hpp"
#include "run/study/error_bars.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr double radians = std::numbers::pi / 180;
constexpr int waves = 4;      // half waves of a field of stiffness
constexpr double step = 0.02; // of the change that stands for a small one

// A relative number with this standard deviation that changes the model.
Hypothesis varying(const std::string& what, const std::string& place, double sigma,
                   std::function<void(Model&)> by_a_step) {
  return {.effect = what,
          .place = place,
          .way = "",
          .parameters = {{what, "", {PriorKind::normal, 0, sigma}}},
          .changes = {{std::move(by_a_step), Follow::nominal}},
          .coefficients = [](const VectorXd& v) { return VectorXd(v / step); }};
}

Hypothesis of_the_test(const std::string& what, const std::string& place, double sigma,
                       std::function<void(TestSetup&, double)> act) {
  return {
      .effect = what,
      .place = place,
      .way = "",
      .parameters = {{what, "", {PriorKind::normal, 0, sigma}}},
      .setup = [act = std::move(act)](TestSetup& setup, const VectorXd& v) { act(setup, v[0]); }};
}

void scale_beam(BeamProperties& b, double stiffness, double mass) {
  scale_stiffness(b, stiffness);
  for (double* n : {&b.mass, &b.inertia_x, &b.inertia_y, &b.inertia_z}) *n *= mass;
}

// Another shape, to which the nominal one is no near answer.
bool moves_nodes(const Structure& s, const std::function<void(Case&)>& change) {
  Case data = s.data;
  change(data);
  const Model changed = build(data).model;
  const auto &nodes = s.built.model.mesh.nodes, &others = changed.mesh.nodes;
  constexpr double same = 1e-6; // of the length
  for (std::size_t i = 0; i < std::min(nodes.size(), others.size()); ++i)
    if ((nodes[i] - others[i]).norm() > same * s.length) return true;
  return false;
}

// A number with a tolerance: the case is built anew at two points of it, and stiffness and mass
// follow a parabola through them.
void add_tolerances(std::vector<Hypothesis>& all, const Structure& s) {
  constexpr double low_point = 0.05, high_point = 0.95;
  for (const Tolerance& t : s.data.tolerances) {
    if (t.path == toleranced_damping) continue; // stiffness and mass know nothing of it
    const double low = quantile(t, low_point) - t.value, high = quantile(t, high_point) - t.value;
    if (!(low < 0 && high > 0)) continue;
    // A narrow one is straight enough.
    constexpr double narrow = 0.05;
    const bool straight = high - low < narrow * std::abs(t.value);
    const std::vector<double> samples = straight ? std::vector{high} : std::vector{low, high};
    const auto coefficients = coefficients_through(
        [high, n = Eigen::Index(samples.size())](double x) {
          return VectorXd(Eigen::Vector2d(x / high, x * x / (high * high)).head(n));
        },
        samples);
    Hypothesis h{.effect = "tolerance",
                 .place = t.path,
                 .way = "",
                 .parameters = {{"z", "", {PriorKind::normal, 0, 1}}},
                 .coefficients = [coefficients, t](const VectorXd& z) {
                   const double share = normal_share(z[0]);
                   return coefficients(quantile(t, std::clamp(share, 1e-6, 1 - 1e-6)) - t.value);
                 }};
    for (double x : samples)
      h.case_changes.emplace_back([path = t.path, nominal = t.value, x](Case& data) {
        double& number = *number_at(data, path);
        if (number == nominal) number += x; // a state that sets it knows it
      });
    h.large = moves_nodes(s, h.case_changes.back());
    all.push_back(std::move(h));
  }
}

// Of a number that begins so and ends so: "materials.", ".E" is the modulus of any material.
bool has_tolerance(const Structure& s, const std::string& head, const std::string& tail) {
  return std::any_of(s.data.tolerances.begin(), s.data.tolerances.end(), [&](const Tolerance& t) {
    return t.path.starts_with(head) && t.path.ends_with(tail);
  });
}

// Of a number of a place, "caps.left" or the name of a part.
bool has_tolerance_at(const Structure& s, const std::string& place, const std::string& number) {
  return std::any_of(s.data.tolerances.begin(), s.data.tolerances.end(), [&](const Tolerance& t) {
    return t.path == place + number || t.path == part_key(place) + number;
  });
}

// Of a liner, or of what it leans on.
bool has_stated_stiffness(const Structure& s, const std::string& joint) {
  constexpr std::array numbers{".EA", ".axial", ".lateral", ".bending", ".torsion"};
  return std::any_of(numbers.begin(), numbers.end(),
                     [&](const char* number) { return has_tolerance_at(s, joint, number); });
}

void add_material(std::vector<Hypothesis>& all, bool modulus_known, bool density_known) {
  if (!modulus_known)
    all.push_back(varying("modulus", "all", scatters::modulus, [](Model& m) {
      for (ShellProperties& s : m.shells) s.section.E *= 1 + step;
      for (BeamElement& b : m.beams) scale_beam(b.section, 1 + step, 1);
    }));
  if (!density_known)
    all.push_back(varying("density", "all", scatters::density, [](Model& m) {
      for (ShellProperties& s : m.shells) s.section.rho *= 1 + step;
      for (BeamElement& b : m.beams) scale_beam(b.section, 1, 1 + step);
    }));
}

// A smooth field of stiffness: cosines of one to four half waves, each with its share.
void add_field_of_stiffness(std::vector<Hypothesis>& all, const WallElements& wall) {
  for (int k = 1; k <= waves && wall.convolutions > 1; ++k)
    all.push_back(varying("stiffness field", wall.part, scatters::field * std::sqrt(2. / waves),
                          [wall, k](Model& m) {
                            // One section per convolution.
                            std::map<int, int> section;
                            for (std::size_t i = 0; i < wall.quads.size(); ++i) {
                              ShellQuad& quad = m.mesh.quads[std::size_t(wall.quads[i])];
                              const auto [at, made] = section.try_emplace(wall.convolution[i], 0);
                              if (made) {
                                const double x = (wall.convolution[i] - 0.5) / wall.convolutions;
                                ShellProperties own = m.shells[quad.section];
                                own.section.E *= 1 + step * std::cos(std::numbers::pi * k * x);
                                at->second = int(m.shells.size());
                                m.shells.push_back(own);
                              }
                              quad.section = at->second;
                            }
                          }));
}

void add_walls(std::vector<Hypothesis>& all, const Structure& s) {
  for (const WallElements& wall : walls(s)) {
    if (!has_tolerance(s, part_key(wall.part) + ".wall.plies", ""))
      all.push_back(
          varying("thickness", wall.part, scatters::thickness, [quads = wall.quads](Model& m) {
            for (int q : quads) m.mesh.quads[std::size_t(q)].thickness *= 1 + step;
          }));
    if (!wall.thickness_field) add_field_of_stiffness(all, wall);
  }
  for (Hypothesis& field : thickness_fields(s)) all.push_back(std::move(field));
}

// A field of stiffness along a beam that stands as one part.
void add_beams(std::vector<Hypothesis>& all, const Structure& s) {
  for (const Part& part : s.data.parts) {
    if (!std::holds_alternative<BeamPart>(part.body)) continue;
    std::vector<int> own;
    const Model& model = s.built.model;
    for (std::size_t i = 0; i < model.beams.size(); ++i)
      if (model.components[std::size_t(model.beams[i].component)] == part.name)
        own.push_back(int(i));
    for (int k = 1; k <= waves && own.size() > 1; ++k)
      all.push_back(varying("stiffness field", part.name, scatters::field * std::sqrt(2. / waves),
                            [own, k](Model& m) {
                              for (std::size_t i = 0; i < own.size(); ++i) {
                                const double x = (double(i) + 0.5) / double(own.size());
                                scale_beam(m.beams[std::size_t(own[i])].section,
                                           1 + step * std::cos(std::numbers::pi * k * x), 1);
                              }
                            }));
  }
}

void add_masses(std::vector<Hypothesis>& all, const Structure& s) {
  for (Hypothesis& h : component_mass().hypotheses(s)) {
    if (has_tolerance_at(s, h.place, ".mass")) continue;
    h.parameters = {{"mass", "", {PriorKind::normal, 1, scatters::masses}}};
    h.changes.front().follow = Follow::nominal;
    all.push_back(std::move(h));
  }
  for (const JointGroup& group : joint_groups(s))
    if (group.present && !group.rigid && !has_stated_stiffness(s, group.place))
      all.push_back(varying("joint", group.place, scatters::joints,
                            [group](Model& m) { scale_group(m, group, 1 + step); }));
}

void add_test(std::vector<Hypothesis>& all, const Structure& s) {
  all.push_back(of_the_test("damping", "all", scatters::all_damping_of(s.data),
                            [](TestSetup& setup, double v) { setup.damping *= std::exp(v); }));
  for (const std::string& sensor : sensor_names(s)) {
    const auto reading = [name = sensor](TestSetup& setup) -> Eigen::Matrix3d& {
      return setup.reading.try_emplace(name, Eigen::Matrix3d::Identity()).first->second;
    };
    all.push_back(of_the_test("gain", sensor_place(sensor), scatters::gain,
                              [reading](TestSetup& setup, double v) { reading(setup) *= 1 + v; }));
    for (int axis = 0; axis < 3; ++axis)
      all.push_back(of_the_test(
          "place", sensor_place(sensor), scatters::off_place,
          [name = sensor, axis](TestSetup& setup, double v) {
            setup.moved.try_emplace(name, Eigen::Vector3d::Zero()).first->second[axis] += v;
          }));
    for (int axis = 0; axis < 3; ++axis)
      all.push_back(of_the_test(
          "turn", sensor_place(sensor), scatters::turn * radians,
          [reading, axis](TestSetup& setup, double v) {
            reading(setup) = Eigen::AngleAxisd(v, Eigen::Vector3d::Unit(axis)).toRotationMatrix() *
                             reading(setup);
          }));
  }
  for (int told = 0; told < 3; ++told)
    for (int other = 0; other < 3; ++other)
      if (told != other)
        all.push_back(of_the_test(
            "table", "base", scatters::other_axes,
            [told, other](TestSetup& setup, double v) { setup.base(other, told) += v; }));
}

} // namespace

double scatters::all_damping_of(const Case& data) {
  constexpr double tail = 0.05;
  for (const Tolerance& t : data.tolerances)
    if (t.path == toleranced_damping && quantile(t, tail) > 0)
      return std::log(quantile(t, 1 - tail) / quantile(t, tail)) / (2 * normal_quantile(1 - tail));
  return all_damping;
}

bool is_nuisance(const Hypothesis& varied) {
  const std::string& what = varied.effect;
  return what == "modulus" || what == "density" || what == "damping" || what == "component_mass";
}

std::vector<Hypothesis> scatter(const Structure& s) {
  std::vector<Hypothesis> all;
  add_tolerances(all, s);
  add_material(all, has_tolerance(s, "materials.", ".E"), has_tolerance(s, "materials.", ".rho"));
  add_walls(all, s);
  add_beams(all, s);
  add_masses(all, s);
  add_test(all, s);
  return all;
}

} // namespace plica
