// A clamped beam with masses, a free beam, two beams with a lap.
#include "line_structures.hpp"
#include "line_changes.hpp"
#include "line_model.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sealed {
namespace {

using Eigen::VectorXd;

constexpr double G = steel::E / 2 / (1 + steel::nu), shear = 5. / 6;
constexpr int elements = 5; // a stretch between two points

// A rectangle: `across` and `depth`, the latter in the plane of bending.
LineSection rectangle(double across, double depth) {
  const double A = across * depth, I = A * depth * depth / 12;
  return {
      .EI = steel::E * I, .GA = shear * G * A, .mass = steel::rho * A, .inertia = steel::rho * I};
}

// A beam of one section along points that stand at equal distances, with whatever changes it.
struct Line {
  double length = 0, across = 0, depth = 0;
  int stretches = 1;
  std::string part = "beam";

  double point(int k) const { return (k - 1) * length / stretches; }

  SectionAt section(const Mechanism& m, const Effect& change) const {
    const int hit = change.name == "local_damage" ? number_in(change.place, part + ".stretch") : 0;
    const double loss = hit > 0 ? change.value.at("loss") : 0;
    return [=, *this](double s) {
      const double t = m.name == "taper" ? 1 + m.amount * smooth_field(m.seed, s / length) : 1;
      LineSection r = rectangle(across, depth * t);
      if (m.name == "cables" && s > 0.2 * length && s < 0.75 * length)
        r.mass += m.amount * steel::rho * across * depth;
      if (hit > 0 && s > point(hit) && s < point(hit + 1)) {
        r.EI *= 1 - loss;
        r.GA *= 1 - loss;
      }
      return r;
    };
  }
  void add_to(LineModel& model, const Mechanism& m, const Effect& change, double from, double to,
              int of, bool joined = true) const {
    model.add_stretch(from, to, of, section(m, change), joined);
  }
  double position(const std::string& place) const {
    return place_along(place, part, length, stretches);
  }
};

std::string transverse(char direction, int order) {
  return fmt::format("shape: transverse, direction: {}, order: {}", direction, order);
}

FoundModes joined(FoundModes a, const FoundModes& b) {
  VectorXd all(a.frequencies.size() + b.frequencies.size());
  all << a.frequencies, b.frequencies;
  a.frequencies = all;
  a.shapes.insert(a.shapes.end(), b.shapes.begin(), b.shapes.end());
  return a;
}

std::vector<std::string> bending_labels(char axis, int count) {
  std::vector<std::string> all;
  for (int k = 1; k <= count; ++k) all.push_back(transverse(axis, k));
  return all;
}

std::vector<Station> stations_at(const std::vector<double>& places) {
  std::vector<Station> all;
  for (const double s : places) all.push_back({fmt::format("h{}", all.size() + 1), s});
  return all;
}

std::vector<std::string> channels_of(const std::vector<double>& places, char axis) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < places.size(); ++i) all.push_back(fmt::format("h{}.{}", i + 1, axis));
  return all;
}

