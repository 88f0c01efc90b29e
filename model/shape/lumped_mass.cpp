#include "model/shape/lumped_mass.hpp"

namespace plica {
namespace {

class Lumps {
public:
  explicit Lumps(Model& model) : model_(model) {}

  template <class Nodes>
  void take(const Nodes& nodes, const Eigen::MatrixXd& M, const EndArms& arms = no_arms()) {
    const auto n = Eigen::Index(nodes.size());
    for (Eigen::Index a = 0; a < n; ++a) {
      double mass = 0;
      for (Eigen::Index b = 0; b < n; ++b) mass += M.block<3, 3>(6 * a, 6 * b).trace() / 3;
      const Eigen::Vector3d arm = a < 2 ? arms[std::size_t(a)] : Eigen::Vector3d::Zero();
      add(nodes[std::size_t(a)], mass, arm);
    }
  }

  void add(int node, double mass, const Eigen::Vector3d& arm) {
    if (mass == 0) return;
    if (arm.isZero(0))
      at_nodes_[node] += mass;
    else
      beside_.push_back({node, {.mass = mass, .offset = arm}});
  }

  void finish() {
    for (const auto& [node, mass] : at_nodes_)
      model_.masses.push_back({node, {.mass = mass, .offset = {0, 0, 0}}});
    model_.masses.insert(model_.masses.end(), beside_.begin(), beside_.end());
  }

private:
  Model& model_;
  std::map<int, double> at_nodes_;
  std::vector<MassElement> beside_;
};

} // namespace

void lump_masses(Model& model, const std::map<int, EndArms>& matrices) {
  Lumps lumps(model);
  for (const ShellQuad& q : model.mesh.quads)
    lumps.take(q.nodes, shell_mitc4_mass(mass_geometry(model, q), model.shells[q.section].section));
  for (const ShellTriangle& t : model.mesh.triangles)
    lumps.take(t.nodes, shell_mitc3_mass(mass_geometry(model, t), model.shells[t.section].section));
  for (ShellProperties& shell : model.shells) shell.section.rho = 0;
  for (BeamElement& b : model.beams) {
    const BeamGeometry g = beam_geometry(model.mesh, b);
    const double half = b.section.mass / 2 * (g.node2 + b.offset2 - g.node1 - b.offset1).norm();
    lumps.add(b.node1, half, b.offset1);
    lumps.add(b.node2, half, b.offset2);
    b.section.mass = b.section.inertia_x = b.section.inertia_y = b.section.inertia_z = 0;
  }
  for (const auto& [number, arms] : matrices) {
    MatrixElement& element = model.matrices[std::size_t(number)];
    lumps.take(element.nodes, element.M, arms);
    element.M.setZero();
  }
  lumps.finish();
}

} // namespace plica
