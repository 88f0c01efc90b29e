// Walls that are not isotropic: the elements of isotropic walls as a limit, frequencies of
// laminated plates in closed form, the same wall in the words of both codes.
#include "elements/shell_mitc3.hpp"
#include "elements/shell_mitc4.hpp"
#include "io/decks/nastran_cards.hpp"
#include "io/decks/nastran_laminate.hpp"
#include "io/decks/read_deck.hpp"
#include "tests/deck_text.hpp"
#include "tests/run_calculix.hpp"

#include <Eigen/Cholesky>

#include <map>
#include <numbers>
#include <sstream>

namespace plica::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

TEST(Laminate, an_isotropic_wall_is_that_of_the_shell_elements) {
  const ShellSection section{.E = 2e11, .nu = 0.3, .rho = 8000};
  const ShellLaminate wall = solid_wall(isotropic(2e11, 0.3, 2e11 / 2.6, 8000));
  ShellGeometry quad;
  quad.X << 0, 0.03, 0.035, -0.004, 0, 0.002, 0.03, 0.025, 0.001, 0.001, 0.001, 0.001;
  quad.directors.colwise() = Vector3d::UnitZ();
  quad.thickness << 1e-3, 1.1e-3, 1.2e-3, 1e-3;
  const Vector3d along(0.3, 0.8, 0);
  for (MembraneStrain m : {MembraneStrain::displacement, MembraneStrain::incompatible}) {
    const Matrix24 K = shell_mitc4_stiffness(quad, section, m);
    EXPECT_LT((shell_laminate_stiffness(quad, wall, along, m) - K).norm(), 1e-10 * K.norm());
  }
  TriangleGeometry triangle;
  triangle.X = quad.X.leftCols<3>();
  triangle.directors.colwise() = Vector3d::UnitZ();
  triangle.thickness << 1e-3, 1.1e-3, 1.2e-3;
  const Matrix18 K = shell_mitc3_stiffness(triangle, section);
  EXPECT_LT((shell_laminate_stiffness(triangle, wall, along) - K).norm(), 1e-10 * K.norm());
}

TEST(Laminate, plies_of_one_material_at_any_angle_have_five_sixths_of_its_shear) {
  const PlyMaterial m = isotropic(7e10, 0.3, 7e10 / 2.6, 2700);
  const ShellLaminate solid = solid_wall(m);
  const ShellLaminate plies = general_laminate({{m, 1e-3, 0.3}, {m, 2e-3, -1}, {m, 5e-4, 2}});
  EXPECT_LT((plies.A - solid.A).norm(), 1e-12 * solid.A.norm());
  EXPECT_LT((plies.D - solid.D).norm(), 1e-12 * solid.A.norm());
  EXPECT_EQ(plies.B.norm(), 0);
  EXPECT_LT((plies.S - solid.S).norm(), 1e-12 * solid.S.norm());
}

// --- a rectangular plate, E1 140, E2 10 GPa, a x b, t = 1 mm, edges that carry it and slide along
// their normal

constexpr double a = 0.3, b = 0.2, t = 1e-3, rho = 1600;
const PlyMaterial carbon = orthotropic(140e9, 10e9, 0.3, 5e9, 5e9, 3.5e9, rho);

Mesh ply_plate() {
  return mesh_plate({Vector3d(0, 0, 0), {a, 0, 0}, {a, b, 0}, {0, b, 0}}, 48, 32, t);
}

std::string ply_nastran(const std::string& property, const std::string& theta) {
  std::string text;
  const Mesh mesh = ply_plate();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vector3d& x = mesh.nodes[i];
    std::string held;
    if (std::abs(x.x()) < 1e-9 || std::abs(x.x() - a) < 1e-9) held += "23";
    if (std::abs(x.y()) < 1e-9 || std::abs(x.y() - b) < 1e-9) held += held.empty() ? "13" : "1";
    text += fmt::format("GRID*,{},,{},{}\n*,{},,{}\n", i + 1, nastran_real(x.x()),
                        nastran_real(x.y()), nastran_real(x.z()), held);
  }
  for (std::size_t e = 0; e < mesh.quads.size(); ++e)
    text += fmt::format("CQUAD4,{},1,{},{},{},{},{}\n", e + 1, mesh.quads[e].nodes[0] + 1,
                        mesh.quads[e].nodes[1] + 1, mesh.quads[e].nodes[2] + 1,
                        mesh.quads[e].nodes[3] + 1, theta);
  return text + "MAT8,1,140.+9,10.+9,.3,5.+9,5.+9,3.5+9,1600.\n" + property;
}

