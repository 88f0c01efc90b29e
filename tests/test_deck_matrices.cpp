// Superelements of other codes as parts: DMIG, *MATRIX INPUT; replicated cards and includes of the
// executive control.
#include "io/decks/read_deck.hpp"
#include "io/files/files.hpp"
#include "io/superelements/abaqus.hpp"
#include "io/superelements/nastran_dmig.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Geometry>

#include <numbers>

namespace plica::test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// Two nodes and a mode, numbers of any size.
Superelement any_element() {
  Superelement s;
  s.name = "any";
  s.node_names = {"left", "right"};
  s.nodes = {{0, 0, 0}, {0.3, 0.1, 0}};
  std::srand(7);
  const MatrixXd A = MatrixXd::Random(13, 13), B = MatrixXd::Random(13, 13);
  Eigen::VectorXd size(13);
  for (int i = 0; i < 13; ++i) size[i] = std::pow(10., i / 3 % 5); // alike along the three axes
  s.K = size.asDiagonal() * (A * A.transpose()) * size.asDiagonal();
  s.M = 1e-6 * (size.asDiagonal() * (B * B.transpose()) * size.asDiagonal()).eval();
  return s;
}

MatrixXd block_turn(const Matrix3d& R) {
  MatrixXd T = MatrixXd::Identity(13, 13);
  for (int i = 0; i < 12; i += 3) T.block<3, 3>(i, i) = R;
  return T;
}

// Of all matrices of a model with two nodes and a scalar one.
MatrixXd summed(const Model& model, MatrixXd MatrixElement::*which) {
  MatrixXd all = MatrixXd::Zero(18, 18);
  for (const MatrixElement& e : model.matrices)
    for (std::size_t a = 0; a < e.nodes.size(); ++a)
      for (std::size_t b = 0; b < e.nodes.size(); ++b)
        all.block<6, 6>(6 * e.nodes[a], 6 * e.nodes[b]) +=
            (e.*which).block<6, 6>(Eigen::Index(6 * a), Eigen::Index(6 * b));
  EXPECT_EQ(all.bottomRows<5>().norm(), 0);
  return all.topLeftCorner<13, 13>();
}

void expect_back_as(const DeckModel& deck, const MatrixXd& T, const Superelement& s) {
  const Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3d(1, 1, 2).normalized()).toRotationMatrix();
  for (const Matrix3d& R : {Matrix3d(Matrix3d::Identity()), turn}) {
    const Model model = place(deck, {.turn = R});
    ASSERT_EQ(model.mesh.nodes.size(), 3U);
    const MatrixXd all = block_turn(R) * T;
    for (const auto& [own, theirs] : {std::pair{summed(model, &MatrixElement::K), s.K},
                                      std::pair{summed(model, &MatrixElement::M), s.M}}) {
      const MatrixXd back = all.transpose() * own * all;
      const Eigen::VectorXd scale = theirs.diagonal().cwiseSqrt().cwiseInverse();
      EXPECT_LT((scale.asDiagonal() * (back - theirs) * scale.asDiagonal()).cwiseAbs().maxCoeff(),
                1e-10);
    }
  }
}

TEST(DeckMatrices, what_is_exported_comes_back) {
  const Superelement s = any_element();
  const TemporaryFolder folder("matrices");
  ElementLabels placed;
  placed.system = 12;
  placed.axes = Eigen::AngleAxisd(0.3, Vector3d::UnitX()).toRotationMatrix();
  for (const ElementLabels& labels : {ElementLabels{}, placed}) {
    const std::string name = labels.system == 0 ? "plain" : "placed";
    const MatrixXd T = block_turn(labels.axes);
    write_whole(folder.path / (name + "_part.bdf"), nastran_deck(s, labels));
    write_whole(folder.path / (name + ".bdf"),
                "CEND\nK2GG = KPLICA, KPLICAL\nM2GG = 1.0*MPLICA, MPLICAL\nBEGIN BULK\nINCLUDE '" +
                    name + "_part.bdf'\nENDDATA\n");
    write_whole(folder.path / abaqus_matrix_file('K'), abaqus_matrix(s, s.K, labels));
    write_whole(folder.path / abaqus_matrix_file('M'), abaqus_matrix(s, s.M, labels));
    write_whole(folder.path / (name + ".inp"), abaqus_deck(s, labels));
    for (const char* suffix : {".bdf", ".inp"})
      expect_back_as(*read_deck(folder.path / (name + suffix), UnknownCards::error), T, s);
  }
}

DeckModel matrix_deck(const std::string& name, const std::string& text) {
  const TemporaryFolder folder("matrices");
  write_whole(folder.path / name, text);
  return *read_deck(folder.path / name, UnknownCards::error);
}

