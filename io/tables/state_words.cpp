#include "io/tables/state_words.hpp"

#include "io/tables/text.hpp"

#include <fmt/format.h>

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
  Json json{{"loads", s.loads},
            {"route", s.route},
            {"load_steps", s.load_steps},
            {"iterations", iterations},
            {"largest_displacement", json_number(s.largest_displacement)},
            {"linear_error", json_number(s.linear_error)},
            {"reactions", reactions}};
  if (s.buckling_looked_for)
    json["buckling"] = {
        {"loads", buckling}, {"proved", s.buckling_proved}, {"reason", s.buckling_reason}};
  return json;
}

std::vector<std::string> state_sentences(const StateResult& s) {
  std::string loads;
  for (const std::string& load : s.loads) loads += (loads.empty() ? "" : "; ") + load;
  std::vector<std::string> sentences{
      loads.empty() ? "nothing acts" : loads,
      fmt::format("the farthest node moves by {} mm; {} load step{}, {} iterations, {}",
                  significant(1e3 * s.largest_displacement, 4), s.load_steps,
                  s.load_steps == 1 ? "" : "s", s.iterations.size(), s.route)};
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
  return sentences;
}

std::vector<std::string> buckling_sentences(const StateResult& s) {
  std::vector<std::string> sentences;
  for (const BucklingResult& b : s.buckling)
    sentences.push_back(fmt::format("buckles at {} times these loads, {} % of the motion across "
                                    "the axis",
                                    significant(b.factor, 4), significant(100 * b.sideways, 2)));
  if (!s.buckling_looked_for) return sentences;
  if (s.buckling.empty()) sentences.push_back("no buckling below 1000 times these loads");
  sentences.push_back(s.buckling_proved ? "counted by inertia: none is missing"
                                        : "not counted: " + s.buckling_reason);
  return sentences;
}

} // namespace plica
