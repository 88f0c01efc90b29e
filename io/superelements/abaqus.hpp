// A superelement for Abaqus (and programs that read its *MATRIX INPUT): two matrix files and a
// deck.
//
// A line of a matrix file is "row node, row DOF, column node, column DOF, value", lower triangle.
// Modal coordinates are nodes of their own with DOF 1. Damping, where there is some, beside K
// and M.
#pragma once

#include "io/superelements/labels.hpp"

namespace plica {

std::string abaqus_deck(const Superelement& s, const ElementLabels& labels = {});
std::string abaqus_matrix_file(char letter); // "superelement_k.inp"
std::string abaqus_matrix(const Superelement& s, const Eigen::MatrixXd& A,
                          const ElementLabels& labels = {});

// Recovered points as nodes that follow the coordinates by *EQUATION: motion inside the part where
// any other node has its motion.
std::string abaqus_recovery(const Superelement& s, const ElementLabels& labels = {});

// The same as one linear user element U1 over all boundary nodes and modal points: upper triangles,
// column by column, four numbers a line. For Abaqus/Standard, where a user element may be used in
// any step that its matrices are enough for.
std::string abaqus_user_element(const Superelement& s, const ElementLabels& labels = {});

} // namespace plica
