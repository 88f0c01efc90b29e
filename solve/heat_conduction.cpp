#include "solve/heat_conduction.hpp"

#include "solve/sparse_factor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A shell as heat sees it: integral of grad N' grad N, and of N t and N over its surface.
struct Cell {
  std::vector<int> nodes; // numbers among those of the part
  MatrixXd gradients;
  VectorXd area;
  double thickness = 0; // mean
};

// One point of integration: shape functions, their derivatives, the weight.
struct Point {
  VectorXd N;
  Eigen::MatrixX2d d;
  double weight = 0;
};

std::vector<Point> points_of(std::size_t corners) {
  std::vector<Point> points;
  if (corners == 3) {
    Eigen::MatrixX2d d(3, 2);
    d << -1, -1, 1, 0, 0, 1;
    points.push_back({VectorXd::Constant(3, 1. / 3), d, 0.5});
    return points;
  }
  const double g = 1 / std::sqrt(3.);
  const Eigen::Array4d r{-1, 1, 1, -1}, s{-1, -1, 1, 1};
  for (Index p = 0; p < 4; ++p) {
    const Eigen::Array4d R = 1 + g * r[p] * r, S = 1 + g * s[p] * s;
    Eigen::MatrixX2d d(4, 2);
    d.col(0) = r * S / 4;
    d.col(1) = s * R / 4;
    points.push_back({R * S / 4, d, 1});
  }
  return points;
}

template <class Shell> Cell cell_of(const Mesh& mesh, const Shell& shell) {
  const std::size_t corners = shell.nodes.size();
  Cell cell;
  cell.nodes.assign(shell.nodes.begin(), shell.nodes.end());
  cell.gradients = MatrixXd::Zero(Index(corners), Index(corners));
  cell.area = VectorXd::Zero(Index(corners));
  cell.thickness = shell.thickness.mean();
  Eigen::Matrix3Xd X(3, corners);
  for (std::size_t i = 0; i < corners; ++i)
    X.col(Index(i)) = mesh.nodes[std::size_t(shell.nodes[i])];
  for (const Point& p : points_of(corners)) {
    const Eigen::Matrix<double, 3, 2> along = X * p.d;
    const Eigen::Matrix2d metric = along.transpose() * along;
    const double surface = p.weight * std::sqrt(metric.determinant());
    cell.gradients += surface * p.d * metric.inverse() * p.d.transpose();
    cell.area += surface * p.N;
  }
  return cell;
}

class Conduction {
public:
  Conduction(const Model& model, int component, const std::function<double(double)>& conductivity,
             const HeatLoads& loads)
      : conductivity_(conductivity), loads_(loads), number_(model.mesh.nodes.size(), -1) {
    collect(model, model.mesh.quads, component);
    collect(model, model.mesh.triangles, component);
    for (const auto& [node, temperature] : loads.held) {
      const int number = number_[std::size_t(node)];
      if (number < 0) continue;
      held_[number] = temperature;
      widen(temperature);
    }
    for (const auto& film : {loads.below, loads.above})
      if (film) widen(film->gas);
  }

  WallTemperature solve() {
    if (nodes_.empty() || !(low_ <= high_))
      throw std::runtime_error("nothing gives the wall a temperature");
    T_ = VectorXd::Constant(Index(nodes_.size()), (low_ + high_) / 2);
    constexpr int most = 100;
    constexpr double settled = 1e-9; // K
    for (int i = 0; i < most; ++i) {
      const VectorXd before = T_;
      substitute();
      if ((T_ - before).cwiseAbs().maxCoeff() < settled) return result();
    }
    throw std::runtime_error("the temperature of the wall does not settle");
  }

private:
  template <class Shells> void collect(const Model& model, const Shells& shells, int component) {
    for (const auto& shell : shells) {
      if (model.shells[std::size_t(shell.section)].component != component) continue;
      Cell cell = cell_of(model.mesh, shell);
      for (int& node : cell.nodes) {
        int& number = number_[std::size_t(node)];
        if (number < 0) {
          number = int(nodes_.size());
          nodes_.push_back(node);
        }
        node = number;
      }
      cells_.push_back(std::move(cell));
    }
  }

