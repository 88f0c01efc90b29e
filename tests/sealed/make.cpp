#include "campaign.hpp"
#include "files.hpp"
#include "measure.hpp"
#include "sets/sets.hpp"

#include "solve/sparse_factor.hpp"

#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <fmt/os.h>
#include <fstream>
#include <mutex>
#include <numbers>
#include <set>
#include <thread>

namespace sealed {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// What of the library the strangers of a specimen could be taken for.
std::vector<std::string> look_alikes(const Specimen& s) {
  static const std::map<std::string, std::vector<std::string>> all{
      {"absorber", {"added_mass", "fixture_flexibility"}},
      {"sloshing", {"added_mass", "component_mass", "fixture_flexibility"}},
      {"coupling_spring", {"extra_support", "joint_stiffness", "ply_slip"}},
      {"eccentric_mass", {"added_mass", "component_mass", "cross_axis_base_motion"}},
      {"rocking_table", {"cross_axis_base_motion", "fixture_flexibility", "rotated_sensor"}},
      {"time_delay", {"rotated_sensor", "damping", "sensor_gain"}},
      {"sensor_resonance", {"sensor_gain"}},
      {"rubber", {"joint_stiffness", "extra_support", "damping"}}};
  std::vector<std::string> found;
  if (!s.without.empty()) found = alike_to(s.without);
  for (const Effect& e : s.effects)
    if (const auto own = all.find(e.name); own != all.end())
      found.insert(found.end(), own->second.begin(), own->second.end());
  return found;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// How a case says what is other in specimens that are mounted: a line in place of another.
std::string as_mounted(const std::string& line, const Specimen& s) {
  const bool bellows = s.structure == "short_bellows";
  if (line.starts_with("mount:"))
    return fmt::format(
        "mount: {{left: rigid, right: {{stiffness: [{0}, {0}, {0}, {1}, {1}, {1}]}}}}",
        bellows ? "40 MN/m +- 8.5 %" : "50 MN/m +- 8.5 %",
        bellows ? "70 kNm/rad +- 8.5 %" : "50 kNm/rad +- 8.5 %");
  if (line.starts_with("  damping:"))
    return fmt::format("  damping: {{modal: {} % +- {} %}}", bellows ? "1" : "0.8",
                       bellows ? "0.2" : "0.16");
  if (!line.starts_with("  - {name:") || line.find("mass:") == std::string::npos) return line;
  std::string all = line;
  for (const PlacedSensor& sensor : placed_sensors(s))
    if (sensor.name != "mid" && sensor.name != "quarter" && sensor.name != "joint" &&
        (!bellows || line.find("quarter") != std::string::npos))
      all += fmt::format("\n  - {{name: {}, at: [{}], mass: {:g} g}}", sensor.name, sensor.at,
                         1000 * sensor.mass);
  return all;
}

// What a case leaves out it may not name a prior of.
void write_case(const fs::path& data, const Specimen& s) {
  const fs::path source = PLICA_SOURCE_DIR;
  const bool bellows = s.structure == "short_bellows";
  std::vector<std::string> lines = lines_of(
      source / (bellows ? "tests/sealed" : "cases/" + s.structure) / (s.structure + ".yaml"));
  if (!bellows)
    for (const char* line :
         {"diagnose: # specimens of the suite may be hot, and heavy weights may sit on them",
          "  priors:", "    - {effect: temperature, parameter: delta_T, between: [-300, 300]}",
          "    - {effect: added_mass, parameter: mass, between: [0, 1]}"})
      lines.push_back(line);
  std::ofstream out(data / (case_of(s) + ".yaml"));
  for (const std::string& line : lines) {
    if (line.starts_with("measured:")) continue; // each specimen has its own
    if (!s.without.empty() && line.find("effect: " + s.without + ",") != std::string::npos)
      continue;
    out << (line.starts_with("case: ") ? "case: " + case_of(s)
            : s.mounted                ? as_mounted(line, s)
                                       : line)
        << '\n';
    if (!s.without.empty() && line.starts_with("diagnose:"))
      out << "  without: [" << s.without << "]\n";
  }
}

void write_cases(const fs::path& data, const Suite& suite) {
  for (const char* structure : {"short_bellows", "cantilever_masses", "bolted_lap"})
    write_case(data, {.structure = structure});
  for (const Specimen& s : suite.specimens)
    if (!s.without.empty() || s.mounted) write_case(data, s);
}

} // namespace

void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex guard;
  const auto loop = [&] {
    plica::set_threads(1); // of this thread: the specimens themselves share the cores
    for (std::size_t i = next++; i < count; i = next++) try {
        work(i);
      } catch (...) {
        const std::scoped_lock lock(guard);
        error = std::current_exception();
        next = count;
      }
  };
  std::vector<std::thread> threads;
  for (int t = 1; t < jobs; ++t) threads.emplace_back(loop);
  loop();
  for (std::thread& t : threads) t.join();
  if (error) std::rethrow_exception(error);
}

