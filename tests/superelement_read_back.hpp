// Exports of a superelement as a program knows them that has read them, by small readers after the
// published formats, and the checks that cbcheck makes of them.
#pragma once

#include <Eigen/Dense>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace plica::test {

using Label = std::pair<int, int>; // point, DOF

// What a program knows after reading a deck.
struct ReadBack {
  std::map<int, Eigen::Vector3d> nodes;
  std::map<Label, int> number; // of each coordinate: nodes first, by number
  Eigen::MatrixXd K, M;
};

std::string cut(const std::string& line, std::size_t at, std::size_t width);
double real(std::string text);                 // with exponents of Nastran: 1.5D+03, 1.5+3
std::vector<double> numbers(std::string line); // between commas

// GRID*, SPOINT, DMIG* in columns of sixteen; matrices whose names begin alike are added.
ReadBack nastran(const std::string& text);

// Rectangular DMIG by the numbers of their columns, those of the file added; rows as in `points`.
Eigen::MatrixXd rectangular_dmig(const std::string& text, const ReadBack& points);

// *NODE and the files of *MATRIX INPUT: node, DOF, node, DOF, value.
ReadBack abaqus(const std::filesystem::path& folder, const std::string& deck);

// Motion of the nodes, the modal coordinates at rest, about the origin.
Eigen::MatrixXd motions_of_nodes(const ReadBack& r);

struct Checked {
  double rigid = 0, mass = 0, first_hertz = 0, axial = 0;
  Eigen::Vector3d centre{0, 0, 0};
};

// Rigid motions of the nodes about the origin; mass and centre by them; first elastic frequency;
// static stiffness of the second node along the line between both.
Checked cbcheck(const ReadBack& r);

} // namespace plica::test
