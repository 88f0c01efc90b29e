#include "engine/ranks.hpp"

#include "app/terminal.hpp"

#include <array>
#include <cstdlib>
#include <numeric>
#include <unistd.h>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<int> starts(const std::vector<int>& counts) {
  std::vector<int> start(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, start.begin() + 1);
  return start;
}

} // namespace

void end_all(const std::string& why, int exit_code) {
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  if (rank > 0) sleep(2); // where the first has the same to say, it has said it
  say_failure("plica-mpi: " + (size > 1 ? "rank " + std::to_string(rank) + ": " : "") + why +
              "; all ranks end, no file was written");
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::abort();
}

Ranks::Ranks(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm, &rank_);
  MPI_Comm_size(comm, &size_);
}

MatrixXd Ranks::sum(MatrixXd own) const {
  MPI_Allreduce(MPI_IN_PLACE, own.data(), int(own.size()), MPI_DOUBLE, MPI_SUM, comm_);
  return own;
}

double Ranks::sum(double own) const {
  MPI_Allreduce(MPI_IN_PLACE, &own, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return own;
}

long long Ranks::sum(long long own) const {
  MPI_Allreduce(MPI_IN_PLACE, &own, 1, MPI_LONG_LONG, MPI_SUM, comm_);
  return own;
}

double Ranks::largest(double own) const {
  MPI_Allreduce(MPI_IN_PLACE, &own, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return own;
}

MatrixXd Ranks::broadcast(MatrixXd first) const {
  std::array<long long, 2> size{first.rows(), first.cols()};
  MPI_Bcast(size.data(), 2, MPI_LONG_LONG, 0, comm_);
  first.resize(size[0], size[1]);
  for (Index c = 0; c < first.cols(); ++c)
    MPI_Bcast(first.col(c).data(), int(first.rows()), MPI_DOUBLE, 0, comm_);
  return first;
}

std::vector<int> Ranks::broadcast(std::vector<int> first) const {
  int size = int(first.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, comm_);
  first.resize(std::size_t(size));
  MPI_Bcast(first.data(), size, MPI_INT, 0, comm_);
  return first;
}

std::string Ranks::broadcast(std::string first) const {
  int size = int(first.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, comm_);
  first.resize(std::size_t(size));
  MPI_Bcast(first.data(), size, MPI_CHAR, 0, comm_);
  return first;
}

std::vector<int> Ranks::row_counts(Index own) const {
  const int rows = int(own);
  std::vector<int> counts(std::size_t(size_), 0);
  MPI_Allgather(&rows, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
  return counts;
}

MatrixXd Ranks::gather_rows(const MatrixXd& own) const {
  const std::vector<int> counts = row_counts(own.rows()), start = starts(counts);
  MatrixXd all(first() ? start.back() + counts.back() : 0, own.cols());
  for (Index c = 0; c < own.cols(); ++c)
    MPI_Gatherv(own.col(c).data(), int(own.rows()), MPI_DOUBLE,
                first() ? all.col(c).data() : nullptr, counts.data(), start.data(), MPI_DOUBLE, 0,
                comm_);
  return all;
}

MatrixXd Ranks::scatter_rows(const MatrixXd& all, Index rows) const {
  const std::vector<int> counts = row_counts(rows), start = starts(counts);
  int columns = int(all.cols());
  MPI_Bcast(&columns, 1, MPI_INT, 0, comm_);
  MatrixXd own(rows, columns);
  for (Index c = 0; c < columns; ++c)
    MPI_Scatterv(first() ? all.col(c).data() : nullptr, counts.data(), start.data(), MPI_DOUBLE,
                 own.col(c).data(), int(rows), MPI_DOUBLE, 0, comm_);
  return own;
}

std::vector<std::string> Ranks::everyones(const std::string& own) const {
  const std::vector<int> counts = row_counts(Index(own.size())), start = starts(counts);
  std::string all(std::size_t(start.back() + counts.back()), ' ');
  MPI_Allgatherv(own.data(), int(own.size()), MPI_CHAR, all.data(), counts.data(), start.data(),
                 MPI_CHAR, comm_);
  std::vector<std::string> texts;
  for (std::size_t r = 0; r < counts.size(); ++r)
    texts.push_back(all.substr(std::size_t(start[r]), std::size_t(counts[r])));
  return texts;
}

} // namespace plica
