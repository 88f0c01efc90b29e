#include "diagnose/effects/beam_path.hpp"

#include "model/description/pipe_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int degree = 6;             // of the entries of h h'
constexpr std::size_t intervals = 16; // of a path, about

// Factors on the DOFs of two nodes of the motion along `d` at a share t of the way between.
RowVectorXd motion(const Vector3d& from, const Vector3d& to, const Vector3d& d, double t) {
  const double h = (to - from).norm();
  const Vector3d e = (to - from) / h, straight = d.dot(e) * e, across = d - straight;
  const Vector3d turn = e.cross(across); // slope across = rotation . turn
  const double t2 = t * t, t3 = t2 * t;
  RowVectorXd row(12);
  row << ((1 - 3 * t2 + 2 * t3) * across + (1 - t) * straight).transpose(),
      (h * (t - 2 * t2 + t3) * turn).transpose(),
      ((3 * t2 - 2 * t3) * across + t * straight).transpose(), (h * (t3 - t2) * turn).transpose();
  return row;
}

// A change each at the samples: seven in an interval, those at its ends shared.
std::vector<ModelChange> changes_along(const Structure& s, const BeamPath& path,
                                       const std::vector<Vector3d>& axes, double mass,
                                       double stiffness) {
  std::vector<ModelChange> changes;
  const auto n = int(path.nodes.size()) - 1;
  for (int sample = 0; sample <= degree * n; ++sample) {
    const auto i = std::size_t(std::min(sample / degree, n - 1));
    const double t = double(sample - degree * int(i)) / degree;
    OnMotion own{.nodes = {path.nodes[i], path.nodes[i + 1]},
                 .rows = MatrixXd(Index(axes.size()), 12),
                 .mass = mass,
                 .stiffness = stiffness};
    const std::vector<Vector3d>& x = s.built.model.mesh.nodes;
    for (std::size_t a = 0; a < axes.size(); ++a)
      own.rows.row(Index(a)) =
          motion(x[std::size_t(own.nodes[0])], x[std::size_t(own.nodes[1])], axes[a], t);
    changes.push_back({.apply = {}, .on_motion = {std::move(own)}});
  }
  return changes;
}

// Numbers among the nodes of a part from its one end to the other where its stretches end: the path
// has these nodes, since across them slope or curvature may leap.
std::vector<std::size_t> ends_of_stretches(const Structure& s, const Part& part,
                                           const std::vector<int>& nodes) {
  std::vector<std::size_t> ends{0};
  if (const auto* beam = std::get_if<BeamPart>(&part.body))
    for (std::size_t k = 2; k < beam->points.size(); ++k) {
      const std::string point = part.name + ".point[" + std::to_string(k) + "]";
      const int node = s.built.model.mesh.sets.at(point).front();
      ends.push_back(std::size_t(std::find(nodes.begin(), nodes.end(), node) - nodes.begin()));
    }
  if (const auto* pipe = std::get_if<EquivalentPipe>(&part.body)) {
    const auto stretches = pipe_stretches(*pipe, s.data.materials.at(pipe->material));
    for (std::size_t k = 0; k + 1 < stretches.size(); ++k)
      ends.push_back(ends.back() + std::size_t(stretches[k].elements));
  }
  if (const auto* chain = std::get_if<ConnectorChain>(&part.body); chain && chain->arms > 0) {
    ends.push_back(1);
    ends.push_back(nodes.size() - 2);
  }
  ends.push_back(nodes.size() - 1);
  return ends;
}

// Of a part whose nodes lie in order from its one end to the other.
BeamPath path_of(const Structure& s, const Part& part) {
  const std::vector<Vector3d>& x = s.built.model.mesh.nodes;
  const std::vector<int>& nodes = s.built.model.mesh.sets.at(part.name + ".all");
  const std::vector<std::size_t> ends = ends_of_stretches(s, part, nodes);
  BeamPath path{.part = part.name, .nodes = {nodes.front()}, .at = {0}};
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const std::size_t elements = ends[k] - ends[k - 1];
    const std::size_t wanted = std::max<std::size_t>(intervals * elements / ends.back(), 1);
    const std::size_t step = (elements + wanted - 1) / wanted;
    for (std::size_t from = ends[k - 1]; from < ends[k]; from += step) {
      const int node = nodes[std::min(from + step, ends[k])];
      path.at.push_back(path.at.back() +
                        (x[std::size_t(node)] - x[std::size_t(path.nodes.back())]).norm());
      path.nodes.push_back(node);
    }
  }
  return path;
}

} // namespace

std::size_t BeamPath::nearest(double s) const {
  const auto found = std::min_element(
      at.begin(), at.end(), [&](double a, double b) { return std::abs(a - s) < std::abs(b - s); });
  return std::size_t(found - at.begin());
}

VectorXd BeamPath::weights(double s) const {
  const auto n = int(nodes.size()) - 1;
  const auto next = std::upper_bound(at.begin() + 1, at.end() - 1, s);
  const auto i = std::size_t(next - at.begin() - 1);
  const double t = std::clamp((s - at[i]) / (at[i + 1] - at[i]), 0., 1.);
  VectorXd w = VectorXd::Zero(degree * n + 1);
  for (int j = 0; j <= degree; ++j) {
    double lagrange = 1;
    for (int k = 0; k <= degree; ++k)
      if (k != j) lagrange *= (t * degree - k) / double(j - k);
    w[degree * Index(i) + j] = lagrange;
  }
  return w;
}

Hypothesis anywhere_along(const BeamPath& path, const EffectParameter& size,
                          std::vector<ModelChange> samples) {
  return {.effect = "",
          .place = path.part,
          .way = "",
          .parameters = {size, {"at", "m", {PriorKind::towards_ends, 0, path.length()}}},
          .changes = std::move(samples),
          .coefficients = [path](const VectorXd& v) { return VectorXd(v[0] * path.weights(v[1])); },
          .at_rig = false,
          .along = 1};
}

std::vector<BeamPath> beam_paths(const Structure& s) {
  std::vector<BeamPath> found;
  for (const Part& part : s.data.parts)
    if (std::holds_alternative<BeamPart>(part.body)) found.push_back(path_of(s, part));
  return found;
}

std::vector<BeamPath> line_paths(const Structure& s) {
  std::vector<BeamPath> found;
  for (const Part& part : s.data.parts)
    if (std::holds_alternative<BeamPart>(part.body) ||
        std::holds_alternative<EquivalentPipe>(part.body) ||
        std::holds_alternative<ConnectorChain>(part.body))
      found.push_back(path_of(s, part));
  return found;
}

bool is_along(const Structure& s, const Spot& spot) {
  return spot.on_path && s.data.diagnose.places.empty();
}

std::vector<ModelChange> support_along(const Structure& s, const BeamPath& path,
                                       const std::vector<Vector3d>& axes) {
  return changes_along(s, path, axes, 0, 1);
}

std::vector<ModelChange> mass_along(const Structure& s, const BeamPath& path) {
  return changes_along(s, path, {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()}, 1, 0);
}

} // namespace plica
