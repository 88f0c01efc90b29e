#include "io/decks/deck_beam_loads.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Vector3d;

// Shapes of the deflection w at xi = s / L by w1, w1', w2, w2'; phi = 12 EI / (GA L^2).
std::array<double, 4> shapes(double xi, double L, double phi) {
  const double x2 = xi * xi, x3 = x2 * xi, all = 1 + phi;
  return {(1 - 3 * x2 + 2 * x3 + phi * (1 - xi)) / all,
          L * (xi - 2 * x2 + x3 + phi / 2 * (xi - x2)) / all, (3 * x2 - 2 * x3 + phi * xi) / all,
          L * (-x2 + x3 - phi / 2 * (xi - x2)) / all};
}

// At the ends of the beam's axis.
struct EndForces {
  std::array<Vector3d, 2> force{Vector3d(0, 0, 0), Vector3d(0, 0, 0)}, moment = force;
};

// Of a force at one place. x, y, z: along the beam and the axes of its section.
void add_at(EndForces& ends, double xi, double L, const Vector3d& force,
            const Eigen::Matrix3d& axes, double phi_y, double phi_z) {
  const Vector3d x = axes.col(0), y = axes.col(1), z = axes.col(2);
  const std::array<double, 4> along_y = shapes(xi, L, phi_y), along_z = shapes(xi, L, phi_z);
  for (std::size_t k = 0; k < 2; ++k) {
    ends.force[k] += x * force.dot(x) * (k == 0 ? 1 - xi : xi) + y * force.dot(y) * along_y[2 * k] +
                     z * force.dot(z) * along_z[2 * k];
    // Slopes: dv/dx turns about z, dw/dx about -y.
    ends.moment[k] += z * force.dot(y) * along_y[2 * k + 1] - y * force.dot(z) * along_z[2 * k + 1];
  }
}

} // namespace

void add_beam_load(std::vector<DeckForce>& forces, const DeckModel& deck, const BeamElement& beam,
                   const BeamLine& load) {
  const std::array<int, 2> nodes{beam.node1, beam.node2};
  const std::array<Vector3d, 2> offsets{beam.offset1, beam.offset2};
  const Vector3d line = deck.nodes[std::size_t(beam.node2)] + beam.offset2 -
                        deck.nodes[std::size_t(beam.node1)] - beam.offset1;
  const double L = line.norm();
  Eigen::Matrix3d axes;
  axes.col(0) = line / L;
  axes.col(1) = beam.up.cross(axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  const BeamProperties& s = beam.section;
  const double phi_y = 12 * s.EI_z / (s.GA_y * L * L), phi_z = 12 * s.EI_y / (s.GA_z * L * L);
  EndForces ends;
  const double reach = load.end - load.start;
  if (reach == 0) {
    add_at(ends, load.start, L, load.p1 * load.direction, axes, phi_y, phi_z);
  } else { // exact up to degree five: a cubic times a straight line
    const double g = std::sqrt(0.6);
    for (const auto& [at, weight] : {std::pair{-g, 5. / 9}, {0., 8. / 9}, {g, 5. / 9}}) {
      const double t = (1 + at) / 2, p = load.p1 + t * (load.p2 - load.p1);
      add_at(ends, load.start + t * reach, L, weight / 2 * reach * L * p * load.direction, axes,
             phi_y, phi_z);
    }
  }
  for (std::size_t k = 0; k < 2; ++k)
    forces.push_back({.node = nodes[k],
                      .force = ends.force[k],
                      .moment = ends.moment[k] + offsets[k].cross(ends.force[k])});
}

} // namespace plica