std::string ply_abaqus(const std::string& section) {
  std::string text = "*NODE, NSET=ALL\n", x_edges, y_edges;
  const Mesh mesh = ply_plate();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vector3d& x = mesh.nodes[i];
    text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", i + 1, x.x(), x.y(), x.z());
    if (std::abs(x.x()) < 1e-9 || std::abs(x.x() - a) < 1e-9)
      x_edges += fmt::format("{}, 2, 3\n", i + 1);
    if (std::abs(x.y()) < 1e-9 || std::abs(x.y() - b) < 1e-9)
      y_edges += fmt::format("{0}, 1, 1\n{0}, 3, 3\n", i + 1);
  }
  text += "*ELEMENT, TYPE=S4, ELSET=WALL\n";
  for (std::size_t e = 0; e < mesh.quads.size(); ++e)
    text += fmt::format("{}, {}, {}, {}, {}\n", e + 1, mesh.quads[e].nodes[0] + 1,
                        mesh.quads[e].nodes[1] + 1, mesh.quads[e].nodes[2] + 1,
                        mesh.quads[e].nodes[3] + 1);
  return text +
         "*MATERIAL, NAME=CARBON\n*ELASTIC, TYPE=LAMINA\n140e9, 10e9, .3, 5e9, 5e9, 3.5e9\n" +
         "*DENSITY\n1600.\n" + section + "*BOUNDARY\n" + x_edges + y_edges;
}

DeckModel ply_deck(const std::string& name, const std::string& text) {
  const TemporaryFolder folder("laminates");
  write_whole(folder.path / name, name.ends_with(".bdf") ? of_consistent_mass(text) : text);
  return *read_deck(folder.path / name, UnknownCards::error);
}

Eigen::VectorXd ply_hertz(const DeckModel& deck, int count = 5) {
  return find_modes(place(deck, {}), count).hertz;
}

// Thin plate with cross plies, w and displacements as sines (Jones, Mechanics of composite
// materials, 1999, chapter 5): membrane and bending coupled by B, eliminated at each pair of waves.
std::vector<double> cross_ply_hertz(const ShellLaminate& wall, std::size_t count) {
  const Matrix3d A = t * wall.A, B = t * t * wall.B, D = t * t * t / 12 * wall.D;
  std::vector<double> all;
  for (int m = 1; m < 8; ++m)
    for (int n = 1; n < 8; ++n) {
      const double p = m * pi / a, q = n * pi / b;
      Matrix3d T;
      T(0, 0) = A(0, 0) * p * p + A(2, 2) * q * q;
      T(1, 1) = A(2, 2) * p * p + A(1, 1) * q * q;
      T(0, 1) = T(1, 0) = (A(0, 1) + A(2, 2)) * p * q;
      T(0, 2) = T(2, 0) = -B(0, 0) * p * p * p - (B(0, 1) + 2 * B(2, 2)) * p * q * q;
      T(1, 2) = T(2, 1) = -B(1, 1) * q * q * q - (B(0, 1) + 2 * B(2, 2)) * p * p * q;
      T(2, 2) = D(0, 0) * std::pow(p, 4) + 2 * (D(0, 1) + 2 * D(2, 2)) * p * p * q * q +
                D(1, 1) * std::pow(q, 4);
      const Eigen::Vector2d beside = T.topRightCorner<2, 1>();
      const double k = T(2, 2) - beside.dot(T.topLeftCorner<2, 2>().ldlt().solve(beside).eval());
      all.push_back(std::sqrt(k / (rho * t)) / (2 * pi));
    }
  std::sort(all.begin(), all.end());
  all.resize(count);
  return all;
}

void expect_hertz(const Eigen::VectorXd& ours, const std::vector<double>& theirs, double within) {
  for (std::size_t i = 0; i < theirs.size(); ++i)
    EXPECT_NEAR(ours[Eigen::Index(i)] / theirs[i], 1, within) << "mode " << i + 1;
}

