// A clamped plate by Kirchhoff's theory and Ritz's method: products of Legendre polynomials, the
// clamp as springs along its edge.
#include "line_structures.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace sealed {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int degree = 9, points = 16, per_axis = degree + 1;
struct Sensor {
  const char* name;
  double x, y;
};
constexpr std::array sensors{Sensor{"p1", 0.15, 0.05},  Sensor{"p2", 0.15, 0.15},
                             Sensor{"p3", 0.225, 0.10}, Sensor{"p4", 0.3, 0.},
                             Sensor{"p5", 0.3, 0.1},    Sensor{"p6", 0.3, 0.2}};

constexpr double nu = steel::nu;

// Values, first and second derivatives of P_n in x = 2 s - 1, by s.
struct Polynomials {
  VectorXd value, slope, curvature;
};
Polynomials polynomials(double s) {
  const double x = 2 * s - 1;
  Polynomials p{VectorXd(per_axis), VectorXd(per_axis), VectorXd(per_axis)};
  VectorXd second = VectorXd::Zero(per_axis);
  for (int n = 0; n < per_axis; ++n) {
    p.value[n] = boost::math::legendre_p(n, x);
    p.slope[n] = n == 0 ? 0 : boost::math::legendre_p_prime(n, x);
    // P''_n = P''_(n-2) + (2n - 1) P'_(n-1)
    if (n >= 2) second[n] = second[n - 2] + (2 * n - 1) * p.slope[n - 1];
  }
  p.slope *= 2;
  p.curvature = 4 * second;
  return p;
}

VectorXd product(const VectorXd& a, const VectorXd& b) {
  VectorXd all(a.size() * b.size());
  for (Index i = 0; i < a.size(); ++i) all.segment(i * b.size(), b.size()) = a[i] * b;
  return all;
}

struct Points {
  std::array<double, points> s, weight;
};
Points gauss() {
  using Rule = boost::math::quadrature::gauss<double, points>;
  Points p{};
  for (int i = 0; i < points / 2; ++i) {
    const double a = Rule::abscissa()[std::size_t(i)], w = Rule::weights()[std::size_t(i)];
    p.s[std::size_t(2 * i)] = (1 + a) / 2;
    p.s[std::size_t(2 * i + 1)] = (1 - a) / 2;
    p.weight[std::size_t(2 * i)] = p.weight[std::size_t(2 * i + 1)] = w / 2;
  }
  return p;
}

class Plate final : public ChangedStructure {
public:
  explicit Plate(const PlateShape& shape)
      : lx(shape.length), ly(shape.width), thickness(shape.thickness),
        sensor_mass_(shape.sensor_mass) {}
  std::string name() const override { return "plate"; }
  double damping() const override { return 0.004; }
  double length() const override { return lx; }
  std::vector<std::string> labels() const override {
    std::vector<std::string> all;
    for (int k = 1; k <= 7; ++k)
      all.push_back(fmt::format("shape: other, direction: z, order: {}", k));
    return all;
  }
  std::vector<std::string> channels(std::size_t /*mode*/) const override {
    std::vector<std::string> all;
    for (const Sensor& sensor : sensors) all.push_back(std::string(sensor.name) + ".z");
    return all;
  }
  FoundModes modes(const Mechanism& m, const Effect& change) const override {
    const Index n = per_axis * per_axis;
    Matrices of{.K = MatrixXd::Zero(n, n), .M = MatrixXd::Zero(n, n)};
    const Points rule = gauss();
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j) add_wall(m, rule, i, j, of);
    add_clamp(m, change, rule, of);
    const MatrixXd seen = add_sensors(change, of);
    if (change.name == "added_mass" && change.place == "plate") {
      const VectorXd w = product(polynomials(change.value.at("at") / lx).value,
                                 polynomials(change.value.at("across") / ly).value);
      of.M += change.value.at("mass") * w * w.transpose();
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(of.K, of.M);
    constexpr double turn = 2 * std::numbers::pi;
    constexpr int count = 7;
    FoundModes found{.frequencies = eigen.eigenvalues().head(count).cwiseSqrt() / turn};
    for (Index k = 0; k < count; ++k) found.shapes.emplace_back(seen * eigen.eigenvectors().col(k));
    return found;
  }
  Change draw_change(Draws& draws) const override {
    if (draws.below(3) == 0)
      return {.effect = {"boundary_compliance", "mount.clamp", {}},
              .size = "k_rotation",
              .smallest = 1e-8,
              .largest = 0.01,
              .inverse = true};
    Effect mass{"added_mass", "plate", {}};
    if (draws.below(2) == 0)
      mass.place = std::string("sensor.") + sensors[std::size_t(draws.below(6))].name;
    else // off the clamp, where nothing moves
      mass.value = {{"at", draws.between(0.3, 1) * lx}, {"across", draws.between(0, 1) * ly}};
    return {.effect = mass, .size = "mass", .smallest = 1e-5, .largest = 0.25};
  }
  bool alike(const std::string& effect, const std::string& place, const std::string& other_effect,
             const std::string& other_place) const override { // the middle line divides it evenly
    if (place == "plate") return false;                       // its point says where
    const auto side = [](const std::string& at) {
      for (const auto* pair : {"p1p2", "p4p6"})
        if (const auto k = std::string(pair).find(at.substr(at.find('.') + 1));
            k != std::string::npos)
          return std::string(pair);
      return at;
    };
    return effect == other_effect && side(place) == side(other_place);
  }
  std::vector<double> point(const std::string& place) const override {
    if (place == "plate") return {0, 0};
    for (const Sensor& sensor : sensors)
      if (place == std::string("sensor.") + sensor.name) return {sensor.x, sensor.y};
    return {};
  }
  std::vector<double> mirrored(std::vector<double> point) const override {
    point[1] = ly - point[1];
    return point;
  }

private:
  struct Matrices {
    MatrixXd K, M;
  };
  double along(const Mechanism& m) const { return lx + (m.name == "places" ? m.amount : 0); }

