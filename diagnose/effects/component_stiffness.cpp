#include "diagnose/effects/beam_stiffness.hpp"
#include "diagnose/effects/places.hpp"
#include "lab/measured/states.hpp"

namespace plica {
namespace {

ModelChange doubled(const PartGroup& group) {
  return {[group](Model& model) {
            for (ShellProperties& shell : model.shells)
              if (group.holds(model, shell.component)) shell.section.E *= 2;
            for (BeamElement& b : model.beams)
              if (group.holds(model, b.component)) scale_stiffness(b.section, 2);
          },
          Follow::modes};
}

// All stiffness of a part by one factor: it says where, not why. Of a structure of one part it
// would be a modulus, which no specimen has another of; beside a baseline a part stays what it is.
std::vector<Hypothesis> component_stiffness_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  if (has_baseline(s.measured)) return found;
  for (const PartGroup& group : part_groups(s))
    found.push_back(
        {.effect = "component_stiffness",
         .place = group.place,
         .way = "",
         .parameters = {{"ratio", "", {PriorKind::log_normal, 1, 0.5}}},
         .changes = {doubled(group)},
         .coefficients = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(v.array() - 1); },
         .names_place_only = true,
         .in_case =
             [parts = group.parts](const Case& now, const Eigen::VectorXd& v) {
               CaseEdits edits;
               for (const std::string& part : parts)
                 for (CaseEdit& edit : with_own_material(now, part, v[0], 1))
                   edits.push_back(std::move(edit));
               return edits;
             }});
  return found.size() > 1 ? found : std::vector<Hypothesis>();
}

} // namespace

Effect component_stiffness() {
  return {.name = "component_stiffness",
          .plain = "a part with {ratio} times the drawn stiffness, cause open",
          .physics =
              "a part is stiffer or softer than drawn, all of it by one factor: another part, "
              "or a cause at that place which is not known here",
          .signature = "modes that strain the part, at every level alike",
          .look_alikes = {{"component_mass", "weigh the part", true},
                          {"ply_slip", "further levels"},
                          {"boundary_compliance", "an accelerometer on the held end"}},
          .needs = "two parts of shells or beams, and no baseline",
          .hypotheses = component_stiffness_hypotheses};
}

} // namespace plica
