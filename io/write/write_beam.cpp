#include "io/write/write_beam.hpp"

#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {
namespace {

constexpr std::array names{"axial", "transverse", "bending", "torsion"};

std::string layer_yaml(const PipeLayer& l, const char* size, double value, const char* unit) {
  const std::string gyration =
      l.mass_radius ? fmt::format(", mass_radius: {:.6g} mm", 1e3 * *l.mass_radius) : "";
  return fmt::format(
      "{{radius: {:.6g} mm, {}: {:.6g} {}, axial: {:.6g} N/m, torsion: {:.6g} Nm/rad{}}}",
      1e3 * l.radius, size, value, unit, l.axial, l.torsion, gyration);
}

std::string pipe_yaml(const std::string& name, const EquivalentPipe& p) {
  std::string text =
      fmt::format("      {}:\n        type: pipe\n        material: {}\n", name, p.material);
  text += fmt::format("        start: {:.6g} mm\n        length: {:.6g} mm\n"
                      "        convoluted: {:.6g} mm\n",
                      1e3 * p.start, 1e3 * p.length, 1e3 * p.convoluted);
  text += "        outer: " + layer_yaml(p.outer, "wall", 1e3 * p.outer.wall, "mm") + "\n";
  if (p.inner) text += "        inner: " + layer_yaml(*p.inner, "mass", p.inner->mass, "kg") + "\n";
  return text + fmt::format("        end_radius: {:.6g} mm\n        end_wall: {:.6g} mm\n",
                            1e3 * p.end_radius, 1e3 * p.end_wall);
}

std::string chain_yaml(const std::string& name, const ConnectorChain& c) {
  return fmt::format("      {}:\n        type: connector\n        start: {:.6g} mm\n"
                     "        length: {:.6g} mm\n        arms: {:.6g} mm\n        count: {}\n"
                     "        spring: {{axial: {:.6g} N/m, transverse: {:.6g} N/m, bending: {:.6g} "
                     "Nm/rad, torsion: {:.6g} Nm/rad}}\n"
                     "        mass: {:.6g} kg\n        radius: {:.6g} mm\n"
                     "        arm_mass: {:.6g} kg\n",
                     name, 1e3 * c.start, 1e3 * c.length, 1e3 * c.arms, c.count, c.spring.axial,
                     c.spring.transverse, c.spring.bending, c.spring.torsion, c.mass,
                     1e3 * c.radius, c.arm_mass);
}

std::string difference(const std::optional<double>& x, double of) {
  return x ? fmt::format("{:.2f} ({})", *x, with_sign(100 * (*x / of - 1), 1)) : "-";
}

std::vector<std::string> beam_row(const std::string& head, double shell,
                                  const std::optional<double>& pipe,
                                  const std::optional<double>& chain) {
  return {head, fmt::format("{:.2f}", shell), difference(pipe, shell), difference(chain, shell)};
}

// Frequency up to which a simple model stays within 10 % of the shells, all directions.
double good_up_to(const EquivalentBeam& beam, const std::array<double, 4> TransferStiffness::*model,
                  std::size_t direction) {
  double good = 0;
  for (const TransferStiffness& t : beam.transfer) {
    if (std::abs((t.*model)[direction] / t.shell[direction] - 1) > 0.1) break;
    good = t.hertz;
  }
  return good;
}

std::string transfer_csv(const EquivalentBeam& beam) {
  std::string text = "frequency [Hz]";
  for (const char* model : {"shell", "pipe", "connector"})
    for (std::size_t k = 0; k < names.size(); ++k)
      text += fmt::format(",{} {} [{}]", model, names[k], k < 2 ? "N/m" : "Nm/rad");
  text += "\n";
  for (const TransferStiffness& t : beam.transfer) {
    text += fmt::format("{}", t.hertz);
    for (const auto& model : {t.shell, t.pipe, t.connector})
      for (const double v : model) text += fmt::format(",{}", v);
    text += "\n";
  }
  return text;
}

} // namespace

std::string beam_yaml(const EquivalentBeam& beam) {
  std::string text =
      "# From the shells, nothing fitted. For the section `models` of the case; caps "
      "keep their masses.\nmodels:\n";
  const Part &pipe = beam.pipe.parts.front(), &chain = beam.connector.parts.front();
  text +=
      "  pipe_of_shell:\n    parts:\n" + pipe_yaml(pipe.name, std::get<EquivalentPipe>(pipe.body));
  return text + "  connector_of_shell:\n    parts:\n" +
         chain_yaml(chain.name, std::get<ConnectorChain>(chain.body));
}

std::string beam_text(const EquivalentBeam& beam) {
  TextRows rows{
      {"equivalent beams, nothing fitted", "shells", "pipe (diff. %)", "connectors (diff. %)"}};
  const StaticStiffness &s = beam.shell_static, &p = beam.pipe_static, &c = beam.connector_static;
  rows.push_back(beam_row("mass, kg", beam.mass, beam.pipe_mass, beam.connector_mass));
  rows.push_back(
      beam_row("axial stiffness, kN/m", s.k_axial / 1e3, p.k_axial / 1e3, c.k_axial / 1e3));
  rows.push_back(beam_row("transverse stiffness, kN/m", s.k_transverse_x / 1e3,
                          p.k_transverse_x / 1e3, c.k_transverse_x / 1e3));
  rows.push_back(
      beam_row("bending stiffness, Nm/rad", s.k_bending_x, p.k_bending_x, c.k_bending_x));
  rows.push_back(beam_row("torsional stiffness, kNm/rad", s.k_torsion / 1e3, p.k_torsion / 1e3,
                          c.k_torsion / 1e3));
  for (const SimplifiedMode& m : beam.modes)
    rows.push_back(
        beam_row(fmt::format("{} mode {}, Hz", m.shape, m.order), m.shell, m.pipe, m.connector));
  std::string text = text_table(rows, "<>") + "\n";
  TextRows good{{"transfer stiffness within 10 % up to", "pipe, Hz", "connectors, Hz"}};
  for (std::size_t k = 0; k < names.size(); ++k)
    good.push_back({names[k], fmt::format("{:.0f}", good_up_to(beam, &TransferStiffness::pipe, k)),
                    fmt::format("{:.0f}", good_up_to(beam, &TransferStiffness::connector, k))});
  text += text_table(good, "<>");
  if (beam.ejma_axial > 0)
    text += fmt::format("\nEJMA formula for the bellows alone, plies free to slip: {:.2f} kN/m\n",
                        beam.ejma_axial / 1e3);
  for (const std::string& remark : beam.remarks) text += "remark: " + remark + "\n";
  return text;
}

std::vector<std::string> beam_files() {
  return {"beam.yaml", "beam.csv", "beam.txt"};
}

void write_beam(const EquivalentBeam& beam, OutputFolder& out) {
  out.add("beam.yaml", beam_yaml(beam));
  out.add("beam.csv", transfer_csv(beam));
  out.add("beam.txt", beam_text(beam));
}

} // namespace plica
