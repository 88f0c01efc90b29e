// Matrix Market (coordinate, real, symmetric), for programs without a format of their own.
#pragma once

#include <Eigen/Core>

#include <string>

namespace plica {

// Of any shape.
std::string general_matrix_market(const Eigen::MatrixXd& A, const std::string& comment);

std::string matrix_market(const Eigen::MatrixXd& A, const std::string& comment);

} // namespace plica
