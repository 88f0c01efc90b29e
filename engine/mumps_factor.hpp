// A = L D L' of a distributed symmetric matrix by MUMPS (Amestoy, Duff, L'Excellent & Koster, SIAM
// J. Matrix Anal. Appl. 23 (2001) 15-41), through PETSc.
//
// An indefinite matrix is pivoted for size, so that the count of negative pivots is an inertia
// (Sylvester) also beside the spectrum; one that is taken for definite is not pivoted, and its
// pivots say whether it is. Every option that matters is set here, not left to a default, and what
// MUMPS really did is read back: asked for an ordering that it was built without, it takes another
// in silence. Where its workspace is too small (error -8 or -9) the factorisation is made again
// with more.
#pragma once

#include "engine/distributed_matrix.hpp"

#include <functional>
#include <memory>

namespace plica {

struct MumpsSettings {
  int workspace = 30; // ICNTL(14): percent beyond what the analysis foresees
  int megabytes = 0;  // ICNTL(23): most a rank may take; 0 = as foreseen
  int ordering = 7;   // ICNTL(7): 7 = the best that this MUMPS was built with
  int retries = 6;    // with more workspace
  // Told in words what was retried.
  std::function<void(const std::string&)> note = [](const std::string&) {};
};

struct MumpsReport {
  std::string ordering;     // that was really used: INFOG(7)
  double entries = 0;       // of the factor: INFOG(29)
  double flops = 0;         // RINFOG(3)
  double megabytes = 0;     // of the rank that needed most: INFOG(21)
  double megabytes_sum = 0; // of all ranks: INFOG(22)
  int workspace = 0, retries = 0;
  int delayed = 0; // pivots that waited for a better place: INFOG(13)
};

enum class Definiteness { definite, indefinite };

class MumpsFactor {
public:
  // Collective, as are all members. Analyses and factors A, which must outlive the factor.
  MumpsFactor(const DistributedMatrix& A, Definiteness kind, const Ranks& ranks,
              MumpsSettings settings);

  // Own rows of A^-1 b.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  void solve(Vec b, Vec x) const;

  int negative_pivots() const { return negative_; }
  int null_pivots() const { return null_; } // more than none: A is singular
  const MumpsReport& report() const { return report_; }

private:
  void set_options();
  void factorise(const DistributedMatrix& A);
  int info(int number) const; // INFOG

  const Ranks* ranks_;
  MumpsSettings settings_;
  MumpsReport report_;
  OwnedMat factor_;
  int negative_ = 0, null_ = 0, rows_ = 0;
};

// That an error (INFOG(1)) is mended by more workspace.
bool lacks_workspace(int infog1);

// What MUMPS' error says, in a sentence with what to do.
std::string mumps_error(int info1, int info2, int workspace);

} // namespace plica
