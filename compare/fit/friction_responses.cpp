#include "compare/fit/friction_responses.hpp"

#include "model/description/place_keys.hpp"
#include "run/analyses/levels.hpp"
#include "run/routes/ply_slip.hpp"

namespace plica {

FrictionResponses::FrictionResponses(const Case& data) {
  const BuiltCase slipping = slipping_case(data);
  Timing timing;
  const StageListener quiet = [](const std::string&) {};
  const auto route = choose_route(slipping, data.analyses, quiet, timing);
  model_ = jointed_model(data, slipping, *route);
  joints_ = slipping.joints;
}

bool FrictionResponses::is_friction(const std::string& path) {
  const auto place = path_in_place(path);
  if (!place || place->key.find(".curve[") != std::string::npos) return false; // is in the model
  return place->key.starts_with("friction.") ||
         (place->kind == PlaceKind::part && place->key.starts_with("wall.slip.") &&
          place->key != "wall.slip.bond");
}

std::vector<LevelResponses> FrictionResponses::operator()(const Case& design) const {
  JointedModel model = model_;
  const auto laws = laws_in(design, joints_);
  const Eigen::VectorXd before = stuck_stiffness(model.structure).diagonal();
  model.structure.laws = laws ? *laws : laws_of(slipping_case(design).joints);
  // The damping ratio holds with these joints stuck.
  const Eigen::VectorXd now = stuck_stiffness(model.structure).diagonal();
  model.structure.zeta.array() *= (now.array() / before.array()).sqrt();
  return level_responses(model, *design.analyses.levels, [](const std::string&) {});
}

} // namespace plica