// 25 x 15 mm, 600 mm long, four masses, a sensor at the tip.
class ClampedBeam final : public ChangedStructure {
public:
  std::string name() const override { return "clamped_beam"; }
  double damping() const override { return 0.005; }
  double length() const override { return 0.6; }
  std::vector<std::string> labels() const override {
    return {transverse('z', 1), transverse('z', 2), transverse('z', 3), transverse('z', 4),
            transverse('x', 1), transverse('x', 2), transverse('x', 3)};
  }
  std::vector<Station> stations() const override { return stations_at(struck()); }
  std::vector<std::string> channels(std::size_t mode) const override {
    return channels_of(struck(), mode < 4 ? 'z' : 'x');
  }
  FoundModes modes(const Mechanism& m, const Effect& change) const override {
    return joined(bending(m, change, 'z').modes(4, struck()),
                  bending(m, change, 'x').modes(3, struck()));
  }
  Change draw_change(Draws& draws) const override {
    switch (draws.below(5)) {
    case 0:
      return mass_at("beam", draws.between(0.15, 0.6), 0.5);
    case 1:
      return damage_of(fmt::format("beam.stretch[{}]", 1 + draws.below(4)));
    case 2:
      return soft_clamp("mount.root", 3e8, 3e3);
    case 3:
      return ratio_of("component_mass", fmt::format("m{}", 2 + draws.below(3)),
                      draws.below(2) ? 1 : -1);
    default:
      return {.effect = {"extra_support", "beam", {{"at", draws.between(0.15, 0.6)}}},
              .size = "k",
              .smallest = 1,
              .largest = 1e7};
    }
  }
  double position(const std::string& place) const override {
    if (place == "sensor.tip") return 0.6;
    if (place.size() == 2 && place[0] == 'm') return line(true).point(place[1] - '0' + 1);
    return line(true).position(place);
  }

private:
  static std::vector<double> struck() { return {0.15, 0.3, 0.45, 0.6}; }
  static Line line(bool is_z) {
    return {.length = 0.6,
            .across = is_z ? 0.025 : 0.015,
            .depth = is_z ? 0.015 : 0.025,
            .stretches = 4};
  }
  static LineModel bending(const Mechanism& m, const Effect& change, char plane) {
    const Line beam = line(plane == 'z');
    const double off = m.name == "places" ? m.amount : 0;
    LineModel model;
    // Nodes stand where masses, sensor and change are; a support at `at` needs one.
    std::vector<double> stops{0};
    for (int k = 2; k <= 5; ++k)
      stops.push_back(beam.point(k) + (k == 5 ? 1 : smooth_field(m.seed, k / 5.)) * off);
    const auto at = change.value.find("at");
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const double a = stops[i], b = stops[i + 1];
      if (at != change.value.end() && at->second > a + 1e-3 && at->second < b - 1e-3) {
        beam.add_to(model, m, change, a, at->second, elements);
        beam.add_to(model, m, change, at->second, b, elements);
      } else {
        beam.add_to(model, m, change, a, b, elements);
      }
    }
    for (int k = 1; k <= 4; ++k) {
      const std::string own = fmt::format("m{}", k);
      double mass = 0.15;
      if (change.name == "component_mass" && change.place == own) mass *= change.value.at("ratio");
      const int node = model.node(stops[std::size_t(k)]);
      model.add_mass(node, mass);
      if (m.name == "theory") { // a bolted block stiffens the beam under it, and turns with it
        constexpr double block = 0.04;
        model.add_mass(node, 0, m.amount * mass * block * block / 12);
        const LineSection r = rectangle(beam.across, beam.depth);
        const int left = model.node(stops[std::size_t(k)] - block / 2);
        model.add_joint(left, node, 0, m.amount * r.EI / block);
      }
    }
    model.add_mass(model.node(stops.back()), 0.005);
    if (at != change.value.end()) {
      const int node = model.node(std::min(at->second, stops.back()));
      if (change.name == "added_mass") model.add_mass(node, change.value.at("mass"));
      if (change.name == "extra_support" && plane == 'z')
        model.add_springs(node, change.value.at("k"), 0);
    }
    // The clamp turns: by what was left out, and by what changed.
    double compliance = 0;
    if (m.name == "boundary") compliance += m.amount * 0.6 / rectangle(0.025, 0.015).EI;
    if (change.name == "boundary_compliance") compliance += 1 / change.value.at("k_rotation");
    if (compliance > 0) model.add_springs(0, 0, 1 / compliance);
    model.fix(0, true, compliance == 0);
    return model;
  }
};

// 25.4 x 12.7 mm, 720 mm long, in soft strings; modes of bending in its thin direction.
class FreeBeam final : public ChangedStructure {
public:
  std::string name() const override { return "free_beam"; }
  double damping() const override { return 0.002; }
  double length() const override { return 0.72; }
  bool symmetric() const override { return true; }
  std::vector<std::string> labels() const override { return bending_labels('z', 6); }
  std::vector<Station> stations() const override { return stations_at(struck()); }
  std::vector<std::string> channels(std::size_t /*mode*/) const override {
    return channels_of(struck(), 'z');
  }
  FoundModes modes(const Mechanism& m, const Effect& change) const override {
    LineModel model;
    const double off = m.name == "places" ? m.amount : 0;
    const auto at = change.value.find("at");
    const int stretches = 5;
    for (int k = 1; k <= stretches; ++k) {
      const double a = line().point(k), b = line().point(k + 1) + (k == stretches ? off : 0);
      if (at != change.value.end() && at->second > a + 1e-3 && at->second < b - 1e-3) {
        line().add_to(model, m, change, a, at->second, elements);
        line().add_to(model, m, change, at->second, b, elements);
      } else {
        line().add_to(model, m, change, a, b, elements);
      }
    }
    if (change.name == "added_mass")
      model.add_mass(model.node(at->second), change.value.at("mass"));
    if (m.name == "boundary") // not so soft
      for (const double s : {0.144, 0.576})
        model.add_springs(model.node(s), 1e3 * m.amount * rectangle(0.0254, 0.0127).EI / 0.05, 0);
    if (m.name == "places") // bolts and a hole
      model.add_mass(model.node(0.432), 10 * m.amount * 0.0254 * 0.0127 * steel::rho);
    if (m.name == "theory") // a stud with what is screwed on it stiffens the beam
      model.add_joint(model.node(0.24), model.node(0.288), 0,
                      m.amount * rectangle(0.0254, 0.0127).EI / 0.048);
    FoundModes found = model.modes(8, struck());
    found.frequencies = VectorXd(found.frequencies.tail(6));
    found.shapes.erase(found.shapes.begin(), found.shapes.begin() + 2);
    return found;
  }
  Change draw_change(Draws& draws) const override {
    if (draws.below(2)) return mass_at("beam", draws.between(0, 0.72), 0.35);
    return damage_of(fmt::format("beam.stretch[{}]", 1 + draws.below(5)));
  }
  double position(const std::string& place) const override { return line().position(place); }

private:
  static std::vector<double> struck() { return {0, 0.144, 0.288, 0.432, 0.576, 0.72}; }
  static Line line() { return {.length = 0.72, .across = 0.0254, .depth = 0.0127, .stretches = 5}; }
};

