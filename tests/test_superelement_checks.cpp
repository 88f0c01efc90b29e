// Every export of a superelement, read back and checked as cbcheck does: rigid motions, mass,
// frequencies, statics.
#include "tests/bellows_case.hpp"
#include "tests/superelement_read_back.hpp"
#include "tests/superelement_readers.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include "io/files/files.hpp"
#include "io/write/write_superelement.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <sstream>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

void expect_same(const Checked& c, const Checked& expected, const std::string& what,
                 double mass_unit = 1, double length_unit = 1) {
  std::printf("  %-28s rigid %.1e  mass %.6f  first %.4f Hz  axial %.6g\n", what.c_str(), c.rigid,
              c.mass, c.first_hertz, c.axial);
  EXPECT_LT(c.rigid, 1e-8) << what;
  EXPECT_NEAR(c.mass / (expected.mass * mass_unit), 1, 1e-9) << what;
  EXPECT_NEAR(c.first_hertz / expected.first_hertz, 1, 1e-6) << what;
  EXPECT_NEAR(c.axial / (expected.axial * length_unit), 1, 1e-9) << what;
}

struct Exported {
  TemporaryFolder folder{"element"};
  ReducedCase reduced;
  std::string text(const char* name) const { return read_whole(folder.path / name); }
};

Case small_bellows() {
  Case data = verification_case("bellows_a", {.around = 16, .arc = 2, .wall = 2});
  data.sensors = {{.name = "wall", .at = {0, 0, 0}, .reach = 1}};
  return data;
}

std::unique_ptr<Exported> exported(const SuperelementFormat& format) {
  auto e = std::make_unique<Exported>();
  e->reduced =
      reduce_case(small_bellows(), {.cutoff = 2000, .boundary = {}}, [](const std::string&) {});
  written(e->folder.path, [&](OutputFolder& out) { write_superelement(e->reduced, format, out); });
  return e;
}

Checked own(const Superelement& s) {
  ReadBack r;
  for (std::size_t k = 0; k < s.nodes.size(); ++k) r.nodes[int(k)] = s.nodes[k];
  for (int i = 0; i < s.K.rows(); ++i) r.number.emplace(Label{0, i}, i);
  r.K = s.K;
  r.M = s.M;
  return cbcheck(r);
}

TEST(SuperelementChecks, every_export_is_the_part_again) {
  const auto e = exported({});
  const Checked part = own(e->reduced.element);
  expect_same(cbcheck(nastran(e->text("superelement.bdf"))), part, "DMIG");
  expect_same(cbcheck(abaqus(e->folder.path, e->text("superelement.inp"))), part, "MATRIX INPUT");
  const auto matrices = read_op4(e->folder.path / "superelement.op4");
  ReadBack r = nastran(e->text("superelement.bdf"));
  r.K = matrices.at("KPLICA");
  r.M = matrices.at("MPLICA");
  expect_same(cbcheck(r), part, "OUTPUT4");
  // Recovery: the rows of the matrix move the point as the superelement does.
  const RecoveryRows& rows = e->reduced.element.recovery.at(0);
  EXPECT_LT((matrices.at("OTMPLICA") - rows.rows).cwiseAbs().maxCoeff(), 1e-12);
}

// First numbers, a name, millimetres and a place: the same part there.
TEST(SuperelementChecks, numbers_names_units_and_places_fit_in) {
  SuperelementFormat format{.units = Units::millimetres};
  format.labels.first_node = 7001;
  format.labels.first_mode = 8001;
  format.labels.first_point = 9001;
  format.labels.name = "BLW";
  format.labels.axes = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  format.labels.origin = {0.1, -0.2, 0.3};
  const auto e = exported(format);
  const Checked part = own(e->reduced.element);
  const ReadBack r = nastran(e->text("superelement.bdf"));
  EXPECT_EQ(r.nodes.begin()->first, 7001);
  EXPECT_NE(e->text("superelement.bdf").find("KBLW"), std::string::npos);
  EXPECT_NE(e->text("superelement.inp").find("NSET=BLW_BOUNDARY"), std::string::npos);
  expect_same(cbcheck(r), part, "DMIG, placed, mm", 1e-3, 1e-3);
  expect_same(cbcheck(abaqus(e->folder.path, e->text("superelement.inp"))), part,
              "MATRIX INPUT, placed, mm", 1e-3, 1e-3);
  const Vector3d centre =
      1000 * (format.labels.axes * own(e->reduced.element).centre + format.labels.origin);
  EXPECT_LT((cbcheck(r).centre - centre).norm(), 1e-5);
}

