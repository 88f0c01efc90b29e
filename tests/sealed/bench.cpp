#include "bench.hpp"

#include <Eigen/Geometry>
#include <numbers>

namespace sealed {
namespace {

using std::numbers::pi;

// "sensor.mid", "bellows.convolution[4]", "beam.point[3]" as a place of the structure.
const MatrixXd& place(const Structure& s, const std::string& path) {
  const auto found = s.places.find(path);
  if (found == s.places.end()) throw std::runtime_error("no place " + path);
  return found->second;
}

void add_fixture(Structure& test, const Effect& e, const std::string& end) {
  const double mass = e.value.at("mass"), w = 2 * pi * e.value.at("frequency");
  constexpr double gyration = 0.06; // m
  const double inertia = mass * gyration * gyration;
  stand_on_springs(test, end, mass * w * w, 4 * inertia * w * w); // it rocks at twice that
  add_mass(test, place(test, end), mass, Vector3d::Constant(inertia));
}

void add_nonlinear(Structure& test, const Effect& e, Law law) {
  const MatrixXd rows = place(test, e.place);
  for (const int axis : {0, 1, 2})
    test.nonlinear.push_back(
        {law, rows.row(axis).transpose(), e.value.at("stiffness"), e.value.at("slip_ratio")});
}

} // namespace

void mount_on_springs(Structure& test, const Specimen& s, const std::string& end, VectorXd k,
                      Draws& draws) {
  for (double& own : k) own *= 1 + 0.05 * draws.normal();
  for (const Effect& e : s.effects)
    if (e.name == "boundary_compliance" && e.place == "mount." + end)
      for (Eigen::Index d = 0; d < 6; ++d)
        k[d] = 1 / (1 / k[d] + 1 / e.value.at(d < 3 ? "k_translation" : "k_rotation"));
  const int foot = add_unknowns(test, 6);
  const MatrixXd rows = place(test, end);
  std::erase_if(test.held, [&](int i) { return rows.col(i).cwiseAbs().maxCoeff() > 0; });
  MatrixXd own = MatrixXd::Zero(6, test.K.cols());
  own.middleCols(foot, 6).setIdentity();
  test.R.middleRows(foot, 6) = rows * test.R;
  for (int d = 0; d < 6; ++d) test.held.push_back(foot + d);
  add_springs(test, rows - own, k);
  test.places["foot." + end] = own;
}

MatrixXd rows_on_cap(const Structure& s, const std::string& end, const Vector3d& offset) {
  const MatrixXd& cap = place(s, end);
  MatrixXd rows = cap.topRows(3);
  for (int axis = 0; axis < 3; ++axis) { // turn x offset
    const Vector3d moved = Vector3d(Vector3d::Unit(axis)).cross(offset);
    rows += moved * cap.row(3 + axis);
  }
  return rows;
}

Probe probe_of(const Specimen& s, const std::string& name, const MatrixXd& rows,
               const Vector3d& normal, Draws& draws) {
  Probe probe{.name = name, .rows = rows, .reading = Matrix3d::Identity()};
  const Vector3d tilt(draws.normal(), draws.normal(), draws.normal());
  const double degree = pi / 180;
  const double turn = value_of(s, "rotated_sensor", "sensor." + name, "angle", 0);
  probe.reading = Eigen::AngleAxisd(-turn, normal) *
                  Eigen::AngleAxisd(tilt.norm() * degree, tilt.normalized()).toRotationMatrix();
  const double gain = value_of(s, "sensor_gain", "sensor." + name, "gain", 1);
  for (int a = 0; a < 3; ++a) probe.reading.row(a) *= gain * (1 + 0.01 * draws.normal());
  probe.delay = value_of(s, "time_delay", "sensor." + name, "delay", 0);
  probe.resonance = value_of(s, "sensor_resonance", "sensor." + name, "frequency", 0);
  return probe;
}

void add_table_and_damping(Bench& bench, const Specimen& s, double zeta, Draws& draws) {
  const double fraction = value_of(s, "cross_axis_base_motion", "base", "fraction", 0);
  const double rocking = value_of(s, "rocking_table", "base", "per_metre", 0);
  for (const int d : {0, 1, 2}) {
    std::array<double, 6> motion{};
    motion[std::size_t(d)] = 1;
    motion[d == 0 ? 1 : 0] = fraction;
    motion[d == 2 ? 3 : 5] = rocking;
    bench.table[d] = motion;
  }
  const double ratio = value_of(s, "damping", "all", "ratio", 1) *
                       (1 + 0.005 * value_of(s, "temperature", "all", "delta_T", 0)) *
                       (s.mounted ? 1 + 0.2 * (2 * draws.uniform() - 1) : 1);
  bench.zeta.resize(600);
  for (double& z : bench.zeta) z = zeta * ratio * std::exp(0.12 * draws.normal());
}

void add_surroundings(Structure& test, const Specimen& s) {
  for (const Effect& e : s.effects) {
    const auto end = e.place.substr(e.place.find('.') + 1);
    const bool on_springs = test.places.contains("foot." + end);
    if (e.name == "fixture_flexibility") add_fixture(test, e, on_springs ? "foot." + end : end);
    if (e.name == "boundary_compliance" && !on_springs)
      stand_on_springs(test, end, e.value.at("k_translation"), e.value.at("k_rotation"));
    if (e.name == "extra_support")
      add_springs(test, place(test, e.place).topRows(3), VectorXd::Constant(3, e.value.at("k")));
    if (e.name == "added_mass") add_mass(test, place(test, e.place).topRows(3), e.value.at("mass"));
    if (e.name == "clearance") add_nonlinear(test, e, Law::stop);
    if (e.name == "hardening") add_nonlinear(test, e, Law::cubic);
    if (e.name == "absorber" || e.name == "sloshing")
      add_oscillator(test, MatrixXd(place(test, e.place).topRows(3)), e.value.at("mass"),
                     e.value.at("frequency"));
  }
}

void add_friction(Structure& test, const Effect& e, const MatrixXd& relative,
                  const std::vector<std::pair<int, double>>& stiffness) {
  for (const auto& [axis, k] : stiffness)
    test.nonlinear.push_back({Law::bouc_wen, relative.row(axis).transpose(),
                              k * e.value.at("share"), e.value.at("slip_ratio"), axis < 3 ? 0 : 1});
}

} // namespace sealed
