// How far the thickness of a wall scatters along it, as the case states it.
#include "diagnose/predict/predictor.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "io/files/files.hpp"
#include "io/input/case_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "words/input_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plica::test {
namespace {

using Eigen::VectorXd;

constexpr double length = 0.6, radius = 0.01, thickness = 1e-3;

// A round wall between two held caps: a straight tube, or convolutions from end to end.
Case wall_of(const MeridianSection& section, double ply, std::optional<double> field) {
  Bellows wall;
  wall.material = "steel";
  wall.root_radius = radius;
  wall.profile = {section};
  wall.wall.plies = {ply};
  wall.wall.thickness_field = field;
  wall.mesh = {.around = 12, .arc = 2, .wall = 2};
  Case c;
  c.name = "wall";
  c.materials["steel"] = {.E = 200e9, .nu = 0.3, .rho = 7850};
  c.parts = {{"wall", wall}};
  c.caps = {{.name = "left", .of = {"wall.left"}}, {.name = "right", .of = {"wall.right"}}};
  c.mount = {{.cap = "left"}, {.cap = "right"}};
  c.analyses.damping.modal = 0.01;
  return c;
}

Case tube(std::optional<double> field) {
  MeridianSection straight;
  straight.shape = SectionShape::cuff;
  straight.length = length;
  straight.elements = 60;
  return wall_of(straight, thickness, field);
}

Case convolutions(std::optional<double> field, double ply = 0.2e-3) {
  MeridianSection u;
  u.count = 8;
  u.height = 4e-3;
  u.pitch = 4e-3;
  return wall_of(u, ply, field);
}

std::vector<Hypothesis> fields_of(const Nominal& nominal, const std::string& what) {
  const Measured none;
  std::vector<Hypothesis> found = scatter(nominal.structure(none));
  std::erase_if(found, [&](const Hypothesis& h) { return h.effect != what; });
  return found;
}

TEST(WallScatter, stands_in_place_of_the_field_of_stiffness_where_it_is_stated) {
  const auto count = [](std::optional<double> field, const std::string& what) {
    const Case data = convolutions(field);
    return fields_of(nominal_of(data, Measured()), what).size();
  };
  EXPECT_EQ(count(std::nullopt, "stiffness field"), 4U);
  EXPECT_EQ(count(std::nullopt, "thickness field"), 0U);
  EXPECT_EQ(count(0.02, "stiffness field"), 0U);
  EXPECT_EQ(count(0.02, "thickness field"), 4U);
  EXPECT_EQ(count(0., "stiffness field") + count(0., "thickness field"), 0U);
}

// Half a cosine from end to end leaves the mass as it is and moves its centre by
//   a L int_0^1 (s - 1/2) cos(pi s) ds = -2 a L / pi^2
// and the mean square of all four is the one that is stated.
TEST(WallScatter, is_a_field_of_thickness_of_the_stated_size) {
  constexpr double field = 0.03;
  const Nominal nominal = nominal_of(tube(field), Measured());
  const std::vector<Hypothesis> own = fields_of(nominal, "thickness field");
  ASSERT_EQ(own.size(), 4U);
  double square = 0;
  for (const Hypothesis& h : own) square += std::pow(h.parameters[0].prior.width, 2) / 2;
  EXPECT_NEAR(std::sqrt(square), field, 1e-12);

  Model changed = nominal.states.front().built.model;
  const Mesh before = changed.mesh;
  own[0].changes[1].apply(changed); // by twice its standard deviation
  const double a = 2 * own[0].parameters[0].prior.width;
  double sum = 0, moment = 0, all = 0;
  for (std::size_t q = 0; q < before.quads.size(); ++q) {
    double y = 0;
    for (int node : before.quads[q].nodes) y += before.nodes[std::size_t(node)].y() / 4;
    const double own_t = before.quads[q].thickness.mean(),
                 more = changed.mesh.quads[q].thickness.mean() - own_t;
    EXPECT_NEAR(more / own_t, a * std::cos(std::numbers::pi * y / length), 1e-9);
    sum += more;
    moment += more * (y - length / 2);
    all += own_t;
  }
  EXPECT_NEAR(sum / all, 0, 1e-9);
  EXPECT_NEAR(moment / all, -2 * a * length / std::pow(std::numbers::pi, 2), 1e-3 * a * length);
}

// A thin tube bends as a beam whose EI and mass both go with t: Rayleigh's quotient of the first
// mode phi of a beam clamped at both ends has, by a cosine c of one wave,
//   d lambda / lambda = a (int c phi''^2 / int phi''^2 - int c phi^2 / int phi^2)
TEST(WallScatter, moves_a_frequency_as_membrane_and_mass_do) {
  constexpr double root = 4.730040745, share = 0.982502215;
  double stiff = 0, mass = 0, stiff_c = 0, mass_c = 0;
  constexpr int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n, x = root * s, c = std::cos(2 * std::numbers::pi * s);
    const double phi = std::cosh(x) - std::cos(x) - share * (std::sinh(x) - std::sin(x));
    const double curved = std::cosh(x) + std::cos(x) - share * (std::sinh(x) + std::sin(x));
    stiff += curved * curved / n;
    stiff_c += c * curved * curved / n;
    mass += phi * phi / n;
    mass_c += c * phi * phi / n;
  }
  const double expected = stiff_c / stiff - mass_c / mass;
  const Nominal nominal = nominal_of(tube(0.03), Measured());
  const Hypothesis one_wave = fields_of(nominal, "thickness field")[1];
  const Predictor predict(nominal, TestReadings(), {&one_wave});
  const auto lambda = [&](double a) { return predict.modes(VectorXd::Constant(1, a))->lambda[0]; };
  constexpr double a = 0.01;
  const double slope = (lambda(a) - lambda(-a)) / (2 * a * lambda(0));
  EXPECT_NEAR(slope, expected, 0.04 * expected);
}

