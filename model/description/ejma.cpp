#include "model/description/ejma.hpp"

#include "model/description/profile.hpp"
#include "words/short_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace plica {
namespace {

using std::numbers::pi;

constexpr int levels = 13;
using Table = std::array<std::array<double, 6>, levels>; // a0 .. a5 at each C2

constexpr std::array<double, levels> C2_levels{0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4,
                                               1.6, 2.0, 2.5, 3.0, 3.5, 4.0};

constexpr Table cf{{{1.006, 2.375, -3.977, 8.297, -8.394, 3.194},
                    {1.007, 1.820, -1.818, 2.981, -2.430, 0.870},
                    {1.003, 1.993, -5.055, 12.896, -14.429, 5.897},
                    {1.003, 1.338, -1.717, 1.908, 0.020, -0.550},
                    {0.997, 0.621, -0.907, 2.429, -2.901, 1.361},
                    {1.000, 0.112, -1.410, 3.483, -3.044, 1.013},
                    {1.000, -0.285, -1.309, 3.662, -3.467, 1.191},
                    {1.001, -0.494, -1.879, 4.959, -4.569, 1.543},
                    {1.002, -1.061, -0.715, 3.103, -3.016, 0.990},
                    {1.000, -1.310, -0.829, 4.116, -4.360, 1.550},
                    {0.999, -1.521, -0.039, 2.121, -2.215, 0.770},
                    {0.998, -1.896, 1.839, -2.047, 1.852, -0.664},
                    {1.000, -2.007, 1.620, -0.538, -0.261, 0.249}}};
constexpr Table cd{{{1.000, 1.151, 1.685, -4.414, 4.564, -1.645},
                    {0.999, 1.310, 0.909, -2.407, 2.273, -0.706},
                    {1.003, 2.189, -3.192, 5.928, -5.576, 2.070},
                    {1.005, 1.263, 5.184, -13.929, 13.828, -4.830},
                    {1.001, 0.953, 3.924, -8.773, 10.440, -4.749},
                    {1.002, 0.602, 2.110, -3.625, 5.166, -2.312},
                    {0.998, 0.309, 1.135, -1.040, 1.296, -0.087},
                    {0.999, 0.120, 0.351, -0.178, 0.942, -0.115},
                    {1.000, -0.133, -0.460, 1.596, -1.521, 0.877},
                    {1.000, -0.323, -1.118, 3.730, -4.453, 2.055},
                    {1.000, -0.545, -0.420, 1.457, -1.561, 0.710},
                    {1.000, -0.704, -0.179, 0.946, -1.038, 0.474},
                    {1.001, -0.955, 0.577, -0.462, 0.181, 0.080}}};
constexpr Table cp_low{{{1.001, -0.448, -1.244, 1.932, -0.398, -0.291},
                        {0.999, -0.735, 0.106, -0.585, 1.787, -1.022},
                        {0.961, -1.146, 3.023, -7.488, 8.824, -3.634},
                        {0.955, -2.708, 7.279, 14.212, -104.242, 133.333},
                        {0.950, -2.524, 10.402, -93.848, 423.636, -613.333},
                        {0.950, -2.296, 1.630, 16.030, -113.939, 240.000},
                        {0.950, -2.477, 7.823, -49.394, 141.212, -106.667},
                        {0.950, -2.027, -5.264, 48.303, -139.394, 160.000},
                        {0.950, -2.073, -3.622, 29.136, -49.394, 13.333},
                        {0.950, -2.073, -3.622, 29.136, -49.394, 13.333},
                        {0.950, -2.073, -3.622, 29.136, -49.394, 13.333},
                        {0.950, -2.073, -3.622, 29.136, -49.394, 13.333},
                        {0.950, -2.073, -3.622, 29.136, -49.394, 13.333}}};
constexpr Table cp_high{{{1.001, -0.448, -1.244, 1.932, -0.398, -0.291},
                         {0.999, -0.735, 0.106, -0.585, 1.787, -1.022},
                         {0.961, -1.146, 3.023, -7.488, 8.824, -3.634},
                         {0.622, 1.685, -9.347, 18.447, -15.991, 5.119},
                         {0.201, 2.317, -5.956, 7.594, -4.945, 1.299},
                         {0.598, -0.990, 3.741, -6.453, 5.107, -1.527},
                         {0.473, -0.029, -0.015, -0.030, 0.016, 0.016},
                         {0.477, -0.146, -0.018, 0.037, 0.097, -0.067},
                         {0.935, -3.613, 9.456, -13.228, 9.355, -2.613},
                         {1.575, -8.646, 24.368, -35.239, 25.313, -7.157},
                         {1.464, -7.098, 17.875, -23.778, 15.953, -4.245},
                         {1.495, -6.904, 16.024, -19.600, 12.069, -2.944},
                         {2.037, -11.037, 28.276, -37.655, 25.213, -6.716}}};

double interpolated(const Table& table, double C1, double C2) {
  const auto above = std::lower_bound(C2_levels.begin() + 1, C2_levels.end() - 1, C2);
  const auto i = above - C2_levels.begin();
  const auto polynomial = [&](const std::array<double, 6>& a) {
    return a[0] + C1 * (a[1] + C1 * (a[2] + C1 * (a[3] + C1 * (a[4] + C1 * a[5]))));
  };
  const double share = (C2 - C2_levels[i - 1]) / (C2_levels[i] - C2_levels[i - 1]);
  return (1 - share) * polynomial(table[i - 1]) + share * polynomial(table[i]);
}

void check_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument("EJMA coefficients: " + std::string(name) + " = " +
                              short_text(value, 6) + " lies outside " + short_text(low) + " to " +
                              short_text(high));
}

