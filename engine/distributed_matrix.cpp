#include "engine/distributed_matrix.hpp"

#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// The compressed rows of a part of a matrix that lies on one rank.
class Rows {
public:
  explicit Rows(Mat mat) : mat_(mat) {
    PetscBool done = PETSC_FALSE;
    petsc(MatGetRowIJ(mat_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &start, &column, &done));
    petsc(MatSeqAIJGetArrayRead(mat_, &value));
    if (!done) end_all("the rows of a matrix cannot be read");
  }
  ~Rows() {
    PetscBool done = PETSC_FALSE;
    MatSeqAIJRestoreArrayRead(mat_, &value);
    MatRestoreRowIJ(mat_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &start, &column, &done);
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  PetscInt rows = 0;
  const PetscInt *start = nullptr, *column = nullptr;
  const PetscScalar* value = nullptr;

private:
  Mat mat_;
};

} // namespace

DistributedMatrix::DistributedMatrix(const CompressedRows& own, int size, const Ranks& ranks) {
  const int rows = int(own.start.size()) - 1;
  petsc(MatCreate(ranks.comm(), mat_.fill()));
  petsc(MatSetSizes(mat_, rows, rows, size, size));
  petsc(MatSetType(mat_, MATMPIAIJ));
  petsc(MatMPIAIJSetPreallocationCSR(mat_, own.start.data(), own.column.data(), own.value.data()));
  prepare();
}

DistributedMatrix::DistributedMatrix(Mat mat) : mat_(mat) {
  prepare();
}

void DistributedMatrix::prepare() {
  petsc(MatSetOption(mat_, MAT_SYMMETRIC, PETSC_TRUE));
  petsc(MatSetOption(mat_, MAT_SYMMETRY_ETERNAL, PETSC_TRUE));
  petsc(MatGetOwnershipRange(mat_, &first_, &end_));
  Mat own = nullptr, others = nullptr;
  const PetscInt* columns = nullptr;
  petsc(MatMPIAIJGetSeqAIJ(mat_, &own, &others, &columns));
  PetscInt rows = 0, met = 0;
  petsc(MatGetSize(others, &rows, &met));
  OwnedIS places;
  petsc(ISCreateGeneral(PETSC_COMM_SELF, met, columns, PETSC_COPY_VALUES, places.fill()));
  petsc(MatCreateVecs(mat_, from_.fill(), nullptr));
  petsc(VecCreateSeq(PETSC_COMM_SELF, met, ghosts_.fill()));
  petsc(VecScatterCreate(from_, places, ghosts_, nullptr, scatter_.fill()));
}

DistributedMatrix DistributedMatrix::part(const std::vector<int>& own, const Ranks& ranks) const {
  OwnedIS rows;
  petsc(ISCreateGeneral(ranks.comm(), PetscInt(own.size()), own.data(), PETSC_COPY_VALUES,
                        rows.fill()));
  Mat part = nullptr;
  petsc(MatCreateSubMatrix(mat_, rows, rows, MAT_INITIAL_MATRIX, &part));
  return DistributedMatrix(part);
}

int DistributedMatrix::size() const {
  PetscInt rows = 0;
  petsc(MatGetSize(mat_, &rows, nullptr));
  return rows;
}

double DistributedMatrix::entries(const Ranks& ranks) const {
  MatInfo info;
  petsc(MatGetInfo(mat_, MAT_LOCAL, &info));
  return ranks.sum(double(info.nz_used));
}

Eigen::VectorXd DistributedMatrix::diagonal() const {
  OwnedVec d;
  petsc(MatCreateVecs(mat_, d.fill(), nullptr));
  petsc(MatGetDiagonal(mat_, d));
  const PetscScalar* values = nullptr;
  petsc(VecGetArrayRead(d, &values));
  const Eigen::VectorXd own = Eigen::Map<const Eigen::VectorXd>(values, own_rows());
  petsc(VecRestoreArrayRead(d, &values));
  return own;
}

template <class Sum, bool absolute_values>
MatrixXd DistributedMatrix::product(const MatrixXd& x) const {
  Mat own = nullptr, others = nullptr;
  petsc(MatMPIAIJGetSeqAIJ(mat_, &own, &others, nullptr));
  const Rows inside(own), outside(others);
  MatrixXd y(x.rows(), x.cols());
  const auto term = [](double a, double b) {
    return absolute_values ? Sum(std::abs(a)) * std::abs(b) : Sum(a) * b;
  };
  for (Index c = 0; c < x.cols(); ++c) {
    PetscScalar* to = nullptr;
    petsc(VecGetArray(from_, &to));
    std::copy(x.col(c).begin(), x.col(c).end(), to);
    petsc(VecRestoreArray(from_, &to));
    petsc(VecScatterBegin(scatter_, from_, ghosts_, INSERT_VALUES, SCATTER_FORWARD));
    petsc(VecScatterEnd(scatter_, from_, ghosts_, INSERT_VALUES, SCATTER_FORWARD));
    const PetscScalar* met = nullptr;
    petsc(VecGetArrayRead(ghosts_, &met));
    for (PetscInt i = 0; i < inside.rows; ++i) {
      Sum sum = 0;
      for (PetscInt k = inside.start[i]; k < inside.start[i + 1]; ++k)
        sum += term(inside.value[k], x(inside.column[k], c));
      for (PetscInt k = outside.start[i]; k < outside.start[i + 1]; ++k)
        sum += term(outside.value[k], met[outside.column[k]]);
      y(i, c) = double(sum);
    }
    petsc(VecRestoreArrayRead(ghosts_, &met));
  }
  return y;
}

MatrixXd DistributedMatrix::operator*(const MatrixXd& x) const {
  return product<double, false>(x);
}

MatrixXd DistributedMatrix::absolute(const MatrixXd& x) const {
  return product<double, true>(x);
}

MatrixXd DistributedMatrix::exactly(const MatrixXd& x) const {
  return product<long double, false>(x);
}

DistributedMatrix DistributedMatrix::minus(double sigma, const DistributedMatrix& B) const {
  Mat copy = nullptr;
  petsc(MatDuplicate(mat_, MAT_COPY_VALUES, &copy));
  DistributedMatrix result(copy);
  if (sigma != 0) petsc(MatAXPY(copy, -sigma, B.mat_, SAME_NONZERO_PATTERN));
  return result;
}

} // namespace plica
