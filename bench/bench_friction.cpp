// Sweeps over frequency of a chain of forty modes with twelve friction joints of twenty sliders
// each, harmonics up to 5: by harmonic balance and by equivalent linearisation.
#include "solve/harmonic_balance.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <numbers>

namespace {

using namespace plica;
using std::numbers::pi;

// A rod held at both ends, first mode at 40 Hz, its joints between twelve equal segments.
JointedStructure rod() {
  constexpr int modes = 40, joints = 12;
  JointedStructure s{.lambda = Eigen::VectorXd(modes),
                     .zeta = Eigen::VectorXd::Constant(modes, 0.01),
                     .eta = Eigen::VectorXd::Zero(modes),
                     .joints = Eigen::MatrixXd(modes, joints),
                     .input = Eigen::VectorXd(modes),
                     .laws = {}};
  for (int r = 0; r < modes; ++r) {
    const double n = r + 1;
    s.lambda[r] = std::pow(2 * pi * 40 * n, 2);
    s.input[r] = r % 2 == 0 ? -1.2 / n : 0;
    for (int j = 0; j < joints; ++j)
      s.joints(r, j) =
          std::sqrt(2.) * (std::sin(pi * n * (j + 1.) / joints) - std::sin(pi * n * j / joints));
  }
  for (int j = 0; j < joints; ++j)
    s.laws.push_back({.sliders = sliders_of({.K_T = 3e6, .F_S = 12, .chi = -0.5, .beta = 1}, 20)});
  return s;
}

void sweep(benchmark::State& state, JointMethod method) {
  const JointedStructure structure = rod();
  HarmonicSettings settings{
      .method = method, .harmonics = 5, .tolerance = 1e-7, .from = 2 * pi * 20, .to = 2 * pi * 320};
  settings.largest_step = (settings.to - settings.from) / double(state.range(0));
  std::size_t points = 0;
  for (auto _ : state) points = follow_frequency(structure, 5, settings).points.size();
  state.counters["frequencies"] = double(points);
  state.counters["per frequency"] = benchmark::Counter(
      double(points), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void harmonic_balance(benchmark::State& state) {
  sweep(state, JointMethod::harmonic_balance);
}
void describing_function(benchmark::State& state) {
  sweep(state, JointMethod::describing_function);
}

BENCHMARK(harmonic_balance)->Arg(150)->Arg(300)->Arg(600)->Arg(1200)->Unit(benchmark::kMillisecond);
BENCHMARK(describing_function)->Arg(300)->Arg(1200)->Unit(benchmark::kMillisecond);

} // namespace
