// The short bellows of the sealed suite: its wall on a finer mesh than the diagnosis has, reduced
// once, with liner, ring and caps.
#include "line_structures.hpp"

#include "../bench.hpp"

#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace sealed {
namespace {

using Eigen::VectorXd;

const ReducedWall& wall_of_suite() {
  static const ReducedWall wall = reduce(shell_wall({}, WallSpecimen{}));
  return wall;
}

class BellowsStructure final : public ChangedStructure {
public:
  std::string name() const override { return "bellows"; }
  double damping() const override { return 0.01; }
  double length() const override { return WallShape{}.length(); }
  std::vector<std::string> labels() const override {
    std::vector<std::string> all;
    for (int k = 1; k <= 2; ++k) all.push_back(fmt::format("shape: axial, order: {}", k));
    for (const char axis : {'x', 'z'})
      all.push_back(fmt::format("shape: transverse, direction: {}, order: 1", axis));
    return all;
  }
  FoundModes modes(const Mechanism& m, const Effect& change) const override {
    Specimen specimen{.structure = "short_bellows"};
    if (change.name == "component_mass" || change.name == "joint_stiffness")
      specimen.effects = {change};
    Bench bench = bellows_bench(specimen, wall_of_suite(), {}, Draws::none());
    Structure& s = bench.test;
    double compliance = 0; // of the left mount against translation, m/N
    if (m.name == "boundary") compliance += 1e-7 * m.amount;
    if (change.name == "boundary_compliance") compliance += 1 / change.value.at("k_translation");
    constexpr double rigid = 1e8; // Nm/rad
    if (compliance > 0) stand_on_springs(s, "left", 1 / compliance, rigid);
    if (m.name == "cables") // along one side of five convolutions
      for (int k = 3; k <= 7; ++k) add_mass(s, ring(s, k).topRows(3), 0.01 * m.amount);
    if (m.name == "taper") // the liner is stiffer at one end
      add_springs(s, s.places.at("middle") - s.places.at("left"), 1e6 * m.amount * liner());
    if (m.name == "places") // weights bolted on one side of the ring
      add_mass(s, s.places.at("middle"), 0.005 * m.amount, Vector3d::Zero(), {0.04, 0, 0});
    if (m.name == "theory") // coils of the liner that are up against each other
      add_springs(s, s.places.at("right") - s.places.at("station.3"), 1e6 * m.amount * liner());
    if (change.name == "added_mass")
      add_mass(s, s.places.at(change.place), change.value.at("mass"));
    return {.frequencies = labelled(s)};
  }
  Change draw_change(Draws& draws) const override {
    switch (draws.below(4)) {
    case 0:
      return {.effect = {"added_mass", draws.below(2) ? "sensor.mid" : "sensor.quarter", {}},
              .size = "mass",
              .smallest = 1e-5,
              .largest = 0.08};
    case 1:
      return {.effect = {"joint_stiffness", "interlock", {}},
              .size = "ratio",
              .smallest = 1e-3,
              .largest = 2,
              .about_one = true,
              .sign = draws.below(2) ? 1. : -1.};
    case 2:
      return {.effect = {"component_mass", "extra", {}},
              .size = "ratio",
              .smallest = 1e-3,
              .largest = 1.5,
              .about_one = true,
              .sign = draws.below(2) ? 1. : -1.};
    default:
      return {.effect = {"boundary_compliance", "mount.left", {}},
              .size = "k_translation",
              .smallest = 1e-11,
              .largest = 1e-6,
              .inverse = true};
    }
  }
  double position(const std::string& place) const override {
    if (place == "sensor.mid") return 0.025;
    if (place == "sensor.quarter") return 0.013;
    if (place == "extra") return WallShape{}.root(5);
    if (const auto k = place.find("convolution["); k != std::string::npos)
      return WallShape{}.crown(place[place.size() - 2] - '0');
    return std::numeric_limits<double>::quiet_NaN();
  }

private:
  static MatrixXd ring(const Structure& s, int k) {
    return s.places.at("bellows.convolution[" + std::to_string(k) + "]");
  }
  // Of a spring between two places of six rows, for one of unit stiffness along the axis.
  static VectorXd liner() {
    VectorXd k(6);
    k << 0.05, 1, 0.05, 5e-4, 2e-4, 5e-4;
    return k;
  }
  // The lowest modes of each kind, by how the circles move as a whole.
  static VectorXd labelled(const Structure& s) {
    const Modes modes = modes_of(s);
    std::vector<double> axial, along_x, along_z;
    for (Eigen::Index i = 0; i < modes.w.size(); ++i) {
      Vector3d moved = Vector3d::Zero();
      for (int k = 1; k <= WallShape{}.convolutions; ++k)
        moved.array() += (ring(s, k).topRows(3) * modes.phi.col(i)).array().square();
      constexpr double as_a_whole = 2; // 1/kg
      if (moved.sum() < as_a_whole) continue;
      std::vector<double>& own = moved.y() > std::max(moved.x(), moved.z()) ? axial
                                 : moved.x() > moved.z()                    ? along_x
                                                                            : along_z;
      own.push_back(modes.w[i] / (2 * std::numbers::pi));
    }
    VectorXd all(4);
    all << axial.at(0), axial.at(1), along_x.at(0), along_z.at(0);
    return all;
  }
};

} // namespace

void add_bellows(std::vector<std::unique_ptr<ChangedStructure>>& all) {
  all.push_back(std::make_unique<BellowsStructure>());
}

} // namespace sealed
