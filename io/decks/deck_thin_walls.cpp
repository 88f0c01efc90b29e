#include "io/decks/deck_thin_walls.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

struct Branch {
  Index i = 0, j = 0; // nodes
  double length = 0, thickness = 0;
};

// Walls as branches between nodes, which lie about the centroid of the lines.
class WallNet {
public:
  explicit WallNet(const std::vector<ThinWall>& walls) {
    double size = 0;
    for (const ThinWall& w : walls) size = std::max({size, w.from.norm(), w.to.norm()});
    for (const ThinWall& w : walls) {
      const double length = (w.to - w.from).norm();
      if (!(length > 0 && w.thickness > 0))
        throw std::invalid_argument("a wall without length or thickness");
      const Index i = node_at(w.from, 1e-9 * size), j = node_at(w.to, 1e-9 * size);
      branches.push_back({i, j, length, w.thickness});
    }
    centroid = Vector2d::Zero();
    double area = 0;
    for (const Branch& b : branches) {
      const double a = b.length * b.thickness;
      centroid += a * (nodes[std::size_t(b.i)] + nodes[std::size_t(b.j)]) / 2;
      area += a;
    }
    centroid /= area;
    for (Vector2d& x : nodes) x -= centroid;
  }

  const Vector2d& at(Index node) const { return nodes[std::size_t(node)]; }

  // Integral of f g over the area, both straight along every wall and given at the nodes.
  double integral(const VectorXd& f, const VectorXd& g) const {
    double sum = 0;
    for (const Branch& b : branches)
      sum += b.length * b.thickness / 6 *
             (2 * f[b.i] * g[b.i] + 2 * f[b.j] * g[b.j] + f[b.i] * g[b.j] + f[b.j] * g[b.i]);
    return sum;
  }

  VectorXd coordinate(int axis) const {
    VectorXd x(static_cast<Index>(nodes.size()));
    for (Index i = 0; i < x.size(); ++i) x[i] = at(i)[axis];
    return x;
  }

  // Potentials at the nodes that drive the flows `into` the nodes through t / L of every wall.
  VectorXd potentials(const VectorXd& into) const {
    const auto n = static_cast<Index>(nodes.size());
    MatrixXd net = MatrixXd::Zero(n, n);
    for (const Branch& b : branches) {
      const double c = b.thickness / b.length;
      net(b.i, b.i) += c;
      net(b.j, b.j) += c;
      net(b.i, b.j) -= c;
      net(b.j, b.i) -= c;
    }
    return net.completeOrthogonalDecomposition().solve(into); // up to a constant
  }

  // Whether a wall is part of a cell: its ends are joined without it.
  bool in_a_cell(std::size_t wall) const {
    std::vector<Index> root(nodes.size());
    std::iota(root.begin(), root.end(), Index{0});
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t k = 0; k < branches.size(); ++k) {
        if (k == wall) continue;
        Index &a = root[std::size_t(branches[k].i)], &b = root[std::size_t(branches[k].j)];
        changed = changed || a != b;
        a = b = std::min(a, b);
      }
    }
    return root[std::size_t(branches[wall].i)] == root[std::size_t(branches[wall].j)];
  }

  std::vector<Vector2d> nodes;
  std::vector<Branch> branches;
  Vector2d centroid;

private:
  Index node_at(const Vector2d& x, double tolerance) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if ((nodes[i] - x).norm() <= tolerance) return static_cast<Index>(i);
    nodes.push_back(x);
    return static_cast<Index>(nodes.size()) - 1;
  }
};

double lever(const WallNet& net, const Branch& b) {
  const Vector2d along = (net.at(b.j) - net.at(b.i)) / b.length;
  return net.at(b.i)[0] * along[1] - net.at(b.i)[1] * along[0];
}

// Warping under unit twist about the centroid.
VectorXd warping(const WallNet& net) {
  VectorXd into = VectorXd::Zero(static_cast<Index>(net.nodes.size()));
  for (const Branch& b : net.branches) {
    into[b.i] += b.thickness * lever(net, b);
    into[b.j] -= b.thickness * lever(net, b);
  }
  return net.potentials(into);
}

// Half the flow at three places of every wall under the stress that grows by f at the nodes.
std::vector<std::array<double, 3>> shear_flow(const WallNet& net, const VectorXd& f) {
  VectorXd into = VectorXd::Zero(f.size());
  for (const Branch& b : net.branches) {
    into[b.i] += b.thickness * b.length * (2 * f[b.i] + f[b.j]) / 6;
    into[b.j] += b.thickness * b.length * (f[b.i] + 2 * f[b.j]) / 6;
  }
  const VectorXd p = net.potentials(into);
  const double gauss = std::sqrt(0.6);
  std::vector<std::array<double, 3>> flow;
  for (const Branch& b : net.branches) {
    const double mean = (p[b.j] - p[b.i]) / b.length + b.length * (2 * f[b.i] + f[b.j]) / 6;
    std::array<double, 3> at{};
    for (int g = 0; g < 3; ++g) {
      const double s = b.length * (1 + (g - 1) * gauss) / 2;
      at[std::size_t(g)] =
          b.thickness * (mean - f[b.i] * s - (f[b.j] - f[b.i]) * s * s / (2 * b.length));
    }
    flow.push_back(at);
  }
  return flow;
}

} // namespace

ThinWallSection thin_wall_section(const std::vector<ThinWall>& walls) {
  const WallNet net(walls);
  const VectorXd y = net.coordinate(0), z = net.coordinate(1), w = warping(net);
  Matrix2d I; // integrals of y y, y z, z z
  I << net.integral(y, y), net.integral(y, z), net.integral(z, y), net.integral(z, z);
  if (!(I.determinant() > 1e-12 * I.trace() * I.trace()))
    throw std::invalid_argument("walls along one line");
  ThinWallSection section;
  // About the shear centre P the warping w + yP z - zP y has no moment with y and z.
  Matrix2d moments;
  moments << I(0, 1), -I(0, 0), I(1, 1), -I(0, 1);
  section.shear_centre =
      net.centroid - moments.partialPivLu().solve(Vector2d(net.integral(w, y), net.integral(w, z)));
  for (std::size_t k = 0; k < net.branches.size(); ++k) {
    const Branch& b = net.branches[k];
    const double h = lever(net, b), t = b.thickness;
    if (net.in_a_cell(k)) {
      section.J += t * h * (h * b.length + w[b.j] - w[b.i]);
      section.closed = true;
    } else {
      section.J += b.length * t * t * t / 3;
    }
  }
  std::array<std::vector<std::array<double, 3>>, 2> flows;
  for (int axis = 0; axis < 2; ++axis) {
    const Vector2d slope = I.inverse().col(axis); // of the stress under a unit force
    flows[std::size_t(axis)] = shear_flow(net, slope[0] * y + slope[1] * z);
  }
  constexpr std::array<double, 3> weights{5. / 18, 8. / 18, 5. / 18};
  for (int a = 0; a < 2; ++a)
    for (int c = 0; c < 2; ++c) {
      double sum = 0;
      for (std::size_t k = 0; k < net.branches.size(); ++k)
        for (std::size_t g = 0; g < 3; ++g)
          sum += weights[g] * net.branches[k].length / net.branches[k].thickness *
                 flows[std::size_t(a)][k][g] * flows[std::size_t(c)][k][g];
      section.shear_compliance(a, c) = sum;
    }
  return section;
}

} // namespace plica
