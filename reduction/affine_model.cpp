#include "reduction/affine_model.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A + sum_k c_k dA_k over the changes that are not empty.
MatrixXd summed(const MatrixXd& A, const std::vector<MatrixXd>& dA, const VectorXd& coefficients) {
  MatrixXd sum = A;
  for (std::size_t k = 0; k < dA.size(); ++k)
    if (dA[k].size() > 0 && coefficients[Index(k)] != 0) sum += coefficients[Index(k)] * dA[k];
  return sum;
}

// What is zero everywhere becomes empty.
MatrixXd restricted(const MatrixXd& A, const std::vector<int>& coordinates) {
  return A.isZero(0) ? MatrixXd() : MatrixXd(A(coordinates, coordinates));
}

// Gives rows, or columns, for so many coordinates more; what is empty stays so.
void append_rows(MatrixXd& A, Index more) {
  A.conservativeResize(A.rows() + more, Eigen::NoChange);
  A.bottomRows(more).setZero();
}
void append_columns(MatrixXd& A, Index more) {
  A.conservativeResize(Eigen::NoChange, A.cols() + more);
  A.rightCols(more).setZero();
}
void append_both(MatrixXd& A, Index more) {
  if (A.size() == 0) return;
  append_rows(A, more);
  append_columns(A, more);
}

// x x' of the spring is among the squares; its other end is the mass, M = 1 over its coordinate.
void tie_resonators(const std::vector<MotionSum>& sums, const VectorXd& c, MatrixXd& K) {
  for (const MotionSum& sum : sums) {
    const double omega = sum.frequency(c);
    if (omega <= 0) continue;
    const VectorXd force = omega * sum.over_q(c);
    K.col(sum.coordinate) -= force;
    K.row(sum.coordinate) -= force.transpose();
    K(sum.coordinate, sum.coordinate) = omega * omega;
  }
}

void add_squares(const std::vector<MotionSum>& sums, MotionTerm::Of of, const VectorXd& c,
                 MatrixXd& A) {
  for (const MotionSum& sum : sums) {
    if (sum.of != of) continue;
    const VectorXd x = sum.over_q(c);
    A.noalias() += x * x.transpose();
  }
}

} // namespace

VectorXd with_products(VectorXd coefficients, const std::vector<std::array<int, 2>>& products) {
  const Index own = coefficients.size();
  coefficients.conservativeResize(own + Index(products.size()));
  for (std::size_t k = 0; k < products.size(); ++k)
    coefficients[own + Index(k)] = coefficients[products[k][0]] * coefficients[products[k][1]];
  return coefficients;
}

VectorXd MotionSum::coefficients_of(const VectorXd& all) const {
  return all.segment(first, rows.rows());
}

VectorXd MotionSum::over_q(const VectorXd& all) const {
  const VectorXd own = coefficients_of(all);
  VectorXd x = VectorXd::Zero(rows.cols());
  for (Index i = 0; i < own.size(); ++i) // most of them are zero: a place lies among few nodes
    if (own[i] != 0) x += own[i] * rows.row(i).transpose();
  return x;
}

double MotionSum::frequency(const VectorXd& all) const {
  return of == MotionTerm::Of::resonator ? all[first + rows.rows() - 1] : 0;
}

MatrixXd AffineModel::stiffness(const VectorXd& c) const {
  MatrixXd all = summed(K, dK, with_products(c, products));
  add_squares(sums, MotionTerm::Of::spring, c, all);
  add_squares(sums, MotionTerm::Of::resonator, c, all);
  tie_resonators(sums, c, all);
  return all;
}

MatrixXd AffineModel::mass_matrix(const VectorXd& c) const {
  MatrixXd all = summed(M, dM, with_products(c, products));
  add_squares(sums, MotionTerm::Of::mass, c, all);
  return all;
}