  void widen(double temperature) {
    low_ = std::min(low_, temperature);
    high_ = std::max(high_, temperature);
  }

  double mean_of(const Cell& cell) const {
    double sum = 0;
    for (int n : cell.nodes) sum += T_[n];
    return std::clamp(sum / double(cell.nodes.size()), low_, high_);
  }

  // Of a square metre, W/K: the film and half of the wall.
  double taken_by(const std::optional<WallFilm>& film, const Cell& cell, double k) const {
    return film ? 1 / (1 / film->coefficient + cell.thickness / (2 * k)) : 0;
  }

  // The next T_ with the conductivity of the present one.
  void substitute() {
    const Index n = T_.size();
    std::vector<Eigen::Triplet<double>> entries;
    VectorXd heat = VectorXd::Zero(n);
    for (const Cell& cell : cells_) {
      const double k = conductivity_(mean_of(cell));
      for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
        for (std::size_t j = 0; j < cell.nodes.size(); ++j)
          if (cell.nodes[i] >= cell.nodes[j])
            entries.emplace_back(cell.nodes[i], cell.nodes[j],
                                 k * cell.thickness * cell.gradients(Index(i), Index(j)));
        for (const auto& film : {loads_.below, loads_.above}) {
          const double h = taken_by(film, cell, k) * cell.area[Index(i)];
          if (h == 0) continue;
          entries.emplace_back(cell.nodes[i], cell.nodes[i], h);
          heat[cell.nodes[i]] += h * film->gas;
        }
      }
    }
    SparseMatrix K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    for (const auto& [number, temperature] : held_) T_[number] = temperature;
    std::vector<int> free;
    for (int i = 0; i < int(n); ++i)
      if (!held_.contains(i)) free.push_back(i);
    if (free.empty()) return;
    VectorXd given = T_;
    given(free).setZero();
    const VectorXd right = heat - symmetric_product(K, given).col(0);
    const SparseMatrix K_free = restrict_to(K, free);
    SparseFactor factor(K_free);
    if (!factor.factorise(K_free).ok)
      throw std::runtime_error("a piece of the wall has neither a temperature nor gas");
    T_(free) = factor.solve(VectorXd(right(free))).col(0);
    lacking_ = symmetric_product(K, T_).col(0) - heat;
  }

  WallTemperature result() const {
    WallTemperature wall;
    wall.at = VectorXd::Constant(Index(number_.size()), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      wall.at[nodes_[i]] = std::clamp(T_[Index(i)], low_, high_);
    if (lacking_.size() > 0)
      for (const auto& [number, temperature] : held_)
        wall.through += std::max(0., lacking_[number]);
    for (const Cell& cell : cells_) {
      const double T = mean_of(cell), k = conductivity_(T);
      const double in =
          loads_.below ? taken_by(loads_.below, cell, k) * (loads_.below->gas - T) : 0;
      const double out =
          loads_.above ? taken_by(loads_.above, cell, k) * (T - loads_.above->gas) : 0;
      wall.across = std::max(wall.across, std::abs(in + out) * cell.thickness / (2 * k));
      wall.through += cell.area.sum() * (std::max(0., in) + std::max(0., -out));
    }
    return wall;
  }

  const std::function<double(double)>& conductivity_;
  const HeatLoads& loads_;
  std::vector<int> number_, nodes_; // of a node of the mesh among those of the part, and back
  std::vector<Cell> cells_;
  std::map<int, double> held_; // by the former
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  VectorXd T_, lacking_; // lacking_: heat that comes in at the nodes that are held, W
};

} // namespace

WallTemperature conducted_temperature(const Model& model, int component,
                                      const std::function<double(double)>& conductivity,
                                      const HeatLoads& loads) {
  return Conduction(model, component, conductivity, loads).solve();
}

} // namespace plica
