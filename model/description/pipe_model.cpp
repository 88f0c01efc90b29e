#include "model/description/pipe_model.hpp"

#include "model/description/connector_curve.hpp"

#include <Eigen/Cholesky>
#include <limits>
#include <numbers>

namespace plica {
namespace {

constexpr double shear_factor = 0.53; // of a thin pipe

BeamProperties layer_section(const PipeLayer& layer, double over, double mass_per_length,
                             const EquivalentPipe& pipe) {
  constexpr double rigid = std::numeric_limits<double>::infinity();
  const double R2 = layer.radius * layer.radius;
  const double EA = layer.axial * over, GJ = layer.torsion * over;
  const double GA = pipe.shear == PipeShear::rigid || GJ == 0 ? rigid : shear_factor * GJ / R2;
  const double gyration = layer.mass_radius.value_or(layer.radius);
  const double polar = mass_per_length * gyration * gyration;
  const double across = pipe.rotary_inertia ? polar / 2 : 0;
  return {.EA = EA,
          .EI_y = EA * R2 / 2,
          .EI_z = EA * R2 / 2,
          .GJ = GJ,
          .GA_y = GA,
          .GA_z = GA,
          .mass = mass_per_length,
          .inertia_x = polar,
          .inertia_y = across,
          .inertia_z = across};
}

} // namespace

std::vector<PipeStretch> pipe_stretches(const EquivalentPipe& pipe, const Material& material) {
  const double over = pipe.modulus_over == PipeLength::whole ? pipe.length : pipe.convoluted;
  const double straight = (pipe.length - pipe.convoluted) / 2;
  const double outer_mass =
      2 * std::numbers::pi * pipe.outer.radius * pipe.outer.wall * material.rho;
  const BeamProperties end =
      pipe_section({material.E, material.nu, material.rho}, pipe.end_radius, pipe.end_wall);
  std::vector<PipeStretch> stretches;
  const double a = pipe.start, b = a + straight, c = b + pipe.convoluted, d = a + pipe.length;
  if (straight > 0) {
    stretches.push_back({a, (a + b) / 2, 2, {end}, pipe.end_cap});
    stretches.push_back({(a + b) / 2, b, 2, {end}});
  }
  stretches.push_back({b, c, pipe.elements, {layer_section(pipe.outer, over, outer_mass, pipe)}});
  if (straight > 0) {
    stretches.push_back({c, (c + d) / 2, 2, {end}, pipe.end_cap});
    stretches.push_back({(c + d) / 2, d, 2, {end}});
  }
  if (pipe.inner)
    for (PipeStretch& s : stretches)
      s.layers.push_back(layer_section(*pipe.inner, over, pipe.inner->mass / pipe.length, pipe));
  return stretches;
}

Matrix6 connector_law(const ConnectorSpring& s) {
  Matrix6 law = Matrix6::Zero();
  const double along = s.axial_curve.empty() ? s.axial : stiffness_at_rest(s.axial_curve);
  const double across =
      s.transverse_curve.empty() ? s.transverse : stiffness_at_rest(s.transverse_curve);
  law.diagonal() << across, along, across, s.bending, s.torsion, s.bending;
  for (std::size_t row = 0; row < s.matrix.size(); ++row)
    for (int column = 0; column < 6; ++column)
      law(Eigen::Index(row), column) = s.matrix[row][column];
  return law;
}

bool resists_every_motion(const ConnectorSpring& spring) {
  return connector_law(spring).llt().info() == Eigen::Success;
}

} // namespace plica
