#include "app/command_line.hpp"
#include "app/located.hpp"
#include "app/terminal.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "model/shape/doubts.hpp"
#include "run/analyses/run.hpp"
#include "run/routes/route.hpp"
#include "solve/sparse_factor.hpp"

#include <Eigen/Geometry>
#include <fmt/core.h>

namespace plica {
namespace {

struct CheckOptions {
  ChosenCase chosen;
  int threads = 0;
};

int check(const CheckOptions& options) {
  set_threads(options.threads);
  if (is_benchmark(options.chosen.path)) {
    read_benchmark(options.chosen.path);
    print(fmt::format("{}: the benchmark is valid\n", options.chosen.path));
    return 0;
  }
  const CaseFile file = read_chosen(options.chosen);
  test_of(file);
  const BuiltCase built = located(file, [&] { return build(file.data); });
  const auto symmetry = located(file, [&] {
    return symmetric_view(built.model, file.data.analyses.reduction ? Symmetry::automatic
                                                                    : file.data.analyses.symmetry);
  });
  const Estimate cost = located(file, [&] { return estimate(built, file.data.analyses); });
  const MeshQuality quality = mesh_quality(built.model.mesh);
  print(fmt::format("{}: the case is valid\n", options.chosen.path));
  print(fmt::format("  {} nodes, {} elements, {} degrees of freedom\n", cost.nodes, cost.elements,
                    cost.dofs));
  if (!built.model.shells.empty())
    print(fmt::format(
        "  mesh: warp at most {:.2g}, aspect ratio at most {:.2g}, Jacobian ratio at least "
        "{:.2g}\n",
        quality.max_warp, quality.max_aspect, quality.min_jacobian));
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : built.model.mesh.nodes) box.extend(x);
  print(fmt::format("  {:.4g} x {:.4g} x {:.4g} m (x, y, z)\n", box.sizes().x(), box.sizes().y(),
                    box.sizes().z()));
  for (const std::string& doubt : doubts(file.data, built)) print("  warning: " + doubt + "\n");
  for (const BuiltSensor& sensor : built.sensors)
    print(fmt::format("  sensor {}: {:.2f} mm from the nearest node\n", sensor.name,
                      1e3 * sensor.distance));
  const std::size_t variants = file.data.variants.size(), limits = 2 * file.data.tolerances.size();
  if (const auto* view = std::get_if<CyclicModel>(&symmetry))
    print(fmt::format(
        "  repeats around its axis: solved in {} sectors, in far less than the estimate\n",
        view->around()));
  else if (!file.data.analyses.reduction)
    print(fmt::format("  full mesh: {}\n", std::get<std::string>(symmetry)));
  print(fmt::format("  estimate: {:.1f} GB, {:.0f} s a run", cost.memory / 1e9, cost.seconds));
  if (variants > 0) print(fmt::format("; {} variants about as long each", variants));
  if (!file.data.states.empty())
    print(fmt::format("; {} states, longer each", file.data.states.size()));
  if (file.data.analyses.error_bars)
    print(fmt::format("; error bars: 2 runs on finer meshes, {} on coarse ones",
                      limits > 0 ? limits + 2 : 0));
  print("\n");
  return 0;
}

} // namespace

void add_check_command(CommandLine& line) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& command = line.add("check", "validate a case and estimate its cost",
                               [options] { return check(*options); });
  add_case(command, options->chosen);
  add_state(command, options->chosen);
  add_threads(command, options->threads);
}

} // namespace plica
