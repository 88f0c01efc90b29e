// Matrices of a file that OUTPUT4 of Nastran writes: text or binary (either byte order, words of
// four or eight bytes), dense or sparse, real, in single or double precision. It names neither
// nodes nor components; what uses it has to know the order of the rows. Source: the description of
// OUTPUT4 and INPUTT4 in the DMAP manual of Nastran.
#pragma once

#include "io/decks/deck_error.hpp"

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <set>

namespace plica {

// Those of the file that are wanted, by their names in capitals; what is not there is left out.
// Throws InputError: no such file, one that is cut or holds what no matrix has, a wanted matrix
// that is complex or has more than 2000 rows or columns.
std::map<std::string, Eigen::MatrixXd> read_op4_file(const std::filesystem::path& file,
                                                     const std::set<std::string>& wanted);

} // namespace plica
