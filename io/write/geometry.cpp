#include "io/write/geometry.hpp"

#include "io/files/files.hpp"
#include "io/report/drawn_shapes.hpp"
#include "io/tables/text.hpp"
#include "io/universal/writer.hpp"
#include "mesh/generation/msh_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace plica {
namespace {

constexpr int thin_shell_triangle = 91, thin_shell_quad = 94,
              linear_beam = 21; // fe descriptor ids of data set 2412

std::string mode_file(int mode, const std::string& format) {
  return fmt::format("mode_{:02}.{}", mode, format);
}

void write_surfaces(const Results& results, const std::string& format, OutputFolder& out) {
  const Surface surface = surface_of(results);
  const std::vector<SurfaceShape> shapes = drawn_shapes(results);
  const auto add = [&](const std::string& name, const Surface& drawn,
                       const std::vector<SurfaceShape>& targets) {
    out.add_by(name,
               [&](const std::filesystem::path& file) { write_surface(drawn, targets, file); });
  };
  add("part." + format, surface, shapes);
  if (format == "glb") return;
  for (std::size_t m = 0; m < shapes.size(); ++m)
    add(mode_file(int(m) + 1, format), deformed(surface, shapes[m]), {});
}

UniversalShape mode_shape(const Results& results, std::size_t mode) {
  UniversalShape s;
  s.ids[0] = fmt::format("{}: mode {}", results.case_name, mode + 1);
  s.ids[1] = mode_label(results.modes[mode]);
  s.data_type = UniversalDataType::real_double;
  describe(s, UniversalNormalMode{.load_case = 1,
                                  .mode = int(mode) + 1,
                                  .frequency = results.modes[mode].frequency,
                                  .modal_mass = 1,
                                  .viscous_damping = results.modes[mode].damping,
                                  .hysteretic_damping = 0});
  s.data_characteristic = 2;
  const Eigen::MatrixXd& shape = results.shapes[mode];
  for (Eigen::Index i = 0; i < shape.rows(); ++i) s.nodes.push_back(int(i) + 1);
  s.real = shape.leftCols(3).array().isFinite().select(shape.leftCols(3), 0);
  return s;
}

} // namespace

const std::vector<std::string>& geometry_formats() {
  static const std::vector<std::string> formats{"msh", "uff", "glb", "obj", "ply", "stl"};
  return formats;
}

std::string geometry_uff(const Results& results) {
  require_one_row_per_node(results);
  UniversalUnits units;
  units.description = "SI: metre, newton";
  UniversalNodes nodes;
  nodes.double_precision = false;
  for (std::size_t i = 0; i < results.mesh.nodes.size(); ++i) {
    const Eigen::Vector3d& x = results.mesh.nodes[i];
    UniversalNode n;
    n.label = int(i) + 1;
    n.position = {x.x(), x.y(), x.z()};
    nodes.nodes.push_back(n);
  }
  UniversalElements elements;
  const auto add = [&](int descriptor, std::vector<int> of) {
    UniversalElement e;
    e.label = int(elements.elements.size()) + 1;
    e.descriptor = descriptor;
    e.property = e.material = 1;
    if (descriptor == linear_beam) e.beam = UniversalBeam{};
    for (int& node : of) ++node;
    e.nodes = std::move(of);
    elements.elements.push_back(std::move(e));
  };
  for (const ShellQuad& q : results.mesh.quads)
    add(thin_shell_quad, {q.nodes.begin(), q.nodes.end()});
  for (const ShellTriangle& t : results.mesh.triangles)
    add(thin_shell_triangle, {t.nodes.begin(), t.nodes.end()});
  for (const auto& line : results.lines) add(linear_beam, {line.begin(), line.end()});
  std::string text = universal_text(units) + universal_text(nodes);
  if (!elements.elements.empty()) text += universal_text(elements);
  for (std::size_t m = 0; m < shown_modes(results); ++m)
    text += universal_text(mode_shape(results, m));
  return text;
}

std::vector<std::string> geometry_files(const std::vector<std::string>& formats, int modes) {
  std::vector<std::string> names;
  for (const std::string& format : formats) {
    names.push_back(format == "msh"   ? "mesh.msh"
                    : format == "uff" ? "geometry.uff"
                                      : "part." + format);
    if (format == "obj" || format == "ply" || format == "stl")
      for (int m = 1; m <= modes; ++m) names.push_back(mode_file(m, format));
  }
  return names;
}

void write_geometry(const Results& results, const std::vector<std::string>& formats,
                    OutputFolder& out) {
  for (const std::string& format : formats) {
    if (format == "msh")
      out.add_by("mesh.msh", [&](const std::filesystem::path& file) {
        write_msh(results.mesh, results.lines, file);
        if (!read_whole(file).ends_with("$EndElements\n")) // Gmsh says nothing of a full disk
          throw std::runtime_error("the disk may be full");
      });
    else if (format == "uff")
      out.add("geometry.uff", geometry_uff(results));
    else
      write_surfaces(results, format, out);
  }
}

} // namespace plica