TEST(Laminate, cross_plies_have_the_frequencies_of_their_closed_form) {
  const std::vector<GeneralPly> even{
      {carbon, t / 4, 0}, {carbon, t / 2, pi / 2}, {carbon, t / 4, 0}};
  const std::vector<GeneralPly> odd{{carbon, t / 2, 0}, {carbon, t / 2, pi / 2}};
  const Eigen::VectorXd symmetric = ply_hertz(
      ply_deck("a.bdf", ply_nastran("PCOMP,1,,,,,,,SYM\n,1,2.5-4,0.,,1,2.5-4,90.\n", "")));
  expect_hertz(symmetric, cross_ply_hertz(general_laminate(even), 5), 0.01);
  const DeckModel coupled = ply_deck("b.bdf", ply_nastran("PCOMP,1\n,1,5.-4,0.,,1,5.-4,90.\n", ""));
  expect_hertz(ply_hertz(coupled), cross_ply_hertz(general_laminate(odd), 5), 0.01);
  ASSERT_EQ(coupled.notes.size(), 1U);
  EXPECT_NE(coupled.notes[0].find("a wall that is not isotropic: 1536, solved"), std::string::npos);
}

TEST(Laminate, one_wall_in_the_words_of_both_codes) {
  const Eigen::VectorXd ours =
      ply_hertz(ply_deck("a.bdf", ply_nastran("PCOMP,1\n,1,3.-4,0.,,1,7.-4,40.\n", "")));
  const std::string turned = "CORD2R,5,,0.,0.,0.,0.,0.,1.\n,0.,1.,0.\n"; // x along our y
  std::vector<Eigen::VectorXd> all{
      ply_hertz(ply_deck("a.bdf", ply_nastran("PCOMP,1\n,1,3.-4,-40.,,1,7.-4,0.\n", "40."))),
      ply_hertz(
          ply_deck("a.bdf", turned + ply_nastran("PCOMP,1\n,1,3.-4,-90.,,1,7.-4,-50.\n", "5"))),
      ply_hertz(ply_deck("a.inp", ply_abaqus("*SHELL SECTION, ELSET=WALL, COMPOSITE\n"
                                             "3e-4, 3, CARBON, 0.\n7e-4, 3, CARBON, 40.\n"))),
      ply_hertz(
          ply_deck("a.inp", ply_abaqus("*ORIENTATION, NAME=O\n0, 1, 0, -1, 0, 0\n3, -50.\n"
                                       "*SHELL GENERAL SECTION, ELSET=WALL, COMPOSITE, "
                                       "ORIENTATION=O\n3e-4, 3, CARBON, -40.\n7e-4, 3, CARBON\n"))),
      ply_hertz(ply_deck("a.inp", ply_abaqus("*ORIENTATION, NAME=X\n1, 0, 0, 0, 1, 0\n3, 0.\n"
                                             "*ORIENTATION, NAME=Y\n0, 0, 1, 1, 0, 0\n1, 40.\n"
                                             "*SHELL SECTION, ELSET=WALL, COMPOSITE\n"
                                             "3e-4, 3, CARBON, X\n7e-4, 3, CARBON, Y\n")))};
  const ShellLaminate wall = general_laminate({{carbon, 3e-4, 0}, {carbon, 7e-4, 40 * pi / 180}});
  Eigen::Matrix<double, 6, 6> law;
  law << t * wall.A, t * t * wall.B, t * t * wall.B, t * t * t / 12 * wall.D;
  std::string matrix;
  for (int j = 0, number = 0; j < 6; ++j)
    for (int i = 0; i <= j; ++i)
      matrix += fmt::format("{:.12g}{}", law(i, j), ++number % 8 == 0 ? "\n" : ", ");
  all.push_back(ply_hertz(ply_deck(
      "a.inp", ply_abaqus("*SHELL GENERAL SECTION, ELSET=WALL, DENSITY=1.6\n" + matrix +
                          fmt::format("\n*TRANSVERSE SHEAR STIFFNESS\n{:.12g}, {:.12g}, 0.\n",
                                      t * wall.S(0, 0), t * wall.S(1, 1))))));
  for (std::size_t k = 0; k < all.size(); ++k) // its thickness and the shear of turned plies: 1e-3
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(all[k][i] / ours[i], 1, k < 3 ? 1e-3 : 2e-3) << k << i;
}

// A wall whose G is not E/2/(1+nu), and one of a material for each of its stiffnesses.
TEST(Laminate, a_shell_of_several_materials_is_the_sum_of_them) {
  const auto with = [](const std::string& property) {
    return ply_hertz(ply_deck("a.bdf", ply_nastran(property, "")));
  };
  const std::string shear = "MAT1,3,140.+9,5.+9,.3\n";
  const Eigen::VectorXd ours = with(shear + "PSHELL,1,1,.001,1,,3\n");
  const Eigen::VectorXd plies = with("PCOMP,1\n,1,.001,0.\n");
  const Eigen::VectorXd matrix =
      with(shear + fmt::format("MAT2,2,{},{},0.,{},0.,5.+9,1600.\nPSHELL,1,2,.001,2,,3\n",
                               nastran_real(carbon.Q(0, 0)), nastran_real(carbon.Q(0, 1)),
                               nastran_real(carbon.Q(1, 1))));
  expect_hertz(ours, cross_ply_hertz(solid_wall(carbon), 4), 0.01);
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(plies[i] / ours[i], 1, 2e-3) << i; // G of 3.5 and 5 GPa across
    EXPECT_NEAR(matrix[i] / ours[i], 1, 1e-6) << i;
  }
}