json truth_of(const Specimen& s, const std::map<std::string, double>& found) {
  json effects = json::array();
  for (const Effect& e : s.effects) {
    json value = e.value;
    if (!s.linear && value.contains("slip_ratio"))
      for (const auto& [key, number] : found) value[key] = number;
    effects.push_back({{"name", e.name}, {"place", e.place}, {"value", value}});
  }
  static const std::set<std::string> beyond{"clearance", "hardening", "absorber"};
  json truth{{"id", s.id},
             {"structure", s.structure},
             {"kind", s.kind},
             {"class", s.cls},
             {"strength", s.strength},
             {"effects", effects},
             {"road", s.wall.empty()                                 ? "beams"
                      : s.wall.find("calculix") != std::string::npos ? "calculix"
                                                                     : "mesh"},
             {"wall", s.wall},
             {"outside_by_design", s.kind == "stranger" && beyond.contains(s.cls)},
             {"look_alikes", look_alikes(s)}};
  if (!s.without.empty()) truth["left_out"] = s.without;
  return truth;
}

std::string fingerprint(const fs::path& truth) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(truth))
    if (entry.path().extension() == ".json") files.insert(entry.path());
  std::uint64_t hash = fnv1a("sealed suite");
  for (const fs::path& file : files) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    hash = fnv1a(text, fnv1a(file.filename().string(), hash));
  }
  return fmt::format("FNV-1a {:016x} over {} files", hash, files.size());
}

std::string make_suite(const Suite& suite, const fs::path& data, const fs::path& truth, int jobs) {
  fs::create_directories(data);
  fs::create_directories(truth / "walls"); // their names tell: they stay with the truth
  write_cases(data, suite);
  const auto walls = truth / "walls";
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  in_parallel(suite.walls.size(), jobs, [&](std::size_t i) {
    cached_wall({}, suite.walls[i].specimen, walls, suite.walls[i].name);
    fmt::print("wall {} of {}, {:.0f} s\n", i + 1, suite.walls.size(), seconds());
    std::fflush(stdout);
  });
  in_parallel(suite.specimens.size(), jobs, [&](std::size_t i) {
    const Specimen& s = suite.specimens[i];
    std::optional<ReducedWall> wall;
    if (!s.wall.empty()) wall = cached_wall({}, {}, walls, s.wall); // it is there by now
    const auto found = measure(s, wall ? &*wall : nullptr, suite.seed, data);
    std::ofstream(truth / (s.id + ".json")) << truth_of(s, found).dump(1) << '\n';
    fmt::print("specimen {} of {}, {:.0f} s\n", i + 1, suite.specimens.size(), seconds());
    std::fflush(stdout);
  });
  return fingerprint(truth);
}

void make_single(const SingleRequest& r) {
  const std::array<std::string, 3> strengths{"weak", "medium", "strong"};
  const auto g = std::find(strengths.begin(), strengths.end(), r.strength) - strengths.begin();
  Specimen s{.id = r.out.filename().string(), .structure = r.structure};
  if (g == 3) throw std::runtime_error("no strength " + r.strength);
  if (r.effect != "none") s.effects = graded(r.structure, r.effect, int(g), r.variant);
  if (r.effect != "none" && s.effects.empty())
    throw std::runtime_error("no effect " + r.effect + " on " + r.structure);
  const auto folder = fs::absolute(r.out).parent_path(), walls = folder / (s.id + ".walls");
  std::optional<ReducedWall> wall;
  if (r.structure == "short_bellows") {
    fs::create_directories(walls);
    s.wall = "mesh";
    wall = cached_wall({}, wall_specimen(s, r.seed), walls, s.wall);
    fs::remove_all(walls);
  }
  measure(s, wall ? &*wall : nullptr, r.seed, folder);
}

void check_roads(const fs::path& work) {
  fs::create_directories(work);
  fmt::print("first axial and transverse frequency of the healthy specimen without scatter, Hz\n");
  for (const Road road : {Road::calculix, Road::mesh})
    for (const int refine : {1, 2}) {
      WallSpecimen w;
      w.road = road;
      w.refine = refine;
      const std::string name =
          fmt::format("check_{}_{}", road == Road::mesh ? "mesh" : "calculix", refine);
      const ReducedWall wall = cached_wall({}, w, work, name);
      const Bench bench = bellows_bench({.structure = "short_bellows"}, wall, {}, Draws::none());
      const Modes modes = modes_of(bench.test);
      fmt::print("{:18}", name);
      for (int i = 0; i < 8; ++i) fmt::print(" {:8.1f}", modes.w[i] / (2 * std::numbers::pi));
      fmt::print("  weighed {:.5f} kg\n", bench.body.weighed);
    }
}

} // namespace sealed
