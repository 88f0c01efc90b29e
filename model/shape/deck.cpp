#include "model/shape/deck.hpp"

#include "solve/couplings.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double crease = 20 * std::numbers::pi / 180;
constexpr double rounding = 1e-9;

// Makes the model in steps; node numbers are those of the deck until unused ones go.
class Placer {
public:
  Placer(const DeckModel& deck, const DeckPlacing& placing)
      : deck_(deck), placing_(placing), turn_(placing.turn), L_(placing.units.length),
        M_(placing.units.mass) {}

  Model result() {
    model_.components = {"deck"};
    for (const Vector3d& x : deck_.nodes)
      model_.mesh.nodes.emplace_back(turn_ * (L_ * x) + placing_.move);
    model_.mesh.sets = deck_.sets;
    add_shells();
    for (BeamElement beam : deck_.beams) add(beam);
    for (MassElement mass : deck_.masses) add(mass);
    for (BushingElement bushing : deck_.bushings) add(bushing);
    for (const MatrixElement& spring : deck_.springs) add(spring);
    for (const DeckCoupling& c : deck_.couplings) add(c);
    for (const Constraint& row : deck_.equations) add(row);
    if (placing_.held)
      for (const Constraint& row : deck_.supports) add(row);
    drop_unused();
    hold_what_nothing_reaches();
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
      if (!(n.norm() > rounding * size * size))
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
      if (deck_.shells[e].nodes.size() == 4)
        fill(e, model_.mesh.quads.emplace_back());
      else
        fill(e, model_.mesh.triangles.emplace_back());
    }
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
    Eigen::MatrixXd R = Eigen::MatrixXd::Zero(spring.K.rows(), spring.K.rows());
    for (Eigen::Index i = 0; i < R.rows(); i += 3) R.block<3, 3>(i, i) = turn_;
    for (Eigen::Index i = 0; i < spring.K.rows(); ++i)
      for (Eigen::Index j = 0; j < spring.K.cols(); ++j)
        spring.K(i, j) = stiffness(spring.K(i, j), int(i % 6), int(j % 6));
    spring.K = R * spring.K * R.transpose();
    model_.matrices.push_back(std::move(spring));
  }

  void add(const DeckCoupling& c) {
    if (c.distributing) {
      add_distributing_coupling(model_, c.reference, c.nodes, c.origin, c.weights);
      std::erase_if(model_.constraints, [&](const Constraint& row) {
        return row.node == c.reference && row.dof >= 3 && row.origin == c.origin &&
               c.dofs.size() == 3;
      });
      return;
    }
    std::set<int> dofs;
    for (int dof : c.dofs) dofs.insert(turned(dof).first);
    const bool halves = std::any_of(c.dofs.begin(), c.dofs.end(), [&](int dof) {
      const int first = dof < 3 ? 0 : 3;
      return std::count_if(c.dofs.begin(), c.dofs.end(),
                           [&](int other) { return other / 3 == first / 3; }) < 3;
    });
    if (halves && !keeps_axes(turn_)) refuse(c.origin);
    add_kinematic_coupling(model_, c.reference, c.nodes,
                           keeps_axes(turn_) ? std::vector(dofs.begin(), dofs.end()) : c.dofs,
                           c.origin);
  }

  [[noreturn]] static void refuse(const std::string& origin) {
    throw std::runtime_error(origin + " ties or holds single degrees of freedom, which a turn that "
                                      "is no multiple of 90 degrees mixes");
  }

  // Where a DOF goes under a turn that keeps the axes, and its sign.
  std::pair<int, double> turned(int dof) const {
    Eigen::Index row = 0;
    const Vector3d axis = turn_.col(dof % 3);
    axis.cwiseAbs().maxCoeff(&row);
    return {static_cast<int>(row) + (dof < 3 ? 0 : 3), axis[row] < 0 ? -1. : 1.};
  }

  bool holds_a_whole_triple(const Constraint& row) const {
    const int first = row.dof < 3 ? 0 : 3;
    int held = 0;
    for (const Constraint& other : deck_.supports)
      held += other.node == row.node && other.dof / 3 == first / 3;
    return row.terms.empty() && held >= 3;
  }

  void add(Constraint row) {
    if (!keeps_axes(turn_)) {
      if (!holds_a_whole_triple(row)) refuse(row.origin);
      model_.constraints.push_back(row);
      return;
    }
    const auto [dof, sign] = turned(row.dof);
    for (ConstraintTerm& term : row.terms) {
      const auto [to, own_sign] = turned(term.dof);
      term.factor *= sign * own_sign * std::pow(L_, (row.dof < 3) - (term.dof < 3));
      term.dof = to;
    }
    row.dof = dof;
    model_.constraints.push_back(std::move(row));
  }

  template <class F> void for_each_node_number(F&& f) {
    for (ShellQuad& q : model_.mesh.quads) std::for_each(q.nodes.begin(), q.nodes.end(), f);
    for (ShellTriangle& t : model_.mesh.triangles) std::for_each(t.nodes.begin(), t.nodes.end(), f);
    for (BeamElement& b : model_.beams) f(b.node1), f(b.node2);
    for (MassElement& m : model_.masses) f(m.node);
    for (BushingElement& b : model_.bushings) {
      f(b.node1);
      if (b.node2 >= 0) f(b.node2);
    }
    for (MatrixElement& m : model_.matrices) std::for_each(m.nodes.begin(), m.nodes.end(), f);
    for (Constraint& c : model_.constraints) {
      if (c.terms.empty()) continue; // holding a node does not make use of it
      f(c.node);
      for (ConstraintTerm& t : c.terms) f(t.node);
    }
  }

  void drop_unused() {
    std::vector<int> number(model_.mesh.nodes.size(), -1);
    for_each_node_number([&](int node) { number[node] = 0; });
    std::vector<Vector3d> kept;
    for (std::size_t node = 0; node < number.size(); ++node)
      if (number[node] == 0) {
        number[node] = static_cast<int>(kept.size());
        kept.push_back(model_.mesh.nodes[node]);
      }
    std::erase_if(model_.constraints,
                  [&](const Constraint& c) { return c.terms.empty() && number[c.node] < 0; });
    for_each_node_number([&](int& node) { node = number[node]; });
    for (Constraint& c : model_.constraints)
      if (c.terms.empty()) c.node = number[c.node];
    for (auto& [name, nodes] : model_.mesh.sets) {
      for (int& node : nodes) node = number[node];
      std::erase(nodes, -1);
    }
    std::erase_if(model_.mesh.sets, [](const auto& set) { return set.second.empty(); });
    model_.mesh.nodes = std::move(kept);
  }

  void hold_what_nothing_reaches() {
    std::vector<bool> reached(6 * model_.mesh.nodes.size(), false);
    const auto reach = [&](int node, int first = 0, int last = 6) {
      for (int dof = first; dof < last; ++dof) reached[6 * node + dof] = true;
    };
    for (const ShellQuad& q : model_.mesh.quads)
      for (int node : q.nodes) reach(node);
    for (const ShellTriangle& t : model_.mesh.triangles)
      for (int node : t.nodes) reach(node);
    for (const BeamElement& b : model_.beams) reach(b.node1), reach(b.node2);
    for (const MassElement& m : model_.masses)
      reach(m.node, 0, m.body.inertia.isZero() && m.body.offset.isZero() ? 3 : 6);
    const auto reach_by = [&](const Eigen::MatrixXd& K, const std::vector<int>& nodes) {
      for (Eigen::Index i = 0; i < K.rows(); ++i)
        if (!K.row(i).isZero(0)) reach(nodes[i / 6], int(i % 6), int(i % 6) + 1);
    };
    for (const BushingElement& b : model_.bushings)
      reach_by(bushing_matrix(model_.mesh, b), {b.node1, b.node2});
    for (const MatrixElement& m : model_.matrices) reach_by(m.K, m.nodes);
    for (const Constraint& c : model_.constraints) {
      reach(c.node, c.dof, c.dof + 1);
      for (const ConstraintTerm& t : c.terms) reach(t.node, t.dof, t.dof + 1);
    }
    for (int node = 0; node < static_cast<int>(model_.mesh.nodes.size()); ++node)
      for (int dof = 0; dof < 6; ++dof)
        if (!reached[6 * node + dof]) add_support(model_, {node}, {dof}, "nothing reaches it");
  }

  const DeckModel& deck_;
  const DeckPlacing& placing_;
  Matrix3d turn_;
  double L_, M_;
  std::map<int, std::vector<int>> walls_; // by node of the deck
  Model model_;
};

} // namespace

bool keeps_axes(const Matrix3d& turn) {
  return (turn.cwiseAbs().array() < rounding || (turn.cwiseAbs().array() - 1).abs() < rounding)
      .all();
}

Model place(const DeckModel& deck, const DeckPlacing& placing) {
  return Placer(deck, placing).result();
}

} // namespace plica
