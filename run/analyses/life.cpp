#include "run/analyses/life.hpp"

#include "run/analyses/place_stress.hpp"
#include "words/input_error.hpp"
#include "words/units.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace plica {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

constexpr int direction_count = 18;

MatrixXd normal_directions(StressMeasure measure) {
  if (measure == StressMeasure::signed_von_mises) return MatrixXd::Zero(1, 3);
  MatrixXd rows(direction_count, 3);
  for (int k = 0; k < direction_count; ++k) {
    const double c = std::cos(pi * k / direction_count), s = std::sin(pi * k / direction_count);
    rows.row(k) << c * c, s * s, 2 * c * s;
  }
  return rows;
}

FatigueCurve named(FatigueCurve curve) {
  if (const auto* published = std::get_if<PublishedCurve>(&curve.law)) {
    const PublishedTests& tests = tests_of(published->of);
    if (curve.name.empty()) curve.name = tests.title;
    if (curve.source.empty()) curve.source = tests.source;
  }
  if (!curve.name.empty()) return curve;
  constexpr std::array names{"curve of bellows", "stress-life curve", "strain-life curve",
                             "curve of the case"};
  curve.name = names[curve.law.index()];
  if (curve.law.index() == 0 && curve.source.empty())
    curve.source = "ASME VIII-2 table 4.19.5, as-formed austenitic bellows";
  return curve;
}

} // namespace

LifeCount::LifeCount(const Case& data, const BuiltCase& built)
    : case_(data), life_(*data.analyses.life), model_(built.model),
      nodes_(int(built.model.mesh.nodes.size())), directions_(normal_directions(life_.measure)) {
  const StressField field =
      built.model.rest ? stress_of_state(built.model) : stress_points(built.model);
  points_ = shell_points(data, built, field);
  if (points_.points.empty())
    input_error("analyses.life", "is that of shells, and the case has none",
                "a bellows, a plate, a surface or shells of a deck");
  state_ = VectorXd::Zero(6 * Index(points_.points.size()));
  if (built.model.rest) state_ = plane_of(field).col(0);
  for (const StressPoint& p : points_.points)
    at_.push_back(built.model.mesh.nodes[std::size_t(p.node)]);
}

MatrixXd LifeCount::plane_of(const StressField& field) const {
  MatrixXd plane = plane_stress(points_, field.shell);
  take_thickest_ply(points_, plane);
  return plane;
}

DutyMap LifeCount::new_duty(DutyKind kind, const std::string& name, const std::string& what,
                            double count, const std::string& unit) const {
  const auto sites = Index(2 * points_.points.size()), columns = directions_.rows();
  DutyMap duty;
  duty.head.kind = kind;
  duty.head.name = name;
  duty.head.what = what;
  duty.head.count = count;
  duty.head.unit = unit;
  duty.damage.setZero(sites, columns);
  duty.certain.setZero(sites, columns);
  duty.range.setZero(sites, columns);
  duty.mean.setZero(sites, columns);
  duty.bounds.setZero(sites, columns);
  return duty;
}

void LifeCount::count(DutyMap& duty, int site, Index direction, const StressCycle& cycle,
                      double times) const {
  const CurveLife N = life(life_.curve, cycle);
  duty.damage(site, direction) += float(times / N.cycles);
  if (N.bound == Bound::at_least)
    duty.bounds(site, direction) |= 1;
  else
    duty.certain(site, direction) += float(times / N.cycles);
  if (N.bound == Bound::at_most) duty.bounds(site, direction) |= 2;
  if (float(cycle.range) <= duty.range(site, direction)) return;
  duty.range(site, direction) = float(cycle.range);
  duty.mean(site, direction) = float(cycle.mean);
}

std::vector<int> LifeCount::worst_sites(const MatrixXd& plane, const MatrixXd& C) const {
  const auto sites = int(2 * points_.points.size());
  VectorXd square(sites);
#pragma omp parallel for schedule(static)
  for (int site = 0; site < sites; ++site) {
    const MatrixXd s = plane.middleRows<3>(3 * Index(site));
    const Eigen::Matrix3d S = s * C * s.transpose();
    square[site] = life_.measure == StressMeasure::signed_von_mises
                       ? S(0, 0) + S(1, 1) - S(0, 1) + 3 * S(2, 2)
                       : (directions_ * S).cwiseProduct(directions_).rowwise().sum().maxCoeff();
  }
  std::vector<std::array<int, 2>> worst(points_.places.size(), {-1, -1});
  for (int site = 0; site < sites; ++site) {
    int& w = worst[std::size_t(points_.points[std::size_t(site / 2)].place)][site % 2];
    if (w < 0 || square[site] > square[w]) w = site;
  }
  std::vector<int> all;
  for (const auto& faces : worst)
    for (const int site : faces)
      if (site >= 0) all.push_back(site);
  return all;
}

