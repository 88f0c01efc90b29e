#include "mesh/generation/curve_mesh.hpp"

#include "mesh/generation/gmsh_session.hpp"

#include <algorithm>
#include <numeric>

namespace plica {
namespace {

using Eigen::Vector2d;

int add_point(const Vector2d& p) {
  return gmsh::model::geo::addPoint(p.x(), p.y(), 0);
}

int add_curve(const MeridianCurve& curve, int start, int end) {
  switch (curve.kind) {
  case CurveKind::line:
    return gmsh::model::geo::addLine(start, end);
  case CurveKind::arc:
    return gmsh::model::geo::addCircleArc(start, add_point(curve.centre), end);
  case CurveKind::spline:
    break;
  }
  std::vector<int> tags{start};
  for (std::size_t i = 1; i + 1 < curve.points.size(); ++i)
    tags.push_back(add_point(curve.points[i]));
  tags.push_back(end);
  return gmsh::model::geo::addSpline(tags);
}

CurveNodes nodes_of(int curve, bool with_tangents) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, 1, curve, true, true);
  std::vector<std::size_t> order(tags.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return parameters[a] < parameters[b]; });
  CurveNodes nodes;
  for (std::size_t i : order) {
    nodes.positions.emplace_back(coordinates[3 * i], coordinates[3 * i + 1]);
    if (!with_tangents) continue;
    std::vector<double> derivative;
    gmsh::model::getDerivative(1, curve, {parameters[i]}, derivative);
    nodes.tangents.emplace_back(derivative[0], derivative[1]);
  }
  return nodes;
}

std::vector<CurveNodes> mesh_in_gmsh(const std::vector<MeridianCurve>& curves) {
  std::vector<int> tags;
  int tip = add_point(curves.front().start);
  for (const MeridianCurve& curve : curves) {
    const int end = add_point(curve.end);
    tags.push_back(add_curve(curve, tip, end));
    gmsh::model::geo::mesh::setTransfiniteCurve(tags.back(), curve.elements + 1);
    tip = end;
  }
  gmsh::model::geo::synchronize();
  gmsh::model::mesh::generate(1);
  std::vector<CurveNodes> nodes;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    nodes.push_back(nodes_of(tags[i], curves[i].kind == CurveKind::spline));
    if (nodes.back().positions.size() != static_cast<std::size_t>(curves[i].elements) + 1)
      throw std::runtime_error("Gmsh returned " + std::to_string(nodes.back().positions.size()) +
                               " nodes on a curve of " + std::to_string(curves[i].elements) +
                               " elements");
  }
  return nodes;
}

} // namespace

std::vector<CurveNodes> mesh_curves(const std::vector<MeridianCurve>& curves) {
  if (curves.empty()) return {};
  return in_gmsh([&] { return mesh_in_gmsh(curves); });
}

} // namespace plica
