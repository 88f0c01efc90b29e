// What the mesh of an accuracy of 1 % misses for n = 0 and 1, apart around and along, for bellows
// of many shapes: static stiffness and the lowest mode of each number of waves around. From 1.5
// times as many elements around and twice as many along, at order 2. Beside it what the choice of
// the mesh expects (model/shape/mesh_choice.hpp).
#include "model/shape/mesh_choice.hpp"
#include "run/analyses/run.hpp"
#include "run/study/match_modes.hpp"
#include "run/study/refine.hpp"
#include "solve/blas_kernels.hpp"
#include "solve/sparse_factor.hpp"

#include <fmt/core.h>

#include <set>

namespace {

using namespace plica;

struct Drawing { // mm
  double root_radius, wall, height, pitch;
  int count;
};

constexpr std::array drawings{Drawing{50, 0.5, 4, 10, 10},   Drawing{100, 1, 5, 15, 8},
                              Drawing{30, 1, 3, 10, 8},      Drawing{65, 0.5, 2, 10, 10},
                              Drawing{40, 1.2, 12, 14, 6},   Drawing{26, 0.3, 9, 6, 10},
                              Drawing{50, 0.5, 12, 12, 8},   Drawing{50, 0.15, 12, 12, 8},
                              Drawing{65, 0.5, 8, 6.58, 27}, Drawing{44.9, 0.76, 37, 32, 4}};

Case clamped(const Drawing& d) {
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = 1e-3 * d.root_radius;
  MeridianSection convolutions;
  convolutions.count = d.count;
  convolutions.height = 1e-3 * d.height;
  convolutions.pitch = 1e-3 * d.pitch;
  bellows.profile = {convolutions};
  bellows.wall.plies = {1e-3 * d.wall};
  bellows.mesh.accuracy = 0.01;
  Case data;
  data.materials["steel"] = {193e9, 0.3, 8000};
  data.parts = {{"bellows", bellows}};
  data.caps = {{.name = "left", .of = {"bellows.left"}},
               {.name = "right", .of = {"bellows.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.modes = Modes{.count = 40};
  data.analyses.modes->proof = false;
  return data;
}

// Share of each number that is too high on the coarse mesh, before the modes that were not found.
void print_errors(const Case& data, const Results& coarse, bool along) {
  const Refinement factor{.along = along ? 2. : 1., .around = along ? 1. : 1.5};
  const Refinement ratio = refinement_ratio(data, factor);
  const double q = along ? ratio.along : ratio.around, missing = 1 - 1 / (q * q);
  const Results fine = run(refined(data, factor), [](const auto&) {});
  fmt::print("  {:<7}", along ? "along" : "around");
  const auto print = [&](const std::string& name, double h0, double h1) {
    fmt::print("  {} {:+.2f} %", name, 100 * (h0 - h1) / missing / h0);
  };
  for (std::size_t i = 0; i < stiffness_names.size(); ++i)
    if (i != 2 && i != 4) // z as x
      print(stiffness_names[i], coarse.statics->all()[i], fine.statics->all()[i]);
  const std::vector<SameMode> same = match_modes(coarse, fine);
  std::set<int> seen;
  for (std::size_t i = 0; i < coarse.modes.size(); ++i)
    if (const int n = coarse.modes[i].harmonic; seen.insert(n).second && same[i].index >= 0)
      print(fmt::format("n={}", n), coarse.modes[i].frequency, same[i].frequency);
  fmt::print("\n");
}

} // namespace

int main(int, char** argv) {
  avoid_faulty_blas_kernels(argv);
  set_threads(0);
  for (const Drawing& d : drawings) {
    const Case data = clamped(d);
    const Bellows& bellows = std::get<Bellows>(data.parts.front().body);
    const ElementCounts n = element_counts(bellows);
    fmt::print("R {} t {}, {} by {} mm: {} x ({},{}), axial along expected {:+.2f} %\n",
               d.root_radius, d.wall, d.height, d.pitch, n.around, n.arc, n.wall,
               100 * meridian_error(bellows, n));
    const Results coarse = run(data, [](const auto&) {});
    for (const bool along : {false, true}) print_errors(data, coarse, along);
  }
}
