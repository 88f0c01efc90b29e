#include "model/shape/deck.hpp"

#include "model/shape/deck_constraints.hpp"
#include "model/shape/lumped_mass.hpp"
#include "model/shape/unused_nodes.hpp"
#include "solve/couplings.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double crease = 20 * std::numbers::pi / 180;
constexpr double least_area = 1e-9; // of the square of its largest edge

// Makes the model in steps; node numbers are those of the deck until unused ones go.
class Placer {
public:
  Placer(const DeckModel& deck, const DeckPlacing& placing)
      : deck_(deck), placing_(placing), turn_(placing.turn), L_(placing.units.length),
        M_(placing.units.mass) {}

  Model result(std::vector<int>* numbers) {
    model_.components = {"deck"};
    for (const Vector3d& x : deck_.nodes)
      model_.mesh.nodes.emplace_back(turn_ * (L_ * x) + placing_.move);
    model_.mesh.sets = deck_.sets;
    model_.scalar_nodes = deck_.scalars;
    add_shells();
    for (BeamElement beam : deck_.beams) add(beam);
    for (MassElement mass : deck_.masses) add(mass);
    for (BushingElement bushing : deck_.bushings) add(bushing);
    const int first = static_cast<int>(model_.matrices.size()); // those before are walls
    for (const MatrixElement& spring : deck_.springs) add(spring);
    if (deck_.lumped_mass) lump(first);
    add_deck_constraints(model_, deck_, placing_);
    std::vector<int> kept = drop_unused_nodes(model_);
    kept.resize(deck_.nodes.size()); // those of walls beside their nodes come behind
    if (numbers != nullptr) *numbers = std::move(kept);
    hold_what_nothing_reaches(model_, deck_.holds_what_has_no_stiffness);
    return std::move(model_);
  }

private:
  double force() const { return M_ * L_; } // per second squared
  double per_area(double modulus) const { return modulus * M_ / L_; }

  Vector3d corner_normal(const DeckShell& shell, std::size_t corner) const {
    const auto& x = model_.mesh.nodes;
    const std::size_t n = shell.nodes.size();
    const Vector3d a = x[shell.nodes[(corner + 1) % n]] - x[shell.nodes[corner]];
    const Vector3d b = x[shell.nodes[(corner + n - 1) % n]] - x[shell.nodes[corner]];
    return a.cross(b);
  }

  Vector3d facet_normal(const DeckShell& shell) const {
    if (shell.nodes.size() == 3) return corner_normal(shell, 0);
    const auto& x = model_.mesh.nodes;
    return (x[shell.nodes[2]] - x[shell.nodes[0]]).cross(x[shell.nodes[3]] - x[shell.nodes[1]]);
  }

  std::vector<Vector3d> facet_normals() const {
    std::vector<Vector3d> normals;
    for (const DeckShell& shell : deck_.shells) {
      const Vector3d n = facet_normal(shell);
      double size = 0;
      for (int node : shell.nodes)
        size = std::max(size, (model_.mesh.nodes[node] - model_.mesh.nodes[shell.nodes[0]]).norm());
      if (!(n.norm() > least_area * size * size))
        throw std::runtime_error(shell.origin + " has no area");
      for (std::size_t corner = 0; corner < shell.nodes.size(); ++corner)
        if (!(corner_normal(shell, corner).dot(n) > 0))
          throw std::runtime_error(shell.origin + " is folded, or its nodes are not in order");
      normals.push_back(n.normalized());
    }
    return normals;
  }

  // Director of a corner: as given, or the mean over the facets that meet there.
  Vector3d director(std::size_t e, std::size_t corner, const std::vector<Vector3d>& facets,
                    const std::vector<std::vector<int>>& around) const {
    const DeckShell& shell = deck_.shells[e];
    if (!shell.normal.empty() && shell.normal[corner])
      return (turn_ * *shell.normal[corner]).normalized();
    Vector3d sum = Vector3d::Zero();
    for (int other : around[shell.nodes[corner]])
      if (facets[other].dot(facets[e]) > std::cos(crease)) sum += facets[other];
    return sum.normalized();
  }

  // Node on the middle of a wall beside its nodes; one for all corners with the same place.
  int node_of_wall(int node, double offset, const Vector3d& director) {
    if (offset == 0) return node;
    const Vector3d x = model_.mesh.nodes[node] + L_ * offset * director;
    std::vector<int>& known = walls_[node];
    for (int n : known)
      if ((model_.mesh.nodes[n] - x).norm() < 1e-3 * L_ * std::abs(offset)) return n;
    known.push_back(add_node(model_, x));
    add_kinematic_coupling(model_, node, {known.back()}, {0, 1, 2, 3, 4, 5}, "offset of a wall");
    return known.back();
  }

  void add_shells() {
    for (ShellSection section : deck_.sections) {
      section.E = per_area(section.E);
      section.rho *= M_ / (L_ * L_ * L_);
      model_.shells.push_back({section, placing_.membrane, 0});
    }
    const std::vector<Vector3d> facets = facet_normals();
    std::vector<std::vector<int>> around(deck_.nodes.size());
    for (std::size_t e = 0; e < deck_.shells.size(); ++e)
      for (int node : deck_.shells[e].nodes) around[node].push_back(static_cast<int>(e));
    const auto fill = [&](std::size_t e, auto& shell) {
      const DeckShell& own = deck_.shells[e];
      shell.section = own.section;
      for (std::size_t a = 0; a < own.nodes.size(); ++a) {
        const auto column = static_cast<Eigen::Index>(a);
        const Vector3d V = director(e, a, facets, around);
        shell.directors.col(column) = V;
        shell.thickness[column] = L_ * own.thickness[a];
        shell.nodes[a] = node_of_wall(own.nodes[a], own.offset, V);
      }
    };
    for (std::size_t e = 0; e < deck_.shells.size(); ++e) {
      if (deck_.shells[e].laminate >= 0)
        add_laminate(e, facets, around);
      else if (deck_.shells[e].nodes.size() == 4)
        fill(e, model_.mesh.quads.emplace_back());
      else
        fill(e, model_.mesh.triangles.emplace_back());
    }
  }

