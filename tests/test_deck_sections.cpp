// Sections of beams that decks draw: closed forms, and the drawing integrated point by point; beams
// that bear beside the line about which they twist; elements by their numbers alone.
#include "io/decks/deck_eccentric_beam.hpp"
#include "io/decks/deck_panels.hpp"
#include "io/decks/deck_profiles.hpp"
#include "io/decks/read_deck.hpp"
#include "model/shape/deck.hpp"
#include "tests/deck_loads.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>

namespace plica::test {
namespace deck_loads {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

// --- walls

TEST(ThinWalls, channels_and_uneven_I_twist_where_Vlasov_says) {
  const double b = 3, h = 8, t = 0.1; // between middle lines, the web at y = 0
  const ThinWallSection channel =
      thin_wall_section({{Vector2d(0, -h / 2), Vector2d(0, h / 2), t},
                         {Vector2d(0, h / 2), Vector2d(b, h / 2), t},
                         {Vector2d(0, -h / 2), Vector2d(b, -h / 2), t}});
  EXPECT_NEAR(channel.shear_centre[0], -3 * b * b / (h + 6 * b), 1e-12);
  EXPECT_NEAR(channel.shear_centre[1], 0, 1e-12);
  EXPECT_NEAR(channel.J, (h + 2 * b) * t * t * t / 3, 1e-15);
  const TurnedSection I = profile_section({1, 0, 1}, i_profile(100, 5, {60, 8}, {30, 8}));
  const double lower = 8 * std::pow(60, 3) / 12, upper = 8 * std::pow(30, 3) / 12;
  EXPECT_NEAR(I.shear_centre[1], 4 + 92 * upper / (lower + upper), 1e-9);
  const TurnedSection L_shape = profile_section({1, 0, 1}, l_profile(50, 80, 4, 6));
  EXPECT_NEAR(L_shape.shear_centre[0], 3, 1e-9); // where its legs meet
  EXPECT_NEAR(L_shape.shear_centre[1], 2, 1e-9);
}

// Bredt: [delta] q = 2 A per unit twist, J = 2 A q.
TEST(ThinWalls, of_two_cells_share_the_flow_after_Bredt) {
  const double H = 6, B1 = 4, B2 = 2.5, top = 0.3, side = 0.2, between = 0.15;
  const Vector2d p(0, 0), q(B1, 0), r(B1 + B2, 0), u(0, H), v(B1, H), w(B1 + B2, H);
  const ThinWallSection cells = thin_wall_section({{p, q, top},
                                                   {q, r, top},
                                                   {r, w, side},
                                                   {w, v, top},
                                                   {v, u, top},
                                                   {u, p, side},
                                                   {q, v, between}});
  Matrix2d delta;
  delta << 2 * B1 / top + H / side + H / between, -H / between, -H / between,
      2 * B2 / top + H / side + H / between;
  const Vector2d areas(B1 * H, B2 * H);
  EXPECT_NEAR(cells.J / (4 * areas.dot(delta.inverse() * areas)), 1, 1e-12);
  EXPECT_TRUE(cells.closed);
}

TEST(ThinWalls, in_shear_a_web_has_five_sixths_of_its_area) {
  const ThinWallSection T = // with a feeble flange
      thin_wall_section({{Vector2d(0, -5), Vector2d(0, 0), 0.1},
                         {Vector2d(0, 0), Vector2d(0, 5), 0.1},
                         {Vector2d(0, 0), Vector2d(1e-3, 0), 0.1}});
  EXPECT_NEAR(1 / T.shear_compliance(1, 1), 5. / 6 * 10 * 0.1, 1e-4);
}

TEST(Hexagon, twists_as_tables_say) {
  const BeamMaterial m{2, 0, 1};
  const BeamProperties regular = hexagon_section(m, 0.5, 2, std::sqrt(3.)).properties;
  print_for_table("torsion of a regular hexagon of side 1", regular.GJ, 1.0354, 1e-3);
  EXPECT_NEAR(regular.GJ, 1.0354, 1e-3); // Roark's Formulas, 0.1154 d^4 rounded: 1.0386
  EXPECT_NEAR(regular.EI_y / 2, 5 * std::sqrt(3.) / 16, 1e-12);
  EXPECT_NEAR(regular.EI_z / 2, 5 * std::sqrt(3.) / 16, 1e-12);
  const BeamProperties bar = hexagon_section(m, 1e-7, 2, 1).properties;
  EXPECT_NEAR(bar.GJ / rectangle_section(m, 2, 1).GJ, 1, 1e-4);
}

// --- shapes of PBARL and PBEAML against their drawing

struct Drawing {
  std::string shape, sizes;
  std::function<bool(double, double)> inside; // to the right, up
};

bool between(double x, double low, double high) {
  return x > low && x < high;
}

const std::vector<Drawing> drawings{
    {"L", "40.,60.,8.,6.",
     [](double x, double z) {
       return (between(x, 0, 40) && between(z, 0, 8)) || (between(x, 0, 6) && between(z, 0, 60));
     }},
    {"HAT", "40.,4.,30.,12.",
     [](double x, double z) {
       const double a = std::abs(x);
       return (a < 15 && between(z, 36, 40)) || (between(a, 11, 15) && between(z, 0, 40)) ||
              (between(a, 11, 27) && between(z, 0, 4));
     }},
    {"HAT1", "60.,40.,30.,4.,6.",
     [](double x, double z) {
       const double a = std::abs(x);
       return (a < 15 && between(z, 36, 40)) || (between(a, 11, 15) && between(z, 6, 40)) ||
              (between(a, 11, 30) && between(z, 6, 10)) || (a < 30 && between(z, 0, 6));
     }},
    {"BOX1", "40.,60.,8.,4.,6.,2.",
     [](double x, double z) {
       return between(x, 0, 40) && between(z, 0, 60) && !(between(x, 6, 38) && between(z, 4, 52));
     }},
    {"DBOX", "80.,40.,30.,4.,6.,2.,8.,4.\n,6.,2.",
     [](double x, double z) {
       return between(x, 0, 80) && between(z, 0, 40) && !(between(x, 4, 27) && between(z, 4, 32)) &&
              !(between(x, 33, 78) && between(z, 2, 34));
     }},
    {"CHAN2", "4.,6.,40.,50.",
     [](double x, double z) {
       return std::abs(x) < 25 && between(z, 0, 40) && !(std::abs(x) < 21 && z > 6);
     }},
    {"Z", "20.,4.,32.,40.", [](double x, double z) {
       return (std::abs(x) < 2 && std::abs(z) < 20) || (between(x, -22, 2) && between(z, 16, 20)) ||
              (between(x, -2, 22) && between(z, -20, -16));
     }}};

DeckModel beam_deck(const std::string& property, const std::string& element) {
  const TemporaryFolder folder("deck_sections");
  const auto file = folder.path / "beam.bdf";
  write_whole(file, "GRID,1,,0.,0.,0.\nGRID,2,,1000.,0.,0.\n" + element + ",1,1,1,2,0.,1.,0.\n" +
                        property + "MAT1,1,1.,,0.3,1.\nENDDATA\n");
  return *read_deck(file, UnknownCards::error);
}

// Areas of 1 x 1, whose own second moment the sum of their middles lacks.
TEST(DrawnSections, have_the_area_and_second_moments_of_their_drawing) {
  for (const Drawing& d : drawings) {
    double A = 0;
    Vector2d first(0, 0);
    Matrix2d second = Matrix2d::Zero();
    for (int i = -100; i < 100; ++i)
      for (int j = -100; j < 100; ++j) {
        const Vector2d x(i + 0.5, j + 0.5);
        if (!d.inside(x[0], x[1])) continue;
        A += 1;
        first += x;
        second += x * x.transpose() + Matrix2d::Identity() / 12;
      }
    second -= first * first.transpose() / A;
    const DeckModel deck = beam_deck("PBARL,1,1,," + d.shape + "\n," + d.sizes + "\n", "CBAR");
    ASSERT_EQ(deck.beams.size(), 1) << d.shape;
    const BeamElement& beam = deck.beams[0];
    EXPECT_NEAR(beam.section.EA / A, 1, 1e-12) << d.shape;
    // Up in the drawing is y of the element, here y; to the right its -z.
    const Vector2d z(-beam.up.z(), beam.up.y()), y(z[1], -z[0]);
    const Matrix2d found =
        beam.section.EI_z * y * y.transpose() + beam.section.EI_y * z * z.transpose();
    EXPECT_LT((found - second).norm(), 1e-9 * second.norm()) << d.shape << "\n"
                                                             << found << "\n"
                                                             << second;
  }
}

TEST(DrawnSections, that_do_not_fit_are_refused) {
  for (const char* sizes :
       {"HAT\n,10.,6.,30.,12.\n", "HEXA\n,5.,10.,8.\n", "L\n,4.,60.,8.,6.\n",
        "DBOX\n,40.,40.,39.,4.,6.,2.,8.,4.\n,6.,2.\n", "BOX1\n,40.,60.,50.,14.,6.,2.\n"}) {
    const std::string error =
        error_of([&] { beam_deck("PBARL,1,1,," + std::string(sizes), "CBAR"); });
    EXPECT_NE(error.find("do not fit its shape"), std::string::npos) << sizes << ": " << error;
  }
}

// --- a channel that stands up, web 60 x 4, flanges 30 x 4 to the right of it, its shear centre e
// before the web: CHAN2 turned is CHAN with the same sizes

// Displacement and turn of the free end under what acts there, the force along y of the element
// through the line of the nodes.
std::array<Eigen::Matrix<double, 6, 1>, 3> channel_under_loads(const std::string& element,
                                                               const std::string& property) {
  std::array<Eigen::Matrix<double, 6, 1>, 3> found;
  const std::array<const char*, 3> loads{
      "FORCE,10,2,0,9.,0.,1.,0.\n", "FORCE,10,2,0,500.,1.,0.,0.\n", "MOMENT,10,2,0,30.,1.,0.,0.\n"};
  for (std::size_t k = 0; k < 3; ++k) {
    const Results all = loads_of(
        "beam.bdf", "SOL 101\nCEND\nSPC = 1\nLOAD = 10\nBEGIN BULK\nGRID,1,,0.,0.,0.\n"
                    "GRID,2,,1000.,0.,0.\n" +
                        element + ",1,1,1,2,0.,1.,0.\n" + property +
                        "MAT1,1,2.+5,,0.3,8.-9\nSPC1,1,123456,1\n" + loads[k] + "ENDDATA\n");
    const auto& u = node_of(all.deck_loads.at(0), 2).displacement;
    for (Eigen::Index d = 0; d < 6; ++d) found[k][d] = (d < 3 ? 1e3 : 1) * u[std::size_t(d)];
  }
  return found;
}

// The line of the nodes is that of shear centres: a force there bends and does not twist, a pull
// there bends as one beside the centroid, a moment about it moves nothing aside.
TEST(EccentricBeam, of_a_channel_twists_about_its_shear_centre) {
  const BeamMaterial m{E, 0.3, rho};
  const TurnedSection s = profile_section( // as CHAN2: an U open upward
      m, {{{0, 2, 60, 4}, {-28, 17, 4, 26}, {28, 17, 4, 26}},
          {{{-28, 2}, {28, 2}, 4}, {{-28, 2}, {-28, 30}, 4}, {{28, 2}, {28, 30}, 4}}});
  const double e = s.centroid[1] - s.shear_centre[1]; // of the centroid, along y of the element
  EXPECT_NEAR(s.shear_centre[1], 2 - 3 * 28. * 28 / (56 + 6 * 28.), 1e-9);
  const auto u = channel_under_loads("CBEAM", "PBEAML,1,1,,CHAN2\n,4.,4.,30.,60.\n");
  const BeamProperties& p = s.properties;
  const double bent = 9 * (L * L * L / (3 * p.EI_y) + L / p.GA_z);
  EXPECT_NEAR(u[0][1] / bent, 1, 1e-9);
  EXPECT_NEAR(u[0][3], 0, 1e-12);
  EXPECT_NEAR(u[1][0] / (500 * (L / p.EA + e * e * L / p.EI_y)), 1, 1e-9);
  EXPECT_NEAR(std::abs(u[1][1]) / (500 * std::abs(e) * L * L / (2 * p.EI_y)), 1, 1e-9);
  EXPECT_NEAR(u[2][3] / (30 * L / p.GJ), 1, 1e-9);
  EXPECT_NEAR(u[2].head<3>().norm(), 0, 1e-12);
  // The same by numbers: N1 along y of the element.
  const double A = p.EA / E;
  const auto numbers = channel_under_loads(
      "CBEAM", fmt::format("PBEAM,1,1,{:.16g},{:.16g},{:.16g},,{:.16g}\n,,,,,,,,\n"
                           ",{:.16g},{:.16g}\n,,,,,{:.16g},,{:.16g}\n",
                           A, p.EI_y / E, p.EI_z / E, p.GJ / (E / 2.6), p.GA_z / (E / 2.6 * A),
                           p.GA_y / (E / 2.6 * A), e, e));
  for (std::size_t k = 0; k < 3; ++k) EXPECT_LT((numbers[k] - u[k]).norm(), 1e-9 * u[k].norm());
  // As a CBAR its centroid is on the line of the nodes.
  const auto bar = channel_under_loads("CBAR", "PBARL,1,1,,CHAN2\n,4.,4.,30.,60.\n");
  EXPECT_NEAR(bar[1][0] / (500 * L / p.EA), 1, 1e-9);
}

// Rigid motion: mass, its place and its inertia.
TEST(EccentricBeam, weighs_where_it_bears_and_what_is_extra_where_it_is_said_to_be) {
  const BeamProperties p = rectangle_section({1, 0, 1}, 2, 3); // 6 per length
  const Eccentricity at{
      .neutral = {0, 0.5, 0.7}, .extra = {0, -2, 1}, .extra_mass = 4, .extra_inertia = 9};
  const double length = 5;
  const BeamMatrices all = eccentric_beam({{0, 0, 0}, {length, 0, 0}}, p, at);
  MatrixXd rigid = MatrixXd::Zero(12, 6);
  for (Eigen::Index n = 0; n < 2; ++n) {
    rigid.block<3, 3>(6 * n, 0).setIdentity();
    rigid.block<3, 3>(6 * n + 3, 3).setIdentity();
    const Vector3d x(double(n) * length, 0, 0);
    rigid.block<3, 3>(6 * n, 3) << 0, x.z(), -x.y(), -x.z(), 0, x.x(), x.y(), -x.x(), 0;
  }
  EXPECT_LT((all.K * rigid).norm(), 1e-9 * all.K.norm());
  const MatrixXd M = rigid.transpose() * all.M * rigid;
  EXPECT_NEAR(M(1, 1), length * 10, 1e-9);
  const double about_x = length * (6 * (0.25 + 0.49) + 6 * (4 + 9) / 12. + 4 * 5 + 9);
  EXPECT_NEAR(M(3, 3), about_x, 1e-9);
  EXPECT_NEAR(M(0, 4), length * (6 * 0.7 + 4 * 1), 1e-9); // m z of the centre
}

// --- elements by their numbers

Eigen::VectorXd hertz_of_deck(const std::string& text, int count) {
  const TemporaryFolder folder("deck_sections");
  write_whole(folder.path / "a.bdf", text + "ENDDATA\n");
  return find_modes(place(*read_deck(folder.path / "a.bdf", UnknownCards::error), {}), count).hertz;
}

const std::string posts =
    "PARAM,COUPMASS,1\nMAT1,1,2.+11,,.3,8000.\nPBARL,1,1,,ROD\n,.01\nGRID,1,,0.,0.,0.\n"
    "GRID,2,,.3,0.,0.\nGRID,3,,0.,.3,.05\nGRID,9,,.1,.15,.1\n"
    "GRID,21,,0.,0.,.4\nGRID,22,,.3,0.,.5\nGRID,23,,0.,.3,.45\n"
    "GRID,29,,.1,.15,.5\nCBAR,1,1,1,21,1.,0.,0.\nCBAR,2,1,2,22,1.,0.,0.\n"
    "CBAR,3,1,3,23,1.,0.,0.\nCBAR,5,1,9,29,1.,0.,0.\n"
    "CONM2,90,9,,2.,.01,.02\n,.02,,.03,,,.04\nSPC1,1,123456,21,22,23,29\n";

// Six DOFs of three points move the fourth: as the fourth moves all three, rigidly.
TEST(NumbersAlone, RBE1_and_CRIGD3_are_rigid_bodies) {
  const Eigen::VectorXd tied = hertz_of_deck(posts + "RBE2,7,9,123456,1,2,3\n", 8);
  const std::string lead = ",7,1,123,2,23,3,3\n", follow = ",1,456,2,1456,3,12456\n,9,123456\n";
  for (const std::string& text :
       {"RBE1" + lead + ",UM" + follow, "CRIGD3" + lead + ",MSET" + follow,
        std::string("RBE1,7,9,123456\n,UM,1,123456,2,123456,3,123456\n")}) {
    const Eigen::VectorXd found = hertz_of_deck(posts + text, 8);
    EXPECT_LT((found - tied).norm(), 1e-9 * tied.norm()) << text;
  }
}

TEST(NumbersAlone, RROD_keeps_its_length) {
  const Eigen::VectorXd rod = hertz_of_deck(posts + "RROD,7,1,9,,1\n", 8);
  const Eigen::VectorXd stiff =
      hertz_of_deck(posts + "CONROD,7,1,9,2,1.\nMAT1,2,1.+15\n", 8); // without mass
  EXPECT_LT((rod - stiff).cwiseQuotient(rod).cwiseAbs().maxCoeff(), 1e-4);
  const Eigen::VectorXd older = hertz_of_deck(posts + "CRIGDR,7,1,9,1\n", 8);
  EXPECT_LT((rod - older).norm(), 1e-12 * rod.norm());
  const std::string turned = error_of([] { hertz_of_deck(posts + "RROD,7,1,9,,4\n", 8); });
  EXPECT_NE(turned.find("lets a rotation follow"), std::string::npos) << turned;
}

// k (u1 - u2)^2 / 2 by its stiffness, by its flexibility, and about a base that moves rigidly.
TEST(NumbersAlone, GENEL_is_a_spring) {
  const Eigen::VectorXd spring = hertz_of_deck(posts + "CELAS2,7,4.+5,1,2,9,2\n", 8);
  for (const char* text :
       {"GENEL,7,,1,2,9,2\n,K,4.+5,-4.+5,4.+5\n", "GENEL,7,,1,2\n,UD,,9,2\n,Z,2.5-6\n,S,1.\n"}) {
    const Eigen::VectorXd found = hertz_of_deck(posts + text, 8);
    EXPECT_LT((found - spring).norm(), 1e-9 * spring.norm()) << text;
  }
  // A beam that point 9 carries, which bends in one plane alone.
  const std::string end = "GRID,10,,.6,.15,.1\nCONM2,91,10,,.5,,.02\n,.001,,.001,,,.001\n"
                          "SPC1,1,1345,10\n";
  const double EI = 500, l = 0.5;
  const std::string genel = fmt::format("GENEL,7,,10,2,10,6\n,UD,,9,1,9,2,9,3\n,9,4,9,5,9,6\n"
                                        ",Z,{:.10g},{:.10g},{:.10g}\n",
                                        l * l * l / (3 * EI), l * l / (2 * EI), l / EI);
  const std::string bar = fmt::format("PBAR,8,8,1.,{0:.10g},{0:.10g},1.\nMAT1,8,2.+11,,0.\n"
                                      "CBAR,7,8,9,10,0.,1.,0.\n,,1345\n",
                                      EI / 2e11);
  const Eigen::VectorXd by_numbers = hertz_of_deck(posts + end + genel, 8);
  const Eigen::VectorXd as_a_bar = hertz_of_deck(posts + end + bar, 8);
  EXPECT_LT((by_numbers - as_a_bar).norm(), 1e-8 * as_a_bar.norm());
}

// A panel of parallel edges, one of its two sides longer: in NASTRAN's Theoretical Manual
// Z = P1 P2 A / (P3 P4) (1 + 2/3 (s^2 + s c + c^2) / (1 + nu)) / (2 G t), P the distances from
// where its sides meet, s and c their slopes.
TEST(ShearPanel, of_a_trapezium_is_Garveys) {
  const double G = 8e10, nu = 0.3, t = 0.002;
  Eigen::Matrix<double, 3, 4> x;
  x << 0, 2, 1.6, 0.3, 0, 0, 1, 1, 0, 0, 0, 0;
  const double apex = 2 / (2 - 1.3), s = (2 - 0.3 * apex) / apex, c = -0.3;
  const double Z = apex * apex / std::pow(apex - 1, 2) * 1.65 *
                   (1 + 2. / 3 * (s * s + s * c + c * c) / (1 + nu)) / (2 * G * t);
  const MatrixElement panel = shear_panel({0, 1, 2, 3}, x, G, nu, t, 0);
  // Corner forces of a mean flow of one along edge 1-2, which its displacements then work on.
  const Vector3d d13 = x.col(2) - x.col(0), d24 = x.col(3) - x.col(1);
  const auto area = [&](int i, int j, int k) {
    return Vector3d(x.col(j) - x.col(i)).cross(Vector3d(x.col(k) - x.col(i))).norm() / 2;
  };
  const Vector3d f1 = -d13 * area(0, 1, 3) / (2 * area(0, 2, 3));
  const Vector3d f2 = d24 * area(0, 1, 2) / (2 * area(1, 2, 3));
  const double work = f1.dot(panel.K.block<3, 3>(0, 0) * f1) / f1.squaredNorm() / f1.squaredNorm();
  EXPECT_NEAR(work * 2 * Z, 1, 1e-9);
  const double beside =
      f1.dot(panel.K.block<3, 3>(0, 6) * f2) / f1.squaredNorm() / f2.squaredNorm();
  EXPECT_NEAR(beside * 2 * Z, 1, 1e-9);
  Eigen::VectorXd rigid = Eigen::VectorXd::Zero(24);
  for (int i = 0; i < 4; ++i)
    rigid.segment<3>(6 * i) = Vector3d(0.1, 0.2, 0.5).cross(Vector3d(x.col(i)));
  EXPECT_LT((panel.K * rigid).norm(), 1e-12 * panel.K.norm());
}

} // namespace
} // namespace deck_loads
} // namespace plica::test