void LifeCount::spread(DutyMap& duty) const {
  std::vector<std::array<int, 2>> of(points_.places.size(), {-1, -1});
  for (const int site : duty.counted)
    of[std::size_t(points_.points[std::size_t(site / 2)].place)][site % 2] = site;
  for (Index site = 0; site < duty.damage.rows(); ++site) {
    const int from = of[std::size_t(points_.points[std::size_t(site / 2)].place)][site % 2];
    if (from == site) continue;
    duty.damage.row(site) = duty.damage.row(from);
    duty.certain.row(site) = duty.certain.row(from);
    duty.range.row(site) = duty.range.row(from);
    duty.mean.row(site) = duty.mean.row(from);
    duty.bounds.row(site) = duty.bounds.row(from);
  }
}

namespace {

// A site in its worst direction, by the damage that is certain and then by range.
struct Worst {
  Index site = -1, direction = 0;
  double certain = -1, range = -1, damage = 0;
  bool counted = false; // it stands for its place and face

  bool operator<(const Worst& o) const {
    const bool both_infinite = std::isinf(certain) && std::isinf(o.certain);
    if (!both_infinite && std::abs(certain - o.certain) > 1e-6 * std::max(certain, o.certain))
      return certain < o.certain;
    if (std::abs(range - o.range) > 1e-6 * std::max(range, o.range)) return range < o.range;
    return !counted && o.counted;
  }
};

std::vector<Worst> worst_directions(const std::vector<DutyMap>& duties, Index sites,
                                    Index columns) {
  MatrixXd damage = MatrixXd::Zero(sites, columns), certain = damage, range = damage;
  std::vector<char> counted(std::size_t(sites), 0);
  for (const DutyMap& duty : duties) {
    damage += duty.damage.cast<double>();
    certain += duty.certain.cast<double>();
    range = range.cwiseMax(duty.range.cast<double>());
    for (const int site : duty.counted) counted[std::size_t(site)] = 1;
  }
  std::vector<Worst> worst(static_cast<std::size_t>(sites));
  for (Index site = 0; site < sites; ++site)
    for (Index d = 0; d < columns; ++d) {
      const Worst here{site,
                       d,
                       certain(site, d),
                       range(site, d),
                       damage(site, d),
                       counted[std::size_t(site)] != 0};
      if (worst[std::size_t(site)] < here) worst[std::size_t(site)] = here;
    }
  return worst;
}

// One of each place and face, the worst first.
std::vector<Worst> worst_of_places(const ShellPoints& points, const std::vector<Worst>& sites) {
  std::vector<std::array<Worst, 2>> worst(points.places.size());
  for (const Worst& own : sites) {
    const StressPoint& p = points.points[std::size_t(own.site / 2)];
    Worst& of_place = worst[std::size_t(p.place)][std::size_t(own.site % 2)];
    if (of_place < own) of_place = own;
  }
  std::vector<Worst> spots;
  for (const auto& faces : worst)
    for (const Worst& w : faces)
      if (w.site >= 0) spots.push_back(w);
  std::stable_sort(spots.begin(), spots.end(),
                   [](const Worst& a, const Worst& b) { return b < a; });
  return spots;
}

// A duty where it does most damage, or stresses most.
DutyResult at_its_spot(const DutyMap& duty, std::size_t number, const std::vector<LifeSpot>& spots,
                       const std::vector<Worst>& sites, const FatigueCurve& curve) {
  DutyResult head = duty.head;
  const auto rank = [&](std::size_t i) {
    return std::pair(duty.certain(sites[i].site, sites[i].direction), spots[i].ranges[number]);
  };
  for (std::size_t i = 0; i < spots.size(); ++i)
    if (rank(i) > rank(std::size_t(head.spot))) head.spot = int(i);
  const Worst& w = sites[std::size_t(head.spot)];
  head.damage = double(duty.damage(w.site, w.direction));
  head.range = double(duty.range(w.site, w.direction));
  head.mean = double(duty.mean(w.site, w.direction));
  head.at_most = duty.bounds(w.site, w.direction) & 1;
  head.at_least = duty.bounds(w.site, w.direction) & 2;
  if (head.kind == DutyKind::stroke || head.kind == DutyKind::dwell)
    head.life = life(curve, {head.range, head.mean});
  if (duty.random) head.random = duty.random(int(w.site), int(w.direction));
  return head;
}

// Through the first spot.
std::optional<MeridianDamage> damage_along_meridian(const ShellPoints& points, const Mesh& mesh,
                                                    const LifeResult& life) {
  if (life.spots.empty()) return std::nullopt;
  const LifeSpot& spot = life.spots.front();
  MeridianDamage m{
      .part = points.places[std::size_t(spot.place)].part, .along = {}, .inner = {}, .outer = {}};
  const MeridianPoints own = meridian_points(points, mesh, m.part, spot.at);
  const auto count = Index(own.points.size());
  if (count < 2) return std::nullopt;
  m.along = own.along;
  m.inner.resize(count);
  m.outer.resize(count);
  for (Index k = 0; k < count; ++k) {
    const int node = points.points[std::size_t(own.points[std::size_t(k)])].node;
    m.inner[k] = life.inner[node];
    m.outer[k] = life.outer[node];
  }
  return m;
}

} // namespace

