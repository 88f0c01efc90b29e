#include "line_model.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace sealed {
namespace {

constexpr int order = 3, per_element = order + 1;
constexpr std::array gauss_points{-0.9061798459386640, -0.5384693101056831, 0., 0.5384693101056831,
                                  0.9061798459386640};
constexpr std::array gauss_weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                   0.4786286704993665, 0.2369268850561891};

struct Shape {
  Eigen::Vector4d value, slope;
};

// Lagrange's polynomials on nodes at -1, -1/3, 1/3, 1.
Shape shape_at(double x) {
  constexpr std::array nodes{-1., -1. / 3, 1. / 3, 1.};
  Shape shape{Eigen::Vector4d::Ones(), Eigen::Vector4d::Zero()};
  for (int i = 0; i < per_element; ++i) {
    for (int k = 0; k < per_element; ++k)
      if (k != i) shape.value[i] *= (x - nodes[k]) / (nodes[i] - nodes[k]);
    for (int left = 0; left < per_element; ++left) {
      if (left == i) continue;
      double product = 1 / (nodes[i] - nodes[left]);
      for (int k = 0; k < per_element; ++k)
        if (k != i && k != left) product *= (x - nodes[k]) / (nodes[i] - nodes[k]);
      shape.slope[i] += product;
    }
  }
  return shape;
}

} // namespace

void LineModel::add_stretch(double from, double to, int elements, const SectionAt& section,
                            bool joined) {
  if (s_.empty() || !joined) s_.push_back(from);
  const int first = int(s_.size()) - 1;
  const double length = (to - from) / elements;
  for (int i = 1; i <= order * elements; ++i) s_.push_back(from + i * length / order);
  const auto unknowns = Eigen::Index(2 * s_.size());
  K_.conservativeResizeLike(Eigen::MatrixXd::Zero(unknowns, unknowns));
  M_.conservativeResizeLike(Eigen::MatrixXd::Zero(unknowns, unknowns));
  for (int e = 0; e < elements; ++e)
    for (std::size_t g = 0; g < gauss_points.size(); ++g) {
      const Shape shape = shape_at(gauss_points[g]);
      const LineSection at = section(from + (e + (gauss_points[g] + 1) / 2) * length);
      const double weight = gauss_weights[g] * length / 2;
      Eigen::Matrix<double, 1, 2 * per_element> curvature, shear, deflection, rotation;
      for (int i = 0; i < per_element; ++i) {
        const double value = shape.value[i], slope = shape.slope[i] * 2 / length;
        curvature.segment<2>(2 * i) << 0, slope;
        shear.segment<2>(2 * i) << slope, -value;
        deflection.segment<2>(2 * i) << value, 0;
        rotation.segment<2>(2 * i) << 0, value;
      }
      const int at_unknown = 2 * (first + order * e);
      K_.block<8, 8>(at_unknown, at_unknown) +=
          weight * (at.EI * curvature.transpose() * curvature + at.GA * shear.transpose() * shear);
      M_.block<8, 8>(at_unknown, at_unknown) +=
          weight * (at.mass * deflection.transpose() * deflection +
                    at.inertia * rotation.transpose() * rotation);
    }
}

int LineModel::node(double s, bool earlier) const {
  int best = 0;
  for (int i = 1; i < int(s_.size()); ++i) {
    const double own = std::abs(s_[std::size_t(i)] - s),
                 other = std::abs(s_[std::size_t(best)] - s);
    if (earlier ? own < other - 1e-9 : own < other + 1e-9) best = i;
  }
  return best;
}

void LineModel::add_mass(int node, double mass, double inertia) {
  M_(2 * node, 2 * node) += mass;
  M_(2 * node + 1, 2 * node + 1) += inertia;
}

void LineModel::add_springs(int node, double translation, double rotation) {
  K_(2 * node, 2 * node) += translation;
  K_(2 * node + 1, 2 * node + 1) += rotation;
}

void LineModel::add_joint(int a, int b, double translation, double rotation) {
  for (int way = 0; way < 2; ++way) {
    const double k = way == 0 ? translation : rotation;
    const int i = 2 * a + way, j = 2 * b + way;
    K_(i, i) += k;
    K_(j, j) += k;
    K_(i, j) -= k;
    K_(j, i) -= k;
  }
}

void LineModel::fix(int node, bool deflection, bool rotation) {
  if (deflection) fixed_.push_back(2 * node);
  if (rotation) fixed_.push_back(2 * node + 1);
}

Eigen::VectorXd LineModel::weights_at(double s) const {
  int before = -1, after = -1;
  for (int i = 0; i < int(s_.size()); ++i) {
    const double own = s_[std::size_t(i)];
    if (own <= s && (before < 0 || own > s_[std::size_t(before)])) before = i;
    if (own >= s && (after < 0 || own < s_[std::size_t(after)])) after = i;
  }
  if (before < 0) before = after;
  if (after < 0) after = before;
  const double a = s_[std::size_t(before)], b = s_[std::size_t(after)];
  const double share = b > a ? (s - a) / (b - a) : 0;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(K_.rows());
  weights[2 * before] += 1 - share;
  weights[2 * after] += share;
  return weights;
}

FoundModes LineModel::modes(int count, const std::vector<double>& seen_at) const {
  std::vector<int> free;
  for (int i = 0; i < int(K_.rows()); ++i)
    if (std::find(fixed_.begin(), fixed_.end(), i) == fixed_.end()) free.push_back(i);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K_(free, free),
                                                                        M_(free, free));
  constexpr double turn = 2 * std::numbers::pi;
  FoundModes found{.frequencies = eigen.eigenvalues().head(count).cwiseMax(0).cwiseSqrt() / turn};
  for (int k = 0; k < count; ++k) {
    Eigen::VectorXd shape(seen_at.size());
    for (std::size_t i = 0; i < seen_at.size(); ++i)
      shape[Eigen::Index(i)] = weights_at(seen_at[i])(free).dot(eigen.eigenvectors().col(k));
    found.shapes.push_back(shape);
  }
  return found;
}

} // namespace sealed