// Root i of cosh(b) cos(b) = 1: the clamped Euler beam.
double clamped_beam_root(int i) {
  double b = (2 * i + 1) * pi / 2;
  for (int step = 0; step < 20; ++step) // of cos(b) - 1/cosh(b), which does not overflow
    b -= (std::cos(b) - 1 / std::cosh(b)) / (-std::sin(b) + std::tanh(b) / std::cosh(b));
  return b;
}

// Why the formulas do not take a profile; empty = they do.
std::string foreign_profile(const Bellows& bellows, const MeridianSection*& first) {
  for (const MeridianSection& s : bellows.profile) {
    if (s.shape == SectionShape::cuff) {
      const double end = s.end_radius;
      if (end > 0 && std::abs(end - bellows.root_radius) > 1e-9 * end)
        return "a straight end is a cone";
      continue;
    }
    if (s.shape != SectionShape::u) return "its convolutions are no U";
    if (!first) first = &s;
    if (s.height != first->height || s.pitch != first->pitch ||
        root_arc_radius(s) != root_arc_radius(*first) ||
        crown_arc_radius(s) != crown_arc_radius(*first))
      return "its convolutions differ";
  }
  return first ? "" : "it has no convolutions";
}

double shorter_end(const Bellows& bellows) {
  const auto length = [](const MeridianSection& s) {
    return s.shape == SectionShape::cuff ? s.length : 0;
  };
  return std::min(length(bellows.profile.front()), length(bellows.profile.back()));
}

} // namespace

std::variant<EjmaBellows, std::string> ejma_bellows(const Bellows& bellows,
                                                    const Material& material) {
  const MeridianSection* u = nullptr;
  if (std::string why = foreign_profile(bellows, u); !why.empty()) return why;
  const std::vector<double>& plies = bellows.wall.plies;
  const bool one_wall = bellows.wall.bond == 1 && !bellows.wall.slip;
  const auto [thin, thick] = std::minmax_element(plies.begin(), plies.end());
  if (!one_wall && *thick > 1.001 * *thin) return "its plies differ in thickness";
  const double t = total_thickness(bellows.wall);
  return EjmaBellows{.inner_diameter = 2 * bellows.root_radius - t,
                     .depth = u->height,
                     .pitch = u->pitch,
                     .torus_radius = (root_arc_radius(*u) + crown_arc_radius(*u)) / 2,
                     .thickness = one_wall ? t : plies.front(),
                     .plies = one_wall ? 1 : static_cast<int>(plies.size()),
                     .convolutions = convolutions(bellows),
                     .E = material.E,
                     .nu = material.nu,
                     .thinned = bellows.wall.thinning != Thinning::none,
                     .tangent = shorter_end(bellows)};
}

double ejma_length(const EjmaBellows& b) {
  return b.convolutions * b.pitch;
}

double ejma_metal_area(const EjmaBellows& b) {
  return b.plies * ejma_ply(b) * (0.571 * b.pitch + 2 * b.depth);
}

double ejma_mean_diameter(const EjmaBellows& b) {
  return b.inner_diameter + b.depth + b.plies * b.thickness;
}

double ejma_ply(const EjmaBellows& b) {
  return b.thinned ? b.thickness * std::sqrt(b.inner_diameter / ejma_mean_diameter(b))
                   : b.thickness;
}

EjmaFactors ejma_factors(double C1, double C2) {
  check_range("C1", C1, 0, 1);
  check_range("C2", C2, C2_levels.front(), C2_levels.back());
  return {.C1 = C1,
          .C2 = C2,
          .Cp = interpolated(C1 <= 0.3 ? cp_low : cp_high, C1, C2),
          .Cf = interpolated(cf, C1, C2),
          .Cd = interpolated(cd, C1, C2)};
}