LifeSpot LifeCount::spot_at(Index site, Index direction, double damage) const {
  const StressPoint& p = points_.points[std::size_t(site / 2)];
  LifeSpot spot{.place = p.place,
                .outer = site % 2 != 0,
                .node = p.node,
                .at = {},
                .damage = damage,
                .by_duty = {},
                .ranges = {}};
  Vector3d::Map(spot.at.data()) = at_[std::size_t(site / 2)];
  spot.direction = life_.measure == StressMeasure::critical_direction
                       ? pi * double(direction) / direction_count
                       : std::nan("");
  for (const DutyMap& duty : duties_) {
    spot.by_duty.push_back(double(duty.damage(site, direction)));
    spot.ranges.push_back(double(duty.range(site, direction)));
    spot.at_most = spot.at_most || (duty.bounds(site, direction) & 1);
    spot.at_least = spot.at_least || (duty.bounds(site, direction) & 2);
  }
  return spot;
}

LifeResult LifeCount::result() const {
  LifeResult result{.curve = what_is_inside(named(life_.curve)),
                    .measure = life_.measure == StressMeasure::critical_direction
                                   ? "normal stress in the critical direction"
                                   : "von Mises stress with its sign",
                    .design = is_design(life_.curve),
                    .deviation = life_.deviation ? life_.deviation : deviation_of(life_.curve),
                    .duties = {},
                    .spots = {},
                    .inner = VectorXd::Constant(nodes_, std::nan("")),
                    .outer = VectorXd::Constant(nodes_, std::nan("")),
                    .warnings = warnings_};
  if (life_.curve.temperature_factor != 1)
    result.curve += ", temperature factor " + short_number(life_.curve.temperature_factor);
  const std::vector<Worst> sites =
      worst_directions(duties_, Index(2 * points_.points.size()), directions_.rows());
  const bool certain =
      std::any_of(sites.begin(), sites.end(), [](const Worst& own) { return own.certain > 0; });
  for (const Worst& own : sites) {
    double& at_node = (own.site % 2 ? result.outer
                                    : result.inner)[points_.points[std::size_t(own.site / 2)].node];
    const double damage = certain ? own.certain : own.damage;
    at_node = std::isnan(at_node) ? damage : std::max(at_node, damage);
  }
  const std::vector<Worst> spots = worst_of_places(points_, sites);
  for (const Worst& w : spots) result.spots.push_back(spot_at(w.site, w.direction, w.damage));
  result.meridian = damage_along_meridian(points_, model_.mesh, result);
  for (std::size_t k = 0; k < duties_.size(); ++k)
    result.duties.push_back(at_its_spot(duties_[k], k, result.spots, spots, life_.curve));
  return result;
}

} // namespace plica
