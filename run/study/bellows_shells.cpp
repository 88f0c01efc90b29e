#include "run/study/bellows_shells.hpp"

#include "run/analyses/run.hpp"
#include "run/analyses/static_stiffness.hpp"
#include "solve/stress.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <stdexcept>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

// Columns: along y and across x with the end parallel, a turn about z by a moment alone.
MatrixXd unit_movements(const Matrix1212& K) {
  MatrixXd motion = MatrixXd::Zero(12, 3);
  const Eigen::Matrix3d parallel = K.block<3, 3>(6, 6).inverse();
  motion.block<3, 1>(6, 0) = parallel.col(1) / parallel(1, 1);
  motion.block<3, 1>(6, 1) = parallel.col(0) / parallel(0, 0);
  const Matrix66 C = K.block<6, 6>(6, 6).inverse();
  motion.block<6, 1>(6, 2) = C.col(5) / C(5, 5);
  return motion;
}

// Plane stress: what of its trace is not circumferential. Rows: points; columns: shapes.
MatrixXd meridional(const StressField& field, const Mesh& mesh, Face face) {
  MatrixXd stress(Index(field.node_of_point.size()), field.shell.cols());
  for (Index point = 0; point < stress.rows(); ++point) {
    const Vector3d& x = mesh.nodes[field.node_of_point[point]];
    const Vector3d c = Vector3d::UnitY().cross(Vector3d(x.x(), 0, x.z())).normalized();
    const auto s = field.shell.middleRows<6>(12 * point + 6 * int(face));
    stress.row(point) = (1 - c.x() * c.x()) * s.row(0) + (1 - c.y() * c.y()) * s.row(1) +
                        (1 - c.z() * c.z()) * s.row(2) - 2 * c.x() * c.y() * s.row(3) -
                        2 * c.y() * c.z() * s.row(4) - 2 * c.z() * c.x() * s.row(5);
  }
  return stress;
}

} // namespace

Case bellows_alone(const Case& data, const Part& bellows) {
  Case alone;
  alone.name = data.name;
  alone.materials = data.materials;
  alone.parts = {bellows};
  auto& wall = std::get<Bellows>(alone.parts.front().body).wall;
  wall.slip.reset();
  for (const char* side : {"left", "right"}) {
    alone.caps.push_back({.name = side, .of = {bellows.name + "." + side}});
    alone.mount.push_back({.cap = side, .kind = MountKind::rigid});
  }
  alone.analyses.statics = true;
  alone.analyses.error_bars = false;
  return alone;
}

BellowsStatics::BellowsStatics(const Case& alone, const StageListener& stage) {
  const BuiltCase built = build(alone);
  Timing timing;
  const auto route = choose_route(built, alone.analyses, stage, timing);
  const std::array<int, 2> caps{built.cap_nodes.at("left"), built.cap_nodes.at("right")};
  const auto K = route->end_stiffness(caps);
  if (!K) throw std::runtime_error("a bellows alone has no static stiffness");
  stiffness_ = static_stiffness(*K, false);
  const StressField field = recover_stress(built.model, route->follow(caps, unit_movements(*K)));
  below_ = meridional(field, built.model.mesh, Face::below);
  above_ = meridional(field, built.model.mesh, Face::above);
  y_.resize(below_.rows());
  for (Index point = 0; point < y_.size(); ++point)
    y_[point] = built.model.mesh.nodes[field.node_of_point[point]].y();
}

MeridionalStress BellowsStatics::stress(const EndMovement& m,
                                        const std::array<double, 2>& between) const {
  MeridionalStress worst;
  for (const double lateral : {m.lateral, -m.lateral})
    for (const double angular : {m.angular, -m.angular}) {
      const Vector3d q(m.axial, lateral, angular);
      const Eigen::VectorXd below = below_ * q, above = above_ * q;
      for (Index i = 0; i < y_.size(); ++i) {
        if (y_[i] < between[0] || y_[i] > between[1]) continue;
        worst.bending = std::max(worst.bending, std::abs(below[i] - above[i]) / 2);
        worst.face = std::max({worst.face, std::abs(below[i]), std::abs(above[i])});
      }
    }
  return worst;
}

FirstModes first_modes(Case alone, const StageListener& stage) {
  alone.analyses.statics = false;
  FirstModes first;
  for (const int count : {12, 40}) {
    alone.analyses.modes = Modes{.count = count, .band = {}, .proof = false};
    const std::map<std::string, double> found = headline(run(alone, stage));
    const auto of = [&](const char* key) {
      const auto place = found.find(key);
      return place == found.end() ? std::nullopt : std::optional(place->second);
    };
    first = {of("f_axial"), of("f_transverse")};
    if (first.axial && first.transverse) break;
  }
  return first;
}

} // namespace plica
