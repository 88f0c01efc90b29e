// Three convolutions with parallel walls, meshed through Gmsh: their area is that of Pappus.
#include "expect.hpp"
#include "plica/mesh/generation/revolve.hpp"

#include <Eigen/Geometry>
#include <numbers>

int main() {
  using namespace plica;
  constexpr double root = 0.05, height = 0.01, pitch = 0.008, arc = pitch / 4;
  Meridian meridian(0, root);
  for (int k = 0; k < 3; ++k)
    meridian.add_convolution({height, pitch, arc, arc}, {.arc = 12, .wall = 6});
  const Mesh mesh = revolve(meridian, 120, [](double) { return 2e-4; });
  expect_near(meridian.y(), 3 * pitch, "length");
  expect(mesh.sets.at("crown[3]").size() == 120, "a third crown of 120 nodes");

  double area = 0;
  for (const ShellQuad& quad : mesh.quads)
    for (const auto& [a, b, c] : halves(quad.nodes))
      area += (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]).norm() / 2;
  // Two walls and two half circles in a convolution, the middle of it at half of its height.
  constexpr double length = 2 * (height - pitch / 2) + 2 * std::numbers::pi * arc;
  constexpr double smooth = 3 * length * 2 * std::numbers::pi * (root + height / 2);
  expect_near(area, smooth, "area", 2e-3);
  return differs;
}
