// Cards and keywords that real decks have: the same structure drawn another way has the same
// frequencies, or a closed form says them.
#include "io/decks/deck_panels.hpp"
#include "io/decks/deck_profiles.hpp"
#include "io/decks/nastran_cards.hpp"
#include "io/decks/read_deck.hpp"
#include "io/files/files.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

DeckModel people_deck(const std::string& name, const std::string& text) {
  const TemporaryFolder folder("people");
  write_whole(folder.path / name, text);
  return *read_deck(folder.path / name, UnknownCards::error);
}

Eigen::VectorXd hertz_of(const DeckModel& deck, int count) {
  return find_modes(place(deck, {}), count).hertz;
}

// Axes of a plate that is turned by 30 degrees about z and moved.
Vector3d askew(const Vector3d& x) {
  return Eigen::AngleAxisd(pi / 6, Vector3d::UnitZ()) * x + Vector3d(1, 2, 3);
}

std::string nastran_plate(bool turned, const std::string& grid_end) {
  std::string text;
  const Mesh mesh = deck_plate();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vector3d x = turned ? askew(mesh.nodes[i]) : mesh.nodes[i];
    text += fmt::format("GRID*,{},,{},{}\n*,{}{}\n", i + 1, nastran_real(x.x()),
                        nastran_real(x.y()), nastran_real(x.z()), grid_end);
  }
  for (std::size_t e = 0; e < mesh.quads.size(); ++e)
    text += fmt::format("CQUAD4,{},1,{},{},{},{}\n", e + 1, mesh.quads[e].nodes[0] + 1,
                        mesh.quads[e].nodes[1] + 1, mesh.quads[e].nodes[2] + 1,
                        mesh.quads[e].nodes[3] + 1);
  return text + "MAT1,1,2.+11,,.3,8000.\nPSHELL,1,1,.002,1,,1\n";
}

std::string spc_of(const std::string& set, const std::string& dofs) {
  std::string text;
  const Mesh mesh = deck_plate();
  for (int node : mesh.sets.at(set)) text += fmt::format("SPC1,1,{},{}\n", dofs, node + 1);
  return text;
}

// Held, coupled and tied DOFs along CD of a turned plate are those of the plate as it was.
TEST(PeopleDeck, displacement_systems_turn_what_is_held_and_tied) {
  const int corner = number_at(0.3, 0.2), middle = number_at(0.15, 0.1);
  const std::string more = spc_of("edge4", "135") + spc_of("edge1", "2") +
                           "FORCE,1,1,,1.,0.,0.,1.\n" +
                           fmt::format("RBE2,900,{},3,{}\nMPC,1,{},1,1.,{},1,-.5\n", corner,
                                       number_at(0.3, 0.1), middle, number_at(0.2, 0.1));
  const Vector3d z = askew({0, 0, 1}), x = askew({1, 0, 0});
  const std::string system = fmt::format("CORD2R,7,,1.,2.,3.,{:.10f},{:.10f},{:.10f}\n,{:.10f},"
                                         "{:.10f},{:.10f}\n",
                                         z.x(), z.y(), z.z(), x.x(), x.y(), x.z());
  const Eigen::VectorXd plain = hertz_of(people_deck("a.bdf", nastran_plate(false, "") + more), 8);
  const DeckModel deck = people_deck("b.bdf", nastran_plate(true, ",7") + system + more);
  const Eigen::VectorXd turned = hertz_of(deck, 8);
  const Eigen::VectorXd by_default = hertz_of(
      people_deck("c.bdf", nastran_plate(true, "") + system + "GRDSET,,,,,,7\n" + more), 8);
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(turned[i] / plain[i], 1, 1e-7) << i; // digits of the system
    EXPECT_NEAR(by_default[i] / plain[i], 1, 1e-7) << i;
  }
  ASSERT_EQ(deck.notes.size(), 1U);
  EXPECT_EQ(deck.notes[0], "loads, which act where the case says static: deck: FORCE");
}

