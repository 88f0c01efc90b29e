#include "io/superelements/labels.hpp"

#include <array>
#include <stdexcept>

namespace plica {

namespace fs = std::filesystem;

CoordinateLabel coordinate_label(const Superelement& s, int coordinate) {
  if (coordinate < s.boundary()) return {first_grid + coordinate / 6, coordinate % 6 + 1};
  return {first_scalar + coordinate - s.boundary(), 0};
}

std::vector<std::string> coordinate_names(const Superelement& s) {
  constexpr std::array dofs{"ux", "uy", "uz", "rx", "ry", "rz"};
  std::vector<std::string> names;
  for (int i = 0; i < s.boundary(); ++i) names.push_back(s.node_names[i / 6] + "." + dofs[i % 6]);
  for (int j = 0; j < s.modal(); ++j) names.push_back("mode " + std::to_string(j + 1));
  return names;
}

std::vector<NamedMatrix> matrices_of(const Superelement& s) {
  std::vector<NamedMatrix> list{{'K', &s.K}, {'M', &s.M}};
  if (s.C.size() > 0) list.push_back({'C', &s.C});
  if (s.D.size() > 0) list.push_back({'D', &s.D});
  return list;
}

void bad_line(const fs::path& path, int line, const std::string& what) {
  throw std::runtime_error(path.string() + ":" + std::to_string(line) + ": " + what);
}

} // namespace plica
