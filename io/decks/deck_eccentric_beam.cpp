#include "io/decks/deck_eccentric_beam.hpp"

#include <Eigen/Geometry>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

Matrix3d arm_of(const Vector3d& r) { // theta x r = arm theta
  Matrix3d arm;
  arm << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
  return arm;
}

// Motion of both ends at the arm r, of which the components `seen` are taken.
MatrixXd moved(const Vector3d& r, const Matrix3d& seen) {
  MatrixXd T = MatrixXd::Identity(12, 12);
  for (Index n = 0; n < 12; n += 6) T.block<3, 3>(n, n + 3) = seen * arm_of(r);
  return T;
}

} // namespace

BeamMatrices eccentric_beam(const BeamGeometry& ends, const BeamProperties& section,
                            const Eccentricity& at) {
  const Vector3d x = (ends.node2 - ends.node1).normalized();
  const MatrixXd stretched = moved(at.neutral, x * x.transpose());
  const MatrixXd carried = moved(at.neutral, Matrix3d::Identity());
  BeamMatrices all{.K = stretched.transpose() * beam_stiffness(ends, section) * stretched,
                   .M = carried.transpose() * beam_mass(ends, section) * carried};
  if (at.extra_mass == 0 && at.extra_inertia == 0) return all;
  BeamProperties extra = section;
  extra.mass = at.extra_mass;
  extra.inertia_x = at.extra_inertia;
  extra.inertia_y = extra.inertia_z = 0;
  const MatrixXd beside = moved(at.extra, Matrix3d::Identity());
  all.M += beside.transpose() * beam_mass(ends, extra) * beside;
  return all;
}

} // namespace plica
