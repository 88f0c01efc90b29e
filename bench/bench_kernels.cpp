// Element matrices and assembly, per element.
#include "io/input/case_file.hpp"
#include "mesh/generation/revolve.hpp"
#include "run/analyses/run.hpp"
#include "run/routes/built_reduced.hpp"
#include "run/routes/route.hpp"
#include "run/study/error_bars.hpp"
#include "solve/assembly.hpp"
#include "solve/couplings.hpp"
#include "solve/frequency_response.hpp"
#include "solve/sparse_factor.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace plica;

Model bellows(int around) {
  Meridian meridian(0, 0.065);
  for (int k = 0; k < 4; ++k)
    meridian.add_convolution(
        {.height = 8e-3, .pitch = 6.58e-3, .root_arc = 1.645e-3, .crown_arc = 1.645e-3},
        {.arc = 4, .wall = 5});
  Model model;
  append(model.mesh, revolve(meridian, around, [](double) { return 5e-4; }), "bellows", 0);
  model.shells.push_back({{.E = 193e9, .nu = 0.3, .rho = 8000}, MembraneStrain::incompatible});
  return model;
}

void shell_stiffness(benchmark::State& state) {
  const Model model = bellows(16);
  const ShellGeometry g = shell_geometry(model.mesh, model.mesh.quads.front());
  const auto membrane = static_cast<MembraneStrain>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(shell_mitc4_stiffness(g, model.shells.front().section, membrane));
}
BENCHMARK(shell_stiffness)->DenseRange(0, 2)->ArgName("membrane");

void shell_mass(benchmark::State& state) {
  const Model model = bellows(16);
  const ShellGeometry g = shell_geometry(model.mesh, model.mesh.quads.front());
  for (auto _ : state) benchmark::DoNotOptimize(shell_mitc4_mass(g, model.shells.front().section));
}
BENCHMARK(shell_mass);

void beam(benchmark::State& state) {
  const BeamProperties section = pipe_section({193e9, 0.3, 8000}, 0.03, 1e-3);
  BeamGeometry g;
  g.node1 = {0, 0, 0};
  g.node2 = {0, 0.1, 0};
  for (auto _ : state) {
    benchmark::DoNotOptimize(beam_stiffness(g, section));
    benchmark::DoNotOptimize(beam_mass(g, section));
  }
}
BENCHMARK(beam);

void assembly(benchmark::State& state) {
  const Model model = bellows(48);
  set_threads(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(assemble(model).K.nonZeros());
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(model.mesh.quads.size()));
}
BENCHMARK(assembly)->Arg(1)->Arg(2)->ArgName("threads")->UseRealTime()->Unit(
    benchmark::kMillisecond);

// Cholesky of a clamped bellows and solves with it, against the threads of BLAS.
void factorise(benchmark::State& state) {
  Model model = bellows(96);
  add_support(model, model.mesh.sets["bellows.left"], {0, 1, 2, 3, 4, 5}, "clamp");
  const System system = assemble(model);
  SparseFactor factor(system.K);
  set_blas_threads(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(factor.factorise(system.K).ok);
  set_blas_threads(1);
}
BENCHMARK(factorise)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("blas_threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void solve(benchmark::State& state) {
  Model model = bellows(96);
  add_support(model, model.mesh.sets["bellows.left"], {0, 1, 2, 3, 4, 5}, "clamp");
  const System system = assemble(model);
  SparseFactor factor(system.K);
  factor.factorise(system.K);
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(system.K.rows(), state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(factor.solve(b).data());
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(solve)
    ->Arg(1)
    ->Arg(4)
    ->Arg(16)
    ->Arg(64)
    ->ArgName("right_hand_sides")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// Response of 10 sensor channels at 4,901 frequencies from 60 modes.
void frequency_response(benchmark::State& state) {
  const Eigen::Index modes = 60, channels = 10;
  const ModalModel model{.lambda = Eigen::VectorXd::LinSpaced(modes, 1e5, 1e7),
                         .zeta = Eigen::VectorXd::Constant(modes, 0.01),
                         .eta = Eigen::VectorXd::Zero(modes),
                         .output = Eigen::MatrixXd::Random(channels, modes),
                         .input = Eigen::MatrixXd::Random(modes, 1)};
  const Eigen::VectorXd omega = Eigen::VectorXd::LinSpaced(4901, 60, 3142);
  set_threads(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(plica::frequency_response(model, 0, omega).data());
}
BENCHMARK(frequency_response)
    ->Arg(1)
    ->Arg(2)
    ->ArgName("threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// The dual pipe assembly of superelements (cut-off 1500 Hz): 60 modes, proved, and the response of
// three sensors at 491 even frequencies. The reductions are made once, outside.
void reduced_assembly(benchmark::State& state) {
  const Case data = read_case("cases/dual_assembly/dual_assembly.yaml").data;
  const BuiltCase built = build(data);
  const ReducedModel reduced = reduced_model(built, interface_nodes(built, true), {.cutoff = 1500});
  BuiltCase frame;
  frame.model = reduced.model;
  for (int node : built.held_nodes) frame.held_nodes.push_back(reduced.number[node]);
  std::vector<int> sensors;
  for (const BuiltSensor& s : built.sensors) sensors.push_back(s.node);
  const Loads loads{.base = {1}, .force = {}, .rigid = {}};
  const Eigen::VectorXd omega = Eigen::VectorXd::LinSpaced(491, 62.8, 3141.6);
  const StageListener quiet = [](const std::string&) {};
  for (auto _ : state) {
    Timing timing;
    const auto route = full_route(frame, "", quiet, timing);
    const ModalSolution modes = route->modes({.count = 60}, loads, {});
    const Eigen::Index n = modes.lambda.size();
    const ModalModel modal{.lambda = modes.lambda,
                           .zeta = Eigen::VectorXd::Constant(n, 0.03),
                           .eta = Eigen::VectorXd::Zero(n),
                           .output = reduced.field_at(modes.u, sensors),
                           .input = modes.input};
    benchmark::DoNotOptimize(plica::frequency_response(modal, 0, omega).data());
    if (!modes.proof.passed) state.SkipWithError("the modes are not proved");
  }
}
BENCHMARK(reduced_assembly)->UseRealTime()->Unit(benchmark::kMillisecond);

// One evaluation of a fit: statics and modes of the equivalent pipe of A2, one thread.
void pipe_model(benchmark::State& state) {
  const Case data = for_headline(read_case("cases/bellow_a2/bellow_a2.yaml", "pipe_fitted").data);
  set_threads(1);
  for (auto _ : state) benchmark::DoNotOptimize(run(data, [](const std::string&) {}).modes.data());
}
BENCHMARK(pipe_model)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
