// A frame of four storeys whose floors move across.
#include "line_changes.hpp"
#include "line_model.hpp"
#include "line_structures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sealed {
namespace {

// Four floors of 5.2 kg on legs that bend; floors move across alone.
class Frame final : public ChangedStructure {
public:
  std::string name() const override { return "frame"; }
  // With equal floors and storeys K = k B B' and M = m 1: a floor that is heavier answers as the
  // storey does that is as far from the other end, where it is softer.
  bool alike(const std::string& effect, const std::string& place, const std::string& other_effect,
             const std::string& other_place) const override {
    const auto storey_of = [](const std::string& name, const std::string& at) {
      if (name == "local_damage") return number_in(at, "legs.stretch");
      if (name != "added_mass" && name != "component_mass") return 0;
      if (!at.starts_with("floor") && !at.starts_with("sensor.floor")) return 0;
      return 5 - (at.back() - '0');
    };
    const int own = storey_of(effect, place);
    return own > 0 && own == storey_of(other_effect, other_place);
  }
  double damping() const override { return 0.01; }
  double length() const override { return 4 * storey; }
  std::vector<std::string> labels() const override {
    std::vector<std::string> all;
    for (int k = 1; k <= 4; ++k)
      all.push_back(fmt::format("shape: other, direction: x, order: {}", k));
    return all;
  }
  std::vector<std::string> channels(std::size_t /*mode*/) const override {
    return {"floor1.x", "floor2.x", "floor3.x", "floor4.x"};
  }
  FoundModes modes(const Mechanism& m, const Effect& change) const override {
    LineModel model;
    const int hit = number_in(change.place, "legs.stretch");
    double y = 0;
    std::vector<double> floors{0};
    for (int k = 1; k <= 4; ++k) {
      const double own =
          storey + (m.name == "places" ? m.amount * smooth_field(m.seed, k / 4.) : 0);
      double EI = 15.75 * (hit == k ? 1 - change.value.at("loss") : 1);
      if (m.name == "taper")
        EI *= std::pow(std::max(0.1, 1 + m.amount * smooth_field(m.seed, k / 4.)), 3);
      const double mass = m.name == "cables" && k > 1 ? m.amount * 5.2 / storey : 0;
      model.add_stretch(y, y + own, 3, [EI, mass](double) {
        return LineSection{.EI = EI, .GA = 1e7, .mass = 0.05 + mass, .inertia = 1e-4};
      });
      floors.push_back(y += own);
    }
    for (int k = 0; k <= 4; ++k) {
      const int node = model.node(floors[std::size_t(k)]);
      double ratio = 1;
      if (change.name == "component_mass" && change.place == fmt::format("floor{}", k))
        ratio = change.value.at("ratio");
      if (k > 0) model.add_mass(node, 5.201 * ratio, 0.05);
      const bool turns = k > 0 ? m.name == "theory" : m.name == "boundary";
      if (turns) model.add_springs(node, 0, 15.75 / (m.amount * storey));
      if (k == 0)
        model.fix(node, true, !turns);
      else if (!turns)
        model.fix(node, false, true);
    }
    return model.modes(4, {floors.begin() + 1, floors.end()});
  }
  Change draw_change(Draws& draws) const override {
    if (draws.below(2)) return damage_of(fmt::format("legs.stretch[{}]", 1 + draws.below(4)));
    return ratio_of("component_mass", fmt::format("floor{}", 1 + draws.below(4)), 1);
  }
  double position(const std::string& place) const override {
    for (const char* before : {"floor", "sensor.floor"})
      if (place.starts_with(before)) return storey * (place.back() - '0');
    return place_along(place, "legs", 4 * storey, 4);
  }

private:
  static constexpr double storey = 0.1533;
};

} // namespace

void add_frame(std::vector<std::unique_ptr<ChangedStructure>>& all) {
  all.push_back(std::make_unique<Frame>());
}

} // namespace sealed
