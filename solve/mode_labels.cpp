#include "solve/mode_labels.hpp"

#include "words/directions.hpp"
#include "words/mode_kinds.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pair_tolerance = 1e-6; // of the frequency

// Fourier coefficients of one harmonic: rows u_r u_theta u_y; columns cos, sin.
using Harmonic = Eigen::Matrix<double, 3, 2>;

// All harmonics 0..highest of the displacement round one ring.
std::vector<Harmonic> harmonics_of(const Model& model, const Ring& ring, const VectorXd& u,
                                   int highest) {
  std::vector<Harmonic> a(highest + 1, Harmonic::Zero());
  const auto count = double(ring.nodes.size());
  for (int node : ring.nodes) {
    const Eigen::Vector3d& x = model.mesh.nodes[node];
    const std::complex<double> turn = std::polar(1., std::atan2(x.z(), x.x()));
    const Eigen::Vector3d d = u.segment<3>(6 * node);
    const Eigen::Vector3d local(turn.real() * d.x() + turn.imag() * d.z(),
                                turn.real() * d.z() - turn.imag() * d.x(), d.y());
    std::complex<double> wave = 1; // e^(i n theta)
    for (int n = 0; n <= highest; ++n, wave *= turn)
      a[n] += (n == 0 ? 1 : 2) / count * local * Eigen::RowVector2d(wave.real(), wave.imag());
  }
  return a;
}

// Half waves of a profile along the axis: changes of sign plus one, small values left out.
int half_waves(const std::vector<double>& profile) {
  double largest = 0;
  for (double v : profile) largest = std::max(largest, std::abs(v));
  int waves = 0;
  double last = 0;
  for (double v : profile) {
    if (std::abs(v) < 0.05 * largest) continue;
    if (last == 0 || (v > 0) != (last > 0)) ++waves;
    last = v;
  }
  return waves;
}

ModeLabel label_by_rings(const Model& model, const VectorXd& u) {
  std::size_t around = 0;
  for (const Ring& ring : model.mesh.rings) around = std::max(around, ring.nodes.size());
  const int highest = std::min<int>(static_cast<int>(around / 2), 24);
  std::vector<std::vector<Harmonic>> rings; // per ring, per harmonic
  std::vector<Eigen::Vector3d> energy(highest + 1, Eigen::Vector3d::Zero()); // u_r u_theta u_y
  for (const Ring& ring : model.mesh.rings) {
    rings.push_back(harmonics_of(model, ring, u, highest));
    for (int n = 0; n <= highest; ++n)
      energy[n] += ring.radius * (n == 0 ? 2 : 1) * rings.back()[n].rowwise().squaredNorm();
  }
  ModeLabel label;
  const auto largest = std::max_element(
      energy.begin(), energy.end(),
      [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.sum() < b.sum(); });
  label.harmonic = static_cast<int>(largest - energy.begin());
  int row = 0; // of the displacement whose profile is counted
  label.shape = mode_kind::shell;
  if (label.harmonic == 0) {
    const Eigen::Vector3d& e = *largest;
    row = e[1] > e[0] && e[1] > e[2] ? 1 : e[2] > e[0] ? 2 : 0;
    if (row == 1) label.shape = mode_kind::torsion;
    if (row == 2) label.shape = mode_kind::axial;
    label.direction = row == 0 ? "" : "y";
  }
  Eigen::Vector2d along = Eigen::Vector2d::Zero(); // cos, sin share
  std::vector<std::array<double, 2>> profiles;
  for (const std::vector<Harmonic>& ring : rings) {
    const Harmonic& a = ring[label.harmonic];
    if (label.harmonic == 1) // mean lateral motion: (radial + circumferential) / 2
      profiles.push_back({(a(0, 0) - a(1, 1)) / 2, (a(0, 1) + a(1, 0)) / 2});
    else
      profiles.push_back({a(row, 0), a(row, 1)});
    along += Eigen::Vector2d(profiles.back()[0], profiles.back()[1]).cwiseAbs2();
  }
  const int part = along[1] > along[0] ? 1 : 0;
  if (label.harmonic == 1) {
    label.shape = mode_kind::transverse;
    label.direction = part == 0 ? "x" : "z";
  }
  std::vector<double> profile;
  profile.reserve(profiles.size());
  for (const auto& p : profiles) profile.push_back(p[part]);
  label.order = half_waves(profile);
  return label;
}

