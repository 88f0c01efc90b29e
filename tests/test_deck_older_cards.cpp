// Cards of older and of less usual Nastran decks: the same structure in other words has the same
// frequencies.
#include "io/decks/deck_average.hpp"
#include "io/decks/read_deck.hpp"
#include "io/files/files.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

Eigen::VectorXd older_hertz(const std::string& text, int count = 6) {
  const TemporaryFolder folder("older");
  write_whole(folder.path / "a.bdf", text);
  return find_modes(place(*read_deck(folder.path / "a.bdf", UnknownCards::error), {}), count).hertz;
}

std::string older_refusal(const std::string& text) {
  return error_of([&] { older_hertz(text); });
}

// A plate of 6 x 4, clamped at x = 0, with elements and properties of the caller.
std::string older_plate(const std::string& element, const std::string& property, bool triangles) {
  const Mesh mesh = deck_plate();
  std::string text = "MAT1,1,2.+11,,.3,8000.\n" + property;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    text += fmt::format("GRID,{},,{:.6f},{:.6f},0.\n", i + 1, mesh.nodes[i].x(), mesh.nodes[i].y());
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    const auto& n = mesh.quads[e].nodes;
    if (triangles)
      text += fmt::format("{0},{1},1,{2},{3},{4}\n{0},{5},1,{2},{4},{6}\n", element, 2 * e + 1,
                          n[0] + 1, n[1] + 1, n[2] + 1, 2 * e + 2, n[3] + 1);
    else
      text += fmt::format("{},{},1,{},{},{},{}\n", element, e + 1, n[0] + 1, n[1] + 1, n[2] + 1,
                          n[3] + 1);
  }
  for (int node : mesh.sets.at("edge4")) text += fmt::format("SPC1,1,123456,{}\n", node + 1);
  return text;
}

void expect_alike(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  ASSERT_EQ(a.size(), b.size());
  for (Eigen::Index i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i] / b[i], 1, 1e-9) << i;
}

TEST(OlderCards, walls_of_PQUAD1_and_PTRIA1_are_those_of_PSHELL) {
  const double inertia = 2 * std::pow(2e-3, 3) / 12; // twice the solid wall
  for (const bool triangles : {false, true}) {
    const char *own = triangles ? "CTRIA3" : "CQUAD4", *older = triangles ? "CTRIA1" : "CQUAD1";
    const char* property = triangles ? "PTRIA1" : "PQUAD1";
    expect_alike(older_hertz(older_plate(
                     older, fmt::format("{},1,1,.002,1,{:.16g},1,.0015\n,3.\n", property, inertia),
                     triangles)),
                 older_hertz(older_plate(own, "PSHELL,1,1,.002,1,2.,1,.75\n,3.\n", triangles)));
    expect_alike( // rigid in shear
        older_hertz(older_plate(older, fmt::format("{},1,1,.002,1,{:.16g}\n", property, inertia),
                                triangles)),
        older_hertz(older_plate(own, "PSHELL,1,1,.002,1,2.\n", triangles)));
  }
  EXPECT_NE(older_refusal(older_plate("CQUAD1", "PQUAD1,1\n", false)).find("neither MID1 and T1"),
            std::string::npos);
}

const std::string older_bar = "MAT1,1,2.+11,,.3,8000.\nPBARL,1,1,,ROD\n,.01\nSPC1,1,123456,1\n"
                              "GRID,1,,0.,0.,0.\nGRID,2,,.2,0.,0.\nGRID,3,,.4,0.,0.\n"
                              "GRID,4,,.4,.1,0.\nGRID,5,,.4,.1,.1\n"
                              "CBAR,1,1,1,2,0.,1.,0.\nCBAR,2,1,2,3,0.,1.,0.\n"
                              "CONM2,90,4,,.2\nCONM2,91,5,,.3\n";

