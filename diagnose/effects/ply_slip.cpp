#include "diagnose/effects/places.hpp"
#include "model/description/place_keys.hpp"

#include <cmath>

namespace plica {
namespace {

void set_bending(Model& model, const PartGroup& group, double factor) {
  for (ShellProperties& shell : model.shells)
    if (group.holds(model, shell.component)) shell.section.bending_factor = factor;
}

const Bellows* bellows_of(const Structure& s, const std::string& name) {
  for (const Part& part : s.data.parts)
    if (part.name == name) return std::get_if<Bellows>(&part.body);
  return nullptr;
}

// Plies with bond fraction b bend with D_slip + b (D_solid - D_slip) (elements/shell_section.hpp).
// A wall stated as one ply is taken as two that the case believes bonded. The points through the
// thickness move in by the root of the factor, which is why it comes in as well.
std::vector<Hypothesis> ply_slip_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  for (const PartGroup& group : part_groups(s)) {
    const Bellows* bellows = bellows_of(s, group.parts.front());
    if (!bellows) continue;
    std::vector<double> plies = bellows->wall.plies;
    double bond = bellows->wall.bond;
    if (plies.size() == 1) {
      plies = {plies[0] / 2, plies[0] / 2};
      bond = 1;
    }
    const double nominal = ply_bending_factor(plies, bond);
    const auto functions = [plies, nominal](double b) {
      const double factor = ply_bending_factor(plies, b);
      return Eigen::VectorXd(
          Eigen::Vector2d(factor - nominal, std::sqrt(factor) - std::sqrt(nominal)));
    };
    std::vector<double> samples; // two bonds away from the nominal one
    for (double b : {0., 1., 0.4})
      if (std::abs(b - bond) > 0.2 && samples.size() < 2) samples.push_back(b);
    const auto coefficients = coefficients_through(functions, samples);
    Hypothesis h{
        .effect = "ply_slip",
        .place = group.place,
        .way = "",
        .parameters = {{"bond", "", {PriorKind::uniform, 0, 1}}},
        .coefficients = [coefficients](const Eigen::VectorXd& v) { return coefficients(v[0]); }};
    h.in_case = [parts = group.parts](const Case& now, const Eigen::VectorXd& v) {
      CaseEdits edits;
      for (const std::string& part : parts) {
        const std::string wall = part_key(part) + ".wall.";
        const Wall& own = std::get<Bellows>(part_named(now, part)->body).wall;
        if (const double t = own.plies[0] / 2; own.plies.size() == 1)
          edits.push_back({wall + "plies", "[" + yaml_of(t) + ", " + yaml_of(t) + "]"});
        edits.push_back({wall + "bond", yaml_of(v[0])});
      }
      return edits;
    };
    for (double b : samples)
      h.changes.push_back({[group, factor = ply_bending_factor(plies, b)](Model& model) {
                             set_bending(model, group, factor);
                           },
                           Follow::modes});
    found.push_back(std::move(h));
  }
  return found;
}

} // namespace

Effect ply_slip() {
  return {.name = "ply_slip",
          .plain = "plies of the wall that slip on each other",
          .physics = "the plies of the wall slip on each other more, or less, than the case says",
          .signature = "all elastic modes and the static stiffness fall alike, the mass stays",
          .look_alikes = {{"forming_thinning", "weigh, measure the thickness by ultrasound"},
                          {"temperature", "repeat after a soak"},
                          {"joint_stiffness", "a sweep at a lower level, strain of other modes"}},
          .needs = "a bellows",
          .hypotheses = ply_slip_hypotheses};
}

} // namespace plica
