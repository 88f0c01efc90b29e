#include "io/report/diagnosis_sections.hpp"
#include "io/report/picture.hpp"
#include "io/report/viewer.hpp"
#include "io/tables/ledger_words.hpp"

#include <limits>

namespace plica {
namespace {

// Of the nodes of a place, the one nearest to its middle.
int middle_of(const Mesh& mesh, const std::vector<int>& nodes) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int node : nodes) middle += mesh.nodes[std::size_t(node)] / double(nodes.size());
  int nearest = nodes.front();
  double least = std::numeric_limits<double>::infinity();
  for (int node : nodes)
    if (const double d = (mesh.nodes[std::size_t(node)] - middle).norm(); d < least) {
      least = d;
      nearest = node;
    }
  return nearest;
}

} // namespace

std::string place_html(const Diagnosis& d) {
  Results drawn; // the pictures of a run want its mesh, and what is named on it
  for (std::size_t i = 0; i < d.ledger.rows.size(); ++i) {
    const LedgerRow& row = d.ledger.rows[i];
    for (const NamedEffect& e : row.effects)
      if (!e.nodes.empty() && (!is_long(row) || &e == &row.effects.front()))
        drawn.sensors.push_back(
            {.name = std::to_string(i + 1), .node = middle_of(d.mesh, e.nodes)});
  }
  if (d.resonator && !d.resonator->found.nodes.empty())
    drawn.sensors.push_back(
        {.name = "on a spring", .node = middle_of(d.mesh, d.resonator->found.nodes)});
  drawn.mesh = d.mesh;
  drawn.lines = d.lines;
  return part_viewer(drawn, part_picture(drawn, in_a_column));
}

} // namespace plica
