#include "tests/damaged/geometry_samples.hpp"

#include "io/files/files.hpp"
#include "mesh/generation/surface_file.hpp"
#include "tests/cad_samples.hpp"

#include <cstring>
#include <unistd.h>

namespace plica::test {
namespace {

namespace fs = std::filesystem;

// What `write` writes into a file of that name.
template <class Write> std::string written(const std::string& name, Write&& write) {
  const fs::path folder =
      fs::temp_directory_path() / ("plica_damaged_files_" + std::to_string(getpid()));
  fs::create_directories(folder);
  write(folder / name);
  const std::string bytes = read_whole(folder / name);
  fs::remove_all(folder);
  return bytes;
}

Sample geometry(const std::string& name, const std::string& file, const std::string& bytes,
                const FormatRule& rule, const std::string& more) {
  return {
      name,
      file,
      bytes,
      rule,
      {{"case.yaml",
        "case: t\nmaterials:\n  steel: {E: 200 GPa, nu: 0.3, rho: 8000 kg/m3}\nparts:\n  p: "
        "{type: surface, material: steel, thickness: 1 mm, file: " +
            file + more + "}\nanalyses: {static: false, modes: {count: 1}, error_bars: false}\n"}},
      {"run", "case.yaml", "--out", "out", "--threads", "1"},
      "out/results.json",
      8};
}

Surface tube() {
  constexpr int around = 8, along = 2;
  Surface s;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      s.nodes.emplace_back(50 * std::cos(angle), 60. * j, 50 * std::sin(angle));
    }
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = around * j + i, b = around * j + (i + 1) % around;
      s.triangles.push_back({a, b, b + around});
      s.triangles.push_back({a, b + around, a + around});
    }
  return s;
}

std::string binary_stl(const Surface& s) {
  std::string bytes(80, ' ');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(std::uint32_t(s.triangles.size()));
  for (const auto& t : s.triangles) {
    for (int k = 0; k < 3; ++k) append(0.F);
    for (int node : t)
      for (double x : s.nodes[std::size_t(node)]) append(float(x));
    append(std::uint16_t(0));
  }
  return bytes;
}

} // namespace

std::vector<Sample> geometry_samples() {
  const auto by_suffix = [](const fs::path& file) { write_surface(tube(), {}, file); };
  const auto bracket = [](const fs::path& file) { write_bracket_on_pipe({}, file); };
  const std::string as_it_is = ", unit: 1 mm", meshed = ", element_size: 40 mm";
  const std::string glb = written("t.glb", by_suffix), stl = binary_stl(tube()),
                    ply = written("t.ply", by_suffix);
  const std::size_t data = ply.find("end_header\n") + 11;
  std::uint32_t json = 0;
  std::memcpy(&json, glb.data() + 12, sizeof json);
  constexpr std::size_t stl_header = 80, count = 4, glb_headers = 28;
  return {
      geometry("step", "t.step", written("t.step", bracket), {.chained = true}, meshed),
      geometry("brep", "t.brep", written("t.brep", bracket), {.chained = true}, meshed + as_it_is),
      geometry("iges", "t.igs",
               written("t.igs", [](const fs::path& file) { write_iges_tube(50, 120, file); }),
               {.chained = true}, meshed),
      geometry("stl_text", "t.stl",
               written("t.stl", [](const fs::path& file) { write_stl_tube(50, 120, 8, 2, file); }),
               {}, as_it_is),
      geometry("stl_binary", "t.stl", stl,
               {.payload = {{0, stl_header}, {stl_header + count, stl.size()}}}, as_it_is),
      geometry("obj", "t.obj", written("t.obj", by_suffix), {.comment = '#'}, as_it_is),
      geometry("ply", "t.ply", ply,
               {.chained = true, .payload = {{data, ply.size()}}, .text = {0, data}}, as_it_is),
      geometry("glb", "t.glb", glb,
               {.payload = {{glb_headers + json, glb.size()}}, .text = {20, 20 + json}}, as_it_is)};
}

} // namespace plica::test
