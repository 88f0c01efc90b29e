#include "diagnose/weigh/fit_words.hpp"

#include "diagnose/weigh/likely_values.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace plica {
namespace {

// "0.22" of a line, "0.22 m along and 0.05 m across" of a plate.
std::string place_words(const std::vector<double>& at) {
  return at.size() == 1 ? fmt::format("{:.3g}", at[0])
                        : fmt::format("{:.3g} m along and {:.3g} m across", at[0], at[1]);
}

// "0.22 or 0.38 m along": where it acts on its part, and where it would as well.
std::string places_along(const HypothesisFit& fit, std::size_t member) {
  const Hypothesis& h = *fit.together[member];
  constexpr double apart = 0.05; // of the part
  const auto is_elsewhere = [&](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Prior& prior = h.parameters[h.along[i]].prior;
      if (std::abs(a[i] - b[i]) > apart * (prior.width - prior.centre)) return true;
    }
    return false;
  };
  const Eigen::VectorXd likely = likely_values(fit, member);
  std::vector<std::vector<double>> places{{}};
  for (const std::size_t parameter : h.along) places[0].push_back(likely[Eigen::Index(parameter)]);
  for (const Eigen::VectorXd& other : fit.others) {
    std::vector<double> at;
    for (const std::size_t parameter : h.along)
      at.push_back(value_of(h.parameters[parameter].prior,
                            other[fit.first_of(member) + Eigen::Index(parameter)]));
    if (std::all_of(places.begin(), places.end(),
                    [&](const std::vector<double>& known) { return is_elsewhere(at, known); }))
      places.push_back(std::move(at));
  }
  std::string text;
  for (const std::vector<double>& at : places)
    text += (text.empty() ? "" : " or ") + place_words(at);
  return h.along.size() == 1 ? text + " m along" : text;
}

} // namespace

std::string name_of(const HypothesisFit& fit) {
  if (fit.together.empty()) return "nominal case";
  std::string name;
  for (std::size_t member = 0; member < fit.together.size(); ++member) {
    const Hypothesis& h = *fit.together[member];
    if (!name.empty()) name += " and ";
    name += h.effect + " at " + h.place;
    if (!h.along.empty() && fit.values.size() > 0) name += ", " + places_along(fit, member);
    if (!h.way.empty()) name += " (" + h.way + ")";
  }
  return name;
}

} // namespace plica