EjmaFactors ejma_factors(const EjmaBellows& b) {
  const double rm = b.torus_radius > 0 ? b.torus_radius : b.pitch / 4;
  return ejma_factors(2 * rm / b.depth, 1.82 * rm / std::sqrt(ejma_mean_diameter(b) * ejma_ply(b)));
}

double ejma_convolution_stiffness(const EjmaBellows& b, const EjmaFactors& c) {
  return 1.7 * ejma_mean_diameter(b) * b.E * b.plies * std::pow(ejma_ply(b) / b.depth, 3) / c.Cf;
}

EjmaStress ejma_stress(const EjmaBellows& b, const EjmaFactors& c, double P, double e, double Kr) {
  const double tp = ejma_ply(b), slender = b.depth / tp, wall = b.plies * b.thickness;
  EjmaStress s;
  if (b.tangent > 0) s.S1 = P * (b.inner_diameter + wall) / (2 * wall);
  s.S2 = P * b.pitch * ejma_mean_diameter(b) * Kr / (2 * ejma_metal_area(b));
  s.S3 = P * slender / (2 * b.plies);
  s.S4 = P * slender * slender * c.Cp / (2 * b.plies);
  s.S5 = b.E * tp * tp * e / (2 * std::pow(b.depth, 3) * c.Cf);
  s.S6 = 5 * b.E * tp * e / (3 * b.depth * b.depth * c.Cd);
  s.St = 0.7 * (s.S3 + s.S4) + s.S5 + s.S6;
  return s;
}

EjmaEquivalent ejma_equivalent(const EjmaBellows& b, const EjmaMovement& m) {
  const double Dm = ejma_mean_diameter(b), N = b.convolutions, length = ejma_length(b) + m.axial;
  if (!(length > 0))
    throw std::invalid_argument("an axial movement of " + short_text(1e3 * m.axial, 6) +
                                " mm takes up the length of " +
                                short_text(1e3 * ejma_length(b), 6) + " mm");
  return {.axial = std::abs(m.axial) / N,
          .lateral = 3 * Dm * std::abs(m.lateral) / (N * length),
          .angular = Dm * std::abs(m.angular) / (2 * N)};
}

double ejma_column_squirm(const EjmaBellows& b, const EjmaFactors& c) {
  return 0.34 * pi * ejma_convolution_stiffness(b, c) / (b.convolutions * ejma_length(b));
}

double ejma_in_plane_squirm(const EjmaBellows& b, const EjmaFactors& c, double yield, double Kr) {
  const EjmaStress of_unit = ejma_stress(b, c, 1, 0, Kr);
  const double d = of_unit.S4 / (3 * of_unit.S2), d2 = d * d;
  const double alpha = 1 + 2 * d2 + std::sqrt(1 - 2 * d2 + 4 * d2 * d2);
  return 1.3 * ejma_metal_area(b) * yield /
         (Kr * ejma_mean_diameter(b) * b.pitch * std::sqrt(alpha));
}

double ejma_angular_stiffness(double K, double Dm) {
  return K * Dm * Dm / 8;
}

double ejma_lateral_stiffness(double K, double Dm, double L) {
  return 1.5 * K * (Dm / L) * (Dm / L);
}

double ejma_torsion_stiffness(const EjmaBellows& b) {
  const double G = b.E / (2 * (1 + b.nu));
  return pi * G * b.plies * b.thickness * std::pow(b.inner_diameter, 3) /
         (4 * b.convolutions * (0.571 * b.pitch + 2 * b.depth));
}

double ejma_axial_frequency(int i, int N, double K, double M) {
  if (i < 1 || i > 2 * N - 1)
    throw std::invalid_argument("a chain of " + std::to_string(2 * N) +
                                " half convolutions has no axial mode " + std::to_string(i));
  return 2 * N / pi * std::sin(i * pi / (4 * N)) * std::sqrt(K / M);
}

LateralFrequency ejma_lateral_frequency(int i, double Dm, double L, double K, double M) {
  if (i < 1)
    throw std::invalid_argument("lateral modes are counted from 1, not " + std::to_string(i));
  const double b = clamped_beam_root(i);
  // Ratio of the combinations of the Euler mode, (cosh - cos) / (sinh - sin).
  const double ratio =
      (1 - std::cos(b) / std::cosh(b)) / (std::tanh(b) - std::sin(b) / std::cosh(b));
  const double slope = ratio * b * (ratio * b - 2) / (L * L); // int phi'^2 / int phi^2
  const double f = b * b / (2 * pi * std::sqrt(8.)) * Dm / L * std::sqrt(K / M);
  return {f, f / std::sqrt(1 + Dm * Dm / 8 * slope)};
}

} // namespace plica
