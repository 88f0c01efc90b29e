// Files of a superelement: each read back, and damaged ones refused.
#include "tests/reduced_bellows.hpp"
#include "tests/superelement_readers.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include "io/files/files.hpp"
#include "io/superelements/labels.hpp"
#include "io/superelements/matlab.hpp"
#include "io/write/write_superelement.hpp"
#include "words/input_error.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace plica::test {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;

void expect_same(const MatrixXd& a, const MatrixXd& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      EXPECT_LE(std::abs(a(i, j) - b(i, j)), tolerance * std::abs(b(i, j))) << i << ", " << j;
}

// Numbers that are rounding of their row and column are written as zero.
Superelement as_written(Superelement s) {
  const Eigen::VectorXd stiff = s.K.diagonal(), heavy = s.M.diagonal(), damped = s.C.diagonal();
  for (const auto& [A, size] : {std::pair{&s.K, &stiff}, std::pair{&s.M, &heavy},
                                std::pair{&s.C, &damped}, std::pair{&s.D, &stiff}})
    for (Eigen::Index i = 0; i < A->rows(); ++i)
      for (Eigen::Index j = 0; j < A->cols(); ++j)
        if (std::abs((*A)(i, j)) <=
            1e-14 * std::sqrt(std::abs((*size)[i])) * std::sqrt(std::abs((*size)[j])))
          (*A)(i, j) = 0;
  for (Eigen::Vector3d& x : s.nodes) x = (x.array().abs() < 1e-12).select(0, x);
  for (RecoveryRows& r : s.recovery)
    r.rows = (r.rows.array().abs() < 1e-14 * r.rows.cwiseAbs().maxCoeff()).select(0, r.rows);
  return s;
}

