#include "diagnose/effects/places.hpp"
#include "lab/measured/states.hpp"
#include "model/description/place_keys.hpp"
#include "words/directions.hpp"

#include <cmath>
#include <numbers>

namespace plica {
namespace {

// Of a cube of steel, m.
double edge_of_cube(double mass) {
  constexpr double density = 7850; // kg/m3
  return std::cbrt(mass / density);
}

// Of a fixture that rocks: its mass, and how far it spreads, as its radius of gyration over that of
// a cube of steel of its mass. No body of steel spreads less than a ball.
constexpr double ball_over_cube = 0.96;

double inertia_of(double mass, double spread) {
  constexpr double gyration_of_cube = 0.40825; // radius over edge
  const double gyration = spread * gyration_of_cube * edge_of_cube(mass);
  return mass * gyration * gyration;
}

// Of a fixture: mass, frequency, rocking, spread and, where its centre of mass lies to a side of
// the held end, how far.
struct Fixture {
  explicit Fixture(const Eigen::VectorXd& v, const Eigen::Vector3d& side = Eigen::Vector3d::Zero())
      : mass(v[0]), inertia(inertia_of(v[0], v[3])), off(v.size() > 4 ? v[4] : 0),
        offset(off * side) {
    const double omega = 2 * std::numbers::pi * v[1];
    moving = mass * omega * omega;
    turning = inertia * std::pow(omega * v[2], 2);
  }
  double mass, inertia, off, moving = 0, turning = 0; // kg, kg m2 about its centre, m, N/m, Nm/rad
  Eigen::Vector3d offset;                             // m, from the held end
};

// What a mass so far off adds to the inertia, kg m2.
Eigen::Matrix3d carried(double mass, const Eigen::Vector3d& offset) {
  return mass * (offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose());
}

// Caps that were held rigidly, with the mass of the fixture, on its springs.
CaseEdits on_fixtures(const Case& now, const std::string& place, const Eigen::VectorXd& v,
                      const Eigen::Vector3d& side) {
  const Fixture f(v, side);
  const double k = f.moving, turning = f.turning;
  CaseEdits edits;
  for (const Mount& m : mounts_at(now, place)) {
    const Cap& cap = *cap_named(now, m.cap);
    if (m.kind != MountKind::rigid || cap.offset != Triple{}) return {};
    const double mass = cap.mass + f.mass;
    const Eigen::Vector3d centre = f.mass / mass * f.offset;
    const Eigen::Matrix3d J =
        f.inertia * Eigen::Matrix3d::Identity() + carried(f.mass, f.offset) - carried(mass, centre);
    Sextuple own = cap.inertia;
    for (std::size_t i = 0; i < 3; ++i) own[i] += J(Eigen::Index(i), Eigen::Index(i));
    edits.push_back(
        {mount_key(m.cap), "{stiffness: " + yaml_of({k, k, k, turning, turning, turning}) + "}"});
    edits.push_back({cap_key(m.cap) + ".mass", yaml_of(mass)});
    edits.push_back({cap_key(m.cap) + ".inertia", yaml_of(own)});
    if (!f.offset.isZero())
      edits.push_back(
          {cap_key(m.cap) + ".offset", yaml_of(Triple{centre[0], centre[1], centre[2]})});
  }
  return edits;
}

// Of each node: mass, first moments of mass and inertia about it. The mass matrix is linear in
// them.
ModelChange bodies(const std::vector<int>& nodes, double mass, const Eigen::Vector3d& moment,
                   const Eigen::Matrix3d& inertia) {
  return {
      [=](Model& model) {
        for (int node : nodes) {
          model.masses.push_back({node, {mass, Eigen::Vector3d::Zero(), inertia}});
          if (moment.isZero()) continue;
          // One mass there and as much less here are its moment and nothing else.
          model.masses.push_back({node, {1, moment, -carried(1, moment)}});
          model.masses.push_back({node, {-1, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()}});
        }
      },
      Follow::series};
}

// Mass and springs to the table. It rocks at `rocking` times the frequency at which it moves
// straight.
Hypothesis fixture_under(const Structure& s, const HeldEnds& ends) {
  const double mass = 2 * s.mass;
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  Hypothesis h{
      .effect = "fixture_flexibility",
      .place = ends.place,
      .way = "",
      .parameters = {{"mass", "kg", {PriorKind::log_normal, mass, 1}},
                     {"frequency", "Hz", {PriorKind::log_normal, 1.5 * s.frequency, 0.8}},
                     {"rocking", "", {PriorKind::log_normal, 1.5, 0.4}},
                     {"spread", "", {PriorKind::log_normal, 1.3, 0.35, ball_over_cube}}},
      .size = 1,
      .changes = {ground_springs(ends.nodes, 1, 0),
                  bodies(ends.nodes, 1, none, Eigen::Matrix3d::Zero()),
                  ground_springs(ends.nodes, 0, 1),
                  bodies(ends.nodes, 0, none, Eigen::Matrix3d::Identity())},
      .coefficients =
          [](const Eigen::VectorXd& v) {
            const Fixture f(v);
            return Eigen::VectorXd(Eigen::Vector4d(f.moving, f.mass, f.turning, f.inertia));
          },
      .at_rig = false,
      .released = ends.nodes,
      .resonates = true,
      .in_case = [place = ends.place,
                  none](const Case& now,
                        const Eigen::VectorXd& v) { return on_fixtures(now, place, v, none); }};
  h.released.insert(h.released.end(), ends.fixtures.begin(), ends.fixtures.end());
  return h;
}

// With its centre of mass to a side of the pipe: what moves it along rocks it, so that axial and
// lateral motion are one. To which side of two shows in phases alone, which are not read.
Hypothesis fixture_beside(const Structure& s, const HeldEnds& ends, int axis) {
  const Eigen::Vector3d side = Eigen::Vector3d::Unit(axis);
  Hypothesis h = fixture_under(s, ends);
  h.way = std::string("beside in ") + axis_word(axis);
  h.parameters.push_back({"off", "m", {PriorKind::log_normal, edge_of_cube(2 * s.mass) / 2, 0.8}});
  h.changes.push_back(bodies(ends.nodes, 0, side, Eigen::Matrix3d::Zero()));
  h.changes.push_back(bodies(ends.nodes, 0, Eigen::Vector3d::Zero(), carried(1, side)));
  h.coefficients = [](const Eigen::VectorXd& v) {
    const Fixture f(v);
    Eigen::VectorXd c(6);
    c << f.moving, f.mass, f.turning, f.inertia, f.mass * f.off, f.mass * f.off * f.off;
    return c;
  };
  h.in_case = [place = ends.place, side](const Case& now, const Eigen::VectorXd& v) {
    return on_fixtures(now, place, v, side);
  };
  return h;
}

// A fixture was there before: what comes loose under it is a compliance of the boundary, and beside
// a baseline a further mass on springs would be an absorber for whatever has changed.
std::vector<Hypothesis> fixture_flexibility_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  if (has_baseline(s.measured) && !asked_for(s, "fixture_flexibility")) return found;
  for (const HeldEnds& ends : held_ends(s)) {
    found.push_back(fixture_under(s, ends));
    for (int axis : {0, 2}) // the pipe lies along y
      if (s.reads_across) found.push_back(fixture_beside(s, ends, axis));
  }
  return found;
}

} // namespace

Effect fixture_flexibility() {
  return {.name = "fixture_flexibility",
          .plain = "a fixture that moves under the held end, with a resonance at {frequency}",
          .physics = "a held end stands on a fixture with mass and a resonance of its own",
          .signature = "the lowest modes fall, a further resonance appears, the held end moves",
          .look_alikes = {{"boundary_compliance", "an accelerometer on the fixture"},
                          {"added_mass", "a response of the fixture alone"}},
          .needs =
              "a mount, rigid or with springs; beside a baseline, diagnose: effects or priors of "
              "the case that name it",
          .hypotheses = fixture_flexibility_hypotheses};
}

} // namespace plica