// GRDSET holds what its grid points do not say.
TEST(PeopleDeck, grdset_holds) {
  const Eigen::VectorXd by_cards =
      hertz_of(people_deck("a.bdf", nastran_plate(false, "") + spc_of("edge4", "123456") +
                                        fmt::format("SPC1,1,126,1,THRU,{}\n",
                                                    deck_plate().nodes.size() + 9)),
               6);
  const Eigen::VectorXd by_default =
      hertz_of(people_deck("b.bdf", nastran_plate(false, "") + spc_of("edge4", "12 3456") +
                                        "GRDSET,,,,,,,126\n"),
               6);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(by_default[i] / by_cards[i], 1, deck_agreement) << i;
}

// One truss of half its mass at its end: w^2 = 2 E / (rho L^2), with a mass there k / (m + rho A L
// / 2); of consistent mass 3 E / (rho L^2).
TEST(PeopleDeck, rods_have_the_frequency_of_one_element) {
  const double E = 2e11, rho = 8000, A = 1e-4, L = 0.6, k = E * A / L;
  const double alone = std::sqrt(2 * E / rho) / L / (2 * pi);
  const double loaded = std::sqrt(k / (2 + rho * A * L / 2)) / (2 * pi);
  const std::string grids = "GRID,1,,0.,0.,0.,,123456\nGRID,2,,.6,0.,0.\n";
  const std::string m = "MAT1,1,2.+11,,.3,8000.\n";
  EXPECT_NEAR(hertz_of(people_deck("a.bdf", grids + m + "PROD,5,1,1.-4\nCROD,1,5,1,2\n"), 1)[0] /
                  alone,
              1, 1e-9);
  EXPECT_NEAR(
      hertz_of(people_deck("a.bdf", grids + m + "CONROD,1,1,2,1,1.-4\nCONM2,1,2,,2.\n"), 1)[0] /
          loaded,
      1, 1e-9);
  EXPECT_NEAR(hertz_of(people_deck("a.bdf", "PARAM,COUPMASS,1\n" + grids + m +
                                                "PROD,5,1,1.-4\nCROD,1,5,1,2\n"),
                       1)[0] /
                  (alone * std::sqrt(1.5)),
              1, 1e-9);
  const double tube = pi / 4 * (0.02 * 0.02 - 0.016 * 0.016) * E / L;
  EXPECT_NEAR(
      hertz_of(
          people_deck("a.bdf",
                      grids +
                          "MAT1,1,2.+11,,.3\nPTUBE,5,1,.02,.002\nCTUBE,1,5,1,2\nCMASS2,9,3.,2,1\n"),
          1)[0] /
          (std::sqrt(tube / 3) / (2 * pi)),
      1, 1e-9);
  const std::string abaqus =
      "*NODE\n1, 0, 0, 0\n2, 0.6, 0, 0\n*ELEMENT, TYPE=T3D2, ELSET=BAR\n1, 1, 2\n*MATERIAL, "
      "NAME=S\n"
      "*ELASTIC\n2.e11, .3\n*DENSITY\n8000.\n*SOLID SECTION, ELSET=BAR, MATERIAL=S\n1.e-4\n"
      "*BOUNDARY\n1, 1, 3\n2, 2, 3\n";
  EXPECT_NEAR(hertz_of(people_deck("a.inp", abaqus), 1)[0] / alone, 1, 1e-9);
  const std::string spring = "*NODE\n1, 0, 0, 0\n2, 0.6, 0.8, 0\n*ELEMENT, TYPE=SPRINGA, "
                             "ELSET=S\n1, 1, 2\n*SPRING, ELSET=S\n\n"
                             "900.\n*ELEMENT, TYPE=MASS, ELSET=M\n2, 2\n*MASS, "
                             "ELSET=M\n4.\n*BOUNDARY\n1, 1, 3\n2, 3\n2, 2\n";
  EXPECT_NEAR(hertz_of(people_deck("a.inp", spring), 1)[0] / (std::sqrt(0.36 * 900 / 4) / (2 * pi)),
              1, 1e-9);
}

// Two masses between three springs: w^2 = k/m and 3 k/m.
TEST(PeopleDeck, scalar_points_with_springs_and_masses) {
  const std::string chain =
      "SPOINT,1,2\nCELAS4,1,500.,1\nCELAS4,2,500.,1,2\nPELAS,7,300.,,,8,500.\nCELAS3,3,8,2\n"
      "CMASS4,4,2.,1\nPMASS,6,2.\nCMASS3,5,6,2\nMAT1,1,1.,,.3\n";
  const Eigen::VectorXd hertz = hertz_of(people_deck("a.bdf", chain), 2);
  EXPECT_NEAR(hertz[0], std::sqrt(500. / 2) / (2 * pi), 1e-9);
  EXPECT_NEAR(hertz[1], std::sqrt(3 * 500. / 2) / (2 * pi), 1e-9);
}