  // The wall around one point of the rule.
  void add_wall(const Mechanism& m, const Points& rule, int i, int j, Matrices& of) const {
    const double sx = rule.s[std::size_t(i)], sy = rule.s[std::size_t(j)];
    const double along = this->along(m), across = ly;
    const Polynomials px = polynomials(sx), py = polynomials(sy);
    const double weight =
        rule.weight[std::size_t(i)] * rule.weight[std::size_t(j)] * along * across;
    double t = thickness, mass = 0, stiff = 1;
    if (m.name == "taper")
      t *= 1 + m.amount * (smooth_field(m.seed, sx) + smooth_field(m.seed + 1, sy)) / 2;
    if (m.name == "cables" && sx > 0.3 && sy > 0.4 && sy < 0.8)
      mass = m.amount * steel::rho * thickness;
    if (m.name == "theory") stiff += m.amount; // rolled: stiffer along than across
    const double D = steel::E * t * t * t / 12 / (1 - nu * nu);
    const VectorXd w = product(px.value, py.value),
                   wxx = product(px.curvature, py.value) / (along * along),
                   wyy = product(px.value, py.curvature) / (across * across),
                   wxy = product(px.slope, py.slope) / (along * across);
    of.K += weight * D *
            (stiff * wxx * wxx.transpose() + wyy * wyy.transpose() +
             nu * (wxx * wyy.transpose() + wyy * wxx.transpose()) +
             2 * (1 - nu) * wxy * wxy.transpose());
    of.M += weight * (steel::rho * t + mass) * w * w.transpose();
  }

  // Along the edge, N/m2 and N m/rad per m.
  void add_clamp(const Mechanism& m, const Effect& change, const Points& rule, Matrices& of) const {
    const double own = steel::E * std::pow(thickness, 3) / 12, rigid = 1e5 * own / std::pow(lx, 3);
    double compliance = 1e-5 * lx / own;
    if (m.name == "boundary") compliance += m.amount * lx / own;
    if (change.name == "boundary_compliance") compliance += ly / change.value.at("k_rotation");
    const Polynomials edge = polynomials(0);
    for (int j = 0; j < points; ++j) {
      const Polynomials py = polynomials(rule.s[std::size_t(j)]);
      const VectorXd w = product(edge.value, py.value),
                     turn = product(edge.slope, py.value) / along(m);
      of.K += rule.weight[std::size_t(j)] * ly *
              (rigid * w * w.transpose() + turn * turn.transpose() / compliance);
    }
  }

  // Their masses, too; returns what they see, sensors x polynomials.
  MatrixXd add_sensors(const Effect& change, Matrices& of) const {
    MatrixXd seen(Index(sensors.size()), of.M.rows());
    for (std::size_t k = 0; k < sensors.size(); ++k) {
      const Sensor& sensor = sensors[k];
      const VectorXd w =
          product(polynomials(sensor.x / lx).value, polynomials(sensor.y / ly).value);
      seen.row(Index(k)) = w;
      double mass = sensor_mass_;
      if (change.name == "added_mass" && change.place == std::string("sensor.") + sensor.name)
        mass += change.value.at("mass");
      of.M += mass * w * w.transpose();
    }
    return seen;
  }

  double lx, ly, thickness, sensor_mass_; // m, kg
};

} // namespace

std::unique_ptr<ChangedStructure> clamped_plate(const PlateShape& shape) {
  return std::make_unique<Plate>(shape);
}

void add_plate(std::vector<std::unique_ptr<ChangedStructure>>& all) {
  all.push_back(clamped_plate({}));
}

} // namespace sealed
