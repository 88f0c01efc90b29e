#include "diagnose/effects/resonators.hpp"

#include "diagnose/effects/added_mass.hpp"
#include "diagnose/effects/beam_path.hpp"
#include "diagnose/effects/chosen_effects.hpp"
#include "diagnose/effects/plate_places.hpp"
#include "diagnose/effects/spots.hpp"
#include "lab/measured/states.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr Index own_parameters = 2; // mass and frequency; those of the place follow

using AlongEach = std::array<MovingMotion, 3>;

// The mean motion of nodes along an axis.
MovingMotion mean_motion(const std::vector<int>& nodes, int axis) {
  return {.terms = {{.apply = {},
                     .term = MotionTerm{.nodes = nodes,
                                        .dof = axis,
                                        .of = MotionTerm::Of::resonator,
                                        .begins = true}}},
          .factors = [](const VectorXd&) { return VectorXd::Ones(1); }};
}

template <class Along> AlongEach along_each(const Along& along) {
  return {along(0), along(1), along(2)};
}

// Behind the terms of each motion comes the one of its frequency.
VectorXd coefficients(const AlongEach& motions, const VectorXd& v) {
  const double omega = 2 * std::numbers::pi * v[1], root_of_stiffness = std::sqrt(v[0]) * omega;
  std::vector<double> all;
  for (const MovingMotion& m : motions) {
    for (double factor : m.factors(v.tail(v.size() - own_parameters)))
      all.push_back(root_of_stiffness * factor);
    all.push_back(omega);
  }
  return Eigen::Map<VectorXd>(all.data(), Index(all.size()));
}

class Listing {
public:
  explicit Listing(const Structure& s) : s_(s) {}

  void add(const std::string& place, const char* way, const std::vector<EffectParameter>& where,
           AlongEach motions, const Spot& spot = {}) {
    Hypothesis h{.effect = "resonator",
                 .place = place,
                 .way = way,
                 .parameters = {added_kilograms(s_),
                                {"frequency", "Hz", {PriorKind::log_normal, s_.frequency, 1}}},
                 .at_rig = has_baseline(s_.measured),
                 .resonates = true,
                 .between = spot.between,
                 .free_numbers = spot.free_numbers,
                 .weight = spot.weight};
    for (const EffectParameter& p : where) {
      h.along.push_back(h.parameters.size());
      h.parameters.push_back(p);
    }
    for (const MovingMotion& m : motions) {
      h.changes.insert(h.changes.end(), m.terms.begin(), m.terms.end());
      h.changes.push_back(
          {.apply = {}, .term = MotionTerm{.nodes = {}, .of = MotionTerm::Of::resonator}});
    }
    h.coefficients = [motions = std::move(motions)](const VectorXd& v) {
      return coefficients(motions, v);
    };
    if (sits_where_asked(s_.data, h)) found_.push_back(std::move(h));
  }

  std::vector<Hypothesis> all() && {
    look_at_those_alone(found_);
    return std::move(found_);
  }

private:
  const Structure& s_;
  std::vector<Hypothesis> found_;
};

} // namespace

std::vector<Hypothesis> resonators(const Structure& s) {
  constexpr auto of = MotionTerm::Of::resonator;
  Listing listing(s);
  for (const Spot& spot : contact_spots(s)) {
    if (is_anywhere(s, spot)) continue;
    const auto on = [&](const std::vector<int>& nodes) {
      return along_each([&](int axis) { return mean_motion(nodes, axis); });
    };
    if (!is_told_of_sensor(s, spot)) listing.add(spot.place, "", {}, on({spot.touched}), spot);
    if (spot.nodes.size() > 1)
      listing.add(spot.place, "on the mean motion", {}, on(spot.nodes), spot);
  }
  for (const BeamPath& path : line_paths(s))
    listing.add(path.part, "", path.place(), along_each([&](int axis) {
                  return motion_along(s, path, Vector3d::Unit(axis), of);
                }));
  for (const PlateGrid& grid : plate_grids(s))
    listing.add(grid.part, "", grid.place(),
                along_each([&](int axis) { return motion_on(s, grid, Vector3d::Unit(axis), of); }));
  return std::move(listing).all();
}

std::string words_of_resonator(const Hypothesis& h, const VectorXd& values) {
  const auto shown = [](double value) { // three digits, without a power of ten
    return fmt::format("{}", std::stod(fmt::format("{:.2e}", value)));
  };
  std::string masses = shown(1e3 * values[0]) + " g";
  const auto own = own_parameters + Index(h.along.size());
  for (double later : values.tail(values.size() - own))
    masses += ", then " + shown(1e3 * later) + " g";
  std::string text = fmt::format("{} on a spring of its own, which resonates at {} Hz, at {}",
                                 masses, shown(values[1]), h.place);
  if (!h.way.empty()) text += " (" + h.way + ")";
  for (std::size_t i : h.along) text += fmt::format(", {} m", shown(values[Index(i)]));
  return text;
}

} // namespace plica
