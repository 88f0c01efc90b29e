#include "diagnose/effects/places.hpp"

#include <cmath>

namespace plica {
namespace {

constexpr double modulus_per_kelvin = -3.6e-4; // austenitic steel, room temperature to 300 C
constexpr double damping_per_kelvin = 5e-3;    // relative

} // namespace

std::vector<Hypothesis> damping(const Structure&) {
  return {{.effect = "damping",
           .place = "all",
           .way = "",
           .parameters = {{"ratio", "", {PriorKind::log_normal, 1, 0.6}}},
           .setup = [](TestSetup& setup, const Eigen::VectorXd& v) { setup.damping *= v[0]; }}};
}

// Young's modulus of all shells and beams, and damping.
std::vector<Hypothesis> temperature(const Structure&) {
  return {
      {.effect = "temperature",
       .place = "all",
       .way = "",
       .parameters = {{"delta_T", "K", {PriorKind::normal, 0, 60}}},
       .changes = {{[](Model& model) {
                      for (ShellProperties& s : model.shells) s.section.E *= 0.9;
                      for (BeamElement& b : model.beams)
                        for (double* n : {&b.section.EA, &b.section.EI_y, &b.section.EI_z,
                                          &b.section.GJ, &b.section.GA_y, &b.section.GA_z})
                          *n *= 0.9;
                    },
                    Follow::series}},
       .coefficients =
           [](const Eigen::VectorXd& v) { return Eigen::VectorXd(-modulus_per_kelvin / 0.1 * v); },
       .setup =
           [](TestSetup& setup, const Eigen::VectorXd& v) {
             setup.damping *= std::exp(damping_per_kelvin * v[0]);
           }}};
}

// On every shell and beam part, a share of its own mass.
std::vector<Hypothesis> unweighed_mass(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const Part& part : s.data.parts) {
    if (!std::holds_alternative<Bellows>(part.body) && !std::holds_alternative<Plate>(part.body) &&
        !std::holds_alternative<BeamPart>(part.body))
      continue;
    found.push_back({.effect = "unweighed_mass",
                     .place = part.name,
                     .way = "",
                     .parameters = {{"ratio", "", {PriorKind::log_normal, 0.1, 0.8}}},
                     .changes = {{[name = part.name](Model& model) {
                                    for (ShellProperties& shell : model.shells)
                                      if (model.components[std::size_t(shell.component)] == name)
                                        shell.section.rho *= 2;
                                    for (BeamElement& b : model.beams)
                                      if (model.components[std::size_t(b.component)] == name)
                                        for (double* n :
                                             {&b.section.mass, &b.section.inertia_x,
                                              &b.section.inertia_y, &b.section.inertia_z})
                                          *n *= 2;
                                  },
                                  Follow::series}},
                     .coefficients = [](const Eigen::VectorXd& v) { return v; },
                     .at_rig = false});
  }
  return found;
}

} // namespace plica
