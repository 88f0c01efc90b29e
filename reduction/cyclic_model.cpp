#include "reduction/cyclic_model.hpp"

#include "solve/element_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Triplet = Eigen::Triplet<double>;

bool is_even(int component) {
  return component < 3;
}

// cos or sin of n times the angle between two sides, by the parity of the components.
double sector_factor(int n, int around, int a, int b, int sides_apart) {
  const double phase = 2 * std::numbers::pi * n / around * sides_apart;
  if (is_even(a) == is_even(b)) return std::cos(phase);
  return is_even(a) ? std::sin(phase) : -std::sin(phase);
}

// Number of sectors over which the squares of the weights add up.
double sectors(int n, int around) {
  return n == 0 || 2 * n == around ? around : around / 2.;
}

// Dense blocks over coordinates, collected into K and M over the independent unknowns.
class Collector {
public:
  explicit Collector(const Eigen::SparseMatrix<double>& T) : rows_(T.transpose()) {}

  void add(const std::vector<int>& coordinates, const MatrixXd& K, const MatrixXd& M) {
    std::vector<int> reached;
    for (int c : coordinates)
      for (Row it(rows_, c); it; ++it) reached.push_back(int(it.row()));
    std::sort(reached.begin(), reached.end());
    reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
    MatrixXd T = MatrixXd::Zero(Eigen::Index(coordinates.size()), Eigen::Index(reached.size()));
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      for (Row it(rows_, coordinates[i]); it; ++it)
        T(i, std::lower_bound(reached.begin(), reached.end(), it.row()) - reached.begin()) =
            it.value();
    const MatrixXd k = T.transpose() * K * T, m = T.transpose() * M * T;
    for (std::size_t j = 0; j < reached.size(); ++j)
      for (std::size_t i = j; i < reached.size(); ++i) { // one pattern: zeros are kept
        k_.emplace_back(reached[i], reached[j], k(i, j));
        m_.emplace_back(reached[i], reached[j], m(i, j));
      }
  }

  void write(SparseMatrix& K, SparseMatrix& M) const {
    const Eigen::Index n = rows_.rows();
    K.resize(n, n);
    M.resize(n, n);
    K.setFromTriplets(k_.begin(), k_.end());
    M.setFromTriplets(m_.begin(), m_.end());
  }

private:
  using Row = Eigen::SparseMatrix<double>::InnerIterator;
  Eigen::SparseMatrix<double> rows_; // T transposed: a column per coordinate
  std::vector<Triplet> k_, m_;
};

MatrixXd projected(const MatrixXd& A, const MatrixXd& D) {
  return D.transpose() * A * D;
}

// Elements that follow the quads, all of them on the axis.
void add_axis_elements(const Model& model, const std::vector<AxisUnknown>& axis, int first,
                       Collector& collector) {
  const ElementView elements{model};
  for (int e = static_cast<int>(model.mesh.quads.size()); e < elements.size(); ++e)
    elements.visit(e, [&](const auto& nodes, const auto& K, const auto& M) {
      std::vector<int> coordinates;
      MatrixXd D(K.rows(), 0);
      for (std::size_t k = 0; k < axis.size(); ++k)
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          if (nodes[i] != axis[k].node) continue;
          coordinates.push_back(first + static_cast<int>(k));
          D.conservativeResize(Eigen::NoChange, D.cols() + 1);
          D.rightCols(1).setZero();
          D.rightCols(1).middleRows(6 * Eigen::Index(i), 6) = axis[k].direction;
        }
      if (!coordinates.empty()) collector.add(coordinates, projected(K, D), projected(M, D));
    });
}

} // namespace

double CyclicModel::weight(const Harmonic& h, int component, int step) const {
  // Exact multiples: the angle of n * step sectors, brought into one turn.
  const double angle =
      2 * std::numbers::pi * static_cast<int>((static_cast<long>(h.n) * step) % around_) / around_;
  if (is_even(component)) return h.sine ? std::sin(angle) : std::cos(angle);
  return h.sine ? -std::cos(angle) : std::sin(angle);
}

