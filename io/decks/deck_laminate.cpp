#include "io/decks/nastran_laminate.hpp"

#include <Eigen/Cholesky>

#include <cmath>

namespace plica {
namespace {

// Of the shear stiffness in the plane, as ShellSection has it.
constexpr double drilling_share = 1e-4;

// Along axis i of the wall: bending stiffness and integral of S^2/G about the neutral plane.
double transverse_shear(const std::vector<PlyMaterial>& plies, const std::vector<GeneralPly>& at,
                        int i) {
  double t = 0, first = 0, zeroth = 0;
  for (std::size_t p = 0; p < at.size(); ++p) {
    const double h = at[p].thickness, Q = plies[p].Q(i, i);
    zeroth += Q * h;
    first += Q * h * (t + h / 2);
    t += h;
  }
  double z = -first / zeroth, bending = 0, flexibility = 0, S = 0;
  for (std::size_t p = 0; p < at.size(); ++p) {
    const double h = at[p].thickness, Q = plies[p].Q(i, i), b = Q * z, c = Q / 2;
    bending += Q * h * (z * z + z * h + h * h / 3);
    if (plies[p].G(i, i) > 0)
      flexibility += (S * S * h + S * b * h * h + (b * b + 2 * S * c) * h * h * h / 3 +
                      b * c * std::pow(h, 4) / 2 + c * c * std::pow(h, 5) / 5) /
                     plies[p].G(i, i);
    S += b * h + c * h * h;
    z += h;
  }
  return flexibility > 0 ? bending * bending / flexibility : 0;
}

PlyMaterial turned_ply(const GeneralPly& ply) {
  ShellLaminate own;
  own.A = ply.material.Q;
  PlyMaterial along = ply.material;
  along.Q = turned(own, ply.angle).A;
  const Eigen::Matrix2d& G = ply.material.G;
  if (G(0, 0) > 0 && G(1, 1) > 0) {
    own.S = G;
    along.G = turned(own, ply.angle).S;
  } else if (std::abs(std::sin(2 * ply.angle)) > 1e-9)
    along.G.setZero(); // rigid along one axis of its own: taken so along both of the wall
  else if (std::abs(std::sin(ply.angle)) > 0.5)
    along.G.diagonal() << G(1, 1), G(0, 0);
  return along;
}

} // namespace

PlyMaterial orthotropic(double E1, double E2, double nu12, double G12, double G13, double G23,
                        double rho) {
  PlyMaterial m;
  const double nu21 = nu12 * E2 / E1, share = 1 - nu12 * nu21;
  m.Q << E1 / share, nu12 * E2 / share, 0, nu12 * E2 / share, E2 / share, 0, 0, 0, G12;
  m.G.diagonal() << G13, G23;
  m.rho = rho;
  return m;
}

bool is_material(const PlyMaterial& m) {
  if (!m.Q.allFinite() || !m.G.allFinite() || m.rho < 0 || m.G.diagonal().minCoeff() < 0)
    return false;
  const Eigen::Vector3d root = m.Q.diagonal().cwiseMax(0).cwiseSqrt();
  if (!(root.minCoeff() > 0)) return false;
  const Eigen::Matrix3d scaled =
      root.cwiseInverse().asDiagonal() * m.Q * root.cwiseInverse().asDiagonal();
  return Eigen::LLT<Eigen::Matrix3d>(scaled - 1e-9 * Eigen::Matrix3d::Identity()).info() ==
         Eigen::Success;
}

ShellLaminate solid_wall(const PlyMaterial& m) {
  ShellLaminate wall;
  wall.A = wall.D = m.Q;
  wall.S = 5. / 6 * m.G;
  for (int i = 0; i < 2; ++i)
    if (!(wall.S(i, i) > 0)) wall.S(i, i) = rigid_in_shear * 5 / 6 * m.Q(2, 2);
  wall.rho = m.rho;
  wall.drilling = drilling_share * m.Q(2, 2);
  return wall;
}

ShellLaminate general_laminate(const std::vector<GeneralPly>& plies) {
  double t = 0;
  for (const GeneralPly& p : plies) t += p.thickness;
  std::vector<PlyMaterial> along;
  ShellLaminate wall;
  double z = -t / 2;
  for (const GeneralPly& p : plies) {
    along.push_back(turned_ply(p));
    const Eigen::Matrix3d& Q = along.back().Q;
    const double h = p.thickness, middle = z + h / 2;
    wall.A += Q * h / t;
    wall.B += Q * h * middle / (t * t);
    wall.D += Q * h * (middle * middle + h * h / 12) * 12 / (t * t * t);
    wall.rho += p.material.rho * h / t;
    z += h;
  }
  if (wall.B.cwiseAbs().maxCoeff() < 1e-9 * wall.A.cwiseAbs().maxCoeff()) wall.B.setZero();
  for (int i = 0; i < 2; ++i) {
    wall.S(i, i) = transverse_shear(along, plies, i) / t;
    if (!(wall.S(i, i) > 0)) wall.S(i, i) = rigid_in_shear * 5 / 6 * wall.A(2, 2);
  }
  wall.drilling = drilling_share * wall.A(2, 2);
  return wall;
}

} // namespace plica
