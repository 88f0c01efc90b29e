#include "bench.hpp"

namespace sealed {
namespace {

// Numbers of tests/sealed/short_bellows.yaml.
constexpr double liner_EA = 10e3, liner_EI = 5.78, liner_GJ = 4.4, liner_mass = 0.08;
constexpr double liner_radius = 0.034, ring_mass = 0.02, cap_mass = 0.15, sensor_mass = 0.002;

struct Scatter { // factors; drawn in one order for every state
  double E, rho, left, right, liner, ring, EA;
};

Scatter draw_scatter(Draws& d) {
  const auto factor = [&](double sd) { return 1 + sd * d.normal(); };
  Scatter s{};
  s.E = factor(0.01);
  s.rho = factor(0.005);
  s.left = factor(0.01);
  s.right = factor(0.01);
  s.liner = factor(0.01);
  s.ring = factor(0.01);
  s.EA = factor(0.05);
  return s;
}

// Quadratic between the 3 x 3 nodes round a sensor that sits `along` and `around` off, m.
MatrixXd off_place(const ReducedWall& wall, const std::string& name, double along, double around) {
  const auto weights = [](double x) {
    return std::array{x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2};
  };
  const MatrixXd& spacing = wall.places.at(name + ".spacing");
  const auto a = weights(along / spacing(0)), b = weights(around / spacing(1));
  MatrixXd rows = MatrixXd::Zero(3, wall.K.cols());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      rows += a[i] * b[j] * wall.places.at(name + "." + std::to_string(i) + std::to_string(j));
  return rows;
}

Structure bare(const ReducedWall& wall, double E, double rho) {
  const WallShape shape;
  Structure s;
  s.K = E * wall.K;
  s.M = rho * wall.M;
  s.places = wall.places;
  s.R = MatrixXd::Zero(wall.K.rows(), 6);
  for (int end = 0; end < 3; ++end) {
    const double y = end * shape.length() / 2;
    for (int d = 0; d < 6; ++d) s.R(6 * end + d, d) = 1;
    s.R(6 * end + 0, 5) = -y; // theta x (y e_y)
    s.R(6 * end + 2, 3) = y;
  }
  for (int k = 1; k <= shape.convolutions; ++k)
    s.places["bellows.convolution[" + std::to_string(k) + "]"] =
        wall.places.at("ring." + std::to_string(k));
  for (int d = 0; d < 6; ++d) {
    s.held.push_back(d);
    s.held.push_back(12 + d);
  }
  return s;
}

const std::array<const char*, 5> stations{"left", "station.3", "middle", "station.7", "right"};

std::array<double, 5> station_places() {
  const WallShape w;
  return {0, w.root(3), w.root(5), w.root(7), w.length()};
}

void add_liner(Structure& s, double EA, double mass) {
  const auto y = station_places();
  const double length = WallShape{}.length(), share = EA / liner_EA;
  for (std::size_t i = 0; i + 1 < y.size(); ++i) {
    const MatrixXd a = s.places.at(stations[i]), b = s.places.at(stations[i + 1]);
    const double step = y[i + 1] - y[i], half = mass * step / length / 2;
    add_beam(s, a, b, step, EA, share * liner_EI, share * liner_GJ);
    const double across = half * liner_radius * liner_radius / 2;
    for (const MatrixXd* at : {&a, &b}) add_mass(s, *at, half, {across, 2 * across, across});
  }
}

// Axial and bending motion of every piece of the liner.
void add_liner_friction(Structure& test, const Effect& e, double EA) {
  const auto y = station_places();
  for (std::size_t i = 0; i + 1 < y.size(); ++i) {
    const double step = y[i + 1] - y[i], EI = EA / liner_EA * liner_EI;
    add_friction(test, e, test.places.at(stations[i + 1]) - test.places.at(stations[i]),
                 {{1, EA / step}, {3, EI / step}, {5, EI / step}});
  }
}

void add_liner_strangers(Structure& test, const Specimen& s) {
  if (const Effect* e = find(s, "eccentric_mass"); e)
    add_mass(test, test.places.at("middle"), e->value.at("mass"), {0, 0, 0},
             {e->value.at("offset"), 0, 0});
  if (const Effect* e = find(s, "coupling_spring"); e)
    add_springs(test, test.places.at("ring.6").topRows(3) - test.places.at("ring.3").topRows(3),
                VectorXd::Constant(3, e->value.at("k")));
  if (const Effect* e = find(s, "rubber"); e) {
    Structure spring = test;
    spring.K.setZero();
    add_springs(spring, test.places.at("middle").topRows(3),
                VectorXd::Constant(3, e->value.at("k")));
    test.rubber = spring.K;
  }
}

// The right end on springs; sensors between the axes and on both ends.
void add_mounting(Bench& bench, const Specimen& s, const ReducedWall& wall, Draws& draws) {
  Structure& test = bench.test;
  const double along = 0.7e-3 * draws.normal(), around = 0.7e-3 * draws.normal();
  test.places["sensor.slant"] = off_place(wall, "slant", along, around);
  test.places["sensor.foot"] = rows_on_cap(test, "left", {0, 0, WallShape{}.root_radius});
  test.places["sensor.head"] = rows_on_cap(test, "right", {0, 0, WallShape{}.root_radius});
  for (const char* name : {"slant", "foot", "head"})
    add_mass(test, test.places.at(std::string("sensor.") + name), sensor_mass);
  bench.body.weighed += 3 * sensor_mass;
  VectorXd k(6);
  k << VectorXd::Constant(3, 4e7), VectorXd::Constant(3, 7e4);
  mount_on_springs(test, s, "right", k, draws);
}

} // namespace

Bench bellows_bench(const Specimen& s, const ReducedWall& wall, const State& state, Draws draws) {
  const Scatter f = draw_scatter(draws);
  const double warm = 1 - 3.6e-4 * value_of(s, "temperature", "all", "delta_T", 0);
  const auto ratio = [&](const std::string& part) {
    return value_of(s, "component_mass", part, "ratio", 1);
  };
  Bench bench;
  Structure& body = bench.body;
  body = bare(wall, f.E * warm, f.rho);
  const double EA =
      liner_EA * f.EA * warm * value_of(s, "joint_stiffness", "interlock", "ratio", 1);
  const double liner = liner_mass * f.liner * ratio("interlock");
  add_liner(body, EA, liner);
  const auto set = state.find("parts.extra.mass");
  const double fitted = set == state.end() ? ring_mass : set->second;
  const double ring = ring_mass * f.ring * ratio("extra") + fitted - ring_mass;
  add_mass(body, body.places.at("middle"), ring, {1.6e-5, 3.2e-5, 1.6e-5});
  const double left = cap_mass * f.left * ratio("caps.left");
  const double right = cap_mass * f.right * ratio("caps.right");
  add_mass(body, body.places.at("left"), left);
  add_mass(body, body.places.at("right"), right);
  body.weighed = f.rho * wall.mass + liner + ring + left + right + 2 * sensor_mass;

  Structure& test = bench.test;
  test = body;
  const double smeared = value_of(s, "unweighed_mass", "bellows", "ratio", 0);
  const auto n = wall.M.rows();
  test.M.topLeftCorner(n, n) += smeared * f.rho * wall.M;
  for (const char* name : {"mid", "quarter"}) {
    const double along = 0.7e-3 * draws.normal(), around = 0.7e-3 * draws.normal();
    const MatrixXd rows = off_place(wall, name, along, around);
    test.places[std::string("sensor.") + name] = rows;
    add_mass(test, rows, sensor_mass);
  }
  if (s.mounted) add_mounting(bench, s, wall, draws);
  add_liner_strangers(test, s);
  add_surroundings(test, s);
  if (const Effect* e = find(s, "joint_friction"); e) add_liner_friction(test, *e, EA);
  std::vector<std::pair<std::string, Vector3d>> normals{{"mid", Vector3d::UnitZ()},
                                                        {"quarter", Vector3d::UnitX()}};
  if (s.mounted)
    normals.insert(normals.end(), {{"slant", Vector3d(1, 0, 1).normalized()},
                                   {"foot", Vector3d::UnitZ()},
                                   {"head", Vector3d::UnitZ()}});
  for (const auto& [name, normal] : normals)
    bench.probes.push_back(probe_of(s, name, test.places.at("sensor." + name), normal, draws));
  add_table_and_damping(bench, s, 0.01, draws);
  return bench;
}

} // namespace sealed
