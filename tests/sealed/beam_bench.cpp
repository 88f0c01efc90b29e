// The two cases of beams: elements of Plica's library, finer than those of the cases, with a
// stiffness of its own in each element, on the dense structure of the suite.
#include "bench.hpp"

#include "elements/beam_timoshenko.hpp"

namespace sealed {
namespace {

constexpr double E = 210e9, nu = 0.3, rho = 7850;
constexpr int elements = 10; // per stretch

struct BeamScatter {
  double E, rho;
};

// Adds nodes from y = from to `to` in `stretches`; names "<beam>.point[k]".
void add_beam_part(Structure& s, const std::string& name, double from, double to, int stretches,
                   double width, double depth, const BeamScatter& f, Draws& draws) {
  const int count = stretches * elements, first = add_unknowns(s, 6 * (count + 1));
  const double step = (to - from) / count;
  double field = 0;
  for (int e = 0; e < count; ++e) {
    field = 0.9 * field + std::sqrt(1 - 0.81) * 0.02 * draws.normal();
    const auto section =
        plica::rectangle_section({E * f.E * (1 + field), nu, rho * f.rho}, width, depth);
    const plica::BeamGeometry geometry{.node1 = {0, from + e * step, 0},
                                       .node2 = {0, from + (e + 1) * step, 0}};
    s.K.block(first + 6 * e, first + 6 * e, 12, 12) += plica::beam_stiffness(geometry, section);
    s.M.block(first + 6 * e, first + 6 * e, 12, 12) += plica::beam_mass(geometry, section);
  }
  for (int n = 0; n <= count; ++n) {
    const double y = from + n * step;
    const int row = first + 6 * n;
    s.R.block(row, 0, 6, 6).setIdentity();
    s.R(row + 0, 5) = -y;
    s.R(row + 2, 3) = y;
    if (n % elements != 0) continue;
    s.places[name + ".point[" + std::to_string(n / elements + 1) + "]"] =
        MatrixXd::Identity(s.K.rows(), s.K.rows()).middleRows(row, 6);
  }
  s.weighed += rho * f.rho * width * depth * (to - from);
}

// Rows that were made before unknowns were added have their width by add_unknowns.
void hold(Structure& s, const std::string& cap, const std::string& at) {
  const MatrixXd rows = s.places.at(at);
  s.places[cap] = rows;
  for (int i = 0; i < rows.cols(); ++i)
    if (rows.col(i).cwiseAbs().maxCoeff() > 0) s.held.push_back(i);
}

void add_part_mass(Structure& s, const std::string& at, double mass) {
  add_mass(s, s.places.at(at), mass);
  s.weighed += mass;
}

struct Global {
  BeamScatter f;
  double warm;
};

Global global(const Specimen& s, Draws& draws) {
  const double warm = 1 - 3.6e-4 * value_of(s, "temperature", "all", "delta_T", 0);
  Global g{{1 + 0.01 * draws.normal(), 1 + 0.005 * draws.normal()}, warm};
  g.f.E *= warm;
  return g;
}

void cantilever(Structure& body, const Specimen& s, const State& state, Draws& draws) {
  const Global g = global(s, draws);
  add_beam_part(body, "beam", 0, 0.6, 4, 0.025, 0.015, g.f, draws);
  hold(body, "root", "beam.point[1]");
  for (int k = 1; k <= 4; ++k) {
    const std::string part = "m" + std::to_string(k);
    const double own =
        0.15 * (1 + 0.01 * draws.normal()) * value_of(s, "component_mass", part, "ratio", 1);
    const auto set = state.find("parts." + part + ".mass");
    add_part_mass(body, "beam.point[" + std::to_string(k + 1) + "]",
                  set == state.end() ? own : set->second);
  }
}

void lap(Bench& bench, const Specimen& s, Draws& draws) {
  Structure& body = bench.body;
  const Global g = global(s, draws);
  add_beam_part(body, "beam1", 0, 0.25, 2, 0.040, 0.008, g.f, draws);
  add_beam_part(body, "beam2", 0.25, 0.5, 2, 0.040, 0.008, g.f, draws);
  hold(body, "left", "beam1.point[1]");
  hold(body, "right", "beam2.point[3]");
  VectorXd k(6);
  k << 5e7, 1e8, 5e7, 4e3, 2e4, 2e4;
  k *=
      g.warm * (1 + 0.05 * draws.normal()) * value_of(s, "joint_stiffness", "caps.lap", "ratio", 1);
  const MatrixXd relative = body.places.at("beam2.point[1]") - body.places.at("beam1.point[3]");
  add_springs(body, relative, k);
  body.places["caps.lap"] = body.places.at("beam1.point[3]");
  add_part_mass(body, "caps.lap",
                0.2 * (1 + 0.01 * draws.normal()) *
                    value_of(s, "component_mass", "caps.lap", "ratio", 1));
}

void add_lap_friction(Structure& test, const Effect& e) {
  const MatrixXd relative = test.places.at("beam2.point[1]") - test.places.at("beam1.point[3]");
  add_friction(test, e, relative, {{3, 4e3}, {5, 2e4}});
}

} // namespace

Bench beam_bench(const Specimen& s, const State& state, Draws draws) {
  const bool is_lap = s.structure == "bolted_lap";
  Bench bench;
  Structure& body = bench.body;
  body.K = body.M = MatrixXd(0, 0);
  body.R = MatrixXd(0, 6);
  if (is_lap)
    lap(bench, s, draws);
  else
    cantilever(body, s, state, draws);
  const std::string at = is_lap ? "beam1.point[3]" : "beam.point[5]";
  const char* name = is_lap ? "joint" : "tip";
  Structure& test = bench.test;
  test = body;
  MatrixXd rows = body.places.at(at).topRows(3); // moved along the beam by its rotation
  const double off = 1e-3 * draws.normal();
  rows.row(0) -= off * body.places.at(at).row(5);
  rows.row(2) += off * body.places.at(at).row(3);
  test.places[std::string("sensor.") + name] = rows;
  add_mass(test, rows, 0.005);
  test.weighed = body.weighed += 0.005;
  std::vector<std::string> sensors{name};
  if (s.mounted) {
    for (const auto& [own, end] : {std::pair{"foot", "left"}, std::pair{"head", "right"}}) {
      test.places[std::string("sensor.") + own] = rows_on_cap(test, end, Vector3d::Zero());
      add_mass(test, test.places.at(std::string("sensor.") + own), 0.005);
      test.weighed = body.weighed += 0.005;
      sensors.push_back(own);
    }
    VectorXd k(6);
    k << VectorXd::Constant(3, 5e7), VectorXd::Constant(3, 5e4);
    mount_on_springs(test, s, "right", k, draws);
  }
  add_surroundings(test, s);
  if (const Effect* e = find(s, "joint_friction"); e && is_lap) add_lap_friction(test, *e);
  for (const std::string& own : sensors)
    bench.probes.push_back(
        probe_of(s, own, test.places.at("sensor." + own), Vector3d::UnitZ(), draws));
  add_table_and_damping(bench, s, is_lap ? 0.008 : 0.005, draws);
  return bench;
}

} // namespace sealed
