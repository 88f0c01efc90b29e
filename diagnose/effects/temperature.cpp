#include "diagnose/effects/places.hpp"

#include <algorithm>

namespace plica {
namespace {

constexpr double modulus_per_kelvin = -3.6e-4; // austenitic steel, room temperature to 300 C
constexpr double damping_per_kelvin = 5e-3;    // relative

// A laboratory's. A test that is hot or cold says so (`diagnose: priors` of the case).
constexpr double laboratory = 10; // K

// Young's modulus of all shells and beams, and damping.
std::vector<Hypothesis> temperature_hypotheses(const Structure&) {
  return {
      {.effect = "temperature",
       .place = "all",
       .way = "",
       .parameters = {{"delta_T", "K", {PriorKind::normal, 0, 100, -laboratory, laboratory}}},
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
             setup.damping *= std::max(0.1, 1 + damping_per_kelvin * v[0]);
           },
       .in_case =
           [](const Case& now, const Eigen::VectorXd& v) {
             CaseEdits edits = with_damping(now, std::max(0.1, 1 + damping_per_kelvin * v[0]));
             const double E = 1 + modulus_per_kelvin * v[0];
             for (const auto& [name, material] : now.materials)
               scale(edits, "materials." + name + ".E", material.E, E);
             for (const Part& part : now.parts)
               if (const auto* liner = std::get_if<Interlock>(&part.body))
                 for (const auto& [key, value] :
                      {std::pair{"EA", liner->EA}, std::pair{"EI", liner->EI},
                       std::pair{"GJ", liner->GJ}})
                   scale(edits, "parts." + part.name + "." + key, value, E);
             return edits;
           }}};
}

} // namespace

Effect temperature() {
  return {.name = "temperature",
          .plain = "a temperature {delta_T} off that of the material data",
          .physics = "the specimen is warmer or colder than the material data",
          .signature = "frequencies, static stiffness and damping move together",
          .look_alikes = {"ply_slip: a thermometer", "damping: repeat after a soak"},
          .needs = "",
          .hypotheses = temperature_hypotheses};
}

} // namespace plica