// Two beams of 40 x 8 mm and a lap of springs, welded in at both ends.
class LapBeam final : public ChangedStructure {
public:
  std::string name() const override { return "lap_assembly"; }
  bool symmetric() const override { return true; }
  double damping() const override { return 0.008; }
  double length() const override { return 0.5; }
  std::vector<std::string> labels() const override { return bending_labels('z', 6); }
  std::vector<Station> stations() const override { return stations_at(struck()); }
  std::vector<std::string> channels(std::size_t /*mode*/) const override {
    return channels_of(struck(), 'z');
  }
  FoundModes modes(const Mechanism& m, const Effect& change) const override {
    LineModel model;
    const auto at = change.value.find("at");
    const double middle = 0.25 + (m.name == "places" ? m.amount : 0);
    const bool on_second = change.place == "beam2";
    const double place = at == change.value.end() ? -1 : at->second + (on_second ? 0.25 : 0);
    const auto stretch = [&](double a, double b, bool is_joined) {
      if (place > a + 1e-3 && place < b - 1e-3) {
        line().add_to(model, m, change, a, place, 6, is_joined);
        line().add_to(model, m, change, place, b, 6);
      } else {
        line().add_to(model, m, change, a, b, 10, is_joined);
      }
    };
    stretch(0, middle, true);
    const int before = model.node(middle);
    stretch(middle, 0.5, false);
    const int after = model.node(middle);
    double lap = 1;
    if (change.name == "joint_stiffness") lap = change.value.at("ratio");
    model.add_joint(before, after, 50e6 * lap, 4e3 * lap);
    const double lap_mass = 0.2 * (change.name == "component_mass" ? change.value.at("ratio") : 1);
    model.add_mass(before, lap_mass / 2 + 0.005);
    model.add_mass(after, lap_mass / 2);
    if (m.name == "theory") { // plates that overlap by 40 mm
      const double k = m.amount * rectangle(0.04, 0.008).EI / 0.02;
      model.add_joint(model.node(middle - 0.02, true), before, 0, k);
      model.add_joint(after, model.node(middle + 0.02), 0, k);
    }
    if (place >= 0) model.add_mass(model.node(place), change.value.at("mass"));
    const double welds = m.name == "boundary" ? m.amount * 0.5 / rectangle(0.04, 0.008).EI : 0;
    const int ends[] = {0, model.node(0.5)};
    for (const int end : ends) {
      double compliance = welds;
      if (change.name == "boundary_compliance" && end == 0)
        compliance += 1 / change.value.at("k_rotation");
      if (compliance > 0) model.add_springs(end, 0, 1 / compliance);
      model.fix(end, true, compliance == 0);
    }
    return model.modes(6, struck());
  }
  Change draw_change(Draws& draws) const override {
    switch (draws.below(4)) {
    case 0:
      return mass_at(draws.below(2) ? "beam1" : "beam2", draws.between(0.03, 0.22), 0.25);
    case 1:
      return ratio_of("joint_stiffness", "caps.lap", -1);
    case 2:
      return soft_clamp("mount.left", 1e8, 100);
    default:
      return ratio_of("component_mass", "caps.lap", draws.below(2) ? 1 : -1);
    }
  }
  double position(const std::string& place) const override {
    if (place == "caps.lap" || place == "sensor.joint") return 0.25;
    if (place == "mount.left") return 0;
    if (place == "mount.right") return 0.5;
    if (place.starts_with("beam2")) return 0.25 + half("beam2").position(place);
    return half("beam1").position(place);
  }

private:
  static std::vector<double> struck() { return {0.05, 0.125, 0.2, 0.3, 0.375, 0.45}; }
  static Line line() { return {.length = 0.5, .across = 0.04, .depth = 0.008, .stretches = 4}; }
  static Line half(const std::string& part) {
    return {.length = 0.25, .across = 0.04, .depth = 0.008, .stretches = 2, .part = part};
  }
};

} // namespace

void add_line_structures(std::vector<std::unique_ptr<ChangedStructure>>& all) {
  all.push_back(std::make_unique<ClampedBeam>());
  all.push_back(std::make_unique<FreeBeam>());
  all.push_back(std::make_unique<LapBeam>());
}

} // namespace sealed
