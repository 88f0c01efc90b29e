#include "run/analyses/place_stress.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6 = Eigen::Matrix<double, 6, 1>; // 11, 22, 12 below and above
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Both faces of a ply that bends by a factor of what the field has.
Vector6 faces_of(const Vector6& s, double factor) {
  const Vector3d membrane = (s.head<3>() + s.tail<3>()) / 2;
  const Vector3d bending = factor * (s.tail<3>() - s.head<3>()) / 2;
  Vector6 faces;
  faces << membrane - bending, membrane + bending;
  return faces;
}

PlaceStress row_of(const StressPoint& p, const Mesh& mesh, const Vector6& s, bool outer, int ply) {
  const Vector3d face = outer ? s.tail<3>() : s.head<3>();
  PlaceStress row{.place = p.place,
                  .outer = outer,
                  .ply = ply,
                  .node = p.node,
                  .at = {},
                  .von_mises = signed_von_mises(face),
                  .principal = principal(face),
                  .meridional = face[0],
                  .hoop = face[1],
                  .meridional_membrane = (s[0] + s[3]) / 2,
                  .meridional_bending = (s[3] - s[0]) / 2,
                  .hoop_membrane = (s[1] + s[4]) / 2,
                  .hoop_bending = (s[4] - s[1]) / 2};
  Vector3d::Map(row.at.data()) = mesh.nodes[std::size_t(p.node)];
  if (!p.revolved)
    row.meridional = row.hoop = row.meridional_membrane = row.meridional_bending =
        row.hoop_membrane = row.hoop_bending = none;
  return row;
}

using FaceValue = std::function<double(Index point, bool outer)>;
using FaceRows = std::function<PlaceStress(Index point, bool outer, int ply)>;

// Where a place and face have their largest value, in the order of the places.
std::vector<PlaceStress> worst_rows(const ShellPoints& points, const FaceValue& value,
                                    const FaceRows& row) {
  struct Worst {
    double value = -1;
    Index point = -1;
  };
  std::vector<std::array<Worst, 2>> worst(points.places.size());
  for (Index i = 0; i < Index(points.points.size()); ++i)
    for (const bool outer : {false, true}) {
      Worst& w = worst[std::size_t(points.points[std::size_t(i)].place)][outer];
      if (const double v = value(i, outer); v > w.value) w = {v, i};
    }
  std::vector<PlaceStress> rows;
  for (const auto& faces : worst)
    for (const bool outer : {false, true}) {
      const Index i = faces[outer].point;
      if (i < 0) continue;
      const auto& plies = points.plies[std::size_t(points.points[std::size_t(i)].wall)];
      if (plies.empty()) rows.push_back(row(i, outer, 0));
      for (std::size_t k = 0; k < plies.size(); ++k) rows.push_back(row(i, outer, int(k) + 1));
    }
  return rows;
}

double factor_of(const ShellPoints& points, Index i, int ply) {
  const auto& plies = points.plies[std::size_t(points.points[std::size_t(i)].wall)];
  return ply > 0 ? plies[std::size_t(ply - 1)] : 1;
}

// Through the worst point, ring by ring of its bellows.
template <class At>
std::optional<MeridianStress> along_meridian(const ShellPoints& points, const Mesh& mesh,
                                             const std::vector<PlaceStress>& rows, const At& at) {
  const auto worst =
      std::max_element(rows.begin(), rows.end(), [](const PlaceStress& a, const PlaceStress& b) {
        return std::abs(a.von_mises) < std::abs(b.von_mises);
      });
  if (worst == rows.end() || !std::isfinite(worst->meridional)) return std::nullopt;
  const std::string& part = points.places[std::size_t(worst->place)].part;
  const MeridianPoints own = meridian_points(points, mesh, part, worst->at);
  const auto count = Index(own.points.size());
  if (count < 2) return std::nullopt;
  MeridianStress m{.part = part,
                   .along = own.along,
                   .inner = VectorXd(count),
                   .outer = VectorXd(count),
                   .membrane = VectorXd(count)};
  for (Index k = 0; k < count; ++k) {
    const Vector6 s = at(own.points[std::size_t(k)]);
    m.inner[k] = s[0];
    m.outer[k] = s[3];
    m.membrane[k] = (s[0] + s[3]) / 2;
  }
  return m;
}

} // namespace

MeridianPoints meridian_points(const ShellPoints& points, const Mesh& mesh, const std::string& part,
                               const std::array<double, 3>& at) {
  std::map<int, Index> point_of_ring;
  const double angle = std::atan2(at[2], at[0]);
  for (Index i = 0; i < Index(points.points.size()); ++i) {
    const StressPoint& p = points.points[std::size_t(i)];
    if (p.ring < 0 || points.places[std::size_t(p.place)].part != part) continue;
    const Vector3d& x = mesh.nodes[std::size_t(p.node)];
    const double off =
        std::abs(std::remainder(std::atan2(x.z(), x.x()) - angle, 2 * std::numbers::pi));
    const double step = std::numbers::pi / double(mesh.rings[std::size_t(p.ring)].nodes.size());
    if (off < step) point_of_ring.try_emplace(p.ring, i);
  }
  MeridianPoints m{.points = {}, .along = VectorXd::Zero(Index(point_of_ring.size()))};
  const Ring* before = nullptr;
  for (const auto& [ring, point] : point_of_ring) {
    const Ring& r = mesh.rings[std::size_t(ring)];
    const auto k = Index(m.points.size());
    if (before)
      m.along[k] = m.along[k - 1] + std::hypot(r.y - before->y, r.radius - before->radius);
    before = &r;
    m.points.push_back(point);
  }
  return m;
}

