#include "compare/fit/friction_responses.hpp"

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
  // "parts.NAME.friction...", "caps.NAME.friction...", "parts.NAME.wall.slip..."
  const auto name = path.find('.'), key = path.find('.', name + 1);
  if (name == std::string::npos || key == std::string::npos) return false;
  const std::string kind = path.substr(0, name), rest = path.substr(key);
  if (rest.find(".curve[") != std::string::npos) return false; // its slope is in the model
  const bool joint =
      (kind == "parts" || kind == "caps" || kind == "mount") && rest.starts_with(".friction.");
  return joint || (kind == "parts" && rest.starts_with(".wall.slip.") && rest != ".wall.slip.bond");
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
