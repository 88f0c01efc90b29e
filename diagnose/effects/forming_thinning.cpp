#include "diagnose/effects/places.hpp"
#include "lab/measured/states.hpp"
#include "model/description/place_keys.hpp"

#include <cmath>

namespace plica {
namespace {

// t (r_root / r)^p on top of what the wall has.
void thin(Model& model, const WallElements& wall, double exponent) {
  for (int q : wall.quads) {
    ShellQuad& quad = model.mesh.quads[std::size_t(q)];
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d& x = model.mesh.nodes[quad.nodes[std::size_t(corner)]];
      quad.thickness[corner] *= std::pow(wall.root_radius / std::hypot(x.x(), x.z()), exponent);
    }
  }
}

// Stiffness and mass are smooth in the exponent; a parabola through two samples follows them within
// 0.1 % up to exponents of 1.5.
std::vector<Hypothesis> forming_thinning_hypotheses(const Structure& s) {
  std::vector<Hypothesis> found;
  if (has_baseline(s.measured)) return found; // what was formed stays as it is
  const std::vector<double> samples{0.6, 1.2};
  const auto coefficients = coefficients_through(
      [](double p) { return Eigen::VectorXd(Eigen::Vector2d(p, p * p)); }, samples);
  for (const WallElements& wall : walls(s)) {
    Hypothesis h{
        .effect = "forming_thinning",
        .place = wall.part,
        .way = "",
        .parameters = {{"exponent", "", {PriorKind::log_normal, 0.4, 0.7}}},
        .coefficients = [coefficients](const Eigen::VectorXd& v) { return coefficients(v[0]); }};
    h.in_case = [part = wall.part](const Case& now, const Eigen::VectorXd& v) -> CaseEdits {
      const Wall& own = std::get<Bellows>(part_named(now, part)->body).wall;
      const std::string path = part_key(part) + ".wall.";
      if (own.thinning == Thinning::uniform) return {};
      const double there = own.thinning == Thinning::local ? own.thinning_exponent : 0;
      return {{path + "thinning", "local"}, {path + "thinning_exponent", yaml_of(there + v[0])}};
    };
    for (double p : samples)
      h.changes.push_back({[wall, p](Model& model) { thin(model, wall, p); }, Follow::modes});
    found.push_back(std::move(h));
  }
  return found;
}

} // namespace

Effect forming_thinning() {
  return {
      .name = "forming_thinning",
      .plain = "a wall that forming made thinner towards the crown",
      .physics = "the wall is thinner towards the crown, as forming leaves it",
      .signature = "the stiffness falls, and the mass a little",
      .look_alikes = {{"ply_slip", "weigh, measure the thickness"}, {"temperature", "weigh", true}},
      .needs = "a bellows, and a test without a baseline: a wall is formed once",
      .hypotheses = forming_thinning_hypotheses};
}

} // namespace plica
