#include "reduction/substructures.hpp"
#include "solve/element_view.hpp"
#include "solve/strain_energy.hpp"

#include <algorithm>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Elements with stiffness per component.
std::map<int, int> elements_by_component(const Model& model) {
  std::map<int, int> count;
  const ElementView elements{model};
  for (int e = 0; e < elements.size(); ++e)
    if (const int c = elements.component(e); c >= 0) ++count[c];
  return count;
}

// The elements of all components but one, by nodes of their own.
struct Remainder {
  Model model;
  std::vector<int> nodes; // numbers in the part, increasing
};

template <class List, class Component>
void keep_others(List& list, int without, const Component& component) {
  std::erase_if(list, [&](const auto& element) { return component(element) == without; });
}

Remainder all_but(const Model& part, int component) {
  Remainder rest{.model = part, .nodes = {}};
  Model& m = rest.model;
  const auto of_shell = [&](const auto& s) { return m.shells[std::size_t(s.section)].component; };
  const auto own = [](const auto& element) { return element.component; };
  keep_others(m.mesh.quads, component, of_shell);
  keep_others(m.mesh.triangles, component, of_shell);
  keep_others(m.beams, component, own);
  keep_others(m.bushings, component, own);
  keep_others(m.matrices, component, own);
  m.masses.clear();
  std::set<int> used;
  const ElementView elements{m};
  for (int e = 0; e < elements.size(); ++e)
    for (const int node : elements.nodes(e)) used.insert(node);
  rest.nodes.assign(used.begin(), used.end());
  return rest;
}

// u' K_c u of one instance added to the rows of its components.
void add_energy(const Instance& instance, const MatrixXd& q, MatrixXd& energy) {
  const MatrixXd& K = instance.reduced->reduction.element.K;
  const Eigen::RowVectorXd whole = q.cwiseProduct(K * q).colwise().sum();
  const Model& part = instance.part->model;
  const std::map<int, int> count = elements_by_component(part);
  if (count.empty()) return;
  const auto most = std::max_element(
      count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  energy.row(most->first) += whole;
  if (count.size() == 1) return;
  const Remainder rest = all_but(part, most->first);
  const MatrixXd at = instance.reduced->reduction.field_at(q, rest.nodes);
  constexpr Index stretch = 16; // columns that are spread over all DOFs of the part at a time
  for (Index first = 0; first < q.cols(); first += stretch) {
    const Index columns = std::min(stretch, q.cols() - first);
    MatrixXd u = MatrixXd::Zero(dof_count(part), columns);
    for (std::size_t i = 0; i < rest.nodes.size(); ++i)
      u.middleRows<6>(6 * Index(rest.nodes[i])) = at.block(6 * Index(i), first, 6, columns);
    const MatrixXd others = strain_energy(rest.model, u);
    energy.middleCols(first, columns) += others;
    energy.row(most->first).segment(first, columns) -= others.colwise().sum();
  }
}

} // namespace

MatrixXd strain_energy(const ReducedModel& reduced, const MatrixXd& q) {
  Model frame = reduced.model; // but for the superelements, which stand last
  frame.matrices.resize(frame.matrices.size() - reduced.instances.size());
  MatrixXd energy = strain_energy(frame, q);
  for (const Instance& instance : reduced.instances)
    add_energy(instance, q(rows_of(instance, reduced.number), Eigen::all), energy);
  return energy;
}

} // namespace plica
