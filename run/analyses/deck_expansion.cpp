#include "run/analyses/deck_expansion.hpp"

#include "solve/element_view.hpp"

namespace plica {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Numbers of shells, beams and springs of a deck among the elements of the model that it makes.
class ElementNumbers {
public:
  ElementNumbers(const DeckModel& deck, const Model& placed) {
    const auto size = [](const auto& list) { return int(list.size()); };
    int quad = 0, triangle = size(placed.mesh.quads);
    beams_ = triangle + size(placed.mesh.triangles);
    int matrix = beams_ + size(placed.beams) + size(placed.masses) + size(placed.bushings);
    for (const DeckShell& s : deck.shells)
      shells_.push_back(s.laminate >= 0 ? matrix++ : s.nodes.size() == 4 ? quad++ : triangle++);
    springs_ = matrix;
  }
  int operator()(const DeckStrain& s) const {
    if (s.of == DeckStrain::Of::shell) return shells_[std::size_t(s.index)];
    return (s.of == DeckStrain::Of::beam ? beams_ : springs_) + s.index;
  }

private:
  std::vector<int> shells_;
  int beams_ = 0, springs_ = 0;
};

// Places of the ends of a beam's axis, of the nodes of any other element.
std::vector<Vector3d> places(const Model& model, const DeckStrain& s,
                             const std::vector<int>& nodes) {
  std::vector<Vector3d> x;
  for (const int node : nodes) x.push_back(model.mesh.nodes[std::size_t(node)]);
  if (s.of == DeckStrain::Of::beam) {
    const BeamElement& beam = model.beams[std::size_t(s.index)];
    x[0] += beam.offset1;
    x[1] += beam.offset2;
  }
  return x;
}

} // namespace

ExpansionLoads expansion_loads(const DeckModel& deck, const Model& placed,
                               const std::vector<DeckStrain>& strains) {
  const ElementNumbers number(deck, placed);
  const ElementView elements{placed};
  ExpansionLoads loads{.force = VectorXd::Zero(dof_count(placed))};
  for (const DeckStrain& s : strains)
    elements.visit(number(s), [&](const auto& of, const auto& K, const auto&) {
      const std::vector<int> nodes(of.begin(), of.end());
      const std::vector<Vector3d> x = places(placed, s, nodes);
      VectorXd u = VectorXd::Zero(6 * Index(nodes.size()));
      for (std::size_t a = 0; a < nodes.size(); ++a)
        u.segment<3>(6 * Index(a)) = s.strain * (x[a] - x[0]);
      const VectorXd f = K * u;
      for (std::size_t a = 0; a < nodes.size(); ++a)
        loads.force.segment<6>(6 * nodes[a]) += f.segment<6>(6 * Index(a));
      loads.energy += u.dot(f) / 2;
    });
  return loads;
}

} // namespace plica
