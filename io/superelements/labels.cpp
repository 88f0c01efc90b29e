#include "io/superelements/labels.hpp"

#include "words/directions.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace plica {

CoordinateLabel coordinate_label(const Superelement& s, int coordinate,
                                 const ElementLabels& labels) {
  if (coordinate < s.boundary()) return {labels.first_node + coordinate / 6, coordinate % 6 + 1};
  return {labels.first_mode + coordinate - s.boundary(), 0};
}

void check_labels(const ElementLabels& l, const Superelement& s) {
  constexpr int largest = 99999999;
  struct Range {
    const char* what;
    long first, count;
  };
  const std::array ranges{Range{"nodes", l.first_node, long(s.nodes.size())},
                          Range{"modes", l.first_mode, s.modal()},
                          Range{"points", l.first_point, long(s.recovery.size())}};
  for (const Range& a : ranges) {
    if (a.count > 0 && (a.first < 1 || a.first + a.count - 1 > largest))
      throw std::invalid_argument(std::string("numbers of ") + a.what +
                                  " must lie between 1 and 99999999");
    for (const Range& b : ranges)
      if (&a < &b && a.count > 0 && b.count > 0 && a.first < b.first + b.count &&
          b.first < a.first + a.count)
        throw std::invalid_argument(std::string("numbers of ") + a.what + " (from " +
                                    std::to_string(a.first) + ", " + std::to_string(a.count) +
                                    ") and of " + b.what + " (from " + std::to_string(b.first) +
                                    ", " + std::to_string(b.count) + ") overlap");
  }
  const bool plain = std::all_of(l.name.begin(), l.name.end(),
                                 [](unsigned char c) { return std::isalnum(c) != 0; });
  if (l.name.empty() || l.name.size() > 5 || !plain ||
      std::isalpha(static_cast<unsigned char>(l.name[0])) == 0)
    throw std::invalid_argument("a name has one to five letters and digits, a letter first");
}

Eigen::MatrixXd recovery_matrix(const Superelement& s) {
  Eigen::MatrixXd rows(6 * Eigen::Index(s.recovery.size()), s.K.rows());
  for (std::size_t k = 0; k < s.recovery.size(); ++k)
    rows.middleRows<6>(6 * Eigen::Index(k)) = s.recovery[k].rows;
  return rows;
}

std::vector<std::string> coordinate_names(const Superelement& s) {
  std::vector<std::string> names;
  for (int i = 0; i < s.boundary(); ++i)
    names.push_back(s.node_names[i / 6] + "." + dof_name(i % 6));
  for (int j = 0; j < s.modal(); ++j) names.push_back("mode " + std::to_string(j + 1));
  return names;
}

std::vector<NamedMatrix> matrices_of(const Superelement& s) {
  std::vector<NamedMatrix> list{{'K', &s.K}, {'M', &s.M}};
  if (s.C.size() > 0) list.push_back({'C', &s.C});
  if (s.D.size() > 0) list.push_back({'D', &s.D});
  return list;
}

} // namespace plica
