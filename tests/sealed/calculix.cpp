#include "brick_mesh.hpp"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace sealed {
namespace {

namespace fs = std::filesystem;

// A material for every hundredth of a percent of E.
std::map<int, std::vector<int>> bricks_by_material(const BrickMesh& mesh) {
  std::map<int, std::vector<int>> groups;
  for (std::size_t e = 0; e < mesh.bricks.size(); ++e)
    groups[int(std::lround(1e4 * mesh.factor[e]))].push_back(int(e));
  return groups;
}

void write_deck(const WallShape& shape, const WallSpecimen& s, const BrickMesh& mesh,
                std::ostream& out) {
  out.precision(14);
  out << "*NODE,NSET=NALL\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    out << i + 1 << ',' << mesh.nodes[i].x() << ',' << mesh.nodes[i].y() << ',' << mesh.nodes[i].z()
        << '\n';
  const double stiffer = 1 / std::sqrt(bending_factor(s.bond));
  for (const auto& [material, bricks] : bricks_by_material(mesh)) {
    out << "*ELEMENT,TYPE=C3D20R,ELSET=E" << material << '\n';
    for (const int e : bricks) {
      out << e + 1;
      for (std::size_t n = 0; n < 20; ++n)
        out << (n == 15 ? ",\n" : ",") << mesh.bricks[std::size_t(e)][n] + 1;
      out << '\n';
    }
    out << "*MATERIAL,NAME=M" << material << "\n*ELASTIC\n"
        << shape.E * stiffer * material * 1e-4 << ',' << shape.nu << "\n*DENSITY\n"
        << shape.rho * stiffer << "\n*SOLID SECTION,ELSET=E" << material << ",MATERIAL=M"
        << material << '\n';
  }
  out << "*STEP\n*FREQUENCY,SOLVER=MATRIXSTORAGE\n1\n*END STEP\n";
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("CalculiX wrote no " + file.string());
  std::string text(fs::file_size(file), ' ');
  in.read(text.data(), std::streamsize(text.size()));
  return text;
}

template <class T> T number(const char*& at, const char* end) {
  while (at < end && (*at == ' ' || *at == '\n' || *at == '.')) ++at;
  T value{};
  const auto [rest, error] = std::from_chars(at, end, value);
  if (error != std::errc{}) throw std::runtime_error("unreadable number of CalculiX");
  at = rest;
  return value;
}

bool at_end(const char* at, const char* end) {
  while (at < end && (*at == ' ' || *at == '\n')) ++at;
  return at == end;
}

// Lines "node.direction", in the order of the unknowns.
std::vector<int> unknowns_of(const fs::path& file) {
  const std::string text = text_of(file);
  std::vector<int> unknowns;
  for (const char *at = text.data(), *end = at + text.size(); !at_end(at, end);) {
    const int node = number<int>(at, end);
    unknowns.push_back(3 * (node - 1) + number<int>(at, end) - 1);
  }
  return unknowns;
}

std::vector<Eigen::Triplet<double>> triplets_of(const fs::path& file,
                                                const std::vector<int>& unknowns) {
  const std::string text = text_of(file);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(text.size() / 32);
  for (const char *at = text.data(), *end = at + text.size(); !at_end(at, end);) {
    const int a = number<int>(at, end), b = number<int>(at, end);
    const double value = number<double>(at, end);
    if (value != 0)
      entries.emplace_back(unknowns[std::size_t(a - 1)], unknowns[std::size_t(b - 1)], value);
  }
  return entries;
}

} // namespace

BrickMatrices calculix_matrices(const WallShape& shape, const WallSpecimen& s,
                                const BrickMesh& mesh, const fs::path& folder) {
  fs::create_directories(folder);
  {
    std::ofstream deck(folder / "wall.inp");
    write_deck(shape, s, mesh, deck);
  }
  const std::string command =
      "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx wall > log 2>&1";
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("CalculiX (ccx) failed, see " + (folder / "log").string());
  const std::vector<int> unknowns = unknowns_of(folder / "wall.dof");
  if (unknowns.size() != 3 * mesh.nodes.size())
    throw std::runtime_error("CalculiX dropped unknowns of the wall");
  BrickMatrices matrices{triplets_of(folder / "wall.sti", unknowns),
                         triplets_of(folder / "wall.mas", unknowns)};
  fs::remove_all(folder);
  return matrices;
}

} // namespace sealed
