#include "model/shape/build_bellows.hpp"

#include "mesh/generation/revolve.hpp"
#include "model/description/profile.hpp"
#include "model/shape/mesh_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

using std::numbers::pi;

Convolution convolution(const MeridianSection& s) {
  return {.height = s.height,
          .pitch = s.pitch,
          .root_arc = root_arc_radius(s),
          .crown_arc = crown_arc_radius(s)};
}

int cuff_elements(const Bellows& bellows, const MeridianSection& cuff, double radius,
                  const ElementCounts& n) {
  if (cuff.elements > 0) return cuff.elements;
  if (bellows.mesh.wall > 0) return n.wall;
  const double bending_length = std::sqrt(radius * total_thickness(bellows.wall));
  const double longest = std::min(2 * pi * radius / n.around, 2.5 * bending_length / n.wall);
  return std::max(1, static_cast<int>(std::ceil(cuff.length / longest - 1e-9)));
}

// Adds a section whose cuffs have their elements.
void add_section(Meridian& meridian, const MeridianSection& s, const ElementCounts& n) {
  const MeridianDensity density{n.arc, n.wall};
  std::vector<Eigen::Vector2d> points;
  for (const auto& p : s.points) points.emplace_back(p[0], p[1]);
  const auto add_one = [&] {
    switch (s.shape) {
    case SectionShape::cuff:
      return meridian.add_cuff(s.length, s.end_radius > 0 ? s.end_radius : meridian.radius(),
                               s.elements);
    case SectionShape::u:
    case SectionShape::omega:
      return meridian.add_convolution(convolution(s), density);
    case SectionShape::disc:
      return meridian.add_disc(s.height, s.pitch, density);
    case SectionShape::points:
      return meridian.add_points(points, s.interpolation == Interpolation::smooth, density);
    }
  };
  const int count = s.shape == SectionShape::cuff ? 1 : s.count;
  for (int k = 0; k < count; ++k) add_one();
}

std::function<double(double)> thickness_law(const Bellows& bellows) {
  const double t = total_thickness(bellows.wall), root = bellows.root_radius;
  double height = 0;
  for (const MeridianSection& s : bellows.profile) {
    height = std::max(height, s.height);
    for (const auto& p : s.points) height = std::max(height, p[1] - root);
  }
  switch (bellows.wall.thinning) {
  case Thinning::none:
    break;
  case Thinning::uniform:
    return [thinned = t * std::sqrt(root / (root + height / 2))](double) { return thinned; };
  case Thinning::local:
    return [t, root, p = bellows.wall.thinning_exponent](double r) {
      return t * std::pow(root / r, p);
    };
  }
  return [t](double) { return t; };
}

} // namespace

Bellows with_counts(Bellows bellows) {
  const ElementCounts n = element_counts(bellows);
  Meridian meridian(bellows.start, bellows.root_radius); // tells the radius at each cuff
  const Bellows given = bellows;
  for (MeridianSection& s : bellows.profile) {
    if (s.shape == SectionShape::cuff) s.elements = cuff_elements(given, s, meridian.radius(), n);
    add_section(meridian, s, n);
  }
  bellows.mesh = {.around = n.around, .arc = n.arc, .wall = n.wall};
  return bellows;
}

Meridian bellows_meridian(const Bellows& given) {
  const Bellows bellows = with_counts(given);
  const MeshDensity& mesh = bellows.mesh;
  Meridian meridian(bellows.start, bellows.root_radius);
  for (const MeridianSection& s : bellows.profile)
    add_section(meridian, s, {.around = mesh.around, .arc = mesh.arc, .wall = mesh.wall});
  return meridian;
}

Mesh bellows_mesh(const Bellows& bellows, const Meridian& meridian) {
  return revolve(meridian, element_counts(bellows).around, thickness_law(bellows));
}

} // namespace plica
