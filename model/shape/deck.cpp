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
    model_.scalar_nodes = deck_.scalars;
    add_shells();
    for (BeamElement beam : deck_.beams) add(beam);
    for (MassElement mass : deck_.masses) add(mass);
    for (BushingElement bushing : deck_.bushings) add(bushing);
    for (const MatrixElement& spring : deck_.springs) add(spring);
    for (const DeckCoupling& c : deck_.couplings) add(c);
    for (const Constraint& row : deck_.equations) add(row);
    if (placing_.held)
      for (const Constraint& row : deck_.supports) add(row);
    solve_rows();
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

  // --- rows of constraints

  // Axes of the DOFs of a node in a row of the deck.
  Matrix3d axes_of(int node) const {
    if (deck_.scalars.contains(node)) return Matrix3d::Identity();
    const auto own = deck_.axes.find(node);
    return own == deck_.axes.end() ? turn_ : Matrix3d(turn_ * own->second);
  }

  // direction . u = sum of terms, for the translations or the rotations of a node.
  struct Row {
    Vector3d direction;
    std::map<std::pair<int, int>, double> terms; // by node and DOF
    std::string origin;
  };

  void add(const DeckCoupling& c) {
    const std::size_t first = model_.constraints.size();
    if (c.distributing)
      add_distributing_coupling(model_, c.reference, c.nodes, c.origin, c.weights);
    else
      add_kinematic_coupling(model_, c.reference, c.nodes, {0, 1, 2, 3, 4, 5}, c.origin);
    const auto begin = model_.constraints.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<Constraint> all(begin, model_.constraints.end()); // six for each node
    model_.constraints.erase(begin, model_.constraints.end());
    for (std::size_t i = 0; i < all.size(); i += 3) add_wanted(c, &all[i]);
  }

  // Of three rows, for the translations or the rotations of a node, what a coupling wants.
  void add_wanted(const DeckCoupling& c, const Constraint* rows) {
    const int first = rows[0].dof;
    std::vector<int> wanted;
    for (int k = 0; k < 3; ++k)
      if (std::find(c.dofs.begin(), c.dofs.end(), first + k) != c.dofs.end() ||
          (c.distributing && c.dofs.size() != 3))
        wanted.push_back(k);
    if (wanted.size() == 3) {
      model_.constraints.insert(model_.constraints.end(), rows, rows + 3);
      return;
    }
    const Matrix3d A = axes_of(rows[0].node);
    for (int k : wanted) {
      Row row{A.col(k), {}, c.origin};
      for (int d = 0; d < 3; ++d)
        for (const ConstraintTerm& t : rows[d].terms)
          row.terms[{t.node, t.dof}] += A(d, k) * t.factor;
      rows_[{rows[0].node, first}].push_back(std::move(row));
    }
  }

  void add(const Constraint& row) {
    Row own{axes_of(row.node).col(row.dof % 3), {}, row.origin};
    for (const ConstraintTerm& term : row.terms) {
      const Vector3d direction = axes_of(term.node).col(term.dof % 3);
      const double factor = term.factor * std::pow(L_, (row.dof < 3) - (term.dof < 3));
      for (int d = 0; d < 3; ++d)
        if (std::abs(direction[d]) > rounding)
          own.terms[{term.node, term.dof / 3 * 3 + d}] += factor * direction[d];
    }
    rows_[{row.node, row.dof / 3 * 3}].push_back(std::move(own));
  }

  // Rows of one node along any axes as rows that each determine a DOF of their own: elimination
  // with pivots. What determines a direction twice goes on as it is; who solves says so.
  void solve_rows() {
    for (auto& [at, rows] : rows_) {
      std::vector<std::pair<int, Row>> solved; // DOF of the three, row with 1 there
      for (const Row& given : rows) {
        Row row = given;
        const auto subtract = [](Row& from, const Row& what, double factor) {
          from.direction -= factor * what.direction;
          for (const auto& [dof, f] : what.terms) from.terms[dof] -= factor * f;
        };
        for (const auto& [d, known] : solved) subtract(row, known, row.direction[d]);
        Eigen::Index pivot = 0;
        if (!(row.direction.cwiseAbs().maxCoeff(&pivot) > rounding)) {
          row = given;
          row.direction.cwiseAbs().maxCoeff(&pivot);
        }
        const double largest = row.direction[pivot];
        row.direction /= largest;
        for (auto& [dof, f] : row.terms) f /= largest;
        for (auto& [d, known] : solved)
          if (d != pivot) subtract(known, row, known.direction[pivot]);
        solved.emplace_back(int(pivot), std::move(row));
      }
      for (const auto& [d, row] : solved) add_row(at.first, at.second + d, row);
    }
  }

  void add_row(int node, int dof, const Row& row) {
    Constraint own{node, dof, {}, row.origin};
    for (int d = 0; d < 3; ++d)
      if (d != dof % 3 && std::abs(row.direction[d]) > rounding)
        own.terms.push_back({node, dof / 3 * 3 + d, -row.direction[d]});
    for (const auto& [at, factor] : row.terms)
      if (factor != 0) own.terms.push_back({at.first, at.second, factor});
    model_.constraints.push_back(std::move(own));
  }

  // --- what is left

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
      const bool holds = std::all_of(c.terms.begin(), c.terms.end(),
                                     [&](const ConstraintTerm& t) { return t.node == c.node; });
      if (holds) continue; // which makes no use of a node
      f(c.node);
      for (ConstraintTerm& t : c.terms) f(t.node);
    }
  }

  void drop_unused() {
    std::vector<int> number(model_.mesh.nodes.size(), -1);
    for_each_node_number([&](int node) { number[node] = 0; });
    std::vector<Vector3d> kept;
    std::set<int> scalars;
    for (std::size_t node = 0; node < number.size(); ++node)
      if (number[node] == 0) {
        number[node] = static_cast<int>(kept.size());
        if (model_.scalar_nodes.contains(int(node))) scalars.insert(number[node]);
        kept.push_back(model_.mesh.nodes[node]);
      }
    model_.scalar_nodes = std::move(scalars);
    std::erase_if(model_.constraints, [&](const Constraint& c) { return number[c.node] < 0; });
    std::vector<Constraint> constraints = std::move(model_.constraints);
    model_.constraints.clear();
    for_each_node_number([&](int& node) { node = number[node]; });
    for (Constraint& c : constraints) {
      c.node = number[c.node];
      for (ConstraintTerm& t : c.terms) t.node = number[t.node];
    }
    model_.constraints = std::move(constraints);
    for (auto& [name, nodes] : model_.mesh.sets) {
      for (int& node : nodes) node = number[node];
      std::erase(nodes, -1);
    }
    std::erase_if(model_.mesh.sets, [](const auto& set) { return set.second.empty(); });
    model_.mesh.nodes = std::move(kept);
  }

  // DOFs with stiffness, or, unless those without are held, with mass.
  std::vector<bool> reached_by_elements() const {
    std::vector<bool> reached(6 * model_.mesh.nodes.size(), false);
    const auto reach = [&](int node, int first = 0, int last = 6) {
      for (int dof = first; dof < last; ++dof) reached[6 * node + dof] = true;
    };
    const auto reach_by_shell = [&](const auto& shell) {
      const ShellSection& wall = model_.shells[std::size_t(shell.section)].section;
      for (int node : shell.nodes) reach(node, 0, wall.bending_factor > 0 ? 6 : 3);
    };
    for (const ShellQuad& q : model_.mesh.quads) reach_by_shell(q);
    for (const ShellTriangle& t : model_.mesh.triangles) reach_by_shell(t);
    for (const BeamElement& b : model_.beams) reach(b.node1), reach(b.node2);
    const auto reach_by = [&](const Eigen::MatrixXd& K, const std::vector<int>& nodes) {
      for (Eigen::Index i = 0; i < K.rows(); ++i)
        if (!K.row(i).isZero(0)) reach(nodes[i / 6], int(i % 6), int(i % 6) + 1);
    };
    for (const BushingElement& b : model_.bushings)
      reach_by(bushing_matrix(model_.mesh, b), {b.node1, b.node2});
    for (const MatrixElement& m : model_.matrices) reach_by(m.K, m.nodes);
    if (deck_.holds_what_has_no_stiffness) return reached;
    for (const MassElement& m : model_.masses)
      reach(m.node, 0, m.body.inertia.isZero() && m.body.offset.isZero() ? 3 : 6);
    for (const MatrixElement& m : model_.matrices)
      if (m.K.isZero(0)) reach_by(m.M, m.nodes);
    return reached;
  }

  void hold_what_nothing_reaches() {
    std::vector<bool> reached = reached_by_elements();
    for (const Constraint& c : model_.constraints) {
      reached[6 * c.node + c.dof] = true;
      for (const ConstraintTerm& t : c.terms)
        if (t.node != c.node) reached[6 * t.node + t.dof] = true;
    }
    for (int node = 0; node < static_cast<int>(model_.mesh.nodes.size()); ++node)
      for (int dof = 0; dof < 6; ++dof)
        if (!reached[6 * node + dof]) add_support(model_, {node}, {dof}, "nothing reaches it");
  }

  const DeckModel& deck_;
  const DeckPlacing& placing_;
  Matrix3d turn_;
  double L_, M_;
  std::map<int, std::vector<int>> walls_;                // by node of the deck
  std::map<std::pair<int, int>, std::vector<Row>> rows_; // by node and first of its three DOFs
  Model model_;
};

} // namespace

Model place(const DeckModel& deck, const DeckPlacing& placing) {
  return Placer(deck, placing).result();
}

} // namespace plica
