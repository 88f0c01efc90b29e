#include "model/description/node_sets.hpp"

#include "model/description/deck_model.hpp"
#include "model/description/profile.hpp"

#include <algorithm>

namespace plica {

namespace {

constexpr int most_edges = 24; // of a surface, that may be named

void add_sets(const std::string& name, const Bellows& b, std::vector<std::string>& sets) {
  for (const char* set : {".left", ".right", ".all"}) sets.push_back(name + set);
  if (b.profile.empty()) return;
  if (b.profile.front().shape == SectionShape::cuff) sets.push_back(name + ".cuff.left");
  if (b.profile.size() > 1 && b.profile.back().shape == SectionShape::cuff)
    sets.push_back(name + ".cuff.right");
  for (const PartPlace& place : b.places) sets.push_back(name + "." + place.name);
  const int n = std::min(convolutions(b), 5000);
  for (const char* set : {".convolution[", ".crown[", ".root["})
    for (int k = 1; k <= n; ++k) sets.push_back(name + set + std::to_string(k) + "]");
  if (n > 0) sets.push_back(name + ".root[" + std::to_string(n + 1) + "]");
}
void add_sets(const std::string& name, const Interlock&, std::vector<std::string>& sets) {
  for (const char* set : {".start", ".end", ".all"}) sets.push_back(name + set);
}
void add_sets(const std::string& name, const Plate& p, std::vector<std::string>& sets) {
  for (const char* set : {".edge1", ".edge2", ".edge3", ".edge4", ".corner1", ".corner2",
                          ".corner3", ".corner4", ".all"})
    sets.push_back(name + set);
  for (const PartPlace& place : p.places) sets.push_back(name + "." + place.name);
}
// How many free edges a file has is known when it is meshed.
void add_sets(const std::string& name, const SurfacePart& s, std::vector<std::string>& sets) {
  sets.push_back(name + ".all");
  for (int k = 1; k <= most_edges; ++k) sets.push_back(name + ".edge[" + std::to_string(k) + "]");
  for (const SurfacePlace& place : s.places) sets.push_back(name + "." + place.name);
}
void add_sets(const std::string& name, const DeckPart& d, std::vector<std::string>& sets) {
  sets.push_back(name + ".all");
  if (d.content)
    for (const auto& entry : d.content->sets) sets.push_back(name + "." + entry.first);
  for (const SurfacePlace& place : d.places) sets.push_back(name + "." + place.name);
}
void add_sets(const std::string& name, const BeamPart& b, std::vector<std::string>& sets) {
  for (const char* set : {".start", ".end", ".all"}) sets.push_back(name + set);
  for (std::size_t k = 1; k <= b.points.size(); ++k)
    sets.push_back(name + ".point[" + std::to_string(k) + "]");
  for (const PartPlace& place : b.places) sets.push_back(name + "." + place.name);
}
void add_sets(const std::string&, const PointMass&, std::vector<std::string>&) {}
void add_ends(const std::string& name, std::vector<std::string>& sets) {
  for (const char* set : {".left", ".right", ".all"}) sets.push_back(name + set);
}
void add_sets(const std::string& name, const EquivalentPipe&, std::vector<std::string>& sets) {
  add_ends(name, sets);
}
void add_sets(const std::string& name, const ConnectorChain&, std::vector<std::string>& sets) {
  add_ends(name, sets);
}

} // namespace

std::vector<std::string> set_names(const Case& data) {
  std::vector<std::string> sets;
  for (const Part& part : data.parts)
    std::visit([&](const auto& body) { add_sets(part.name, body, sets); }, part.body);
  return sets;
}

std::vector<std::string> end_names(const Case& data) {
  std::vector<std::string> ends;
  for (const Part& part : data.parts) {
    std::vector<const char*> names;
    if (std::holds_alternative<Bellows>(part.body) ||
        std::holds_alternative<EquivalentPipe>(part.body) ||
        std::holds_alternative<ConnectorChain>(part.body))
      names = {"left", "right"};
    if (std::holds_alternative<BeamPart>(part.body)) names = {"start", "end"};
    if (std::holds_alternative<Plate>(part.body)) names = {"edge1", "edge2", "edge3", "edge4"};
    for (const char* name : names) ends.push_back(part.name + "." + name);
    std::vector<std::string> sets;
    if (const auto* beam = std::get_if<BeamPart>(&part.body)) {
      for (std::size_t k = 1; k <= beam->points.size(); ++k)
        ends.push_back(part.name + ".point[" + std::to_string(k) + "]");
      for (const PartPlace& place : beam->places) ends.push_back(part.name + "." + place.name);
    }
    if (const auto* bellows = std::get_if<Bellows>(&part.body))
      for (const PartPlace& place : bellows->places) ends.push_back(part.name + "." + place.name);
    if (const auto* plate = std::get_if<Plate>(&part.body))
      for (const PartPlace& place : plate->places) ends.push_back(part.name + "." + place.name);
    if (const auto* surface = std::get_if<SurfacePart>(&part.body))
      add_sets(part.name, *surface, sets);
    if (const auto* deck = std::get_if<DeckPart>(&part.body)) add_sets(part.name, *deck, sets);
    if (!sets.empty()) ends.insert(ends.end(), sets.begin() + 1, sets.end()); // all but `all`
  }
  return ends;
}

} // namespace plica