TEST(OlderCards, CRIGD2_ties_what_RBE2_ties) {
  expect_alike(older_hertz(older_bar + "CRIGD2,7,3,4,123456,5,123\nSPC1,1,456,5\n"),
               older_hertz(older_bar + "RBE2,7,3,123456,4\nRBE2,8,3,123,5\nSPC1,1,456,5\n"));
  EXPECT_NE(older_refusal(older_bar + "CRIGD2,7,3,4\n").find("ties nothing of point 4"),
            std::string::npos);
}

TEST(OlderCards, CBUSH1D_is_a_spring_along_its_line_or_its_axis) {
  const std::string held = "SPC1,1,123456,4,5\n";
  expect_alike(older_hertz(older_bar + held + "CBUSH1D,7,70,3,4\nPBUSH1D,70,5.+4,3.\n"),
               older_hertz(older_bar + held + "CELAS2,7,5.+4,3,2,4,2\n"));
  expect_alike(older_hertz(older_bar + held + "CBUSH1D,7,70,3,,0\nPBUSH1D,70,5.+4\n" +
                           "CBUSH1D,8,70,2,,0\n"),
               older_hertz(older_bar + held + "CELAS2,7,5.+4,3,1\nCELAS2,8,5.+4,2,1\n"));
}

// The mean of three points that lead a fourth, and solved for components of two of the three: the
// same relation between their motions.
TEST(OlderCards, RBE3_with_UM_is_the_same_relation) {
  const std::string frame = "MAT1,1,2.+11,,.3,8000.\nPBARL,1,1,,ROD\n,.01\n"
                            "GRID,1,,0.,0.,0.\nGRID,2,,.3,0.,0.\nGRID,3,,0.,.3,.05\n"
                            "GRID,4,,.3,.3,0.\nGRID,9,,.1,.15,.1\nGRID,21,,0.,0.,.4\n"
                            "GRID,22,,.3,0.,.5\nGRID,23,,0.,.3,.45\nGRID,24,,.3,.3,.4\n"
                            "GRID,29,,.1,.15,.5\n"
                            "CBAR,1,1,1,21,1.,0.,0.\nCBAR,2,1,2,22,1.,0.,0.\n"
                            "CBAR,3,1,3,23,1.,0.,0.\nCBAR,4,1,4,24,1.,0.,0.\n"
                            "CBAR,5,1,9,29,1.,0.,0.\nCONM2,90,9,,2.,.01,.02\n,.02,,.03,,,.04\n"
                            "SPC1,1,123456,21,22,23,24,29\n";
  const std::string mean = "RBE3,7,,9,123456,1.,123,1,2\n,3,4";
  const Eigen::VectorXd plain = older_hertz(frame + mean + "\n");
  for (const char* um : {"\n,UM,1,123,2,23\n,3,3\n", "\n,UM,9,123,1,12\n,2,3\n"})
    expect_alike(older_hertz(frame + mean + um), plain);
  EXPECT_NE(older_refusal(frame + mean + "\n,UM,1,123\n").find("UM names 3 components, not the 6"),
            std::string::npos);
  EXPECT_NE(older_refusal(frame + mean + "\n,UM,1,123456\n").find("do not follow"),
            std::string::npos);
}

// Moments of inertia that no body has, beside the node: a matrix of mass all the same.
TEST(OlderCards, CONM2_of_no_body_is_a_matrix_of_mass) {
  const std::string bar = older_bar + "SPC1,1,123456,4,5\n";
  const double k = 3e4, m = 2, arm = 0.1, J = 0.5; // a spring in y, a rotation about x alone
  const std::string alone = "GRID,31,,0.,0.,0.\nSPC1,1,12356,31\nCELAS2,95,3.+4,31,4\n"
                            "CONM2,96,31,,2.,,.1\n,.5\n";
  const Eigen::VectorXd hertz = older_hertz(bar + alone, 8);
  const double expected = std::sqrt(k / (J + m * arm * arm)) / (2 * std::numbers::pi);
  EXPECT_LT((hertz.array() / expected - 1).abs().minCoeff(), 1e-9) << hertz.transpose();
}

} // namespace
} // namespace plica::test
