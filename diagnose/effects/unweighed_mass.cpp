#include "diagnose/effects/effect.hpp"
#include "lab/measured/states.hpp"

namespace plica {
namespace {

// On every shell and beam part, a share of its own mass. Beside a baseline it is what came since,
// and what was weighed afterwards was weighed with it.
std::vector<Hypothesis> unweighed_mass_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  const bool on_scale = has_baseline(s.measured);
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
                     .at_rig = on_scale,
                     .in_case =
                         [name = part.name](const Case& now, const Eigen::VectorXd& v) {
                           return with_own_material(now, name, 1, 1 + v[0]);
                         }});
  }
  return found;
}

} // namespace

Effect unweighed_mass() {
  return {.name = "unweighed_mass",
          .plain = "mass spread over a part that nobody weighed, {ratio%} of its own",
          .physics = "mass spread over a part that the scale did not see, or that came after the "
                     "baseline: a fluid, a coating",
          .signature = "all modes of the part fall, static stiffness stays; the mass grows where a "
                       "baseline was weighed",
          .look_alikes = {{"boundary_compliance", "an accelerometer on the held end"},
                          {"fixture_flexibility", "a response of the fixture"},
                          {"added_mass", "further modes"}},
          .needs = "a bellows, plate or beam",
          .hypotheses = unweighed_mass_hypotheses};
}

} // namespace plica
