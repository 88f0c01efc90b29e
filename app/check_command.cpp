#include "app/chosen_case.hpp"
#include "app/command_line.hpp"
#include "app/terminal.hpp"
#include "io/files/json_text.hpp"
#include "io/input/benchmark_file.hpp"
#include "io/input/case_file.hpp"
#include "io/input/measured_file.hpp"
#include "io/lab_files/measured_data.hpp"
#include "lab/measured/states.hpp"
#include "mesh/machine_memory.hpp"
#include "model/shape/doubts.hpp"
#include "run/analyses/seen_enough.hpp"
#include "run/routes/memory_need.hpp"
#include "run/routes/route.hpp"
#include "run/study/estimate.hpp"
#include "solve/sparse_factor.hpp"

#include <Eigen/Geometry>
#include <fmt/core.h>

namespace plica {
namespace {

struct CheckOptions {
  ChosenCase chosen;
  int threads = 0;
  bool json = false;
  bool json_only = false; // the run that is asked about writes nothing else
};

// What is said of a case that is valid.
struct Checked {
  Estimate cost;
  MemoryLimit limit;
  std::string too_large; // what is said of a run that the machine cannot hold; empty: it can
  MeshQuality quality;
  bool has_shells = false;
  Eigen::Vector3d size; // m
  std::vector<std::string> warnings;
  std::vector<BuiltSensor> sensors;
  int sectors = 0;      // of a part that repeats around its axis
  std::string full_for; // why on the full mesh; empty: by superelements
  std::size_t variants = 0, states = 0, coarse_runs = 0;
  bool error_bars = false;
};

Checked checked(const CaseFile& file, bool json_only) {
  const BuiltCase built = located(file, [&] { return build(file.data); });
  const auto symmetry = located(file, [&] {
    return symmetric_view(built.model, file.data.analyses.reduction ? Symmetry::automatic
                                                                    : file.data.analyses.symmetry);
  });
  const bool seen =
      json_only && !file.data.analyses.error_bars && seen_enough(file.data, built).has_value();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : built.model.mesh.nodes) box.extend(x);
  const std::size_t limits = 2 * file.data.tolerances.size();
  Checked found{
      .cost = located(file, [&] { return estimate(built, file.data.analyses, symmetry, seen); }),
      .limit = memory_limit(),
      .too_large = "",
      .quality = mesh_quality(built.model.mesh),
      .has_shells = !built.model.shells.empty(),
      .size = box.sizes(),
      .warnings = doubts(file.data, built),
      .sensors = built.sensors,
      .full_for = "",
      .variants = file.data.variants.size(),
      .states = file.data.states.size(),
      .coarse_runs = limits > 0 ? limits + 2 : 0,
      .error_bars = file.data.analyses.error_bars,
  };
  try {
    require_memory_for(built, file.data.analyses, symmetry, seen);
  } catch (const TooLarge& error) {
    found.too_large = error.what();
  }
  if (const auto* view = std::get_if<CyclicModel>(&symmetry))
    found.sectors = view->around();
  else if (!file.data.analyses.reduction)
    found.full_for = std::get<std::string>(symmetry);
  return found;
}

std::string text_of(const Checked& c) {
  std::string text = fmt::format("  {} nodes, {} elements, {} degrees of freedom\n", c.cost.nodes,
                                 c.cost.elements, c.cost.dofs);
  if (c.has_shells)
    text += fmt::format(
        "  mesh: warp at most {:.2g}, aspect ratio at most {:.2g}, Jacobian ratio at least "
        "{:.2g}\n",
        c.quality.max_warp, c.quality.max_aspect, c.quality.min_jacobian);
  text +=
      fmt::format("  {:.4g} x {:.4g} x {:.4g} m (x, y, z)\n", c.size.x(), c.size.y(), c.size.z());
  for (const std::string& doubt : c.warnings) text += "  warning: " + doubt + "\n";
  for (const BuiltSensor& sensor : c.sensors)
    text += fmt::format("  sensor {}: {:.2f} mm from the nearest node\n", sensor.name,
                        1e3 * sensor.distance);
  if (c.sectors > 0)
    text += fmt::format("  repeats around its axis: solved in {} sectors\n", c.sectors);
  else if (!c.full_for.empty())
    text += fmt::format("  full mesh: {}\n", c.full_for);
  text += fmt::format("  estimate: {:.3g} GB of {:.3g} GB ({}), {:.0f} s a run",
                      c.cost.memory / 1e9, c.limit.bytes / 1e9, c.limit.set_by, c.cost.seconds);
  if (c.variants > 0) text += fmt::format("; {} variants about as long each", c.variants);
  if (c.states > 0) text += fmt::format("; {} states, longer each", c.states);
  if (c.error_bars)
    text += fmt::format("; error bars: 2 runs on finer meshes, {} on coarse ones", c.coarse_runs);
  return text + "\n";
}

Json json_of(const Checked& c) {
  Json sensors = Json::array();
  for (const BuiltSensor& s : c.sensors)
    sensors.push_back({{"name", s.name}, {"distance", s.distance}});
  return {
      {"valid", true},
      {"problems", Json::array()},
      {"warnings", c.warnings},
      {"model", {{"nodes", c.cost.nodes}, {"elements", c.cost.elements}, {"dofs", c.cost.dofs}}},
      {"size", {c.size.x(), c.size.y(), c.size.z()}},
      {"mesh_quality",
       {{"max_warp", json_number(c.quality.max_warp)},
        {"max_aspect", json_number(c.quality.max_aspect)},
        {"min_jacobian", json_number(c.quality.min_jacobian)}}},
      {"sensors", sensors},
      {"symmetry",
       {{"sectors", c.sectors > 0 ? Json(c.sectors) : Json(nullptr)},
        {"full_mesh_because", c.full_for}}},
      {"estimate",
       {{"memory", c.cost.memory},
        {"seconds", c.cost.seconds},
        {"memory_limit", c.limit.bytes},
        {"memory_limit_set_by", c.limit.set_by}}},
      {"too_large", c.too_large},
      {"variants", c.variants},
      {"states", c.states},
      {"error_bars", c.error_bars}};
}

Json json_of(const InputError& error) {
  Json problems = Json::array();
  for (const InputProblem& p : error.problems())
    problems.push_back({{"file", p.file},
                        {"line", p.line},
                        {"key", p.key},
                        {"wrong", p.wrong},
                        {"allowed", p.allowed}});
  return {{"valid", false}, {"problems", problems}};
}

int check_benchmark(const CheckOptions& options) {
  read_benchmark(options.chosen.path);
  if (options.json)
    print(json_text({{"valid", true}, {"problems", Json::array()}}));
  else
    print(fmt::format("{}: the benchmark is valid\n", options.chosen.path));
  return 0;
}

int check(const CheckOptions& options) {
  set_threads(options.threads);
  try {
    if (is_benchmark(options.chosen.path)) return check_benchmark(options);
    const TestedCase tested = read_tested_case(options.chosen);
    const CaseFile& file = tested.file;
    if (const auto& test = tested.test)
      load_frfs(measured_as_drawn(test->data), test->path.parent_path());
    const Checked found = checked(file, options.json_only);
    if (options.json)
      print(json_text(json_of(found)));
    else
      print(fmt::format("{}: the case is valid\n{}", options.chosen.path, text_of(found)));
    if (found.too_large.empty()) return 0;
    say_failure("plica: " + found.too_large);
    return 4;
  } catch (const TooLarge& error) { // before there was a mesh
    if (options.json)
      print(json_text({{"valid", true}, {"problems", Json::array()}, {"too_large", error.what()}}));
    throw;
  } catch (const InputError& error) {
    if (!options.json) throw;
    if (speaks_json()) say_problems(error);
    print(json_text(json_of(error)));
    return 1;
  }
}

} // namespace

void add_check_command(CommandLine& line) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App& command = line.add("check", "validate a case and estimate its cost",
                               [options] { return check(*options); });
  add_case(command, options->chosen);
  add_state(command, options->chosen);
  add_threads(command, options->threads);
  command.add_flag("--json", options->json, "print JSON in place of words, also of what is wrong");
  command
      .add_option_function<std::string>(
          "--only", [options](const std::string&) { options->json_only = true; },
          "estimate a run with `--only json`, which leaves the shapes of all nodes out where "
          "superelements let it")
      ->check(CLI::IsMember({"json"}))
      ->type_name("");
}

} // namespace plica
