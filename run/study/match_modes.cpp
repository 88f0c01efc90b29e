#include "run/study/match_modes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t most_samples = 400;
constexpr double same_frequency = 1e-3; // of the frequency, on meshes that are not symmetric
constexpr double alike = 0.6;           // least assurance

// Nodes evenly over their numbers, and every node of a line.
std::vector<int> samples(const Results& results) {
  const Mesh& mesh = results.mesh;
  const std::size_t step = std::max<std::size_t>(1, mesh.nodes.size() / most_samples);
  std::vector<int> nodes;
  for (std::size_t node = step / 2; node < mesh.nodes.size(); node += step)
    nodes.push_back(static_cast<int>(node));
  for (const auto& line : results.lines) nodes.insert(nodes.end(), line.begin(), line.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<int> nodes_at(const Mesh& mesh, const Eigen::Vector3d& place) {
  constexpr double apart = 1e-9; // m
  std::vector<int> found;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if ((mesh.nodes[i] - place).norm() < apart) found.push_back(static_cast<int>(i));
  return found;
}

// The node of the other mesh next to one of this. Where several share a place, as a liner and what
// it leans on do, they do in the same order.
int counterpart(const Mesh& mesh, int node, const Mesh& other) {
  const Eigen::Vector3d& x = mesh.nodes[std::size_t(node)];
  const int nearest = nearest_node(other, x).first;
  const std::vector<int> here = nodes_at(mesh, x),
                         there = nodes_at(other, other.nodes[std::size_t(nearest)]);
  const auto rank = std::size_t(std::find(here.begin(), here.end(), node) - here.begin());
  return there[std::min(rank, there.size() - 1)];
}

// Roots of the weights of the samples: every stretch of the longest side of the part weighs the
// same, so that a fine wall does not outvote the beams of a line.
Eigen::VectorXd weights(const Mesh& mesh, const std::vector<int>& nodes,
                        const Eigen::AlignedBox3d& box) {
  constexpr int stretches = 100;
  Index axis = 0;
  const double longest = box.sizes().maxCoeff(&axis);
  std::vector<int> stretch, count(stretches, 0);
  for (int node : nodes) {
    const double share = (mesh.nodes[std::size_t(node)][axis] - box.min()[axis]) / longest;
    stretch.push_back(longest > 0 ? std::min(int(share * stretches), stretches - 1) : 0);
    ++count[std::size_t(stretch.back())];
  }
  Eigen::VectorXd roots(Index(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    roots[Index(i)] = 1 / std::sqrt(double(count[std::size_t(stretch[i])]));
  return roots;
}

// Unit columns, one per mode: motions of the nodes, their rotations at a length.
MatrixXd sampled(const std::vector<MatrixXd>& shapes, const std::vector<int>& nodes,
                 const Eigen::VectorXd& roots, double length) {
  MatrixXd u(6 * Index(nodes.size()), Index(shapes.size()));
  for (std::size_t j = 0; j < shapes.size(); ++j)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      u.col(Index(j)).segment<6>(6 * Index(i)) =
          roots[Index(i)] * shapes[j].row(nodes[i]).transpose();
  for (Index row = 0; row < u.rows(); ++row)
    if (row % 6 >= 3) u.row(row) *= length;
  for (Index j = 0; j < u.cols(); ++j)
    if (const double size = u.col(j).norm(); size > 0) u.col(j) /= size;
  return u;
}

} // namespace

std::vector<SameMode> match_modes(const Results& results, const Results& other) {
  std::vector<SameMode> same(results.modes.size());
  if (results.shapes.empty() || other.shapes.empty()) return same;
  const std::vector<int> here = samples(results);
  std::vector<int> there;
  Eigen::AlignedBox3d box;
  for (int node : here) {
    box.extend(results.mesh.nodes[std::size_t(node)]);
    there.push_back(counterpart(results.mesh, node, other.mesh));
  }
  const double length = box.sizes().maxCoeff() / 20;
  const Eigen::VectorXd roots = weights(results.mesh, here, box);
  const MatrixXd mac = (sampled(results.shapes, here, roots, length).transpose() *
                        sampled(other.shapes, there, roots, length))
                           .array()
                           .square();
  const auto hertz = [&](Index j) { return other.modes[std::size_t(j)].frequency; };
  for (Index i = 0; i < mac.rows(); ++i) {
    double best = alike;
    for (Index first = 0, end = 0; first < mac.cols(); first = end) {
      end = first + 1;
      while (end < mac.cols() && hertz(end) - hertz(end - 1) < same_frequency * hertz(end)) ++end;
      const auto group = mac.row(i).segment(first, end - first);
      if (group.sum() <= best) continue;
      best = group.sum();
      Index most = 0;
      group.maxCoeff(&most);
      double mean = 0;
      for (Index j = 0; j < group.size(); ++j) mean += group[j] * hertz(first + j) / best;
      same[std::size_t(i)] = {.index = int(first + most), .frequency = mean};
    }
  }
  return same;
}

} // namespace plica