// With a system of its own the matrices are those of the part, and CORD2R says where it lies.
TEST(SuperelementChecks, a_system_of_its_own_is_where_the_part_is_placed) {
  SuperelementFormat format;
  format.labels.system = 12;
  format.labels.axes = Eigen::AngleAxisd(0.3, Vector3d::UnitX()).toRotationMatrix();
  format.labels.origin = {1, 2, 3};
  const auto e = exported(format);
  const std::string deck = e->text("superelement.bdf");
  expect_same(cbcheck(nastran(deck)), own(e->reduced.element), "DMIG in CORD2R 12");
  const auto at = deck.find("CORD2R*");
  ASSERT_NE(at, std::string::npos);
  std::vector<double> fields;
  std::istringstream lines(deck.substr(at));
  std::string line;
  for (int k = 0; k < 3 && std::getline(lines, line); ++k)
    for (std::size_t f = 0; f < 4; ++f)
      if (const std::string text = cut(line, 8 + 16 * f, 16);
          text.find_first_not_of(' ') != std::string::npos)
        fields.push_back(real(text));
  ASSERT_EQ(fields.size(), 11);
  const Vector3d A(fields[2], fields[3], fields[4]), B(fields[5], fields[6], fields[7]),
      C(fields[8], fields[9], fields[10]);
  EXPECT_LT((A - format.labels.origin).norm(), 1e-12);
  EXPECT_LT((B - A - format.labels.axes.col(2)).norm(), 1e-12); // on z
  EXPECT_LT((C - A - format.labels.axes.col(0)).norm(), 1e-12); // in the plane of x and z
  EXPECT_NE(e->text("superelement.inp").find("*TRANSFORM, NSET=PLICA_BOUNDARY"), std::string::npos);
}

// As DMIG the same matrix, transposed; rigid motions of the nodes move the points rigidly, in place
// and in millimetres.
TEST(SuperelementChecks, inner_points_follow_their_matrix_as_DMIG) {
  SuperelementFormat placed{.units = Units::millimetres};
  placed.labels.first_node = 7001;
  placed.labels.name = "BLW";
  placed.labels.axes = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  placed.labels.origin = {0.1, -0.2, 0.3};
  for (const SuperelementFormat& format : {SuperelementFormat{}, placed}) {
    const auto e = exported(format);
    const std::string text = e->text("superelement_otm.bdf");
    const ReadBack points = nastran(e->text("superelement.bdf"));
    const MatrixXd rows = rectangular_dmig(text, points).transpose();
    ASSERT_EQ(rows.rows(), 6);
    const RecoveryRows& own = e->reduced.element.recovery.at(0);
    const bool moved = format.units == Units::millimetres;
    if (!moved) {
      EXPECT_LT((rows - own.rows).cwiseAbs().maxCoeff(), 1e-14 * own.rows.cwiseAbs().maxCoeff());
    }
    const Vector3d place =
        moved ? Vector3d(1000 * (format.labels.axes * own.place + format.labels.origin))
              : own.place;
    MatrixXd expected = MatrixXd::Identity(6, 6);
    for (int m = 3; m < 6; ++m)
      expected.block<3, 1>(0, m) = Vector3d(Vector3d::Unit(m - 3)).cross(place);
    const double off =
        (rows * motions_of_nodes(points) - expected).cwiseAbs().maxCoeff() / expected.norm();
    std::printf("  OTM as DMIG, %-22s rigid %.1e\n", moved ? "placed, mm" : "in SI", off);
    EXPECT_LT(off, 1e-8);
    const std::string name = moved ? "OTMBLW" : "OTMPLICA";
    EXPECT_NE(text.find("DMIG    " + name + " "), std::string::npos);
    EXPECT_NE(text.find("$ Columns 1 to 6: wall, ux uy uz rx ry rz\n"), std::string::npos);
  }
}