MatrixXd AffineModel::loads(const VectorXd& c) const {
  MatrixXd all = summed(load, d_load, with_products(c, products));
  for (const MotionSum& sum : sums) {
    const Eigen::RowVectorXd rigid = sum.coefficients_of(c).transpose() * sum.rigid;
    if (sum.of == MotionTerm::Of::mass) all.noalias() += sum.over_q(c) * rigid;
    if (const double omega = sum.frequency(c); omega > 0) all.row(sum.coordinate) += rigid / omega;
  }
  return all;
}

double AffineModel::weight(const VectorXd& of_changes) const {
  const VectorXd c = with_products(of_changes, products);
  double sum = mass;
  for (std::size_t k = 0; k < d_mass.size(); ++k) sum += c[Index(k)] * d_mass[k];
  for (const MotionSum& own : sums) {
    const double moved = own.coefficients_of(of_changes).dot(own.rigid.col(weighed_along));
    if (own.of == MotionTerm::Of::mass) sum += moved * moved;
    if (const double omega = own.frequency(of_changes); omega > 0)
      sum += std::pow(moved / omega, 2);
  }
  return sum;
}

MatrixXd AffineModel::stiffness_of(int group, const VectorXd& c) const {
  MatrixXd own = dK[std::size_t(group)];
  if (own.size() == 0) own = MatrixXd::Zero(K.rows(), K.cols());
  for (std::size_t k = 0; k < products.size(); ++k) {
    const auto& [a, b] = products[k];
    const MatrixXd& together = dK[std::size_t(c.size()) + k];
    if (together.size() == 0) continue;
    if (a == group) own += c[b] * together;
    if (b == group) own += c[a] * together;
  }
  return own;
}

AffineModel AffineModel::restricted_to(const std::vector<int>& coordinates) const {
  AffineModel own;
  own.K = K(coordinates, coordinates);
  own.M = M(coordinates, coordinates);
  for (const MatrixXd& d : dK) own.dK.push_back(restricted(d, coordinates));
  for (const MatrixXd& d : dM) own.dM.push_back(restricted(d, coordinates));
  own.products = products;
  own.load = load(coordinates, Eigen::all);
  for (const MatrixXd& d : d_load)
    own.d_load.push_back(d.size() == 0 ? d : MatrixXd(d(coordinates, Eigen::all)));
  own.mass = mass;
  own.d_mass = d_mass;
  own.weighed_along = weighed_along;
  for (const MotionSum& sum : sums) {
    own.sums.push_back(sum);
    own.sums.back().rows = sum.rows(Eigen::all, coordinates);
    if (sum.of == MotionTerm::Of::resonator)
      own.sums.back().coordinate =
          std::find(coordinates.begin(), coordinates.end(), sum.coordinate) - coordinates.begin();
  }
  own.marked = marked(Eigen::all, coordinates);
  own.lambda = lambda;
  own.nominal = nominal(coordinates, Eigen::all);
  for (int i : coordinates) own.boundary += i < boundary;
  own.suspension = suspension;
  own.suspension.rigid = suspension.rigid(coordinates, Eigen::all);
  return own;
}

void AffineModel::hang_resonators() {
  const Index before = K.rows();
  Index more = 0;
  for (MotionSum& sum : sums)
    if (sum.of == MotionTerm::Of::resonator) sum.coordinate = before + more++;
  if (more == 0) return;
  for (MatrixXd* A : {&K, &M}) append_both(*A, more);
  for (auto* changes : {&dK, &dM})
    for (MatrixXd& A : *changes) append_both(A, more);
  for (MatrixXd& A : d_load)
    if (A.size() > 0) append_rows(A, more);
  for (MatrixXd* A : {&load, &nominal, &suspension.rigid}) append_rows(*A, more);
  append_columns(marked, more);
  for (MotionSum& sum : sums) append_columns(sum.rows, more);
  constexpr double far_above = 1e4;
  const double idle = far_above * lambda.maxCoeff();
  K.bottomRightCorner(more, more).diagonal().setConstant(idle);
  M.bottomRightCorner(more, more).setIdentity();
}

} // namespace plica