Eigen::Matrix<double, 6, 6> cyclic_components(int step, int around) {
  const double angle = 2 * std::numbers::pi * step / around;
  const Eigen::Vector3d e_r(std::cos(angle), 0, std::sin(angle)), e_y(0, 1, 0),
      e_t(-std::sin(angle), 0, std::cos(angle));
  Eigen::Matrix<double, 6, 6> B = Eigen::Matrix<double, 6, 6>::Zero();
  B.col(0).head<3>() = e_r;
  B.col(1).head<3>() = e_y;
  B.col(2).tail<3>() = e_t;
  B.col(3).head<3>() = e_t;
  B.col(4).tail<3>() = e_r;
  B.col(5).tail<3>() = e_y;
  return B;
}

bool CyclicModel::active(const Harmonic& h, int component) const {
  return is_pair(h.n) || is_even(component) != h.sine;
}

std::vector<AxisUnknown> CyclicModel::axis_unknowns(const Harmonic& h) const {
  std::vector<AxisUnknown> unknowns;
  for (int node : axis_nodes_) {
    const auto add = [&](int dof, double sign) {
      unknowns.push_back({.node = node, .direction = sign * Vector6::Unit(dof)});
    };
    if (h.n == 0) add(h.sine ? 4 : 1, 1);
    if (h.n == 1) {
      add(h.sine ? 2 : 0, 1);
      add(h.sine ? 3 : 5, h.sine ? -1 : 1); // a quarter turn takes z into -x
    }
  }
  return unknowns;
}

CyclicModel::Terms CyclicModel::by_axis(const std::vector<AxisUnknown>& axis, int node, int dof,
                                        double factor) const {
  Terms terms;
  for (std::size_t k = 0; k < axis.size(); ++k)
    if (axis[k].node == node && axis[k].direction[dof] != 0)
      terms.emplace_back(6 * rings_ + int(k), factor * axis[k].direction[dof]);
  return terms;
}

// A ring follows the axis (rigid cap) or is held; what the harmonic does not have is nothing.
std::optional<CyclicModel::Terms> CyclicModel::ring_follows(const HarmonicSystem& s, int ring,
                                                            int c) const {
  const Harmonic& h = s.harmonic;
  if (!active(h, c)) return Terms{};
  const int step = h.n == 0 ? 0 : 1; // where no weight of a pair or of n = 0 vanishes
  const auto B = cyclic_components(step, around_);
  const double w = weight(h, c, step);
  std::optional<Terms> own;
  // The rows tie whole directions: checked when built.
  for (int row : rows_of_[model_->mesh.rings[ring].nodes[step]]) {
    const Constraint& constraint = model_->constraints[row];
    if (B(constraint.dof, c) == 0) continue;
    if (!own) own.emplace();
    for (const ConstraintTerm& t : constraint.terms)
      for (const auto& term : by_axis(s.axis, t.node, t.dof, B(constraint.dof, c) * t.factor / w))
        own->push_back(term);
  }
  return own;
}

// An axis node follows rings (distributing coupling) or other axis nodes.
std::optional<CyclicModel::Terms> CyclicModel::axis_follows(const HarmonicSystem& s,
                                                            const AxisUnknown& unknown) const {
  const Harmonic& h = s.harmonic;
  std::optional<Terms> own;
  for (int row : rows_of_[unknown.node]) {
    const Constraint& constraint = model_->constraints[row];
    const double share = unknown.direction[constraint.dof];
    if (share == 0) continue;
    if (!own) own.emplace();
    for (const ConstraintTerm& t : constraint.terms) {
      const NodePlace& place = place_[t.node];
      if (place.ring < 0) {
        for (const auto& term : by_axis(s.axis, t.node, t.dof, share * t.factor))
          own->push_back(term);
        continue;
      }
      const auto B = cyclic_components(place.step, around_);
      for (int c = 0; c < 6; ++c)
        if (B(t.dof, c) != 0 && active(h, c))
          own->emplace_back(6 * place.ring + c,
                            share * t.factor * B(t.dof, c) * weight(h, c, place.step));
    }
  }
  return own;
}

