#include "io/tables/levels_json.hpp"

#include "io/files/json_text.hpp"
#include "io/tables/levels_csv.hpp"

#include <cmath>

namespace plica {
namespace {

Json json_of(const std::vector<LevelPeak>& peaks, const LevelFamily& family) {
  Json list = Json::array();
  for (const LevelPeak& p : peaks)
    list.push_back({{"sensor", family.channels[std::size_t(p.channel)].first},
                    {"direction", family.channels[std::size_t(p.channel)].second},
                    {"frequency", json_number(p.frequency)},
                    {"amplitude", json_number(p.amplitude)},
                    {"damping", json_number(p.damping)},
                    {"energy_damping", json_number(p.energy_damping)}});
  return list;
}

Json json_of(const LevelCurve& curve, const LevelFamily& family) {
  Json joints = Json::array();
  for (const JointMotion& j : curve.joints)
    joints.push_back(
        {{"joint", j.joint}, {"motion", json_number(j.motion)}, {"energy", json_number(j.energy)}});
  return {{"level", json_number(curve.level)},
          {"complete", curve.complete},
          {"reason", curve.reason},
          {"peaks_up", json_of(curve.peaks_up, family)},
          {"peaks_down", json_of(curve.peaks_down, family)},
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

Json json_of(const LevelFamily& family) {
  Json curves = Json::array(), backbones = Json::array(), fast = Json::array(),
       referee = Json::array();
  for (const LevelCurve& c : family.curves) curves.push_back(json_of(c, family));
  for (const BackboneCurve& b : family.backbones) backbones.push_back(json_of(b));
  for (const LinearisedError& e : family.linearised)
    fast.push_back({{"level", json_number(e.level)},
                    {"frequency", json_number(e.frequency)},
                    {"amplitude", json_number(e.amplitude)}});
  for (const RefereeCheck& r : family.referee)
    referee.push_back({{"level", json_number(r.level)},
                       {"frequency", json_number(r.frequency)},
                       {"difference", json_number(r.difference)},
                       {"settled", r.settled}});
  return {{"base", family.is_force ? Json(nullptr) : Json(family.excitation)},
          {"force", family.is_force ? Json(family.excitation) : Json(nullptr)},
          {"unit", family.unit},
          {"method", family.method},
          {"harmonics", family.harmonics},
          {"joints", family.joints},
          {"modes", family.modes},
          {"file", levels_name(family) + ".csv"},
          {"levels", curves},
          {"backbones", backbones},
          {"linearised_error", fast},
          {"referee", referee},
          {"seconds", json_number(family.seconds)}};
}

} // namespace

Json levels_json(const Results& results) {
  Json list = Json::array();
  for (const LevelFamily& family : results.families) list.push_back(json_of(family));
  return list;
}

Json slipping_json(const SlippingLimit& slipping) {
  return {
      {"joints", slipping.joints},
      {"k_axial_stuck", slipping.k_axial_stuck > 0 ? Json(slipping.k_axial_stuck) : Json(nullptr)}};
}

} // namespace plica