TEST(SuperelementFiles, come_back_as_they_were) {
  const TemporaryFolder folder("superelement");
  const ReducedCase r = reduced(sample_case());
  written(folder.path, [&](OutputFolder& out) { write_superelement(r, {}, out); });
  const Superelement s = as_written(r.element);
  const Superelement own = read_hdf5(folder.path / "superelement.h5");
  EXPECT_EQ(own.name, s.name);
  EXPECT_EQ(own.node_names, s.node_names);
  for (const auto& [a, b] : {std::pair{&own.K, &s.K}, std::pair{&own.M, &s.M},
                             std::pair{&own.C, &s.C}, std::pair{&own.D, &s.D}})
    expect_same(*a, *b, 0);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) EXPECT_EQ(own.nodes[k], s.nodes[k]);
  expect_same(own.recovery.at(0).rows, s.recovery[0].rows, 0);
  ASSERT_EQ(own.stresses.size(), s.stresses.size());
  expect_same(own.stresses.at(0).rows, s.stresses[0].rows, 0);
  ASSERT_EQ(own.loads.size(), 7u) << "six base motions and a force";
  for (std::size_t k = 0; k < s.loads.size(); ++k) {
    EXPECT_EQ(own.loads[k].name, s.loads[k].name);
    expect_same(own.loads[k].force, s.loads[k].force, 0);
  }
  const Superelement nastran = read_nastran_deck(folder.path / "superelement.bdf");
  expect_same(nastran.K, s.K, 1e-15);
  expect_same(nastran.M, s.M, 1e-15);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    EXPECT_LT((nastran.nodes[k] - s.nodes[k]).norm(), 1e-11);
  expect_same(nastran.C, s.C, 1e-15);
  expect_same(nastran.D, s.D, 1e-15);
  const auto op4 = read_op4(folder.path / "superelement.op4");
  ASSERT_EQ(op4.size(), 5u);
  expect_same(op4.at("OTMPLICA"), s.recovery[0].rows, 0);
  expect_same(op4.at("KPLICA"), s.K, 0);
  expect_same(op4.at("MPLICA"), s.M, 0);
  expect_same(op4.at("BPLICA"), s.C, 0);
  expect_same(op4.at("K4PLICA"), s.D, 0);
  const Superelement matlab = read_matlab(folder.path / "superelement.mat");
  EXPECT_EQ(matlab.node_names, s.node_names);
  EXPECT_EQ(matlab.units, s.units);
  for (const auto& [a, b] : {std::pair{&matlab.K, &s.K}, std::pair{&matlab.M, &s.M},
                             std::pair{&matlab.C, &s.C}, std::pair{&matlab.D, &s.D}})
    expect_same(*a, *b, 0);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) EXPECT_EQ(matlab.nodes[k], s.nodes[k]);
  const auto [user_k, user_m] = read_abaqus_user_element(s, folder.path / "superelement_user.inp");
  expect_same(user_k, s.K, 0);
  expect_same(user_m, s.M, 0);
  expect_same(read_abaqus_matrix(s, folder.path / "superelement_d.inp"), s.D, 0);
  expect_same(read_abaqus_matrix(s, folder.path / "superelement_k.inp"), s.K, 0);
  expect_same(read_abaqus_matrix(s, folder.path / "superelement_m.inp"), s.M, 0);
  expect_same(read_matrix_market(folder.path / "superelement_k.mtx"), s.K, 0);
  expect_same(read_matrix_market(folder.path / "superelement_m.mtx"), s.M, 0);
  const auto json = nlohmann::json::parse(read_whole(folder.path / "certificate.json"));
  EXPECT_EQ(json["passed"], true);
  const auto sidecar = nlohmann::json::parse(read_whole(folder.path / "superelement.json"));
  EXPECT_EQ(sidecar["coordinates"].size(), std::size_t(s.K.rows()));
  EXPECT_EQ(sidecar["coordinates"][7], "right.uy");
  for (const auto& entry : fs::directory_iterator(folder.path))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST(SuperelementFiles, damaged_are_refused_with_their_name_and_line) {
  const TemporaryFolder folder("superelement_damaged");
  const ReducedCase r = reduced(sample_case(), 500);
  written(folder.path, [&](OutputFolder& out) { write_superelement(r, {}, out); });
  const auto message = [](const auto& read) -> std::string {
    try {
      read();
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "no error";
  };
  const fs::path h5 = folder.path / "superelement.h5", deck = folder.path / "superelement.bdf",
                 matrix = folder.path / "superelement_k.inp";
  std::string bytes = read_whole(h5);
  write_whole(h5, bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("superelement.h5: "), std::string::npos);
  const std::size_t inside =
      bytes.find(std::string(reinterpret_cast<const char*>(&r.element.K(0, 0)), sizeof(double)));
  ASSERT_NE(inside, std::string::npos);
  std::string flipped = bytes;
  flipped[inside + 2] = char(flipped[inside + 2] ^ 1);
  write_whole(h5, flipped);
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("superelement.h5: "), std::string::npos);
  write_whole(h5, "no HDF5");
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("damaged, or no HDF5 file"), std::string::npos);
  std::string text = read_whole(deck);
  write_whole(deck, text.substr(0, text.find('\n', text.size() / 2) + 1));
  EXPECT_NE(message([&] { read_nastran_deck(deck); }).find("is cut off"), std::string::npos);
  text.replace(text.find("DMIG* "), 5, "DMGI*");
  write_whole(deck, text);
  EXPECT_NE(message([&] { read_nastran_deck(deck); }).find("unknown card"), std::string::npos);
  text = read_whole(matrix);
  write_whole(matrix, "101, 1, 101, x, 3\n" + text);
  EXPECT_NE(message([&] { read_abaqus_matrix(r.element, matrix); }).find("k.inp:1: "),
            std::string::npos);
  write_whole(matrix, text + "999, 1, 101, 1, 3\n");
  EXPECT_NE(message([&] { read_abaqus_matrix(r.element, matrix); }).find("has not"),
            std::string::npos);
  const fs::path op4 = folder.path / "superelement.op4", mat = folder.path / "superelement.mat",
                 user = folder.path / "superelement_user.inp";
  text = read_whole(op4);
  write_whole(op4, text.substr(0, text.size() / 3));
  EXPECT_NE(message([&] { read_op4(op4); }).find("superelement.op4:"), std::string::npos);
  text.replace(text.find("E+0"), 2, "Ex");
  write_whole(op4, text);
  EXPECT_NE(message([&] { read_op4(op4); }).find("is not a number"), std::string::npos);
  write_whole(mat, read_whole(mat).substr(0, 100));
  EXPECT_NE(message([&] { read_matlab(mat); }).find("superelement.mat: "), std::string::npos);
  text = read_whole(user);
  write_whole(user, text.substr(0, text.find("*MATRIX, TYPE=MASS")));
  EXPECT_NE(message([&] { read_abaqus_user_element(r.element, user); }).find("mass matrix"),
            std::string::npos);
  EXPECT_NE(message([&] { read_hdf5(folder.path / "absent.h5"); }).find("absent.h5"),
            std::string::npos);
  EXPECT_NE(message([&] {
              write_whole(folder.path / "superelement.h5" / "such", "x");
            }).find("cannot make the folder"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