// Every coordinate by the independent ones.
void CyclicModel::follow(HarmonicSystem& s) const {
  const int count = 6 * rings_ + static_cast<int>(s.axis.size());
  std::vector<std::optional<Terms>> terms; // of dependent coordinates
  terms.reserve(count);
  for (int ring = 0; ring < rings_; ++ring)
    for (int c = 0; c < 6; ++c) terms.push_back(ring_follows(s, ring, c));
  for (const AxisUnknown& unknown : s.axis) terms.push_back(axis_follows(s, unknown));
  std::vector<int> number(count, -1);
  int independent = 0;
  for (int c = 0; c < count; ++c)
    if (!terms[c]) {
      number[c] = independent++;
      s.coordinate.push_back(c);
    }
  for (std::size_t k = 0; k < s.axis.size(); ++k) s.axis[k].number = number[6 * rings_ + k];
  std::vector<Triplet> entries;
  // Chains end: the full model was eliminated without a loop.
  const std::function<void(int, int, double)> resolve = [&](int coordinate, int at, double factor) {
    if (!terms[at]) {
      entries.emplace_back(coordinate, number[at], factor);
      return;
    }
    for (const auto& [next, f] : *terms[at]) resolve(coordinate, next, factor * f);
  };
  for (int c = 0; c < count; ++c) resolve(c, c, 1);
  s.T.resize(count, independent);
  s.T.setFromTriplets(entries.begin(), entries.end());
}

HarmonicSystem CyclicModel::system(const Harmonic& h) const {
  HarmonicSystem s{
      .harmonic = h, .K = {}, .M = {}, .T = {}, .coordinate = {}, .axis = axis_unknowns(h)};
  follow(s);
  Collector collector(s.T);
  const double count = sectors(h.n, around_);
  for (const Belt& belt : sector_) {
    const int left = *std::min_element(belt.ring.begin(), belt.ring.end());
    MatrixXd K = MatrixXd::Zero(12, 12), M = K;
    for (int p = 0; p < 4; ++p)
      for (int q = 0; q < 4; ++q)
        for (int a = 0; a < 6; ++a)
          for (int b = 0; b < 6; ++b) {
            const double f = count * sector_factor(h.n, around_, a, b, belt.side[q] - belt.side[p]);
            const int i = 6 * (belt.ring[p] - left) + a, j = 6 * (belt.ring[q] - left) + b;
            K(i, j) += f * belt.K(6 * p + a, 6 * q + b);
            M(i, j) += f * belt.M(6 * p + a, 6 * q + b);
          }
    std::vector<int> coordinates(12);
    for (int i = 0; i < 12; ++i) coordinates[i] = 6 * left + i;
    collector.add(coordinates, K, M);
  }
  add_axis_elements(*model_, s.axis, 6 * rings_, collector);
  collector.write(s.K, s.M);
  return s;
}

HarmonicSystem CyclicModel::quarter_turned(HarmonicSystem s) const {
  const std::vector<AxisUnknown> cosine = s.axis;
  s.harmonic.sine = true;
  s.axis = axis_unknowns(s.harmonic);
  for (std::size_t k = 0; k < s.axis.size(); ++k) s.axis[k].number = cosine[k].number;
  return s;
}

Eigen::Matrix<double, 6, 6> CyclicModel::components(const Harmonic& h, int step) const {
  Eigen::Matrix<double, 6, 6> B = cyclic_components(step, around_);
  for (int c = 0; c < 6; ++c) B.col(c) *= weight(h, c, step);
  return B;
}

MatrixXd CyclicModel::expand(const HarmonicSystem& s, const MatrixXd& q) const {
  MatrixXd u = MatrixXd::Zero(dof_count(*model_), q.cols());
  add_expanded(s, q, u);
  return u;
}

