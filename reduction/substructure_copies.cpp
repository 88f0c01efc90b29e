#include "reduction/substructures.hpp"

#include <algorithm>
#include <map>

namespace plica {
namespace {

class Comparison {
public:
  explicit Comparison(double rounding) : rounding_(rounding) {}

  bool same(const Substructure& a, const Substructure& b) const;

private:
  bool equal(double a, double b) const { // two infinities are equal too
    return a == b || std::abs(a - b) <= rounding_ * std::max(std::abs(a), std::abs(b));
  }
  template <class A, class B>
  bool equal(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) const {
    return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).norm() <= rounding_ * b.norm();
  }
  template <class T, class F> bool all_equal(const T& a, const T& b, F&& pairwise) const {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), pairwise);
  }

  bool equal(const ShellSection& a, const ShellSection& b) const {
    return equal(a.E, b.E) && equal(a.nu, b.nu) && equal(a.rho, b.rho) &&
           equal(a.bending_factor, b.bending_factor) &&
           equal(a.shear_correction, b.shear_correction) && equal(a.drilling, b.drilling);
  }

  bool equal(const BeamProperties& a, const BeamProperties& b) const {
    for (const auto member :
         {&BeamProperties::EA, &BeamProperties::EI_y, &BeamProperties::EI_z, &BeamProperties::GJ,
          &BeamProperties::GA_y, &BeamProperties::GA_z, &BeamProperties::mass,
          &BeamProperties::inertia_x, &BeamProperties::inertia_y, &BeamProperties::inertia_z})
      if (!equal(a.*member, b.*member)) return false;
    return true;
  }

  // Terms of no more than rounding may be there in one and missing in the other.
  bool equal(const Constraint& a, const Constraint& b) const {
    if (a.node != b.node || a.dof != b.dof) return false;
    std::map<std::pair<int, int>, double> difference;
    for (const ConstraintTerm& t : a.terms) difference[{t.node, t.dof}] += t.factor;
    for (const ConstraintTerm& t : b.terms) difference[{t.node, t.dof}] -= t.factor;
    return std::all_of(difference.begin(), difference.end(),
                       [&](const auto& entry) { return std::abs(entry.second) <= rounding_; });
  }

  double rounding_;
};

bool Comparison::same(const Substructure& a, const Substructure& b) const {
  const Model &m = a.model, &n = b.model;
  if (a.boundary != b.boundary || m.mesh.nodes.size() != n.mesh.nodes.size()) return false;
  const Eigen::Vector3d shift = n.mesh.nodes.front() - m.mesh.nodes.front();
  const double size = (m.mesh.nodes.back() - m.mesh.nodes.front()).norm() + shift.norm();
  const auto same_shell = [&](const auto& p, const auto& q) {
    const ShellProperties &s = m.shells[p.section], &t = n.shells[q.section];
    return p.nodes == q.nodes && equal(p.directors, q.directors) &&
           equal(p.thickness, q.thickness) && s.membrane == t.membrane &&
           equal(s.section, t.section);
  };
  return all_equal(m.mesh.nodes, n.mesh.nodes,
                   [&](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
                     return (x + shift - y).norm() <= rounding_ * size;
                   }) &&
         all_equal(m.mesh.quads, n.mesh.quads, same_shell) &&
         all_equal(m.mesh.triangles, n.mesh.triangles, same_shell) &&
         all_equal(m.beams, n.beams,
                   [&](const BeamElement& p, const BeamElement& q) {
                     return p.node1 == q.node1 && p.node2 == q.node2 && equal(p.up, q.up) &&
                            equal(p.offset1, q.offset1) && equal(p.offset2, q.offset2) &&
                            equal(p.section, q.section);
                   }) &&
         all_equal(m.masses, n.masses,
                   [&](const MassElement& p, const MassElement& q) {
                     return p.node == q.node && equal(p.body.mass, q.body.mass) &&
                            equal(p.body.offset, q.body.offset) &&
                            equal(p.body.inertia, q.body.inertia);
                   }) &&
         all_equal(m.bushings, n.bushings,
                   [&](const BushingElement& p, const BushingElement& q) {
                     return p.node1 == q.node1 && p.node2 == q.node2 &&
                            equal(p.bushing.law, q.bushing.law) &&
                            equal(p.bushing.axes, q.bushing.axes) &&
                            equal(p.bushing.preload, q.bushing.preload);
                   }) &&
         all_equal(m.matrices, n.matrices,
                   [&](const MatrixElement& p, const MatrixElement& q) {
                     return p.nodes == q.nodes && equal(p.K, q.K) && equal(p.M, q.M);
                   }) &&
         all_equal(m.constraints, n.constraints,
                   [&](const Constraint& p, const Constraint& q) { return equal(p, q); });
}

} // namespace

bool is_copy(const Substructure& a, const Substructure& b, double rounding) {
  return Comparison(rounding).same(a, b);
}

} // namespace plica