// A beam clamped at one end and hinged at the other resists a moment-free end with 3 EI / L^3; a
// hinge about the other axis leaves 12 EI / L^3.
TEST(PeopleDeck, released_ends) {
  const double L = 2, EI = 7;
  BeamElement beam{.node1 = 0, .node2 = 1, .section = {}, .up = {0, 0, 1}};
  beam.section = {.EA = 5, .EI_y = EI, .EI_z = 2 * EI, .GJ = 3, .mass = 1.5};
  const std::vector<Vector3d> x{{0, 0, 0}, {L, 0, 0}};
  const MatrixElement hinged = released_beam(x, beam, beam.up, {6 + 4});
  EXPECT_NEAR(hinged.K(8, 8), 3 * EI / (L * L * L), 1e-9);
  EXPECT_NEAR(hinged.K(7, 7), 12 * 2 * EI / (L * L * L), 1e-9);
  EXPECT_NEAR(hinged.K.col(10).norm(), 0, 1e-9);
  EXPECT_NEAR(hinged.K(4, 4), 3 * EI / L, 1e-9);
  Eigen::VectorXd rigid = Eigen::VectorXd::Zero(12);
  rigid[2] = rigid[8] = 1;
  EXPECT_NEAR(rigid.dot(hinged.M * rigid), 1.5 * L, 1e-9);
  EXPECT_NEAR((hinged.K * rigid).norm(), 0, 1e-9);
  const MatrixElement loose = released_beam(x, beam, beam.up, {3, 4, 5, 9, 10, 11}); // a truss
  EXPECT_NEAR(loose.K(6, 6), 5 / L, 1e-9);
  EXPECT_NEAR(loose.K(8, 8), 0, 1e-9);
  // The y of the element is our z, its 5 bends about our y.
  const std::string text = "GRID,1,,0.,0.,0.,,123456\nGRID,2,,2.,0.,0.,,12456\nMAT1,1,2.,,0.,0.\n"
                           "PBAR,1,1,1.,{}\nCBAR,1,1,1,2,0.,0.,1.,,+\n+,,{}\nCONM2,9,2,,4.\n";
  const auto stiff = [&](const char* inertia, const char* released) {
    const std::string deck = fmt::format(fmt::runtime(text), inertia, released);
    return 4 * std::pow(2 * pi * hertz_of(people_deck("a.bdf", deck), 1)[0], 2);
  };
  EXPECT_NEAR(stiff("3.,1.", ""), 12 * 2 * 3. / 8, 1e-6);
  EXPECT_NEAR(stiff("3.,1.", "6"), 3 * 2 * 3. / 8, 1e-6);
  EXPECT_NEAR(stiff("3.,1.", "5"), 12 * 2 * 3. / 8, 1e-6);
}

// Three plies of one material are a wall; a soft core of the same nu leaves the bending of its
// faces.
TEST(PeopleDeck, plies_that_make_an_isotropic_wall) {
  std::string plate = nastran_plate(false, "") + spc_of("edge4", "123456");
  const Eigen::VectorXd plain = hertz_of(people_deck("a.bdf", plate), 6);
  const std::string property = "PSHELL,1,1,.002,1,,1\n";
  const auto with = [&](const std::string& other) {
    std::string text = plate;
    text.replace(text.find(property), property.size(), other);
    return hertz_of(people_deck("a.bdf", text), 6);
  };
  const Eigen::VectorXd plies = with("PCOMP,1\n,1,.0005,0.,,1,.001,90.\n,1,.0005,0.\n");
  const Eigen::VectorXd half = with("PCOMP,1,,,,,,,SYM\n,1,.0005,0.,,1,.0005,90.\n");
  const double bent = 1 - 0.125 * (1 - 1e-3); // of D without the core
  const Eigen::VectorXd core =
      with("MAT1,2,2.+8,,.3,8000.\nPCOMP,1\n,1,.0005,,,2,.001\n,1,.0005\n");
  const Eigen::VectorXd sandwich = with(fmt::format("PSHELL,1,1,.002,1,{:.6f},1,1000.\n", bent));
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(plies[i] / plain[i], 1, 1e-9) << i;
    EXPECT_NEAR(half[i] / plain[i], 1, 1e-9) << i;
  }
  EXPECT_LT(core[0], sandwich[0]); // the core gives way in shear
  EXPECT_NEAR(core[0] / sandwich[0], 1, 0.05);
}