double axial_stiffness(const Nominal& nominal, const std::vector<const Hypothesis*>& acts,
                       const VectorXd& values) {
  TestReadings test;
  Reading k;
  k.kind = ReadingKind::stiffness;
  k.direction = StaticDirection::axial;
  test.readings = {k};
  return std::exp((*Predictor(nominal, test, acts)(values))[0]);
}

// Convolutions in series, each of k ~ t^p: bending would be p = 3, membrane 1. By a cosine of the
// size a the compliance is the mean of (1 + a c)^-p, the stiffness 1 / (1 + p (p + 1) a^2 / 4).
// p is that of cases drawn thinner and thicker.
TEST(WallScatter, softens_convolutions_in_series_as_thin_ones_bend) {
  const auto drawn = [](double ply) {
    return axial_stiffness(nominal_of(convolutions(0.1, ply), Measured()), {}, VectorXd());
  };
  constexpr double ply = 0.2e-3;
  const double p = std::log(drawn(1.05 * ply) / drawn(0.95 * ply)) / std::log(1.05 / 0.95);
  EXPECT_GT(p, 2);
  EXPECT_LT(p, 3);
  const Nominal nominal = nominal_of(convolutions(0.1), Measured());
  const Hypothesis waves = fields_of(nominal, "thickness field")[2];
  constexpr double a = 0.12;
  const double ratio = axial_stiffness(nominal, {&waves}, VectorXd::Constant(1, a)) /
                       axial_stiffness(nominal, {}, VectorXd());
  EXPECT_NEAR(1 / ratio - 1, p * (p + 1) * a * a / 4, 0.2 * p * (p + 1) * a * a / 4);
}

TEST(WallScatter, is_a_number_of_the_wall_without_a_tolerance_of_its_own) {
  const auto problem = [](const std::string& field) -> std::string {
    const TemporaryFolder folder("wall");
    const std::filesystem::path path = folder.path / "case.yaml";
    write_whole(path, "case: wall\n"
                      "materials: {steel: {E: 200 GPa, nu: 0.3, rho: 7850}}\n"
                      "parts:\n"
                      "  wall:\n"
                      "    type: bellows\n"
                      "    material: steel\n"
                      "    root_radius: 20 mm\n"
                      "    profile: [{shape: cuff, length: 0.1}]\n"
                      "    wall: {plies: [1 mm], thickness_field: " +
                          field + "}\n");
    try {
      const Case data = read_case(path.string()).data;
      return std::to_string(*std::get<Bellows>(data.parts[0].body).wall.thickness_field);
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(problem("3 %"), std::to_string(0.03));
  const std::string key = "case.yaml:9: parts.wall.wall.thickness_field: ";
  EXPECT_NE(problem("50 %").find(key), std::string::npos) << problem("50 %");
  EXPECT_NE(problem("3 % +- 1 %").find(key + "takes no tolerance"), std::string::npos)
      << problem("3 % +- 1 %");
}

} // namespace
} // namespace plica::test
