// The response of a structure without its modes, to prove the modal sum.
#pragma once

#include "solve/assembly.hpp"

namespace plica::test {

// From one factorisation per frequency of K (1 + i eta) - omega^2 M, by UMFPACK (CHOLMOD takes no
// complex symmetric matrix): free DOFs x frequencies. omega in rad/s. Throws std::runtime_error
// when a factorisation fails.
Eigen::MatrixXcd direct_response(const SparseMatrix& K, const SparseMatrix& M, double eta,
                                 const Eigen::VectorXd& force, const Eigen::VectorXd& omega);

} // namespace plica::test
