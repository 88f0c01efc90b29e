// A clamped beam with masses, a free beam, two beams with a lap, a frame of four storeys.
#include "line_structures.hpp"
#include "line_model.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

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

// Number in "beam.stretch[3]", 0 = not of this form.
int number_in(const std::string& place, const std::string& before) {
  if (!place.starts_with(before + "[")) return 0;
  return std::stoi(place.substr(before.size() + 1));
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
    if (place == part) return 0; // its coordinate is a value
    if (const int k = number_in(place, part + ".point")) return point(k);
    if (const int k = number_in(place, part + ".stretch")) return (point(k) + point(k + 1)) / 2;
    return std::numeric_limits<double>::quiet_NaN();
  }
};

std::string transverse(char direction, int order) {
  return fmt::format("shape: transverse, direction: {}, order: {}", direction, order);
}

VectorXd joined(const VectorXd& a, const VectorXd& b) {
  VectorXd all(a.size() + b.size());
  all << a, b;
  return all;
}

Change mass_at(const std::string& part, double s, double most) {
  return {.effect = {"added_mass", part, {{"at", s}}},
          .size = "mass",
          .smallest = 1e-4 * most,
          .largest = most};
}

Change damage_of(const std::string& place) {
  return {.effect = {"local_damage", place, {}}, .size = "loss", .smallest = 1e-4, .largest = 0.9};
}

Change ratio_of(const std::string& effect, const std::string& place, double sign) {
  return {.effect = {effect, place, {}},
          .size = "ratio",
          .smallest = 1e-3,
          .largest = 1.5,
          .about_one = true,
          .sign = sign};
}

Change soft_clamp(const std::string& place, double stiffest, double softest) {
  return {.effect = {"boundary_compliance", place, {}},
          .size = "k_rotation",
          .smallest = 1 / stiffest,
          .largest = 1 / softest,
          .inverse = true};
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
  VectorXd frequencies(const Mechanism& m, const Effect& change) const override {
    return joined(bending(m, change, 'z').frequencies(4), bending(m, change, 'x').frequencies(3));
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
  std::vector<std::string> labels() const override {
    std::vector<std::string> all;
    for (int k = 1; k <= 6; ++k) all.push_back(transverse('z', k));
    return all;
  }
  VectorXd frequencies(const Mechanism& m, const Effect& change) const override {
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
    return model.frequencies(8).tail(6);
  }
  Change draw_change(Draws& draws) const override {
    if (draws.below(2)) return mass_at("beam", draws.between(0, 0.72), 0.35);
    return damage_of(fmt::format("beam.stretch[{}]", 1 + draws.below(5)));
  }
  double position(const std::string& place) const override { return line().position(place); }

private:
  static Line line() { return {.length = 0.72, .across = 0.0254, .depth = 0.0127, .stretches = 5}; }
};

// Two beams of 40 x 8 mm and a lap of springs, welded in at both ends.
class LapBeam final : public ChangedStructure {
public:
  std::string name() const override { return "lap_assembly"; }
  bool symmetric() const override { return true; }
  double damping() const override { return 0.008; }
  double length() const override { return 0.5; }
  std::vector<std::string> labels() const override {
    std::vector<std::string> all;
    for (int k = 1; k <= 6; ++k) all.push_back(transverse('z', k));
    return all;
  }
  VectorXd frequencies(const Mechanism& m, const Effect& change) const override {
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
    return model.frequencies(6);
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
  static Line line() { return {.length = 0.5, .across = 0.04, .depth = 0.008, .stretches = 4}; }
  static Line half(const std::string& part) {
    return {.length = 0.25, .across = 0.04, .depth = 0.008, .stretches = 2, .part = part};
  }
};

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
  VectorXd frequencies(const Mechanism& m, const Effect& change) const override {
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
    return model.frequencies(4);
  }
  Change draw_change(Draws& draws) const override {
    if (draws.below(2)) return damage_of(fmt::format("legs.stretch[{}]", 1 + draws.below(4)));
    return ratio_of("component_mass", fmt::format("floor{}", 1 + draws.below(4)), 1);
  }
  double position(const std::string& place) const override {
    for (const char* before : {"floor", "sensor.floor"})
      if (place.starts_with(before)) return storey * (place.back() - '0');
    return Line{.length = 4 * storey, .stretches = 4, .part = "legs"}.position(place);
  }

private:
  static constexpr double storey = 0.1533;
};

} // namespace

void add_line_structures(std::vector<std::unique_ptr<ChangedStructure>>& all) {
  all.push_back(std::make_unique<ClampedBeam>());
  all.push_back(std::make_unique<FreeBeam>());
  all.push_back(std::make_unique<LapBeam>());
  all.push_back(std::make_unique<Frame>());
}

} // namespace sealed
