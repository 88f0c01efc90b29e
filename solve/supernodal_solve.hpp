// Solves with a factor A = P' L S L' P that is stored by supernodes.
#pragma once

#include "solve/supernodes.hpp"

namespace plica {

// Adds what the subtrees have summed apart to the rows of the trunk; `width` numbers a row.
void add_sums(const Supernodes& nodes, int width, double* rows);

// A^-1 b. `numbers`: L, supernode by supernode, each by columns with its height as stride; `sign`:
// S. The cores share the subtrees; the result is the same on any number of threads.
Eigen::MatrixXd solve_by_supernodes(const Supernodes& nodes, const double* numbers,
                                    const Eigen::VectorXd& sign, const Eigen::MatrixXd& b);

} // namespace plica
