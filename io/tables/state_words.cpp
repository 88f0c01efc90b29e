#include "io/tables/state_words.hpp"

#include "io/tables/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plica {

Json state_json(const StateResult& s) {
  Json iterations = Json::array(), reactions = Json::array(), buckling = Json::array();
  for (const StateIterationResult& i : s.iterations)
    iterations.push_back({{"share", json_number(i.share)},
                          {"residual", json_number(i.residual)},
                          {"step", json_number(i.step)}});
  for (const EndReaction& r : s.reactions)
    reactions.push_back({{"cap", r.cap}, {"force", r.force}, {"moment", r.moment}});
  for (const BucklingResult& b : s.buckling)
    buckling.push_back({{"factor", json_number(b.factor)}, {"across", json_number(b.sideways)}});
  Json heat = Json::array(), squirm = Json::array(), joints = Json::array();
  for (const StateJointResult& j : s.joints)
    joints.push_back({{"joint", j.joint},
                      {"motion", json_number(j.motion)},
                      {"force", json_number(j.force)},
                      {"slipped", json_number(j.slipped)}});
  Json bolts = Json::array();
  for (const BoltResult& b : s.bolts)
    bolts.push_back({{"part", b.part},
                     {"force", json_number(b.force)},
                     {"shortened", json_number(b.shortened)}});
  for (const HeatResult& h : s.heat)
    heat.push_back({{"part", h.part},
                    {"lowest", json_number(h.lowest)},
                    {"highest", json_number(h.highest)},
                    {"across", json_number(h.across)},
                    {"through", json_number(h.through)}});
  for (const SquirmResult& q : s.squirm)
    squirm.push_back({{"bellows", q.bellows},
                      {"kind", word_of(q.kind)},
                      {"limit", json_number(q.limit)},
                      {"factor", json_number(q.factor)}});
  Json json{{"name", s.name},
            {"loads", s.loads},
            {"sources", s.sources},
            {"heat", heat},
            {"squirm", squirm},
            {"turned_at", s.turned_at > 0 ? json_number(s.turned_at) : Json(nullptr)},
            {"route", s.route},
            {"load_steps", s.load_steps},
            {"iterations", iterations},
            {"largest_displacement", json_number(s.largest_displacement)},
            {"linear_error", json_number(s.linear_error)},
            {"reactions", reactions},
            {"joints", joints},
            {"bolts", bolts}};
  if (s.buckling_looked_for)
    json["buckling"] = {
        {"loads", buckling}, {"proved", s.buckling_proved}, {"reason", s.buckling_reason}};
  return json;
}

namespace {

// Segments of a joint in one sentence: that which moves farthest.
std::vector<std::string> joint_sentences(const StateResult& s) {
  std::vector<StateJointResult> farthest;
  for (StateJointResult j : s.joints) {
    j.joint = j.joint.substr(0, j.joint.find(','));
    const auto known = std::find_if(farthest.begin(), farthest.end(),
                                    [&](const auto& f) { return f.joint == j.joint; });
    if (known == farthest.end())
      farthest.push_back(j);
    else if (std::abs(j.motion) > std::abs(known->motion))
      *known = j;
  }
  double largest = 0;
  for (const StateJointResult& j : farthest)
    if (!j.angular) largest = std::max(largest, std::abs(j.motion));
  std::vector<std::string> sentences;
  for (const StateJointResult& j : farthest)
    if (std::abs(j.motion) > 1e-6 * (j.angular ? 1 : largest))
      sentences.push_back(
          fmt::format("{} has moved by {} {} and bears {} {}{}", j.joint,
                      significant((j.angular ? 1 : 1e3) * j.motion, 3), j.angular ? "rad" : "mm",
                      significant(j.force, 3), j.angular ? "Nm" : "N",
                      j.slipped > 0 ? fmt::format("; {:.0f} % of its friction, by stiffness, has "
                                                  "slipped",
                                                  100 * j.slipped)
                                    : ""));
  return sentences;
}

} // namespace

std::vector<std::string> state_sentences(const StateResult& s) {
  std::string loads;
  for (const std::string& load : s.loads) loads += (loads.empty() ? "" : "; ") + load;
  std::vector<std::string> sentences{
      loads.empty() ? "nothing acts" : loads,
      fmt::format("the farthest node moves by {} mm; {} load step{}, {} iterations, {}",
                  significant(1e3 * s.largest_displacement, 4), s.load_steps,
                  s.load_steps == 1 ? "" : "s", s.iterations.size(), s.route)};
  for (const HeatResult& h : s.heat)
    sentences.push_back(fmt::format("the wall of {} has {} to {} degC, at most {} K between its "
                                    "faces; {} W go through it",
                                    h.part, significant(h.lowest, 4), significant(h.highest, 4),
                                    significant(h.across, 2), significant(h.through, 3)));
  for (const std::string& source : s.sources) sentences.push_back("over temperature, " + source);
  if (s.turned_at > 0)
    sentences.push_back(fmt::format("the loads turn back at {} of them: the part snaps through, "
                                    "this is the state beyond",
                                    significant(s.turned_at, 3)));
  constexpr double good = 0.01, poor = 0.1;
  if (std::isfinite(s.linear_error) && s.largest_displacement > 0)
    sentences.push_back(fmt::format("a linear state would be {} % off in its displacements: {}",
                                    significant(100 * s.linear_error, 2),
                                    s.linear_error < good   ? "good enough"
                                    : s.linear_error < poor ? "for estimates only"
                                                            : "not good enough"));
  for (const EndReaction& r : s.reactions)
    sentences.push_back(fmt::format("the part pushes what holds cap {} by [{}, {}, {}] N and "
                                    "[{}, {}, {}] Nm",
                                    r.cap, significant(r.force[0], 4), significant(r.force[1], 4),
                                    significant(r.force[2], 4), significant(r.moment[0], 4),
                                    significant(r.moment[1], 4), significant(r.moment[2], 4)));
  for (const BoltResult& b : s.bolts)
    sentences.push_back(fmt::format("bolt {} is tightened by {} mm to {} N", b.part,
                                    significant(1e3 * b.shortened, 4), significant(b.force, 4)));
  for (std::string& joint : joint_sentences(s)) sentences.push_back(std::move(joint));
  return sentences;
}

std::vector<std::string> buckling_sentences(const StateResult& s) {
  std::vector<std::string> sentences;
  for (const BucklingResult& b : s.buckling)
    sentences.push_back(fmt::format("buckles at {} times these loads, {} % of the motion across "
                                    "the axis",
                                    significant(b.factor, 4), significant(100 * b.sideways, 2)));
  for (const SquirmResult& q : s.squirm) {
    const bool elastic = is_elastic(q.kind);
    sentences.push_back(
        fmt::format("{} of {} by {}: {}{} bar, {} times the pressure",
                    q.kind == SquirmKind::elastic_wall ? "elastic buckling of the wall"
                                                       : word_of(q.kind) + std::string(" squirm"),
                    q.bellows, elastic ? "its shells" : "EJMA", elastic ? "" : "limit ",
                    significant(q.limit / 1e5, 4), significant(q.factor, 4)));
  }
  if (!s.buckling_looked_for) return sentences;
  if (s.buckling.empty()) sentences.push_back("no buckling below 1000 times these loads");
  sentences.push_back(s.buckling_proved ? "counted by inertia: none is missing"
                                        : "not counted: " + s.buckling_reason);
  return sentences;
}

} // namespace plica