// Energy of a uniform strain: sigma . eps / 2 times the volume, however the plane lies.
TEST(PeopleDeck, membranes_and_panels_store_the_energy_of_uniform_strain) {
  const ShellSection wall{
      .E = 2e11, .nu = 0.3, .rho = 8000, .bending_factor = 0, .shear_correction = 0, .drilling = 0};
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Matrix3d x;
  x << 0, 0.3, 0.1, 0, 0.05, 0.2, 0, 0, 0;
  const Vector3d strain(1e-4, -2e-4, 3e-4);
  const auto field = [&](const Vector3d& at) {
    return Vector3d(strain[0] * at.x() + strain[2] * at.y(), strain[1] * at.y(), 0);
  };
  const MatrixElement t = membrane_triangle({0, 1, 2}, R * x, wall, 0.002);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(18);
  for (int i = 0; i < 3; ++i) u.segment<3>(6 * i) = R * field(x.col(i));
  const double area = (0.3 * 0.2 - 0.05 * 0.1) / 2;
  const double energy = strain.dot(shell_law(wall).in_plane * strain) / 2 * area * 0.002;
  EXPECT_NEAR(u.dot(t.K * u) / 2 / energy, 1, 1e-12);
  Eigen::Matrix<double, 3, 4> corners;
  corners << 0, 0.3, 0.3, 0, 0, 0, 0.2, 0.2, 0, 0, 0, 0;
  const MatrixElement p = shear_panel({0, 1, 2, 3}, R * corners, 8e10, 0.3, 0.002, 16);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(24), moved = v;
  for (int i = 0; i < 4; ++i) {
    v.segment<3>(6 * i) = R * field(corners.col(i));
    moved.segment<3>(6 * i) = Vector3d(0, 0, 1);
  }
  EXPECT_NEAR(v.dot(p.K * v), 8e10 * 0.002 * 0.06 * 9e-8, 1e-9);
  EXPECT_NEAR(moved.dot(p.M * moved), 16 * 0.06, 1e-12);
}

// Bending alone and membrane alone together are the whole wall, in frequencies of a flat plate.
TEST(PeopleDeck, a_wall_may_bend_alone) {
  const std::string plate = nastran_plate(false, "") + spc_of("edge4", "123456");
  const Eigen::VectorXd whole =
      hertz_of(people_deck("a.bdf", plate + fmt::format("SPC1,1,126,1,THRU,{}\n",
                                                        deck_plate().nodes.size())),
               5);
  std::string text = plate;
  const std::string property = "PSHELL,1,1,.002,1,,1\n";
  text.replace(text.find(property), property.size(), "PSHELL,1,,.002,1,,1\n");
  const Eigen::VectorXd alone = hertz_of(people_deck("b.bdf", text), 5);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(alone[i] / whole[i], 1, 1e-9) << i;
}