StressTable stress_table(const ShellPoints& points, const Mesh& mesh, StressKind kind,
                         const std::string& name, const Eigen::Ref<const VectorXd>& plane) {
  const auto at = [&](Index i) { return Vector6(plane.segment<6>(6 * i)); };
  StressTable table{.kind = kind, .name = name, .rows = {}, .meridian = {}};
  table.rows = worst_rows(
      points,
      [&](Index i, bool outer) {
        return plane_von_mises(plane.segment<3>(6 * i + 3 * int(outer)));
      },
      [&](Index i, bool outer, int ply) {
        return row_of(points.points[std::size_t(i)], mesh,
                      faces_of(at(i), factor_of(points, i, ply)), outer, ply);
      });
  table.meridian = along_meridian(points, mesh, table.rows, at);
  return table;
}

StressTable harmonic_table(const ShellPoints& points, const Mesh& mesh, const std::string& name,
                           const Eigen::VectorXcd& plane) {
  // vM(phi)^2 of Re(s e^{i phi}) is largest at half the angle of its second harmonic.
  const auto at_worst_phase = [&](Index i, bool outer) {
    const auto s = plane.segment<3>(6 * i + 3 * int(outer));
    const Vector3d c = s.real(), d = s.imag();
    const auto form = [](const Vector3d& a, const Vector3d& b) {
      return a[0] * b[0] + a[1] * b[1] - (a[0] * b[1] + a[1] * b[0]) / 2 + 3 * a[2] * b[2];
    };
    const double phase = std::atan2(-2 * form(c, d), form(c, c) - form(d, d)) / 2;
    return Vector6((plane.segment<6>(6 * i) * std::polar(1., phase)).real());
  };
  StressTable table{.kind = StressKind::harmonic, .name = name, .rows = {}, .meridian = {}};
  table.rows = worst_rows(
      points,
      [&](Index i, bool outer) {
        return plane_von_mises(at_worst_phase(i, outer).segment<3>(3 * int(outer)));
      },
      [&](Index i, bool outer, int ply) {
        return row_of(points.points[std::size_t(i)], mesh,
                      faces_of(at_worst_phase(i, outer), factor_of(points, i, ply)), outer, ply);
      });
  table.meridian = along_meridian(points, mesh, table.rows, [&](Index i) {
    return Vector6(plane.segment<6>(6 * i).cwiseAbs()); // amplitudes
  });
  return table;
}

StressTable rms_table(const ShellPoints& points, const Mesh& mesh, const std::string& name,
                      const MatrixXd& plane, const MatrixXd& C) {
  const auto covariance = [&](Index i, double factor) { // of both faces
    MatrixXd s = plane.middleRows<6>(6 * i);
    const MatrixXd membrane = (s.topRows<3>() + s.bottomRows<3>()) / 2;
    const MatrixXd bending = factor * (s.bottomRows<3>() - s.topRows<3>()) / 2;
    s << membrane - bending, membrane + bending;
    return Eigen::Matrix<double, 6, 6>(s * C * s.transpose());
  };
  const auto von_mises_of = [](const Eigen::Matrix<double, 6, 6>& S, bool outer) {
    const Index o = outer ? 3 : 0;
    return std::sqrt(std::max(0., S(o, o) + S(o + 1, o + 1) - S(o, o + 1) + 3 * S(o + 2, o + 2)));
  };
  std::vector<std::array<double, 2>> rms(points.points.size());
  const auto count = int(points.points.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix<double, 6, 6> S = covariance(i, 1);
    rms[std::size_t(i)] = {von_mises_of(S, false), von_mises_of(S, true)};
  }
  StressTable table{.kind = StressKind::rms, .name = name, .rows = {}, .meridian = {}};
  table.rows = worst_rows(
      points, [&](Index i, bool outer) { return rms[std::size_t(i)][outer]; },
      [&](Index i, bool outer, int ply) {
        const Eigen::Matrix<double, 6, 6> S = covariance(i, factor_of(points, i, ply));
        const auto root = [](double x) { return std::sqrt(std::max(0., x)); };
        const auto half = [&](Index k, double sign) { // of both faces' sum or difference
          return root(S(k, k) + S(k + 3, k + 3) + sign * 2 * S(k, k + 3)) / 2;
        };
        const Index o = outer ? 3 : 0;
        PlaceStress row = row_of(points.points[std::size_t(i)], mesh, Vector6::Zero(), outer, ply);
        row.von_mises = von_mises_of(S, outer);
        row.principal = {none, none};
        if (!points.points[std::size_t(i)].revolved) return row;
        row.meridional = root(S(o, o));
        row.hoop = root(S(o + 1, o + 1));
        row.meridional_membrane = half(0, 1);
        row.meridional_bending = half(0, -1);
        row.hoop_membrane = half(1, 1);
        row.hoop_bending = half(1, -1);
        return row;
      });
  table.meridian = along_meridian(points, mesh, table.rows, [&](Index i) {
    return Vector6(covariance(i, 1).diagonal().cwiseMax(0).cwiseSqrt());
  });
  return table;
}

} // namespace plica
