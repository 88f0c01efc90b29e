// Every export of a superelement, read by small readers of its own after the published formats, and
// checked as cbcheck does: rigid motions, mass, frequencies, statics.
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include "io/files/files.hpp"
#include "io/write/write_superelement.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace plica::test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Label = std::pair<int, int>; // point, DOF

// What a program knows after reading a deck.
struct ReadBack {
  std::map<int, Vector3d> nodes;
  std::map<Label, int> number; // of each coordinate: nodes first, by number
  MatrixXd K, M;
};

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
void put(MatrixXd& A, int i, int j, double x) {
  A(i, j) += x;
  if (i != j) A(j, i) += x;
}

// GRID*, SPOINT, DMIG* in columns of sixteen; matrices whose names begin alike are added.
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

// Rectangular DMIG by the numbers of their columns, those of the file added; rows as in `points`.
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

// *NODE and the files of *MATRIX INPUT: node, DOF, node, DOF, value.
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

// Dense OUTPUT4 text: three numbers of 23 columns a line.
std::map<std::string, MatrixXd> op4(const std::string& text) {
  std::map<std::string, MatrixXd> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const int columns = std::stoi(cut(line, 0, 8)), rows = std::stoi(cut(line, 8, 8));
    std::string name = cut(line, 32, 8);
    std::erase(name, ' ');
    MatrixXd A = MatrixXd::Zero(rows, columns);
    while (std::getline(lines, line)) {
      const int column = std::stoi(cut(line, 0, 8)), first = std::stoi(cut(line, 8, 8)),
                count = std::stoi(cut(line, 16, 8));
      for (int k = 0; k < count; ++k) {
        if (k % 3 == 0) std::getline(lines, line);
        if (column <= columns)
          A(first - 1 + k, column - 1) = std::stod(cut(line, 23 * std::size_t(k % 3), 23));
      }
      if (column > columns) break;
    }
    all[name] = A;
  }
  return all;
}

struct Checked {
  double rigid = 0, mass = 0, first_hertz = 0, axial = 0;
  Vector3d centre{0, 0, 0};
};

// Motion of the nodes, the modal coordinates at rest, about the origin.
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

// Rigid motions of the nodes about the origin; mass and centre by them; first elastic frequency;
// static stiffness of the second node along the line between both.
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
  const auto matrices = op4(e->text("superelement.op4"));
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
  for (long i = 0; i < r.K.rows(); ++i)
    for (long j = 0; j < i; ++j) {
      if (r.K(i, j) == 0) continue;
      EXPECT_GT(std::abs(r.K(i, j)), 1e-14 * std::sqrt(r.K(i, i) * r.K(j, j)));
    }
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
