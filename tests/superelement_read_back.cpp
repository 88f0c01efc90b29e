#include "tests/superelement_read_back.hpp"

#include "io/files/files.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <sstream>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

void put(MatrixXd& A, int i, int j, double x) {
  A(i, j) += x;
  if (i != j) A(j, i) += x;
}

} // namespace

std::string cut(const std::string& line, std::size_t at, std::size_t width) {
  return line.size() > at ? line.substr(at, width) : "";
}

double real(std::string text) {
  std::erase(text, ' ');
  if (const auto d = text.find('D'); d != std::string::npos) text[d] = 'e';
  const auto sign = text.find_first_of("+-", 1);
  if (sign != std::string::npos && text.find_first_of("eE") == std::string::npos)
    text.insert(sign, "e");
  return std::stod(text);
}

ReadBack nastran(const std::string& text) {
  ReadBack r;
  std::vector<int> scalars;
  std::istringstream lines(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '$') all.push_back(line);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].starts_with("GRID*"))
      r.nodes[std::stoi(cut(all[k], 8, 16))] = {
          real(cut(all[k], 40, 16)), real(cut(all[k], 56, 16)), real(cut(all[k + 1], 8, 16))};
    if (all[k].starts_with("SPOINT")) scalars.push_back(std::stoi(cut(all[k], 8, 8)));
  }
  for (const auto& [node, x] : r.nodes)
    for (int d = 1; d <= 6; ++d) r.number.emplace(Label{node, d}, int(r.number.size()));
  for (const int s : scalars) r.number.emplace(Label{s, 0}, int(r.number.size()));
  r.K = r.M = MatrixXd::Zero(long(r.number.size()), long(r.number.size()));
  MatrixXd* A = nullptr;
  int column = 0;
  for (const std::string& line : all) {
    if (line.starts_with("DMIG*")) {
      A = cut(line, 8, 1) == "K" ? &r.K : cut(line, 8, 1) == "M" ? &r.M : nullptr;
      if (cut(line, 8, 2) == "K4") A = nullptr;
      column = r.number.at({std::stoi(cut(line, 24, 16)), std::stoi(cut(line, 40, 16))});
    } else if (line.starts_with("*") && A) {
      put(*A, r.number.at({std::stoi(cut(line, 8, 16)), std::stoi(cut(line, 24, 16))}), column,
          real(cut(line, 40, 16)));
    } else {
      A = nullptr;
    }
  }
  return r;
}

MatrixXd rectangular_dmig(const std::string& text, const ReadBack& points) {
  MatrixXd A;
  int column = -1;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("$")) continue;
    if (line.starts_with("DMIG*")) {
      column = std::stoi(cut(line, 24, 16)) - 1;
    } else if (line.starts_with("DMIG")) {
      const int columns = std::stoi(cut(line, 64, 8));
      EXPECT_EQ(std::stoi(cut(line, 16, 8)), 0);
      EXPECT_EQ(std::stoi(cut(line, 24, 8)), 9); // rectangular
      EXPECT_EQ(std::stoi(cut(line, 32, 8)), 2); // double precision, exponents D
      if (A.size() == 0) A = MatrixXd::Zero(long(points.number.size()), columns);
      EXPECT_EQ(A.cols(), columns);
    } else {
      EXPECT_NE(line.find('D'), std::string::npos) << line;
      const Label row{std::stoi(cut(line, 8, 16)), std::stoi(cut(line, 24, 16))};
      A(points.number.at(row), column) += real(cut(line, 40, 16));
    }
  }
  return A;
}

std::vector<double> numbers(std::string line) {
  for (char& c : line)
    if (c == ',') c = ' ';
  std::istringstream fields(line);
  std::vector<double> list;
  for (double x = 0; fields >> x;) list.push_back(x);
  return list;
}

ReadBack abaqus(const std::filesystem::path& folder, const std::string& deck) {
  ReadBack r;
  std::istringstream lines(deck);
  bool boundary = false, modal = false;
  std::vector<int> modes;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("**")) continue;
    if (line.starts_with("*")) {
      boundary = line.find("_BOUNDARY") != std::string::npos && line.starts_with("*NODE");
      modal = line.find("_MODAL") != std::string::npos;
      continue;
    }
    const std::vector<double> x = numbers(line);
    if (boundary) r.nodes[int(x.at(0))] = {x.at(1), x.at(2), x.at(3)};
    if (modal) modes.push_back(int(x.at(0)));
  }
  for (const auto& [node, x] : r.nodes)
    for (int d = 1; d <= 6; ++d) r.number.emplace(Label{node, d}, int(r.number.size()));
  for (const int m : modes) r.number.emplace(Label{m, 1}, int(r.number.size()));
  r.K = r.M = MatrixXd::Zero(long(r.number.size()), long(r.number.size()));
  for (const auto& [name, A] :
       {std::pair{"superelement_k.inp", &r.K}, {"superelement_m.inp", &r.M}}) {
    std::istringstream file(read_whole(folder / name));
    for (std::string line; std::getline(file, line);) {
      const std::vector<double> x = numbers(line);
      put(*A, r.number.at({int(x.at(0)), int(x.at(1))}), r.number.at({int(x.at(2)), int(x.at(3))}),
          x.at(4));
    }
  }
  return r;
}

MatrixXd motions_of_nodes(const ReadBack& r) {
  MatrixXd R = MatrixXd::Zero(long(r.number.size()), 6);
  int at = 0;
  for (const auto& [node, x] : r.nodes) {
    for (int m = 0; m < 6; ++m) {
      R(at + m, m) = 1;
      if (m >= 3) R.block<3, 1>(at, m) = Vector3d(Vector3d::Unit(m - 3)).cross(x);
    }
    at += 6;
  }
  return R;
}

Checked cbcheck(const ReadBack& r) {
  const MatrixXd R = motions_of_nodes(r);
  Checked c;
  const Eigen::VectorXd size = r.K.diagonal().cwiseSqrt().cwiseMax(1e-300);
  c.rigid = (size.cwiseInverse().asDiagonal() * MatrixXd(r.K * R)).cwiseAbs().maxCoeff() /
            size.maxCoeff();
  const MatrixXd m = R.transpose() * r.M * R;
  c.mass = m(0, 0);
  c.centre = Vector3d(m(1, 5) - m(2, 4), m(2, 3) - m(0, 5), m(0, 4) - m(1, 3)) / (2 * c.mass);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(r.K, r.M, Eigen::EigenvaluesOnly);
  c.first_hertz = std::sqrt(modes.eigenvalues()[6]) / (2 * std::numbers::pi);
  const Vector3d along =
      (std::next(r.nodes.begin())->second - r.nodes.begin()->second).normalized();
  c.axial = along.dot(r.K.block<3, 3>(6, 6) * along);
  return c;
}

} // namespace plica::test