// Masses of 2 and 1 on springs of 2000 and 1000 in a row: eigenvalues 500 and 2000.
TEST(DeckMatrices, chains_as_other_codes_write_them) {
  const std::string grids = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n";
  const std::vector<std::pair<const char*, std::string>> decks{
      {"a.bdf", // as a punch file of an external superelement
       "CEND\nK2GG=KAAX\nM2GG=MAAX\nBEGIN BULK\n" + grids +
           "DMIG    KAAX           0       6       2       0                       2\n"
           "DMIG*   KAAX                           1               1\n"
           "*                      1               1 3.000000000D+03\n"
           "DMIG*   KAAX                           2               1\n"
           "*                      1               1-1.000000000D+03\n"
           "*                      2               1 1.000000000D+03\n"
           "DMIG    MAAX           0       6       2       0                       2\n"
           "DMIG*   MAAX                           1               1\n"
           "*                      1               1 2.000000000D+00\n"
           "DMIG*   MAAX                           2               1\n"
           "*                      2               1 1.000000000D+00\n"},
      {"b.bdf", // square, two entries a line, a factor
       "CEND\nK2GG=10.*ST\nM2GG=MA\nBEGIN BULK\n" + grids +
           "DMIG,ST,0,1,1,1\nDMIG,ST,1,1,,1,1,300.\n,2,1,-100.\n"
           "DMIG,ST,2,1,,1,1,-100.,0.\n,2,1,100.\nDMIG,MA,0,6,1,1\nDMIG,MA,1,1,,1,1,2.\n"
           "DMIG,MA,2,1,,2,1,1.\n"},
      {"c.inp", "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n*MATRIX INPUT, NAME=K\n1, 1, 1, 1, 3000.\n"
                "1, 1, 2, 1, -1000.\n2, 1, 2, 1, 1000.\n*MATRIX INPUT, NAME=M, TYPE=UNSYMMETRIC\n"
                "1, 1, 1, 1, 2.\n2, 1, 2, 1, 1.\n*MATRIX ASSEMBLE, STIFFNESS=K, MASS=M\n"}};
  for (const auto& [name, text] : decks) {
    const Eigen::VectorXd hertz = find_modes(place(matrix_deck(name, text), {}), 2).hertz;
    ASSERT_EQ(hertz.size(), 2) << name;
    EXPECT_NEAR(hertz[0] * 2 * std::numbers::pi, std::sqrt(500.), 1e-8) << name;
    EXPECT_NEAR(hertz[1] * 2 * std::numbers::pi, std::sqrt(2000.), 1e-8) << name;
  }
}

TEST(DeckMatrices, what_is_no_such_matrix_is_refused) {
  const std::string head = "CEND\nK2GG=KX\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n";
  const std::vector<std::tuple<const char*, std::string, const char*>> all{
      {"a.bdf", head, "there is no matrix KX"},
      {"a.bdf", head + "DMIG,KX,1,1,,1,1,2.\n", "has no head before it"},
      {"a.bdf", head + "DMIG,KX,0,6,3,0\n", "is of form 6, type 3"},
      {"a.bdf", head + "DMIG,KX,0,1,2,0\nDMIG,KX,1,1,,2,1,2.\n", "is not symmetric"},
      {"a.bdf", head + "DMIG,KX,0,6,2,0\nDMIG,KX,1,1,,1,1,-2.\n", "below zero"},
      {"a.bdf", head + "DMIG,KX,0,6,2,0\nDMIG,KX,1,1,,9,1,-2.\n", "there is no grid point 9"},
      {"a.inp", "*NODE\n1, 0., 0., 0.\n*MATRIX ASSEMBLE, STIFFNESS=K\n", "there is no matrix K"},
      {"a.inp",
       "*NODE\n1, 0., 0., 0.\n*MATRIX INPUT, NAME=K, INPUT=no.mtx\n*MATRIX ASSEMBLE, "
       "STIFFNESS=K\n",
       "there is no file"},
      {"a.inp",
       "*NODE\n1, 0., 0., 0.\n*MATRIX INPUT, NAME=K\n1, 1, 1, 1, 2.\n1, 1, 1, 1, 2.\n"
       "*MATRIX ASSEMBLE, STIFFNESS=K\n",
       "has this entry twice"}};
  for (const auto& [name, text, message] : all) {
    try {
      matrix_deck(name, text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_NE(to_string(error.problems().at(0)).find(message), std::string::npos)
          << text << to_string(error.problems().at(0));
    }
  }
}

// Cards that replicate the one before, in both ways of writing them.
TEST(DeckMatrices, replicas_are_the_cards_spelt_out) {
  std::string spelt, rest = "MAT1,1,2.+11,,.3,8000.\nPBARL,1,1,,ROD\n,.01\nSPC1,1,123456,1\n";
  for (int i = 0; i < 11; ++i) spelt += fmt::format("GRID,{},,{:.1f},0.,0.\n", i + 1, 0.1 * i);
  for (int i = 0; i < 10; ++i)
    spelt += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i + 1, i + 1, i + 2);
  const std::string grid = "GRID,1,,0.,0.,0.\n", bar = "CBAR,1,1,1,2,0.,1.,0.\n";
  const Eigen::VectorXd hertz = find_modes(place(matrix_deck("a.bdf", spelt + rest), {}), 6).hertz;
  for (const std::string& text : {grid + "=,*1,,*.1,==\n=9\n" + bar + "=,*1,=,*1,*1,==\n=8\n",
                                  grid + "=(10),*(1),,*(.1),==\n" + bar +
                                      "=       *(1)    =       *(1)    *(1)    ==\n=(8)\n"}) {
    const Eigen::VectorXd theirs =
        find_modes(place(matrix_deck("a.bdf", text + rest), {}), 6).hertz;
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(theirs[i] / hertz[i], 1, 1e-9) << text;
  }
  EXPECT_THROW(matrix_deck("a.bdf", grid + "=9\n" + rest), InputError);
  EXPECT_THROW(matrix_deck("a.bdf", grid + "=(x),*1,==\n" + rest), InputError);
  const DeckModel altered =
      matrix_deck("a.bdf", "INCLUDE 'alter.v9'\nCEND\nSPC=1\nBEGIN BULK\n" + spelt + rest);
  ASSERT_EQ(altered.notes.size(), 1U);
  EXPECT_NE(altered.notes[0].find("executive control in line 1"), std::string::npos);
}

} // namespace
} // namespace plica::test
