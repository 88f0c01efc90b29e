// A plate of two square metres off the axis, its area, and a dent in the middle of it.
#include "expect.hpp"
#include "plica/mesh/dent.hpp"
#include "plica/mesh/plate.hpp"

#include <Eigen/Geometry>

int main() {
  using namespace plica;
  const Mesh flat = mesh_plate({{{3, 0, 0}, {3, 2, 0}, {3, 2, 1}, {3, 0, 1}}}, 8, 4, 1e-3);
  expect(flat.nodes.size() == 45 && flat.sets.at("edge2").size() == 5, "9 times 5 nodes");
  double area = 0;
  for (const ShellQuad& quad : flat.quads)
    for (const auto& [a, b, c] : halves(quad.nodes))
      area += (flat.nodes[b] - flat.nodes[a]).cross(flat.nodes[c] - flat.nodes[a]).norm() / 2;
  expect_near(area, 2, "area");

  Mesh dented = flat;
  press(dented, {.at = {3, 1, 0.5}, .depth = 0.1, .radius = 0.5});
  const auto depth_at = [&](double y) {
    const int node = nearest_node(flat, {3, y, 0.5}).first;
    return (flat.nodes[node] - dented.nodes[node]).norm();
  };
  expect_near(depth_at(1), 0.1, "depth in the middle");
  expect_near(depth_at(1.25), 0.1 * 0.75 * 0.75, "depth half the radius away");
  expect(depth_at(1.5) == 0, "no depth at the edge of the dent");
  return differs;
}
