// The ranks of a run and what they say to each other, over MPI.
//
// Vectors over unknowns are distributed by rows: every rank holds the rows of its own unknowns,
// rank after rank. Sums come out the same on every rank.
#pragma once

#include <Eigen/Core>
#include <mpi.h>
#include <string>
#include <vector>

namespace plica {

// Trouble of one rank, or of a library, that the others need not see: says it once and ends all
// ranks. Nothing is unwound, for what would be destroyed may wait for the others.
[[noreturn]] void end_all(const std::string& why, int exit_code = 3);

class Ranks {
public:
  explicit Ranks(MPI_Comm comm);

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  Eigen::MatrixXd sum(Eigen::MatrixXd own) const;
  double sum(double own) const;
  long long sum(long long own) const;
  double largest(double own) const;

  // What the first rank holds, to all: sizes too.
  Eigen::MatrixXd broadcast(Eigen::MatrixXd first) const;
  std::vector<int> broadcast(std::vector<int> first) const;
  std::string broadcast(std::string first) const;

  // Rows of all ranks one after another, on the first; 0 rows on the others.
  Eigen::MatrixXd gather_rows(const Eigen::MatrixXd& own) const;
  // The reverse: each rank gets so many of the rows that the first holds.
  Eigen::MatrixXd scatter_rows(const Eigen::MatrixXd& all, Eigen::Index own) const;

  // The text of every rank, on every rank.
  std::vector<std::string> everyones(const std::string& own) const;

private:
  std::vector<int> row_counts(Eigen::Index own) const;

  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};

} // namespace plica
