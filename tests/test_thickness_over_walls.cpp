// How far the thickness of a wall that is no bellows scatters over it, as the case states it.
#include "diagnose/predict/predictor.hpp"
#include "diagnose/weigh/scatter.hpp"
#include "tests/steel_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plica {
namespace {

using Eigen::VectorXd;

constexpr double plate_length = 0.3, plate_width = 0.2;

// A rectangle on four edges that nothing clamps.
Case supported_plate(std::optional<double> field) {
  Case c = steel_plate(
      {{{0, 0, 0}, {plate_length, 0, 0}, {plate_length, plate_width, 0}, {0, plate_width, 0}}},
      {24, 16});
  std::get<Plate>(c.parts[0].body).thickness_field = field;
  for (const char* along_x : {"plate.edge1", "plate.edge3"}) // no slope along an edge
    c.supports.push_back({.set = along_x, .dofs = {0, 1, 2, 4, 5}});
  for (const char* across : {"plate.edge2", "plate.edge4"})
    c.supports.push_back({.set = across, .dofs = {0, 1, 2, 3, 5}});
  c.analyses.modes = Modes{.count = 4};
  c.analyses.damping.modal = 0.01;
  return c;
}

std::vector<Hypothesis> fields_of(const Nominal& nominal) {
  const Measured none;
  std::vector<Hypothesis> found = scatter(nominal.structure(none));
  std::erase_if(found, [](const Hypothesis& h) { return h.effect != "thickness field"; });
  return found;
}

TEST(ThicknessOverWalls, is_a_field_of_the_stated_size_where_it_is_stated) {
  EXPECT_TRUE(fields_of(nominal_of(supported_plate(std::nullopt), Measured())).empty());
  constexpr double field = 0.03;
  const Nominal nominal = nominal_of(supported_plate(field), Measured());
  const std::vector<Hypothesis> own = fields_of(nominal);
  ASSERT_EQ(own.size(), 9U);
  const Mesh before = nominal.states.front().built.model.mesh;
  VectorXd square = VectorXd::Zero(Eigen::Index(before.quads.size()));
  for (const Hypothesis& h : own) {
    Model changed = nominal.states.front().built.model;
    h.changes[1].apply(changed); // by twice its standard deviation
    for (std::size_t q = 0; q < before.quads.size(); ++q)
      square[Eigen::Index(q)] += std::pow(
          (changed.mesh.quads[q].thickness.mean() / before.quads[q].thickness.mean() - 1) / 2, 2);
  }
  EXPECT_NEAR(std::sqrt(square.mean()), field, 1e-9);
}

// Of few elements as well, down to one, whose thickness is one number.
TEST(ThicknessOverWalls, is_there_on_a_coarse_mesh) {
  constexpr double field = 0.03;
  for (const std::array<int, 2>& elements : {std::array{1, 1}, {2, 1}, {1, 2}, {3, 1}}) {
    Case c = supported_plate(field);
    std::get<Plate>(c.parts[0].body).elements = elements;
    c.supports.resize(1); // one side of it free
    const BuiltCase built = build(c);
    const Measured none;
    std::vector<Hypothesis> own = scatter({.data = c, .built = built, .measured = none});
    std::erase_if(own, [](const Hypothesis& h) { return h.effect != "thickness field"; });
    ASSERT_FALSE(own.empty()) << elements[0] << elements[1];
    double square = 0;
    for (const Hypothesis& h : own) {
      Model changed = built.model;
      h.changes[1].apply(changed);
      for (std::size_t q = 0; q < changed.mesh.quads.size(); ++q)
        square +=
            std::pow(changed.mesh.quads[q].thickness[0] / built.model.mesh.quads[q].thickness[0] -
                         1,
                     2) /
            4;
    }
    EXPECT_NEAR(std::sqrt(square / double(built.model.mesh.quads.size())), field, 1e-9);
  }
}

// Rayleigh's quotient of the first mode sin(pi x / a) sin(pi y / b) of Navier's plate, by a
// relative field f of thickness: bending goes with 1 + 3 f, mass with 1 + f.
double slope_in_closed_form(const std::function<double(double, double)>& f) {
  constexpr double a = plate_length, b = plate_width, nu = 0.3, pi = std::numbers::pi;
  double stiff = 0, mass = 0, stiff_f = 0, mass_f = 0;
  constexpr int n = 200;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = (i + 0.5) / n, y = (j + 0.5) / n;
      const double w = std::sin(pi * x) * std::sin(pi * y), wxx = -w / (a * a), wyy = -w / (b * b),
                   wxy = std::cos(pi * x) * std::cos(pi * y) / (a * b);
      const double energy = std::pow(wxx + wyy, 2) - 2 * (1 - nu) * (wxx * wyy - wxy * wxy);
      stiff += energy;
      stiff_f += 3 * f(x, y) * energy;
      mass += w * w;
      mass_f += f(x, y) * w * w;
    }
  return stiff_f / stiff - mass_f / mass;
}

// Along both directions and over both; odd half waves move it by nothing.
TEST(ThicknessOverWalls, moves_a_frequency_as_in_closed_form) {
  const Nominal nominal = nominal_of(supported_plate(0.03), Measured());
  const std::vector<Hypothesis> own = fields_of(nominal);
  ASSERT_EQ(own.size(), 9U);
  const auto waves = [](double at, int k) { return std::cos(std::numbers::pi * k * at); };
  struct Shape {
    std::size_t number;
    int along, across;
  };
  // In the order of thickness_fields: (1,0) (0,1) (2,0) (1,1) (0,2) ...
  for (const Shape& s : {Shape{2, 2, 0}, {3, 1, 1}, {4, 0, 2}}) {
    const double size = std::sqrt(s.along > 0 ? 2 : 1) * std::sqrt(s.across > 0 ? 2 : 1);
    const double expected = slope_in_closed_form(
        [&](double x, double y) { return size * waves(x, s.along) * waves(y, s.across); });
    const Predictor predict(nominal, TestReadings(), {&own[s.number]});
    const auto lambda = [&](double v) {
      return predict.modes(VectorXd::Constant(1, v))->lambda[0];
    };
    constexpr double step = 0.01;
    const double slope = (lambda(step) - lambda(-step)) / (2 * step * lambda(0));
    EXPECT_NEAR(slope, expected, 0.04 * std::max(std::abs(expected), 1.)) << s.along << s.across;
  }
}

} // namespace
} // namespace plica
