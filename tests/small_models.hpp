// Twenty-two small models, each below 5000 unknowns: plates, tubes, bellows, frames, held, free, on
// springs, with masses on kinematic and distributing couplings, with near-degenerate modes.
#pragma once

#include "mesh/generation/revolve.hpp"
#include "mesh/plate.hpp"
#include "solve/couplings.hpp"

#include <functional>
#include <numbers>
#include <stdexcept>

namespace plica::test {

struct SmallModel {
  std::string name;
  std::function<Model()> make;
  int rigid_modes = 0;
};

namespace small {

inline const std::vector<int> all{0, 1, 2, 3, 4, 5};
const ShellSection steel{.E = 200e9, .nu = 0.3, .rho = 7900};
const BeamProperties bar = round_section({200e9, 0.3, 7900}, 0.01);

inline Model shell(Mesh mesh, const ShellSection& section = steel) {
  Model model;
  model.mesh = std::move(mesh);
  model.shells = {{section, MembraneStrain::incompatible}};
  return model;
}

inline Model held(Model model, const std::vector<std::string>& sets,
                  const std::vector<int>& dofs = all) {
  for (const std::string& set : sets) add_support(model, model.mesh.sets.at(set), dofs, set);
  return model;
}

// 0.3 m x `width`; `lift` raises corner 3 out of the plane.
inline Model plate(int along, int across, double width, double lift = 0) {
  return shell(mesh_plate({{{0, 0, 0}, {0.3, 0, 0}, {0.3, width, lift}, {0, width, 0}}}, along,
                          across, 0.003));
}

inline Model tube(int around, int along) {
  Meridian meridian(0, 0.05);
  meridian.add_cuff(0.2, 0.05, along);
  return shell(revolve(meridian, around, [](double) { return 0.001; }));
}

inline Model bellows(int convolutions, int around, double arc_radius = 0.003,
                     const ShellSection& section = steel) {
  Meridian meridian(0, 0.04);
  meridian.add_cuff(0.005, 0.04, 1);
  for (int k = 0; k < convolutions; ++k)
    meridian.add_convolution(
        {.height = 0.015, .pitch = 0.012, .root_arc = arc_radius, .crown_arc = arc_radius}, {2, 2});
  meridian.add_cuff(0.005, 0.04, 1);
  return shell(revolve(meridian, around, [](double) { return 0.0004; }), section);
}

inline Model discs(int convolutions, int around) {
  Meridian meridian(0, 0.04);
  for (int k = 0; k < convolutions; ++k) meridian.add_disc(0.012, 0.004, {1, 4});
  return shell(revolve(meridian, around, [](double) { return 0.0003; }));
}

// A node tied rigidly to a set, with a mass on an arm and a body's inertia.
inline int add_body(Model& model, const std::string& set, double mass, double arm,
                    bool distributing = false) {
  const std::vector<int> nodes = model.mesh.sets.at(set);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (int node : nodes) centre += model.mesh.nodes[node] / double(nodes.size());
  const int reference = add_node(model, centre);
  if (distributing)
    add_distributing_coupling(model, reference, nodes, "body on " + set);
  else
    add_kinematic_coupling(model, reference, nodes, all, "body on " + set);
  const Eigen::Matrix3d inertia = 1e-4 * mass * Eigen::Matrix3d::Identity();
  model.masses.push_back({reference, {.mass = mass, .offset = {0, arm, 0}, .inertia = inertia}});
  return reference;
}

inline void add_spring(Model& model, int node, double force, double moment) {
  BushingElement spring{.node1 = node, .node2 = -1, .bushing = {}};
  spring.bushing.law.diagonal() << force, force, force, moment, moment, moment;
  model.bushings.push_back(spring);
}

inline int add_beam(Model& model, int from, const Eigen::Vector3d& to, int elements) {
  const Eigen::Vector3d a = model.mesh.nodes[from], step = (to - a) / elements;
  const Eigen::Vector3d up =
      std::abs(step.normalized().z()) > 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  for (int e = 1; e <= elements; ++e) {
    const int next = add_node(model, a + e * step);
    BeamElement beam;
    beam.node1 = from;
    beam.node2 = next;
    beam.section = bar;
    beam.up = up;
    model.beams.push_back(beam);
    from = next;
  }
  return from;
}

inline Model cantilever(bool clamped) {
  Model model;
  const int root = add_node(model, {0, 0, 0});
  add_beam(model, root, {1, 0, 0}, 20);
  if (clamped) add_support(model, {root}, all, "root");
  return model;
}

// Portal of three bars on two feet.
inline Model portal() {
  Model model;
  const int left = add_node(model, {0, 0, 0});
  const int right = add_beam(model, add_beam(model, left, {0, 0, 1}, 8), {0.7, 0, 1}, 8);
  const int foot = add_beam(model, right, {0.7, 0, 0}, 8);
  add_support(model, {left, foot}, all, "feet");
  return model;
}

// Equal bars side by side, joined at the tips by a soft spring: modes in close groups.
inline Model soft_comb(int bars) {
  Model model;
  int last = -1;
  for (int k = 0; k < bars; ++k) {
    const int root = add_node(model, {0, 0.1 * k, 0});
    const int tip = add_beam(model, root, {1, 0.1 * k, 0}, 10);
    add_support(model, {root}, all, "root");
    BushingElement tie{.node1 = last, .node2 = tip, .bushing = {}};
    tie.bushing.law.diagonal().setConstant(0.5);
    if (last >= 0) model.bushings.push_back(tie);
    last = tip;
  }
  return model;
}

inline std::vector<SmallModel> plates() {
  const auto edges = std::vector<std::string>{"edge1", "edge2", "edge3", "edge4"};
  return {{"plate_cantilever", [] { return held(plate(12, 8, 0.2), {"edge4"}); }},
          {"plate_square_supported",
           [=] {
             return held(plate(12, 12, 0.3), edges, {0, 1, 2});
           }},
          {"plate_square_free", [] { return plate(10, 10, 0.3); }, 6},
          {"plate_warped_clamped",
           [] {
             return held(plate(10, 8, 0.2, 0.05), {"edge2", "edge4"});
           }},
          {"plate_on_corner_springs",
           [] {
             Model model = plate(10, 8, 0.2);
             for (const char* corner : {"corner1", "corner2", "corner3", "corner4"})
               add_spring(model, model.mesh.sets.at(corner)[0], 2e3, 0);
             return model;
           }},
          {"plate_with_body", [] {
             Model model = held(plate(10, 6, 0.2), {"edge4"});
             add_body(model, "edge2", 0.5, 0.02);
             return model;
           }}};
}

inline const std::vector<std::string> both_ends{"left", "right"};

inline std::vector<SmallModel> tubes() {
  return {{"tube_clamped", [] { return held(tube(24, 10), both_ends); }},
          {"tube_cantilever", [] { return held(tube(20, 8), {"left"}); }},
          {"tube_free", [] { return tube(20, 8); }, 6},
          {"tube_distributing_mass",
           [] {
             Model model = held(tube(20, 8), {"left"});
             add_body(model, "right", 0.8, 0.03, true);
             return model;
           }},
          {"tube_on_springs", [] {
             Model model = tube(16, 8);
             add_spring(model, add_body(model, "left", 0.1, 0), 1e5, 1e3);
             add_spring(model, add_body(model, "right", 0.1, 0), 2e4, 50);
             return model;
           }}};
}

inline std::vector<SmallModel> kinds_of_bellows() {
  const ShellSection slipping{.E = 200e9, .nu = 0.3, .rho = 7900, .bending_factor = 0.25};
  return {{"bellows_one", [] { return held(bellows(1, 24), both_ends); }},
          {"bellows_two", [] { return held(bellows(2, 24), both_ends); }},
          {"bellows_three", [] { return held(bellows(3, 16), both_ends); }},
          {"bellows_omega", [] { return held(bellows(2, 20, 0.0032), both_ends); }},
          {"bellows_slipping", [=] { return held(bellows(2, 20, 0.003, slipping), both_ends); }},
          {"bellows_discs", [] { return held(discs(3, 20), both_ends); }},
          {"bellows_free_caps",
           [] {
             Model model = bellows(2, 20);
             add_body(model, "left", 0.3, 0);
             add_body(model, "right", 0.2, 0.01);
             return model;
           },
           6}};
}

inline std::vector<SmallModel> frames() {
  return {{"beam_cantilever", [] { return cantilever(true); }},
          {"beam_free", [] { return cantilever(false); }, 6},
          {"portal", portal},
          {"soft_comb", [] { return soft_comb(3); }}};
}

} // namespace small

inline std::vector<SmallModel> small_models() {
  std::vector<SmallModel> all;
  for (auto make : {small::plates, small::tubes, small::kinds_of_bellows, small::frames})
    for (SmallModel& model : make()) all.push_back(std::move(model));
  return all;
}

} // namespace plica::test
