// Readers of what superelements are written as, for the tests alone: by the published formats,
// without the code that writes them. All throw std::runtime_error with the file and, where it has
// lines, the line.
#pragma once

#include "io/superelements/labels.hpp"

#include <filesystem>
#include <map>

namespace plica {

// std::runtime_error "file:line: what".
[[noreturn]] void bad_line(const std::filesystem::path& path, int line, const std::string& what);

// Everything of Plica's own file; checks format, version and every size.
Superelement read_hdf5(const std::filesystem::path& path);

// The matrices of a deck of DMIG, in the order of its GRIDs, then SPOINTs; nodes with their places.
Superelement read_nastran_deck(const std::filesystem::path& path);

// Matrices of a dense OUTPUT4 text file by name.
std::map<std::string, Eigen::MatrixXd> read_op4(const std::filesystem::path& path);

// A file of *MATRIX INPUT, and K and M of a linear user element; the sizes are those of `s`.
Eigen::MatrixXd read_abaqus_matrix(const Superelement& s, const std::filesystem::path& path,
                                   const ElementLabels& labels = {});
std::pair<Eigen::MatrixXd, Eigen::MatrixXd>
read_abaqus_user_element(const Superelement& s, const std::filesystem::path& path);

// Coordinate, real, symmetric.
Eigen::MatrixXd read_matrix_market(const std::filesystem::path& path);

} // namespace plica
