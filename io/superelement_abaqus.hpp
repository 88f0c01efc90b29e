// A superelement for Abaqus (and programs that read its *MATRIX INPUT): two matrix files and a
// deck.
//
// A line of a matrix file is "row node, row DOF, column node, column DOF, value", lower triangle.
// Modal coordinates are nodes of their own with DOF 1. Units: SI.
#pragma once

#include "reduction/superelement.hpp"

#include <filesystem>

namespace plica {

std::string abaqus_deck(const Superelement& s, const std::string& stiffness_file,
                        const std::string& mass_file);
std::string abaqus_matrix(const Superelement& s, const Eigen::MatrixXd& A);

// A matrix file back, size known from the superelement it belongs to. Throws std::runtime_error
// with file and line.
Eigen::MatrixXd read_abaqus_matrix(const Superelement& s, const std::filesystem::path& path);

// Matrix Market (coordinate, real, symmetric) of the same matrices, for anything else.
std::string matrix_market(const Eigen::MatrixXd& A, const std::string& comment);
Eigen::MatrixXd read_matrix_market(const std::filesystem::path& path);

} // namespace plica