// --- the same deck in CalculiX, which makes solids of every ply: a plate of S8R, held at one side

struct TurnedPly {
  double thickness = 0, degrees = 0;
};

std::string eight_node_plate(const std::vector<TurnedPly>& plies) {
  const int along = 24, across = 16;
  std::map<std::pair<int, int>, int> numbers;
  std::string nodes = "*NODE\n", elements = "*ELEMENT, TYPE=S8R, ELSET=WALL\n", held;
  const auto node = [&](int i, int j) {
    const auto [known, is_new] = numbers.try_emplace({i, j}, int(numbers.size()) + 1);
    if (is_new)
      nodes += fmt::format("{}, {:.10g}, {:.10g}, 0.\n", known->second, a * i / (2 * along),
                           b * j / (2 * across));
    if (is_new && i == 0) held += fmt::format("{}, 1, 6\n", known->second);
    return known->second;
  };
  for (int j = 0, number = 0; j < 2 * across; j += 2)
    for (int i = 0; i < 2 * along; i += 2)
      elements += fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}\n", ++number, node(i, j),
                              node(i + 2, j), node(i + 2, j + 2), node(i, j + 2), node(i + 1, j),
                              node(i + 2, j + 1), node(i + 1, j + 2), node(i, j + 1));
  std::string axes, section = "*SHELL SECTION, ELSET=WALL, COMPOSITE\n";
  for (std::size_t k = 0; k < plies.size(); ++k) {
    const double c = std::cos(plies[k].degrees * pi / 180),
                 s = std::sin(plies[k].degrees * pi / 180);
    axes += fmt::format("*ORIENTATION, NAME=O{}\n{:.10g}, {:.10g}, 0., {:.10g}, {:.10g}, 0.\n", k,
                        c, s, -s, c);
    section += fmt::format("{}, , CARBON, O{}\n", plies[k].thickness, k);
  }
  return nodes + elements +
         "*MATERIAL, NAME=CARBON\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
         "140e9, 10e9, 10e9, .3, .3, .4, 5e9, 5e9,\n3.5e9, 293.\n*DENSITY\n1600.\n" +
         axes + section + "*BOUNDARY\n" + held + "*STEP\n*FREQUENCY\n6\n*END STEP\n";
}

// Of the table of eigenvalues; empty where CalculiX is not installed or breaks off.
std::vector<double> calculix_ply_hertz(const std::string& deck) {
  std::istringstream stream(calculix_output(deck));
  std::vector<double> all;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line);
    int mode = 0;
    double value = 0, omega = 0, hertz = 0, imaginary = 0;
    if (fields >> mode >> value >> omega >> hertz >> imaginary && mode == int(all.size()) + 1)
      all.push_back(hertz);
    else if (!all.empty())
      break;
  }
  return all;
}

TEST(CalculixPlies, a_plate_of_plies_has_the_frequencies_of_its_solids) {
  const std::vector<std::pair<const char*, std::vector<TurnedPly>>> walls{
      {"+30 -30 -30 +30", {{5e-4, 30}, {5e-4, -30}, {5e-4, -30}, {5e-4, 30}}},
      {"0 90", {{1e-3, 0}, {1e-3, 90}}},
      {"45 -20", {{1e-3, 45}, {1e-3, -20}}}};
  for (const auto& [name, plies] : walls) {
    const std::string deck = eight_node_plate(plies);
    const std::vector<double> theirs = calculix_ply_hertz(deck);
    ASSERT_GE(theirs.size(), 6U) << "CalculiX (ccx) is not there, or broke off";
    const Eigen::VectorXd ours = ply_hertz(ply_deck("a.inp", deck), 6);
    for (Eigen::Index i = 0; i < 6; ++i) {
      fmt::print("{:16} {:8.2f} Hz, CalculiX {:8.2f}\n", name, ours[i], theirs[std::size_t(i)]);
      EXPECT_NEAR(ours[i] / theirs[std::size_t(i)], 1, 0.01) << name;
    }
  }
}

} // namespace
} // namespace plica::test