// The point follows by *EQUATION and MPC as by the rows.
TEST(SuperelementChecks, inner_points_follow_their_equations) {
  const auto e = exported({});
  const RecoveryRows& rows = e->reduced.element.recovery.at(0);
  std::istringstream lines(e->text("superelement_recovery.inp"));
  std::vector<double> all;
  int equations = 0;
  bool inside = false;
  std::map<int, double> of_y; // coordinate number in the file: factor, of DOF 2
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("*EQUATION")) {
      inside = true;
      ++equations;
      std::getline(lines, line);
      const auto terms = std::size_t(numbers(line).at(0));
      std::vector<double> list;
      while (list.size() < 3 * terms && std::getline(lines, line))
        for (const double x : numbers(line)) list.push_back(x);
      ASSERT_EQ(list.size(), 3 * terms);
      EXPECT_EQ(list[2], -1);
      if (list[1] == 2)
        for (std::size_t k = 3; k < list.size(); k += 3)
          of_y[int(list[k]) < 1001 ? int(6 * (list[k] - 101) + list[k + 1] - 1)
                                   : int(e->reduced.element.boundary() + list[k] - 1001)] =
              list[k + 2];
    }
  }
  EXPECT_TRUE(inside);
  EXPECT_EQ(equations, 6);
  for (long j = 0; j < rows.rows.cols(); ++j)
    EXPECT_NEAR(of_y.contains(int(j)) ? of_y[int(j)] : 0, rows.rows(1, j),
                1e-11 * rows.rows.cwiseAbs().maxCoeff())
        << j;
  const std::string mpc = e->text("superelement_recovery.bdf");
  EXPECT_NE(mpc.find("MPC*"), std::string::npos);
  EXPECT_NE(mpc.find("500001"), std::string::npos);
}

TEST(SuperelementChecks, labels_that_do_not_fit_are_refused) {
  const auto e = exported({});
  const auto refused = [&](SuperelementFormat format) {
    const TemporaryFolder folder("exchange");
    EXPECT_THROW(written(folder.path,
                         [&](OutputFolder& out) { write_superelement(e->reduced, format, out); }),
                 InputError);
  };
  SuperelementFormat format;
  format.labels.first_mode = 102; // a node
  refused(format);
  format = {};
  format.labels.name = "TOOLONG";
  refused(format);
}

// Rounding is zero in every file: no number that is below 1e-14 of its row and column.
TEST(SuperelementChecks, zero_is_written_as_zero) {
  const auto e = exported({});
  const ReadBack r = abaqus(e->folder.path, e->text("superelement.inp"));
  int kept = 0, left_out = 0;
  for (long i = 0; i < r.K.rows(); ++i)
    for (long j = 0; j < i; ++j) {
      ++(r.K(i, j) == 0 ? left_out : kept);
      if (r.K(i, j) == 0) continue;
      EXPECT_GT(std::abs(r.K(i, j)), 1e-14 * std::sqrt(r.K(i, i) * r.K(j, j)));
    }
  EXPECT_GT(kept, 0);
  EXPECT_GT(left_out, 0);
}

// Held across on one ring: it may move along and tilt about two axes through the middle of the
// ring, and the certificate asks for these.
TEST(SuperelementChecks, a_part_held_in_some_directions_has_a_certificate) {
  Case data = small_bellows();
  data.analyses.symmetry = Symmetry::off;
  data.supports = {{.set = "bellows.left", .dofs = {0, 2}}};
  data.caps.erase(data.caps.begin()); // that end is held
  const ReducedCase r =
      reduce_case(data, {.cutoff = 2000, .boundary = {}}, [](const std::string&) {});
  EXPECT_EQ(r.certificate.rigid, 3);
  EXPECT_EQ(r.certificate.zero_stiffness, 3);
  EXPECT_TRUE(r.certificate.passed)
      << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
  EXPECT_LT(r.certificate.mass, 1e-8);
}

} // namespace
} // namespace plica::test
