// RBE3 of any components: the mean of points in closed form, and in a deck the rigid bar it can be.
#include "io/decks/deck_average.hpp"
#include "io/decks/read_deck.hpp"
#include "io/files/files.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Geometry>

#include <numbers>
#include <stdexcept>

namespace plica::test {
namespace deck_average {
namespace {

const std::vector<int> six{0, 1, 2, 3, 4, 5};

double factor(const Constraint& row, int node, int dof) {
  double sum = 0;
  for (const ConstraintTerm& t : row.terms)
    if (t.node == node && t.dof == dof) sum += t.factor;
  return sum;
}

// Two points at -a and a along x: rz = (uy2 - uy1) / 4a + (rz1 + rz2) / 4 with the mean arm a; the
// same where the second point has axes of its own, x along y.
TEST(DeckAverage, rotations_are_weighed_by_the_square_of_the_mean_arm) {
  DeckModel deck;
  deck.nodes = {{0, 0, 0}, {-2, 0, 0}, {2, 0, 0}};
  for (const bool turned : {false, true}) {
    if (turned)
      deck.axes[2] =
          Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const std::vector<Constraint> rows =
        average_rows(deck, 0, {1, 5}, {{1, 1, six}, {2, 1, six}}, "");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_NEAR(factor(rows[0], 1, 1), 0.5, 1e-12);
    EXPECT_NEAR(factor(rows[0], 2, turned ? 0 : 1), 0.5, 1e-12);
    EXPECT_NEAR(factor(rows[1], 1, 1), -1. / 8, 1e-12);
    EXPECT_NEAR(factor(rows[1], 2, turned ? 0 : 1), 1. / 8, 1e-12);
    EXPECT_NEAR(factor(rows[1], 1, 5), 0.25, 1e-12);
    EXPECT_NEAR(factor(rows[1], 2, 5), 0.25, 1e-12);
  }
}

TEST(DeckAverage, points_that_do_not_determine_the_motion_are_refused) {
  DeckModel deck;
  deck.nodes = {{0, 0, 0}, {-2, 0, 0}, {2, 0, 0}};
  EXPECT_THROW(average_rows(deck, 0, six, {{1, 1, {0, 1, 2}}, {2, 1, {0, 1, 2}}}, ""),
               std::invalid_argument)
      << "translations on a line leave the turn about it";
}

DeckModel bar_with_body(const std::string& tie) {
  std::string text;
  for (int i = 0; i <= 4; ++i) text += fmt::format("GRID,{},,{}.,0.,0.\n", i + 1, i);
  for (int i = 1; i <= 4; ++i) text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  text += "GRID,9,,4.3,.2,-.1\nCONM2,90,9,,.4\n,1.-2,,1.-2,,,2.-2\nPBAR,1,1,1.-3,1.-7,3.-7,2.-7\n"
          "MAT1,1,2.+11,,0.3,8000.\nSPC1,1,123456,1\n" +
          tie;
  const TemporaryFolder folder("deck_average");
  write_whole(folder.path / "bar.bdf", text);
  return *read_deck(folder.path / "bar.bdf", UnknownCards::error);
}

TEST(DeckAverage, of_one_point_with_its_rotations_is_a_rigid_bar) {
  const Eigen::VectorXd bar = find_modes(place(bar_with_body("RBE2,91,5,123456,9\n"), {}), 6).hertz;
  const Eigen::VectorXd mean =
      find_modes(place(bar_with_body("RBE3,91,,9,123456,1.,123456,5\n"), {}), 6).hertz;
  for (Eigen::Index i = 0; i < 6; ++i) EXPECT_NEAR(mean[i] / bar[i], 1, deck_agreement) << i;
}

} // namespace
} // namespace deck_average
} // namespace plica::test
