#include "model/shape/lumped_mass.hpp"

namespace plica {
namespace {

class Lumps {
public:
  explicit Lumps(Model& model) : model_(model) {}

  template <class Nodes> void take(const Nodes& wall, const Eigen::MatrixXd& M) {
    for (std::size_t a = 0; a < wall.size(); ++a)
      add(wall[a], {.mass = mass_of(M, a), .offset = {0, 0, 0}});
  }

  void take(const MatrixElement& bar, const EndArms& arms) {
    for (std::size_t a = 0; a < 2; ++a) {
      const auto turns = 6 * Eigen::Index(a) + 3;
      add(bar.nodes[a], {mass_of(bar.M, a), arms[a], bar.M.block<3, 3>(turns, turns)});
    }
  }

  // Those of a node that stand in the same place are one.
  void add(int node, const RigidMass& body) {
    if (body.mass == 0) return;
    if (!body.offset.isZero(0)) return beside_.push_back({node, body});
    const auto [known, is_new] = at_nodes_.try_emplace(node, body);
    if (is_new) return;
    known->second.mass += body.mass;
    known->second.inertia += body.inertia;
  }

  void finish() {
    for (const auto& [node, body] : at_nodes_) model_.masses.push_back({node, body});
    model_.masses.insert(model_.masses.end(), beside_.begin(), beside_.end());
  }

private:
  static double mass_of(const Eigen::MatrixXd& M, std::size_t node) {
    double mass = 0;
    for (Eigen::Index b = 0; b < M.cols(); b += 6)
      mass += M.block<3, 3>(6 * Eigen::Index(node), b).trace() / 3;
    return mass;
  }

  Model& model_;
  std::map<int, RigidMass> at_nodes_;
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
    const Eigen::Vector3d axis = g.node2 + b.offset2 - g.node1 - b.offset1, e = axis.normalized();
    const double half = axis.norm() / 2;
    const Eigen::Matrix3d inertia = half * b.section.inertia_x * e * e.transpose();
    lumps.add(b.node1, {half * b.section.mass, b.offset1, inertia});
    lumps.add(b.node2, {half * b.section.mass, b.offset2, inertia});
    b.section.mass = b.section.inertia_x = b.section.inertia_y = b.section.inertia_z = 0;
  }
  for (const auto& [number, arms] : matrices) {
    MatrixElement& element = model.matrices[std::size_t(number)];
    if (element.nodes.size() == 2)
      lumps.take(element, arms);
    else
      lumps.take(element.nodes, element.M);
    element.M.setZero();
  }
  lumps.finish();
}

} // namespace plica