void CyclicModel::add_expanded(const HarmonicSystem& s, const MatrixXd& q, MatrixXd& u) const {
  const MatrixXd all = s.T * q;
  for (int step = 0; step < around_; ++step) {
    const Eigen::Matrix<double, 6, 6> B = components(s.harmonic, step);
    for (int ring = 0; ring < rings_; ++ring)
      u.middleRows<6>(6 * model_->mesh.rings[ring].nodes[step]) +=
          B * all.middleRows<6>(6 * Eigen::Index(ring));
  }
  for (std::size_t k = 0; k < s.axis.size(); ++k)
    u.middleRows<6>(6 * s.axis[k].node) += s.axis[k].direction * all.row(6 * rings_ + k);
}

MatrixXd CyclicModel::expand(const HarmonicSystem& s, const MatrixXd& q,
                             const std::vector<int>& nodes) const {
  const MatrixXd all = s.T * q;
  MatrixXd u = MatrixXd::Zero(6 * Eigen::Index(nodes.size()), q.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const NodePlace& place = place_[nodes[i]];
    auto own = u.middleRows<6>(6 * Eigen::Index(i));
    if (place.ring >= 0)
      own = components(s.harmonic, place.step) * all.middleRows<6>(6 * Eigen::Index(place.ring));
    for (std::size_t k = 0; k < s.axis.size(); ++k)
      if (s.axis[k].node == nodes[i])
        own += s.axis[k].direction * all.row(6 * rings_ + Eigen::Index(k));
  }
  return u;
}

MatrixXd CyclicModel::gather(const HarmonicSystem& s, const MatrixXd& force) const {
  MatrixXd all = MatrixXd::Zero(s.T.rows(), force.cols());
  std::vector<Eigen::Matrix<double, 6, 6>> onto; // transposed, of every step
  for (int step = 0; step < around_; ++step)
    onto.emplace_back(components(s.harmonic, step).transpose());
  for (Eigen::Index k = 0; k < force.cols(); ++k) {
    const auto own = force.col(k);
    for (int ring = 0; ring < rings_; ++ring)
      for (int step = 0; step < around_; ++step) {
        const Vector6 f = own.segment<6>(6 * model_->mesh.rings[ring].nodes[step]);
        if (!f.isZero(0)) // forces of joints act on few nodes
          all.col(k).segment<6>(6 * Eigen::Index(ring)) += onto[std::size_t(step)] * f;
      }
  }
  for (std::size_t k = 0; k < s.axis.size(); ++k)
    all.row(6 * rings_ + k) +=
        s.axis[k].direction.transpose() * force.middleRows<6>(6 * s.axis[k].node);
  return s.T.transpose() * all;
}

MatrixXd CyclicModel::rigid_motions(const HarmonicSystem& s) const {
  MatrixXd all = MatrixXd::Zero(s.T.rows(), 6);
  const Harmonic& h = s.harmonic;
  // Translation along or rotation about x belongs to n = 1; x and z apart by family.
  std::array<bool, 6> held{};
  if (h.n == 0) held[h.sine ? 4 : 1] = true;
  if (h.n == 1) held[h.sine ? 2 : 0] = held[h.sine ? 3 : 5] = true;
  const auto motion = [](int m, const Eigen::Vector3d& x) {
    Vector6 u = Vector6::Unit(m);
    if (m >= 3) u.head<3>() = Eigen::Vector3d::Unit(m - 3).cross(x);
    return u;
  };
  const int step = h.n == 0 ? 0 : 1;
  for (int m = 0; m < 6; ++m) {
    if (!held[m]) continue;
    for (int ring = 0; ring < rings_; ++ring) {
      const Vector6 u = motion(m, model_->mesh.nodes[model_->mesh.rings[ring].nodes[step]]);
      const Vector6 own = cyclic_components(step, around_).transpose() * u;
      for (int c = 0; c < 6; ++c)
        if (active(h, c)) all(6 * ring + c, m) = own[c] / weight(h, c, step);
    }
    for (std::size_t k = 0; k < s.axis.size(); ++k)
      all(6 * rings_ + Eigen::Index(k), m) =
          s.axis[k].direction.dot(motion(m, model_->mesh.nodes[s.axis[k].node]));
  }
  return all(s.coordinate, Eigen::all);
}

} // namespace plica
