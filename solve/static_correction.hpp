// A modal basis completed by residual vectors (Dickens, Nakagawa & Wittbrodt, Comput. Struct. 62
// (1997) 985-998).
//
// A truncated sum of modes misses the static part of those left out. For loads F, the static
// solutions X = K^-1 F are freed of the modes found,
//   R = X - Phi (Phi' M X),
// and turned into pseudo-modes by (R' K R) y = lambda (R' M R) y. Together they are M-orthonormal
// and K-orthogonal to the modes and to each other, so the response stays a sum of single terms, and
// its limit for omega -> 0 is K^-1 F to rounding. Vectors that the modes already hold are dropped.
#pragma once

#include "solve/assembly.hpp"

namespace plica {

struct ModalBasis {
  Eigen::VectorXd lambda; // (2 pi f)^2: the modes, then the pseudo-modes
  Eigen::MatrixXd Phi;    // columns, Phi' M Phi = I
  int modes = 0;          // how many columns are true modes
};

// X: static solutions, one column per load (none: the modes alone).
ModalBasis add_static_correction(const SparseMatrix& K, const SparseMatrix& M,
                                 const Eigen::VectorXd& lambda, const Eigen::MatrixXd& Phi,
                                 const Eigen::MatrixXd& X);

} // namespace plica
