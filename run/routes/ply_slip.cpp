#include "run/routes/ply_slip.hpp"

#include "model/description/place_keys.hpp"
#include "run/routes/route.hpp"
#include "words/input_error.hpp"
#include "words/short_text.hpp"

#include <cmath>

namespace plica {
namespace {

EndStiffness stiffness_alone(const Case& data, const std::string& name, Bellows bellows,
                             double bond) {
  bellows.wall.slip.reset();
  bellows.wall.bond = bond;
  Case alone;
  alone.materials = data.materials;
  alone.parts.push_back({name, bellows});
  for (const char* end : {"left", "right"}) {
    Cap cap;
    cap.name = end;
    cap.of = {name + "." + end};
    alone.caps.push_back(cap);
  }
  const BuiltCase built = build(alone);
  Timing timing;
  const StageListener quiet = [](const std::string&) {};
  Analyses analyses;
  analyses.symmetry = data.analyses.symmetry;
  const auto route = choose_route(built, analyses, quiet, timing);
  const Matrix1212 K =
      *route->end_stiffness({built.cap_nodes.at("left"), built.cap_nodes.at("right")});
  return end_stiffness(K.bottomRightCorner<6, 6>());
}

} // namespace

std::vector<DirectionalLaw> ply_laws(const Case& data, const std::string& name) {
  const Bellows* bellows = nullptr;
  for (const Part& part : data.parts)
    if (part.name == name) bellows = &std::get<Bellows>(part.body);
  const PlySlip& slip = *bellows->wall.slip;
  const EndStiffness slipping = stiffness_alone(data, name, *bellows, bellows->wall.bond);
  const EndStiffness stuck = stiffness_alone(data, name, *bellows, slip.bond);
  const double axial = stuck.axial - slipping.axial;
  const double bending = stuck.bending_x - slipping.bending_x;
  if (!(axial > 1e-6 * slipping.axial))
    input_error(part_key(name) + ".wall.slip.bond",
                "makes the wall no stiffer than bond " + short_text(bellows->wall.bond, 4),
                "a bond above that of the slipping wall, and at least two plies");
  // A ring of springs: bending k R^2 / 2 of the axial k, and a moment F R / 2 of the force F.
  const double radius = std::sqrt(2 * bending / axial);
  SlenderFriction friction;
  friction.axial.emplace().iwan =
      IwanLaw<false>{axial, slip.slip_force, slip.chi, slip.beta, 0, slip.sliders};
  friction.bending.emplace().iwan =
      IwanLaw<true>{bending, slip.slip_force * radius / 2, slip.chi, slip.beta, 0, slip.sliders};
  return directional_laws(friction);
}

BuiltCase slipping_case(const Case& data) {
  PlyLaws plies;
  for (const Part& part : data.parts)
    if (const auto* bellows = std::get_if<Bellows>(&part.body); bellows && bellows->wall.slip)
      plies[part.name] = ply_laws(data, part.name);
  return build_slipping(data, plies);
}

} // namespace plica
