#include "io/decks/write_abaqus_motion.hpp"

#include "io/decks/write_abaqus_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plica {
namespace {

class MotionSteps {
public:
  MotionSteps(const Case& data, const BuiltCase& built, int modes, const DofInDeck& place)
      : case_(data), built_(built), modes_(modes), place_(place) {}

  std::string text() {
    add_base_steps(*case_.analyses.response);
    add_end_steps(*case_.analyses.response);
    return std::move(text_);
  }

private:
  template <class... Args> void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void begin_steady_state(const Response& response) {
    add("*STEP\n*STEADY STATE DYNAMICS\n{:.9e}, {:.9e}, 20, 3.\n", response.band[0],
        response.band[1]);
    const Damping& damping = case_.analyses.damping;
    if (!damping.ranges.empty() || !damping.modes.empty() || !damping.loss_factors.empty() ||
        has_damped_springs(case_))
      add("** damping by ranges, modes, loss factors and springs is left out\n");
    add("*MODAL DAMPING\n1, {}, {:.9e}\n", modes_, damping.modal);
  }

  void end_steady_state() {
    for (const BuiltSensor& s : built_.sensors)
      add("*NODE PRINT, NSET={}\nU\n", abaqus_name(s.name));
    add("*END STEP\n");
  }

  void add_base_steps(const Response& response) {
    if (response.bases.empty()) return;
    add("*AMPLITUDE, NAME=BASE\n{:.9e}, {:.9e}, {:.9e}, {:.9e}\n", response.band[0], response.level,
        response.band[1], response.level);
    for (int direction : response.bases) {
      if (direction > 2) {
        add("** turns of the base are left out\n");
        continue;
      }
      begin_steady_state(response);
      add("*BASE MOTION, DOF={}, AMPLITUDE=BASE\n", direction + 1);
      end_steady_state();
    }
  }

  // Ends that move by 1 m or 1 rad times their amplitudes: what is printed is the transmissibility.
  // The ground behind springs moves by the force that it exerts through them.
  void add_end_steps(const Response& response) {
    for (const Motion& motion : response.motions) {
      add("** motion {}: displacements, so that U is the transmissibility\n", name_of(motion));
      begin_steady_state(response);
      std::vector<EndMotion> ends{motion};
      ends.insert(ends.end(), motion.with.begin(), motion.with.end());
      for (const auto& [load_case, part] : {std::pair{1, 0.}, {2, std::numbers::pi / 2}}) {
        std::string moved, pushed;
        for (const EndMotion& end : ends)
          for (const std::string& cap : end.move) {
            const double displacement = end.amplitude * std::cos(end.phase - part);
            (is_held(cap) ? moved : pushed) += end_line(cap, end.direction, displacement);
          }
        if (!moved.empty() && load_case == 2)
          add("** CalculiX 2.20 breaks off here: give it this part as the load case 1 of a step of "
              "its own\n");
        if (!moved.empty()) add("*BOUNDARY, LOAD CASE={}\n{}", load_case, moved);
        if (!pushed.empty()) add("*CLOAD, LOAD CASE={}\n{}", load_case, pushed);
      }
      end_steady_state();
    }
  }

  bool is_held(const std::string& cap) const {
    const int node = built_.cap_nodes.at(cap);
    return std::find(built_.held_nodes.begin(), built_.held_nodes.end(), node) !=
           built_.held_nodes.end();
  }

  std::string end_line(const std::string& cap, int direction, double displacement) {
    constexpr double rounding = 1e-15;
    if (std::abs(displacement) < rounding) return "";
    const auto [node, dof] = place_(built_.cap_nodes.at(cap), direction);
    if (is_held(cap)) return fmt::format("{}, {}, {}, {:.12e}\n", node, dof, dof, displacement);
    const auto mount = std::find_if(case_.mount.begin(), case_.mount.end(),
                                    [&](const Mount& m) { return m.cap == cap; });
    return fmt::format("{}, {}, {:.12e}\n", node, dof,
                       mount->stiffness[std::size_t(direction)] * displacement);
  }

  const Case& case_;
  const BuiltCase& built_;
  int modes_;
  const DofInDeck& place_;
  std::string text_;
};

} // namespace

std::string abaqus_motion_steps(const Case& data, const BuiltCase& built, int modes,
                                const DofInDeck& place) {
  return MotionSteps(data, built, modes, place).text();
}

} // namespace plica