TEST(PeopleDeck, profiles_of_rectangles) {
  const BeamMaterial m{1, 0, 1};
  // I of 100 x 60, flanges 8, web 5: I = (60 100^3 - 55 84^3) / 12.
  const BeamProperties I =
      rectangles_section(m, {{0, -46, 60, 8}, {0, 46, 60, 8}, {0, 0, 5, 84}}).properties;
  EXPECT_NEAR(I.EA, 2 * 480 + 420, 1e-9);
  EXPECT_NEAR(I.EI_y, (60 * 1e6 - 55 * std::pow(84, 3)) / 12, 1e-6);
  EXPECT_NEAR(I.EI_z, (2 * 8 * std::pow(60, 3) + 84 * 125.) / 12, 1e-6);
  const BeamProperties box = profile_section(m, box_profile(40, 60, {2, 3, 2, 3})).properties;
  EXPECT_NEAR(box.EI_y, (40 * std::pow(60, 3) - 36 * std::pow(54, 3)) / 12, 1e-6);
  EXPECT_NEAR(box.GJ, 0.5 * 4 * 38 * 38 * 57 * 57 / (2 * 38 / 3. + 2 * 57 / 2.), 1e-6);
  // A rectangle whose axes are turned by 30 degrees comes back turned.
  const double a = pi / 6, Iy = 9, Iz = 4, c = std::cos(a), s = std::sin(a);
  const TurnedSection turned = principal_section(m, 1, c * c * Iy + s * s * Iz,
                                                 s * s * Iy + c * c * Iz, -s * c * (Iy - Iz), 1);
  EXPECT_NEAR(turned.properties.EI_y, Iy, 1e-12);
  EXPECT_NEAR(turned.turn, a, 1e-12);
}

// Shells of eight nodes are the four that they are split into.
TEST(PeopleDeck, quadratic_shells_are_split) {
  const Mesh mesh = deck_plate(); // 6 x 4: three by two of eight nodes
  std::string quads, abaqus = "*NODE\n", elements = "*ELEMENT, TYPE=S8R, ELSET=WALL\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    abaqus += fmt::format("{}, {:.12g}, {:.12g}, 0\n", i + 1, mesh.nodes[i].x(), mesh.nodes[i].y());
  int number = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) {
      const auto at = [&](int a, int b) {
        return number_at(0.1 * i + 0.05 * a, 0.1 * j + 0.05 * b);
      };
      const int n[8] = {at(0, 0), at(2, 0), at(2, 2), at(0, 2),
                        at(1, 0), at(2, 1), at(1, 2), at(0, 1)};
      quads += fmt::format("CQUAD8,{},1,{},{},{},{},{},{}\n,{},{}\n", ++number, n[0], n[1], n[2],
                           n[3], n[4], n[5], n[6], n[7]);
      elements += fmt::format("{},{},{},{},{},{},{},{},{}\n", number, n[0], n[1], n[2], n[3], n[4],
                              n[5], n[6], n[7]);
    }
  std::string text = of_consistent_mass(nastran_plate(false, "") + spc_of("edge4", "123456"));
  const Eigen::VectorXd plain = hertz_of(people_deck("a.bdf", text), 6);
  const std::size_t first = text.find("CQUAD4"), last = text.find("MAT1");
  text.replace(first, last - first, quads);
  const DeckModel deck = people_deck("a.bdf", text);
  std::string root;
  for (int node : mesh.sets.at("edge4")) root += fmt::format("{}, 1, 6\n", node + 1);
  const DeckModel other =
      people_deck("a.inp", abaqus + elements +
                               "*MATERIAL, NAME=S\n*ELASTIC\n2.e11, .3\n*DENSITY\n8000.\n*SHELL "
                               "SECTION, ELSET=WALL, MATERIAL=S\n.002\n*BOUNDARY\n" +
                               root);
  EXPECT_EQ(deck.shells.size(), 24U);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(hertz_of(deck, 6)[i] / plain[i], 1, 1e-9) << i;
    EXPECT_NEAR(hertz_of(other, 6)[i] / plain[i], 1, 1e-9) << i;
  }
  ASSERT_EQ(deck.notes.size(), 1U);
  EXPECT_NE(deck.notes[0].find("6 shells of eight or six nodes"), std::string::npos);
}

