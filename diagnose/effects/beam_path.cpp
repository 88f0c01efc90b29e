#include "diagnose/effects/beam_path.hpp"

#include "model/description/pipe_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6 = Eigen::Vector<double, 6>;

constexpr std::size_t intervals = 16; // of a path, about

// Factors on the DOFs of the two ends of the motion along `d` at a share t of the way between.
std::array<Vector6, 2> hermite(const Vector3d& from, const Vector3d& to, const Vector3d& d,
                               double t) {
  const double h = (to - from).norm();
  const Vector3d e = (to - from) / h, straight = d.dot(e) * e, across = d - straight;
  const Vector3d turn = e.cross(across); // slope across = rotation . turn
  const double t2 = t * t, t3 = t2 * t;
  std::array<Vector6, 2> ends;
  ends[0] << (1 - 3 * t2 + 2 * t3) * across + (1 - t) * straight, h * (t - 2 * t2 + t3) * turn;
  ends[1] << (3 * t2 - 2 * t3) * across + t * straight, h * (t3 - t2) * turn;
  return ends;
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

std::vector<EffectParameter> BeamPath::place() const {
  return {{"at", "m", {PriorKind::towards_ends, 0, length()}}};
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

bool is_anywhere(const Structure& s, const Spot& spot) {
  return spot.anywhere && s.data.diagnose.places.empty();
}

MovingMotion motion_along(const Structure& s, const BeamPath& path, const Vector3d& direction,
                          MotionTerm::Of of) {
  std::vector<Vector3d> x;
  for (int node : path.nodes) x.push_back(s.built.model.mesh.nodes[std::size_t(node)]);
  const MotionTerms terms(path.nodes, [&](const MotionTerms::Sample& sample) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const auto ends = hermite(x[i], x[i + 1], direction, somewhere);
      sample(i, ends[0]);
      sample(i + 1, ends[1]);
    }
  });
  return {.terms = terms.changes(of, [](int) { return Follow::series; }),
          .factors = [terms, x, direction, at = path.at](const VectorXd& place) {
            const auto [i, t] = neighbours_of(at, place[0]);
            const auto ends = hermite(x[i], x[i + 1], direction, t);
            VectorXd factors = VectorXd::Zero(terms.size());
            terms.add(i, ends[0], factors);
            terms.add(i + 1, ends[1], factors);
            return factors;
          }};
}

} // namespace plica
