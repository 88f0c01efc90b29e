// The other source of matrices: Plica's own shells, finer than any case would ask, with the
// scatter.
#include "places.hpp"

#include "model/shape/build.hpp"

#include <numbers>

namespace sealed {
namespace {

using std::numbers::pi;

plica::Case bare_bellows(const WallShape& w, const WallSpecimen& s) {
  plica::Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = w.root_radius;
  plica::MeridianSection cuff, u;
  cuff.shape = plica::SectionShape::cuff;
  cuff.length = w.cuff;
  cuff.elements = 5 * s.refine;
  u.count = w.convolutions;
  u.height = w.height;
  u.pitch = w.pitch;
  bellows.profile = {cuff, u, cuff};
  const double ply = w.thickness * s.thickness / 2;
  bellows.wall.plies = {ply, ply};
  bellows.wall.bond = s.bond;
  if (s.thinning != 0) {
    bellows.wall.thinning = plica::Thinning::local;
    bellows.wall.thinning_exponent = s.thinning;
  }
  bellows.mesh = {.around = 48 + 16 * s.refine, .arc = 3 + s.refine, .wall = 3 + s.refine};
  plica::Case data;
  data.name = "wall";
  data.materials["steel"] = {w.E, w.nu, w.rho};
  plica::PointMass ring;
  ring.at = "bellows.root[5]";
  data.parts = {{"bellows", bellows}, {"ring", ring}};
  data.caps.resize(2);
  data.caps[0].name = "left";
  data.caps[0].of = {"bellows.left"};
  data.caps[1].name = "right";
  data.caps[1].of = {"bellows.right"};
  return data;
}

// Every convolution and every share of a dent gets a section of its own, to a tenth of a per mille.
void scatter(plica::Model& model, const WallShape& shape, const WallSpecimen& s) {
  std::map<int, int> sections;
  const plica::ShellProperties plain = model.shells.front();
  for (plica::ShellQuad& quad : model.mesh.quads) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const int node : quad.nodes) centre += model.mesh.nodes[std::size_t(node)] / 4;
    const int key = int(std::lround(
        1e4 * stiffness_factor(shape, s, centre.y(), std::atan2(centre.z(), centre.x()))));
    const auto [found, is_new] = sections.try_emplace(key, int(model.shells.size()));
    if (is_new) {
      model.shells.push_back(plain);
      model.shells.back().section.E *= 1e-4 * key;
    }
    quad.section = found->second;
  }
}

Circle circle(const plica::Mesh& mesh, const std::vector<int>& nodes) {
  Circle c;
  c.nodes = nodes;
  for (const int node : nodes) c.x.push_back(mesh.nodes[std::size_t(node)]);
  return c;
}

// Circles `step` rings before and after a crown.
std::array<Circle, 3> crown_circles(const plica::Mesh& mesh, double y, int step) {
  int best = 0;
  for (int r = 0; r < int(mesh.rings.size()); ++r) {
    const auto off = [&](int i) {
      return std::abs(mesh.rings[std::size_t(i)].y - y) - 1e-3 * mesh.rings[std::size_t(i)].radius;
    };
    if (off(r) < off(best)) best = r;
  }
  std::array<Circle, 3> circles;
  for (int a = 0; a < 3; ++a)
    circles[std::size_t(a)] = circle(mesh, mesh.rings[std::size_t(best + step * (a - 1))].nodes);
  return circles;
}

// The free unknowns with those of the three bodies in front.
std::vector<int> bodies_first(const plica::DofMap& map, const std::array<int, 3>& bodies) {
  std::vector<int> order(std::size_t(map.size()), -1);
  for (int b = 0; b < 3; ++b)
    for (int d = 0; d < 6; ++d)
      order[std::size_t(map.independent[std::size_t(6 * bodies[std::size_t(b)] + d)])] = 6 * b + d;
  int next = rigid_unknowns;
  for (int& o : order)
    if (o < 0) o = next++;
  return order;
}

plica::SparseMatrix reordered(const plica::SparseMatrix& lower, const std::vector<int>& order) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < lower.outerSize(); ++c)
    for (plica::SparseMatrix::InnerIterator it(lower, c); it; ++it) {
      const int p = order[std::size_t(it.row())], q = order[std::size_t(it.col())];
      entries.emplace_back(std::max(p, q), std::min(p, q), it.value());
    }
  plica::SparseMatrix m(lower.rows(), lower.cols());
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

} // namespace

FullWall shell_wall(const WallShape& shape, const WallSpecimen& s) {
  plica::BuiltCase built = plica::build(bare_bellows(shape, s));
  scatter(built.model, shape, s);
  const plica::Mesh& mesh = built.model.mesh;
  const int ring = built.model.masses.back().node;
  built.model.masses.clear();
  const plica::System system = plica::assemble(built.model);
  const std::vector<int> order =
      bodies_first(system.map, {built.cap_nodes.at("left"), ring, built.cap_nodes.at("right")});
  FullWall wall;
  wall.K = reordered(system.K, order);
  wall.M = reordered(system.M, order);
  WallSpots spots;
  for (int k = 1; k <= shape.convolutions; ++k)
    spots.crowns[k] = circle(mesh, mesh.sets.at("bellows.crown[" + std::to_string(k) + "]"));
  for (const int k : {3, 7})
    spots.roots[k] = circle(mesh, mesh.sets.at("bellows.root[" + std::to_string(k) + "]"));
  spots.mid = crown_circles(mesh, shape.crown(4), 2);
  spots.quarter = crown_circles(mesh, shape.crown(2), 2);
  const Displacement displacement = [&](int node, int axis) {
    Terms terms;
    const auto dof = std::size_t(6 * node + axis);
    if (const int own = system.map.independent[dof]; own >= 0)
      return Terms{{order[std::size_t(own)], 1.}};
    for (const auto& [unknown, factor] : system.map.dependent[dof])
      terms.emplace_back(order[std::size_t(unknown)], factor);
    return terms;
  };
  add_places(wall, spots, displacement, system.map.size());
  VectorXd along = VectorXd::Zero(system.map.size());
  for (std::size_t i = 0; i < system.map.full.size(); ++i)
    if (system.map.full[i] % 6 == 1) along[order[i]] = 1;
  wall.mass = along.dot(plica::symmetric_product(wall.M, along).col(0));
  return wall;
}

} // namespace sealed
