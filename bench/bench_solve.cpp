// Cost against size: clamped A2 meshes without use of their symmetry, ten proved modes, every stage
// timed, one and two threads, and the exponent of time over unknowns between the smallest and the
// largest mesh.
//   bench_solve [largest number of unknowns, default 1e6]
#include "run/analyses/run.hpp"
#include "solve/blas_kernels.hpp"
#include "solve/sparse_factor.hpp"

#include <cmath>
#include <cstdlib>
#include <fmt/core.h>
#include <numeric>
#include <vector>

namespace {

using namespace plica;

struct Density {
  int around, arc, wall;
};

Case clamped_a2(const Density& n) {
  Bellows bellows;
  bellows.material = "steel";
  bellows.root_radius = 65e-3;
  MeridianSection convolutions;
  convolutions.count = 27;
  convolutions.height = 8e-3;
  convolutions.pitch = 6.58e-3;
  bellows.profile = {convolutions};
  bellows.wall.plies = {0.5e-3};
  bellows.mesh = {.around = n.around, .arc = n.arc, .wall = n.wall, .accuracy = 0};
  Case data;
  data.materials["steel"] = {193e9, 0.3, 8000};
  data.parts = {{"bellows", bellows}};
  data.caps = {{.name = "left", .of = {"bellows.left"}},
               {.name = "right", .of = {"bellows.right"}}};
  data.mount = {{.cap = "left"}, {.cap = "right"}};
  data.analyses.symmetry = Symmetry::off;
  data.analyses.modes = Modes{.count = 10};
  return data;
}

double total(const Results& results) {
  double sum = 0;
  for (const auto& [stage, seconds] : results.timing) sum += seconds;
  return sum;
}

} // namespace

int main(int argc, char** argv) {
  avoid_faulty_blas_kernels(argv);
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  const std::vector<Density> meshes{{24, 1, 3}, {48, 2, 4}, {60, 4, 5}, {96, 4, 5}, {108, 8, 10}};
  const std::vector<std::string> stages{"mesh",    "assembly", "factorisation", "statics",
                                        "lanczos", "proof",    "labels"};
  fmt::print("{:>9} {:>7}", "unknowns", "threads");
  for (const std::string& stage : stages) fmt::print(" {:>13}", stage);
  fmt::print(" {:>8} {:>8} {:>6}\n", "total s", "peak GB", "proved");
  std::vector<std::pair<double, double>> cost;
  for (const Density& n : meshes) {
    for (int threads : {2, 1}) {
      set_threads(threads);
      const Results results = run(clamped_a2(n), [](const std::string&) {});
      if (results.model.dofs > 1.2 * largest) break;
      fmt::print("{:>9} {:>7}", results.model.dofs, threads);
      for (const std::string& stage : stages)
        fmt::print(" {:>13.2f}", results.timing.contains(stage) ? results.timing.at(stage) : 0.);
      fmt::print(" {:>8.2f} {:>8.2f} {:>6}\n", total(results), results.peak_memory / 1e9,
                 results.verification.passed ? "yes" : "NO");
      if (threads == 2) cost.emplace_back(results.model.dofs, total(results));
    }
  }
  if (cost.size() > 1)
    fmt::print("time grows with unknowns to the power {:.2f}\n",
               std::log(cost.back().second / cost.front().second) /
                   std::log(cost.back().first / cost.front().first));
}