// Half plates as two instances of one part, one moved and turned, tied where they meet.
TEST(PeopleDeck, parts_instances_ties_and_transforms) {
  const Mesh half =
      mesh_plate({Vector3d(0, 0, 0), {0.15, 0, 0}, {0.15, 0.2, 0}, {0, 0.2, 0}}, 3, 4, 2e-3);
  const auto set = [&](const std::string& name, const char* edge) {
    std::string text = "*NSET, NSET=" + name + "\n";
    for (int node : half.sets.at(edge)) text += fmt::format("{}\n", node + 1);
    return text;
  };
  std::string part = "*PART, NAME=Half\n*NODE\n";
  for (std::size_t i = 0; i < half.nodes.size(); ++i)
    part += fmt::format("{}, {:.12g}, {:.12g}, 0.\n", i + 1, half.nodes[i].x(), half.nodes[i].y());
  part += "*ELEMENT, TYPE=S4R, ELSET=Wall\n";
  for (std::size_t e = 0; e < half.quads.size(); ++e) {
    const auto& n = half.quads[e].nodes;
    part += fmt::format("{}, {}, {}, {}, {}\n", e + 1, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
  }
  part += set("LEFT", "edge4") + set("RIGHT", "edge2") +
          "*SHELL SECTION, ELSET=WALL, MATERIAL=S\n.002\n*END PART\n";
  const std::string text =
      part + "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=One-1, PART=Half\n0.5, 0., 0.\n*END INSTANCE\n"
             "*INSTANCE, NAME=Two-1, PART=Half\n0.2, 0.7, 0.1\n0.2, 0.7, 0.1, 0.2, 0.7, 1.1, "
             "180.\n*END INSTANCE\n"
             "*END ASSEMBLY\n*MATERIAL, NAME=S\n*ELASTIC\n2.e11, "
             ".3\n*DENSITY\n8000.\n*STEP\n*FREQUENCY\n5\n"
             "*BOUNDARY\nTwo-1.LEFT, ENCASTRE\nOne-1.LEFT, 1, 6\n*END STEP\n";
  const DeckModel apart = people_deck("a.inp", text);
  EXPECT_EQ(apart.sets.at("TWO-1.LEFT").size(), 5U);
  const Eigen::VectorXd twice = hertz_of(apart, 6);
  for (int i = 0; i < 6; i += 2)
    EXPECT_NEAR(twice[i] / twice[i + 1], 1, 1e-9) << i; // the same part
  std::string tied = text;
  const std::string place = "0.2, 0.7, 0.1\n0.2, 0.7, 0.1, 0.2, 0.7, 1.1, 180.\n",
                    far = "0.65, 0., 0.\n";
  tied.replace(tied.find(place), place.size(), far);
  tied.replace(tied.find("Two-1.LEFT, ENCASTRE\n"), 21, "");
  tied.insert(tied.find("*END ASSEMBLY"),
              "*SURFACE, TYPE=NODE, NAME=L\nOne-1.RIGHT\n"
              "*SURFACE, TYPE=NODE, NAME=R\nTwo-1.LEFT\n*TIE, NAME=T\nR, L\n");
  const Eigen::VectorXd joined = hertz_of(people_deck("a.inp", tied), 6);
  Model own = own_plate();
  hold(own, "edge4", all_dofs);
  const Eigen::VectorXd plate = find_modes(own, 6).hertz;
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(joined[i] / plate[i], 1, 1e-9) << i;
  // Rollers along transformed axes, turned with the part.
  const auto rolled = [&](const std::string& at) {
    std::string deck = text;
    deck.replace(deck.find(place), place.size(), at);
    const std::string held = "Two-1.LEFT, ENCASTRE\nOne-1.LEFT, 1, 6\n";
    deck.replace(deck.find(held), held.size(),
                 "One-1.LEFT, ENCASTRE\nTwo-1.LEFT, 1\nTwo-1.LEFT, 3\nTwo-1.LEFT, 5\nTwo-1.1, 2\n");
    deck.insert(deck.find("*END PART"), "*TRANSFORM, NSET=LEFT\n1., 0., 0., 0., 1., 0.\n");
    return hertz_of(people_deck("a.inp", deck), 8);
  };
  const Eigen::VectorXd straight = rolled(far);
  const Eigen::VectorXd turned = rolled("0.65, 0., 0.\n0., 0., 0., 1., 2., 3., 40.\n");
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(turned[i] / straight[i], 1, 1e-7) << i;
}

TEST(PeopleDeck, nastran_decks_may_be_called_inp) {
  const std::string text = "ID a, deck\nSOL 3\nCEND\nSPC = 1\nBEGIN BULK\n" +
                           nastran_plate(false, "") + spc_of("edge4", "123456") + "ENDDATA\n";
  const Eigen::VectorXd one = hertz_of(people_deck("a.inp", text), 3);
  const Eigen::VectorXd other = hertz_of(people_deck("a.bdf", text), 3);
  EXPECT_EQ(one, other);
}

} // namespace
} // namespace plica::test