// Nodes of a model of beams, springs and masses that all lie on the axis; empty when one does not,
// or when it has shells.
std::vector<int> axis_line(const Model& model) {
  std::vector<int> nodes;
  if (!model.mesh.quads.empty() || !model.mesh.triangles.empty()) return {};
  for (const BeamElement& b : model.beams) nodes.insert(nodes.end(), {b.node1, b.node2});
  for (const BushingElement& b : model.bushings) nodes.insert(nodes.end(), {b.node1, b.node2});
  std::erase(nodes, -1); // the ground
  const auto& x = model.mesh.nodes;
  double length = 0;
  for (int node : nodes) length = std::max(length, std::abs(x[node].y() - x[nodes[0]].y()));
  if (length == 0) return {};
  for (int node : nodes)
    if (std::hypot(x[node].x(), x[node].z()) > 1e-9 * length) return {};
  const auto further = [&](int a, int b) { return x[a].y() < x[b].y(); };
  std::sort(nodes.begin(), nodes.end(),
            [&](int a, int b) { return further(a, b) || (!further(b, a) && a < b); });
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Radius at which a rotation about the axis counts as a displacement: of gyration.
double axis_radius(const Model& model) {
  double mass = 0, inertia = 0;
  for (const BeamElement& b : model.beams) {
    mass += b.section.mass;
    inertia += b.section.inertia_x;
  }
  for (const MassElement& m : model.masses) {
    mass += m.body.mass;
    inertia += m.body.inertia(1, 1);
  }
  return mass > 0 ? std::sqrt(inertia / mass) : 0;
}

ModeLabel label_on_axis(const Model& model, const std::vector<int>& nodes, const VectorXd& u) {
  const double radius = axis_radius(model);
  const std::array<int, 4> dofs{0, 1, 2, 4};
  std::array<std::vector<double>, 4> profiles; // ux uy uz, r ry
  std::array<double, 4> energy{};
  for (int node : nodes)
    for (std::size_t k = 0; k < 4; ++k) {
      const double v = (k == 3 ? radius : 1) * u[6 * node + dofs[k]];
      profiles[k].push_back(v);
      energy[k] += v * v;
    }
  const auto k = std::size_t(std::max_element(energy.begin(), energy.end()) - energy.begin());
  constexpr std::array kinds{mode_kind::transverse, mode_kind::axial, mode_kind::transverse,
                             mode_kind::torsion};
  ModeLabel label;
  label.shape = kinds[k];
  label.direction = axis_names[k < 3 ? k : 1]; // of torsion: about y
  label.order = half_waves(profiles[k]);
  return label;
}

// Largest eigenvector of a Gram matrix of two responses; empty when both stand still.
bool dominant(const Matrix2d& gram, double scale, Eigen::Vector2d& c) {
  if (gram.trace() <= 1e-8 * scale) return false;
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(gram);
  c = eigen.eigenvectors().col(1);
  return eigen.eigenvalues()[1] > (1 + 1e-6) * eigen.eigenvalues()[0];
}

// False for a mode of what stands inside the wall, a liner that turns on its own.
bool wall_takes_part(const Model& model, const VectorXd& u) {
  std::vector<bool> on_wall(model.mesh.nodes.size(), false);
  double radius = 0, wall = 0, inside = 0;
  for (const Ring& ring : model.mesh.rings) {
    radius = std::max(radius, ring.radius);
    for (int node : ring.nodes) on_wall[node] = true;
  }
  for (std::size_t node = 0; node < on_wall.size(); ++node) {
    const auto at = 6 * static_cast<Index>(node);
    const double moves = u.segment<3>(at).norm();
    if (on_wall[node])
      wall = std::max(wall, moves);
    else
      inside = std::max({inside, moves, radius * u.segment<3>(at + 3).norm()});
  }
  return wall > 0.05 * inside;
}

Matrix2d gram_of(const MatrixXd& u, Index first, const std::vector<int>& dofs) {
  Matrix2d gram = Matrix2d::Zero();
  for (int dof : dofs) {
    const Eigen::RowVector2d row = u.block<1, 2>(dof, first);
    gram += row.transpose() * row;
  }
  return gram;
}

} // namespace

ModeLabel label_mode(const Model& model, const VectorXd& u, bool rigid,
                     const Eigen::Matrix<double, 6, 1>& effective_mass_fraction) {
  ModeLabel label;
  if (rigid) {
    label.shape = mode_kind::rigid;
    return label;
  }
  Index direction = 0;
  const double fraction = effective_mass_fraction.head<3>().maxCoeff(&direction);
  const std::string most = axis_word(int(direction)); // along which most of its mass moves
  if (!model.mesh.rings.empty() && wall_takes_part(model, u)) {
    constexpr double whole = 0.3; // of the mass: the rings are not what the mode is about
    ModeLabel by_rings = label_by_rings(model, u);
    if (fraction < whole || by_rings.direction.empty() || by_rings.direction == most)
      return by_rings;
  }
  if (const std::vector<int> axis = axis_line(model); !axis.empty())
    return label_on_axis(model, axis, u);
  label.shape = mode_kind::unnamed;
  if (fraction > 1e-3) label.direction = most;
  return label;
}

void orient_modes(const Model& model, const std::vector<int>& sensor_nodes, const VectorXd& lambda,
                  MatrixXd& Phi, MatrixXd& u) {
  std::vector<int> sensors, lines;
  for (int node : sensor_nodes) sensors.push_back(6 * node);
  for (const Ring& ring : model.mesh.rings) lines.push_back(6 * ring.nodes.front());
  if (lines.empty())
    for (std::size_t node = 0; node < model.mesh.nodes.size(); ++node)
      lines.push_back(6 * static_cast<int>(node));
  for (Index i = 0; i + 1 < lambda.size(); ++i) {
    if (lambda[i + 1] - lambda[i] > 2 * pair_tolerance * std::abs(lambda[i + 1])) continue;
    const double scale = u.middleCols(i, 2).squaredNorm() / double(model.mesh.nodes.size());
    Eigen::Vector2d c;
    if (dominant(gram_of(u, i, sensors), scale, c) || dominant(gram_of(u, i, lines), scale, c)) {
      Matrix2d turn;
      turn << c[0], -c[1], c[1], c[0];
      Phi.middleCols(i, 2) = (Phi.middleCols(i, 2) * turn).eval();
      u.middleCols(i, 2) = (u.middleCols(i, 2) * turn).eval();
    }
    ++i;
  }
  for (Index i = 0; i < lambda.size(); ++i) {
    Index largest = 0;
    u.col(i).cwiseAbs().maxCoeff(&largest);
    if (u(largest, i) >= 0) continue;
    u.col(i) *= -1;
    Phi.col(i) *= -1;
  }
}

} // namespace plica