  // A wall that is not isotropic, by its matrices.
  void add_laminate(std::size_t e, const std::vector<Vector3d>& facets,
                    const std::vector<std::vector<int>>& around) {
    const DeckShell& own = deck_.shells[e];
    ShellLaminate wall = deck_.laminates[own.laminate];
    for (Matrix3d* law : {&wall.A, &wall.B, &wall.D}) *law *= per_area(1);
    wall.S *= per_area(1);
    wall.drilling = per_area(wall.drilling);
    const Vector3d along = turn_ * own.along;
    if (!(along.cross(facets[e]).norm() > 1e-6 * along.norm()))
      throw std::runtime_error(own.origin + " has the first axis of its plies along its normal");
    MatrixElement element;
    const auto shape = [&](auto& g) {
      for (std::size_t a = 0; a < own.nodes.size(); ++a) {
        const auto column = static_cast<Eigen::Index>(a);
        const Vector3d V = director(e, a, facets, around);
        element.nodes.push_back(node_of_wall(own.nodes[a], own.offset, V));
        g.X.col(column) = model_.mesh.nodes[element.nodes.back()];
        g.directors.col(column) = V;
        g.thickness[column] = L_ * own.thickness[a];
      }
    };
    const ShellSection mass{.rho = wall.rho * M_ / (L_ * L_ * L_)};
    if (own.nodes.size() == 4) {
      ShellGeometry g;
      shape(g);
      element.K = shell_laminate_stiffness(g, wall, along, placing_.membrane);
      element.M = shell_mitc4_mass(g, mass);
    } else {
      TriangleGeometry g;
      shape(g);
      element.K = shell_laminate_stiffness(g, wall, along);
      element.M = shell_mitc3_mass(g, mass);
    }
    model_.matrices.push_back(std::move(element));
  }

  void add(BeamElement& beam) {
    BeamProperties& s = beam.section;
    for (double* stiffness : {&s.EA, &s.GA_y, &s.GA_z}) *stiffness *= force();
    for (double* stiffness : {&s.EI_y, &s.EI_z, &s.GJ}) *stiffness *= force() * L_ * L_;
    s.mass *= M_ / L_;
    for (double* inertia : {&s.inertia_x, &s.inertia_y, &s.inertia_z}) *inertia *= M_ * L_;
    for (auto& fibre : s.fibres) fibre = {L_ * fibre[0], L_ * fibre[1]};
    s.E = per_area(s.E);
    beam.up = turn_ * beam.up;
    beam.offset1 = turn_ * (L_ * beam.offset1);
    beam.offset2 = turn_ * (L_ * beam.offset2);
    model_.beams.push_back(beam);
  }

  void add(MassElement& mass) {
    mass.body.mass *= M_;
    mass.body.offset = turn_ * (L_ * mass.body.offset);
    mass.body.inertia = turn_ * (M_ * L_ * L_ * mass.body.inertia) * turn_.transpose();
    model_.masses.push_back(mass);
  }

  // Stiffness between DOFs: forces over displacements, moments over rotations.
  double stiffness(double k, int row, int column) const {
    return k * M_ * std::pow(L_, (row >= 3) + (column >= 3));
  }

  void add(BushingElement& bushing) {
    Matrix6& law = bushing.bushing.law;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) law(i, j) = stiffness(law(i, j), i, j);
    bushing.bushing.axes = turn_ * bushing.bushing.axes;
    model_.bushings.push_back(bushing);
  }

  void add(MatrixElement spring) {
    Eigen::MatrixXd R = Eigen::MatrixXd::Identity(spring.K.rows(), spring.K.rows());
    for (Eigen::Index i = 0; i < R.rows(); i += 3)
      if (!deck_.scalars.contains(spring.nodes[i / 6])) R.block<3, 3>(i, i) = turn_;
    for (Eigen::MatrixXd* matrix : {&spring.K, &spring.M}) {
      for (Eigen::Index i = 0; i < matrix->rows(); ++i)
        for (Eigen::Index j = 0; j < matrix->cols(); ++j) // seconds stay seconds
          (*matrix)(i, j) = stiffness((*matrix)(i, j), int(i % 6), int(j % 6));
      *matrix = R * *matrix * R.transpose();
    }
    model_.matrices.push_back(std::move(spring));
  }

  // Not the matrices that a deck gives as such; `first`: of the springs of the deck.
  void lump(int first) {
    std::map<int, EndArms> matrices;
    for (int wall = 0; wall < first; ++wall) matrices[wall] = no_arms();
    for (const auto& [spring, bar] : deck_.of_springs)
      matrices[first + spring] = {turn_ * (L_ * bar.arms[0]), turn_ * (L_ * bar.arms[1])};
    lump_masses(model_, matrices);
  }

  const DeckModel& deck_;
  const DeckPlacing& placing_;
  Matrix3d turn_;
  double L_, M_;
  std::map<int, std::vector<int>> walls_; // by node of the deck
  Model model_;
};

} // namespace

Model place(const DeckModel& deck, const DeckPlacing& placing, std::vector<int>* numbers) {
  return Placer(deck, placing).result(numbers);
}

} // namespace plica
