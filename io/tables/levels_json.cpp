#include "io/tables/levels_json.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/levels_csv.hpp"

#include <cmath>

namespace plica {
namespace {

Json json_of(const std::vector<LevelPeak>& peaks, const LevelResponses& responses) {
  Json list = Json::array();
  for (const LevelPeak& p : peaks)
    list.push_back({{"sensor", responses.channels[std::size_t(p.channel)].first},
                    {"direction", responses.channels[std::size_t(p.channel)].second},
                    {"frequency", json_number(p.frequency)},
                    {"amplitude", json_number(p.amplitude)},
                    {"damping", json_number(p.damping)},
                    {"energy_damping", json_number(p.energy_damping)}});
  return list;
}

Json json_of(const LevelCurve& curve, const LevelResponses& responses) {
  Json joints = Json::array();
  for (const JointMotion& j : curve.joints)
    joints.push_back({{"joint", j.joint},
                      {"motion", json_number(j.motion)},
                      {"mean", json_number(j.mean)},
                      {"energy", json_number(j.energy)}});
  return {{"level", json_number(curve.level)},
          {"complete", curve.complete},
          {"reason", curve.reason},
          {"peaks_up", json_of(curve.peaks_up, responses)},
          {"peaks_down", json_of(curve.peaks_down, responses)},
          {"jumps_up", curve.jumps_up},
          {"jumps_down", curve.jumps_down},
          {"joints", joints}};
}

Json json_of(const BackboneCurve& b) {
  Json points = Json::array();
  for (Eigen::Index i = 0; i < b.amplitude.size(); ++i)
    points.push_back({{"amplitude", json_number(b.amplitude[i])},
                      {"frequency", json_number(b.frequency[i])},
                      {"damping", json_number(b.damping[i])}});
  return {{"stuck_frequency", json_number(b.stuck_frequency)},
          {"complete", b.complete},
          {"reason", b.reason},
          {"points", points}};
}

Json json_of(const LevelResponses& responses) {
  Json curves = Json::array(), backbones = Json::array(), fast = Json::array(),
       referee = Json::array();
  for (const LevelCurve& c : responses.curves) curves.push_back(json_of(c, responses));
  for (const BackboneCurve& b : responses.backbones) backbones.push_back(json_of(b));
  for (const LinearisedError& e : responses.linearised)
    fast.push_back({{"level", json_number(e.level)},
                    {"frequency", json_number(e.frequency)},
                    {"amplitude", json_number(e.amplitude)}});
  for (const RefereeCheck& r : responses.referee)
    referee.push_back({{"level", json_number(r.level)},
                       {"frequency", json_number(r.frequency)},
                       {"difference", json_number(r.difference)},
                       {"settled", r.settled}});
  return {{"base", responses.is_force ? Json(nullptr) : Json(responses.excitation)},
          {"force", responses.is_force ? Json(responses.excitation) : Json(nullptr)},
          {"unit", responses.unit},
          {"method", responses.method},
          {"harmonics", responses.harmonics},
          {"joints", responses.joints},
          {"modes", responses.modes},
          {"file", levels_name(responses) + ".csv"},
          {"levels", curves},
          {"backbones", backbones},
          {"linearised_error", fast},
          {"referee", referee},
          {"seconds", json_number(responses.seconds)}};
}

} // namespace

Json levels_json(const Results& results) {
  Json list = Json::array();
  for (const LevelResponses& responses : results.level_responses)
    list.push_back(json_of(responses));
  return list;
}

Json slipping_json(const SlippingLimit& slipping) {
  return {
      {"joints", slipping.joints},
      {"k_axial_stuck", slipping.k_axial_stuck > 0 ? Json(slipping.k_axial_stuck) : Json(nullptr)}};
}

} // namespace plica
