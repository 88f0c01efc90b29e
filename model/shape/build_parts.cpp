#include "model/shape/building.hpp"

#include "mesh/dent.hpp"
#include "mesh/plate.hpp"
#include "model/description/place_keys.hpp"
#include "model/shape/build_bellows.hpp"
#include "model/shape/build_deck.hpp"
#include "model/shape/build_pipes.hpp"
#include "model/shape/build_surface.hpp"
#include "model/shape/wall_places.hpp"
#include "words/input_error.hpp"
#include "words/short_text.hpp"

#include <array>
#include <limits>

namespace plica {
namespace {

using Eigen::Vector3d;

void require_unfolded(const Mesh& mesh, const std::string& key, const std::string& allowed) {
  const double ratio = mesh_quality(mesh).min_jacobian;
  if (ratio > folded_ratio) return;
  input_error(key,
              "folds the mesh: a quad is turned over (Jacobian ratio " + short_text(ratio) + ")",
              allowed);
}

double bond(const Building& b, const Wall& wall) {
  return wall.slip && b.state == JointState::stuck ? wall.slip->bond : wall.bond;
}

void name_line(Building& b, const std::string& name, int first, int last) {
  auto& sets = b.built.model.mesh.sets;
  sets[name + ".start"] = {first};
  sets[name + ".end"] = {last};
  for (int node = first; node <= last; ++node) sets[name + ".all"].push_back(node);
}

void name_ends(Building& b, const std::string& name, const AxisNodes& nodes) {
  b.rigid_sections.push_back(name);
  auto& sets = b.built.model.mesh.sets;
  sets[name + ".left"] = {nodes.left};
  sets[name + ".right"] = {nodes.right};
  for (int node = nodes.left; node <= nodes.right; ++node) sets[name + ".all"].push_back(node);
}

BeamProperties beam_properties(const Building& b, const BeamSection& s) {
  if (s.shape == BeamShape::general) {
    constexpr double rigid = std::numeric_limits<double>::infinity();
    return {.EA = s.EA.value_or(0),
            .EI_y = s.EI.value_or(0),
            .EI_z = s.EI.value_or(0),
            .GJ = s.GJ.value_or(0),
            .GA_y = s.GA.value_or(rigid),
            .GA_z = s.GA.value_or(rigid),
            .mass = s.mass_per_length,
            .inertia_x = s.polar_inertia_per_length,
            .inertia_y = s.rotary_inertia_per_length,
            .inertia_z = s.rotary_inertia_per_length};
  }
  const Material& m = b.data.materials.at(s.material);
  const BeamMaterial material{m.E, m.nu, m.rho};
  if (s.shape == BeamShape::rectangle) return rectangle_section(material, s.width, s.depth);
  if (s.shape == BeamShape::solid) return round_section(material, s.radius);
  return pipe_section(material, s.radius, s.thickness);
}

void add(Building& b, const std::string& name, const Bellows& bellows) {
  const Meridian meridian = bellows_meridian(bellows);
  const int section = static_cast<int>(b.built.model.shells.size());
  Mesh mesh = bellows_mesh(bellows, meridian);
  for (std::size_t i = 0; i < bellows.dents.size(); ++i) {
    const DentSpot& dent = bellows.dents[i];
    if (press(mesh, {vector(dent.at), dent.depth, dent.radius}) < 3)
      input_error(part_key(name) + ".dents[" + std::to_string(i) + "]",
                  "has fewer than three nodes of the wall within its radius",
                  "a place on the wall, and a radius of a few elements");
    require_unfolded(mesh, part_key(name) + ".dents[" + std::to_string(i) + "]",
                     "a shallower or a wider dent: its flank turns the wall over");
  }
  append(b.built.model.mesh, mesh, name, section);
  const Material& m = b.data.materials.at(bellows.material);
  b.built.model.shells.push_back(
      {.section = {.E = m.E,
                   .nu = m.nu,
                   .rho = m.rho,
                   .bending_factor = ply_bending_factor(bellows.wall.plies, bond(b, bellows.wall))},
       .membrane = bellows.membrane,
       .component = b.component(name)});
  add_wall_places(b, name, bellows.places, b.built.model.shells.back().component);
  if (!b.built.meridian.empty() && bellows.start < b.built.meridian.back()[0] - 1e-9) return;
  for (const auto& curve : mesh_meridian(meridian))
    for (const MeridianPoint& p : curve)
      b.built.meridian.push_back({p.position.x(), p.position.y()});
}

void add(Building& b, const std::string& name, const Plate& plate) {
  const std::array corners{vector(plate.corners[0]), vector(plate.corners[1]),
                           vector(plate.corners[2]), vector(plate.corners[3])};
  const int section = static_cast<int>(b.built.model.shells.size());
  const Mesh mesh = mesh_plate(corners, plate.elements[0], plate.elements[1], plate.thickness);
  require_unfolded(mesh, part_key(name) + ".corners",
                   "four corners in order round the plate, each with an inner angle below 180 "
                   "deg; two plates where one is concave");
  append(b.built.model.mesh, mesh, name, section);
  const Material& m = b.data.materials.at(plate.material);
  b.built.model.shells.push_back({.section = {.E = m.E, .nu = m.nu, .rho = m.rho},
                                  .membrane = plate.membrane,
                                  .component = b.component(name)});
  add_wall_places(b, name, plate.places, b.built.model.shells.back().component);
}

// Those that are points of the wall rather than the nodes near them.
std::vector<PartPlace> points_of(const std::vector<SurfacePlace>& places) {
  std::vector<PartPlace> points;
  for (const SurfacePlace& place : places)
    if (place.within == 0) points.push_back({place.name, place.at});
  return points;
}

void add(Building& b, const std::string& name, const SurfacePart& surface) {
  const int section = static_cast<int>(b.built.model.shells.size());
  Mesh mesh;
  try {
    mesh = surface_mesh(surface);
  } catch (const std::runtime_error& error) {
    input_error(part_key(name), error.what(), "a surface that can be meshed, and places near it");
  }
  append(b.built.model.mesh, mesh, name, section);
  const Material& m = b.data.materials.at(surface.material);
  b.built.model.shells.push_back({.section = {.E = m.E, .nu = m.nu, .rho = m.rho},
                                  .membrane = surface.membrane,
                                  .component = b.component(name)});
  add_wall_places(b, name, points_of(surface.places), b.built.model.shells.back().component);
}

void add(Building& b, const std::string& name, const DeckPart& deck) {
  const int own = b.component(name);
  try {
    append(b.built.model, deck_model(deck), name, own);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    input_error(part_key(name) + ".file", error.what(), "a deck as docs/decks.md has it");
  }
  add_wall_places(b, name, points_of(deck.places), own);
}

// Shares of a stretch where it has nodes: even steps, its places, and what sensors need that sit
// farther than their reach from a node of the even steps.
std::vector<double> shares_of(const Building& b, const BeamPart& beam, std::size_t stretch) {
  constexpr double same = 1e-6; // of the stretch
  std::vector<double> shares;
  for (int e = 0; e <= beam.elements; ++e) shares.push_back(double(e) / beam.elements);
  const auto add = [&](double share) {
    if (std::none_of(shares.begin(), shares.end(),
                     [&](double other) { return std::abs(other - share) < same; }))
      shares.push_back(share);
  };
  for (const PartPlace& place : beam.places)
    if (const PlaceOnAxis at = nearest_on_axis(beam, place.at); at.stretch == stretch)
      add(at.share);
  const double length = (vector(beam.points[stretch + 1]) - vector(beam.points[stretch])).norm();
  const std::size_t regular = shares.size();
  for (const Sensor& sensor : b.data.sensors) {
    const PlaceOnAxis at = nearest_on_axis(beam, sensor.at);
    if (at.stretch != stretch || at.distance > outer_radius(beam.section) + sensor.reach) continue;
    if (std::none_of(shares.begin(), shares.begin() + std::ptrdiff_t(regular), [&](double other) {
          return std::abs(other - at.share) * length <= sensor.reach;
        }))
      add(at.share);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

void add(Building& b, const std::string& name, const BeamPart& beam) {
  const BeamProperties section = beam_properties(b, beam.section);
  const int own = b.component(name);
  const int first = add_node(b.built.model, vector(beam.points.front()));
  auto& sets = b.built.model.mesh.sets;
  sets[name + ".point[1]"] = {first};
  int previous = first;
  for (std::size_t p = 1; p < beam.points.size(); ++p) {
    const Vector3d from = vector(beam.points[p - 1]), to = vector(beam.points[p]);
    const std::vector<double> shares = shares_of(b, beam, p - 1);
    for (std::size_t e = 1; e < shares.size(); ++e) {
      const int next = add_node(b.built.model, from + (to - from) * shares[e]);
      b.built.model.beams.push_back({.node1 = previous,
                                     .node2 = next,
                                     .section = section,
                                     .up = vector(beam.up),
                                     .component = own});
      previous = next;
    }
    sets[name + ".point[" + std::to_string(p + 1) + "]"] = {previous};
  }
  name_line(b, name, first, previous);
  for (const PartPlace& place : beam.places)
    sets[name + "." + place.name] = {
        nearest_of(b.built.model.mesh, sets.at(name + ".all"), vector(place.at))};
  if (is_on_axis(beam)) b.rigid_sections.push_back(name);
}

void add(Building& b, const std::string& name, const EquivalentPipe& pipe) {
  const int own = b.component(name);
  name_ends(b, name, add_pipe(b.built.model, pipe, b.data.materials.at(pipe.material), own));
}

void add(Building& b, const std::string& name, const ConnectorChain& chain) {
  const int own = b.component(name);
  const auto first = b.built.model.bushings.size();
  name_ends(b, name, add_chain(b.built.model, chain, own, name));
  for (std::size_t k = first; k < b.built.model.bushings.size(); ++k) {
    const BushingElement& link = b.built.model.bushings[k];
    const bool at_end = k == first || k + 1 == b.built.model.bushings.size();
    const Connection between{name, int(k - first) + 1, link.node1, link.node2, own};
    add_curves(b.built.joints, between,
               at_end && chain.end_spring ? *chain.end_spring : chain.spring);
    if (chain.friction) add_joints(b.built.joints, between, directional_laws(*chain.friction));
  }
}

void add(Building&, const std::string&, const Interlock&) {}
void add(Building&, const std::string&, const PointMass&) {}

} // namespace

void add_parts(Building& b) {
  for (const Part& part : b.data.parts)
    std::visit([&](const auto& body) { add(b, part.name, body); }, part.body);
}

} // namespace plica
