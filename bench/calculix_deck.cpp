// Writes the shells of a case as a CalculiX deck with clamped ends and ten frequencies:
//   calculix_deck CASE DECK.inp
#include "io/input/case_file.hpp"
#include "model/shape/build.hpp"

#include <cstdio>
#include <exception>
#include <fstream>

namespace {

void write_deck(const plica::Case& data, std::ostream& out) {
  const plica::BuiltCase built = plica::build(data);
  const plica::Mesh& mesh = built.model.mesh;
  out.precision(12);
  out << "*NODE,NSET=NALL\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Eigen::Vector3d& x = mesh.nodes[i];
    out << i + 1 << ',' << x.x() << ',' << x.y() << ',' << x.z() << '\n';
  }
  out << "*ELEMENT,TYPE=S4,ELSET=SHELL\n";
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    out << e + 1;
    for (int node : mesh.quads[e].nodes) out << ',' << node + 1;
    out << '\n';
  }
  const auto& bellows = std::get<plica::Bellows>(data.parts.front().body);
  const plica::Material& m = data.materials.at(bellows.material);
  out << "*MATERIAL,NAME=WALL\n*ELASTIC\n"
      << m.E << ',' << m.nu << "\n*DENSITY\n"
      << m.rho << "\n*SHELL SECTION,ELSET=SHELL,MATERIAL=WALL\n"
      << mesh.quads.front().thickness[0] << "\n*BOUNDARY\n";
  for (const char* end : {".left", ".right"})
    for (int node : mesh.sets.at(data.parts.front().name + end)) out << node + 1 << ",1,6\n";
  out << "*STEP\n*FREQUENCY\n10\n*END STEP\n";
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: calculix_deck CASE DECK.inp\n", stderr);
    return 1;
  }
  try {
    std::ofstream out(argv[2]);
    write_deck(plica::read_case(argv[1]).data, out);
    return out ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
