#include "run/study/refine.hpp"

#include "model/shape/build_bellows.hpp"
#include "model/shape/mesh_choice.hpp"

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

int more(int elements, double factor) {
  return static_cast<int>(std::ceil(elements * factor - 1e-9));
}

void refine(Bellows& bellows, const Refinement& f) {
  bellows = with_counts(bellows);
  MeshDensity& mesh = bellows.mesh;
  mesh.arc = more(mesh.arc, f.along);
  mesh.wall = more(mesh.wall, f.along);
  mesh.around = 2 * more(mesh.around / 2, f.around);
  for (MeridianSection& s : bellows.profile) s.elements = more(s.elements, f.along);
}
void refine(Plate& plate, const Refinement& f) {
  plate.elements = {more(plate.elements[0], f.along), more(plate.elements[1], f.around)};
}
void refine(SurfacePart& surface, const Refinement& f) {
  surface.size /= f.along; // it has no other direction
  surface.turn /= f.along;
}
void refine(DeckPart&, const Refinement&) {} // its mesh is given
void refine(BeamPart& beam, const Refinement& f) {
  beam.elements = more(beam.elements, f.along);
}
void refine(EquivalentPipe& pipe, const Refinement& f) {
  pipe.elements = more(pipe.elements, f.along);
}
void refine(ConnectorChain&, const Refinement&) {} // its count is part of the model
void refine(Interlock&, const Refinement&) {}
void refine(PointMass&, const Refinement&) {}

// Elements along and around.
std::array<int, 2> elements(const Bellows& b) {
  const MeshDensity mesh = with_counts(b).mesh;
  return {4 * mesh.arc + 2 * mesh.wall, mesh.around}; // of one convolution
}
std::array<int, 2> elements(const Plate& p) {
  return p.elements;
}
std::array<int, 2> elements(const SurfacePart&) {
  return {1, 1}; // counted by its mesh
}
std::array<int, 2> elements(const DeckPart&) {
  return {1, 1};
}
std::array<int, 2> elements(const BeamPart& b) {
  return {b.elements, 1};
}
std::array<int, 2> elements(const EquivalentPipe& p) {
  return {p.elements, 1};
}
std::array<int, 2> elements(const ConnectorChain&) {
  return {1, 1};
}
std::array<int, 2> elements(const Interlock&) {
  return {1, 1};
}
std::array<int, 2> elements(const PointMass&) {
  return {1, 1};
}

} // namespace

Case refined(Case data, const Refinement& factor) {
  for (Part& part : data.parts) std::visit([&](auto& body) { refine(body, factor); }, part.body);
  return data;
}

Case with_coarse_bellows(Case data) {
  for (Part& part : data.parts)
    if (auto* bellows = std::get_if<Bellows>(&part.body)) {
      refine(*bellows, {.along = 0.5, .around = 0.5});
      bellows->mesh.arc = std::max(bellows->mesh.arc, 2);
      bellows->mesh.wall = std::max(bellows->mesh.wall, 2);
      bellows->mesh.around = std::max(bellows->mesh.around, 16);
    }
  return data;
}

Refinement refinement_ratio(const Case& data, const Refinement& factor) {
  const Case fine = refined(data, factor);
  Refinement ratio;
  for (std::size_t i = 0; i < data.parts.size(); ++i) {
    const auto count = [](const Part& part) {
      return std::visit([](const auto& body) { return elements(body); }, part.body);
    };
    const std::array<int, 2> coarse = count(data.parts[i]), finer = count(fine.parts[i]);
    if (ratio.along == 1) ratio.along = double(finer[0]) / coarse[0];
    if (ratio.around == 1) ratio.around = double(finer[1]) / coarse[1];
  }
  return ratio;
}

int unresolved_waves(const Case& data, const Results& results) {
  int waves = 0;
  for (const ModeResult& mode : results.modes) waves = std::max(waves, mode.harmonic);
  const Case finer = resolving(data, waves);
  for (std::size_t i = 0; i < data.parts.size(); ++i)
    if (const auto* bellows = std::get_if<Bellows>(&data.parts[i].body))
      if (element_counts(std::get<Bellows>(finer.parts[i].body)).around >
          element_counts(*bellows).around)
        return waves;
  return 0;
}

Case resolving(Case data, int waves) {
  for (Part& part : data.parts)
    if (auto* bellows = std::get_if<Bellows>(&part.body);
        bellows && mesh_accuracy(*bellows) > 0 && bellows->mesh.waves == 0)
      bellows->mesh.waves = std::max(1, waves);
  return data;
}

} // namespace plica
