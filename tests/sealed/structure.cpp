#include "structure.hpp"

#include <algorithm>
#include <numbers>

namespace sealed {
namespace {

std::vector<int> without(const std::vector<int>& held, Eigen::Index count) {
  std::vector<int> free;
  for (int i = 0; i < count; ++i)
    if (std::find(held.begin(), held.end(), i) == held.end()) free.push_back(i);
  return free;
}

Matrix3d cross(const Vector3d& c) {
  Matrix3d m;
  m << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  return m;
}

} // namespace

int add_unknowns(Structure& s, int count) {
  const auto first = s.K.rows(), n = first + count;
  for (MatrixXd* m : {&s.K, &s.M}) {
    m->conservativeResize(n, n);
    m->bottomRows(count).setZero();
    m->rightCols(count).setZero();
  }
  s.R.conservativeResize(n, 6);
  s.R.bottomRows(count).setZero();
  for (auto& [name, rows] : s.places) {
    rows.conservativeResize(Eigen::NoChange, n);
    rows.rightCols(count).setZero();
  }
  for (NonlinearSpring& spring : s.nonlinear) {
    spring.row.conservativeResize(n);
    spring.row.tail(count).setZero();
  }
  if (s.rubber.size() > 0) {
    s.rubber.conservativeResize(n, n);
    s.rubber.bottomRows(count).setZero();
    s.rubber.rightCols(count).setZero();
  }
  return int(first);
}

void add_mass(Structure& s, const MatrixXd& rows, double mass, const Vector3d& inertia,
              const Vector3d& offset) {
  if (rows.rows() == 3) {
    s.M += mass * rows.transpose() * rows;
    return;
  }
  MatrixXd body = MatrixXd::Zero(6, 6);
  const Matrix3d c = cross(offset);
  body.topLeftCorner(3, 3) = mass * Matrix3d::Identity();
  body.topRightCorner(3, 3) = -mass * c;
  body.bottomLeftCorner(3, 3) = mass * c;
  body.bottomRightCorner(3, 3) = Matrix3d(inertia.asDiagonal()) - mass * c * c;
  s.M += rows.transpose() * body * rows;
}

void add_springs(Structure& s, const MatrixXd& rows, const VectorXd& stiffness) {
  s.K += rows.transpose() * stiffness.asDiagonal() * rows;
}

void add_oscillator(Structure& s, const MatrixXd& rows, double mass, double frequency) {
  const int own = add_unknowns(s, 3);
  MatrixXd stretch = MatrixXd::Zero(3, s.K.cols());
  stretch.leftCols(rows.cols()) = -rows;
  stretch.middleCols(own, 3).setIdentity();
  const double k = mass * std::pow(2 * std::numbers::pi * frequency, 2);
  add_springs(s, stretch, VectorXd::Constant(3, k));
  s.M.diagonal().segment(own, 3).array() += mass;
  s.R.middleRows(own, 3) = rows * s.R.topRows(rows.cols());
}

void add_beam(Structure& s, const MatrixXd& a, const MatrixXd& b, double length, double EA,
              double EI, double GJ) {
  const MatrixXd d = b - a, mean = (a.bottomRows(3) + b.bottomRows(3)) / 2;
  MatrixXd strain(6, a.cols()); // stretch, two shears of the chord, twist, two curvatures
  strain.row(0) = d.row(1);
  strain.row(1) = d.row(0) + length * mean.row(2); // x: slope -rz
  strain.row(2) = d.row(2) - length * mean.row(0);
  strain.row(3) = d.row(4);
  strain.row(4) = d.row(3);
  strain.row(5) = d.row(5);
  const double shear = 12 * EI / std::pow(length, 3);
  VectorXd k(6);
  k << EA / length, shear, shear, GJ / length, EI / length, EI / length;
  add_springs(s, strain, k);
}

void stand_on_springs(Structure& s, const std::string& place, double translation, double rotation) {
  const MatrixXd& rows = s.places.at(place);
  std::erase_if(s.held, [&](int i) { return rows.col(i).cwiseAbs().maxCoeff() > 0; });
  VectorXd k(6);
  k << VectorXd::Constant(3, translation), VectorXd::Constant(3, rotation);
  add_springs(s, rows, k);
}

Modes modes_of(const Structure& s) {
  const std::vector<int> free = without(s.held, s.K.rows());
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(s.K(free, free), s.M(free, free));
  Modes modes;
  modes.w = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
  modes.phi = MatrixXd::Zero(s.K.rows(), modes.w.size());
  modes.phi(free, Eigen::all) = eigen.eigenvectors();
  return modes;
}

} // namespace sealed
