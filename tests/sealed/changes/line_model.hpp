// Bending of a straight line of beams in one plane, by the suite's own theory: Timoshenko's beam in
// elements whose deflection and rotation are cubic polynomials each. Section and mass may vary
// along the line.
#pragma once

#include "structures.hpp"

#include <Eigen/Dense>
#include <functional>

namespace sealed {

struct LineSection {
  double EI = 0, GA = 0; // N m2; N, with the shear coefficient
  double mass = 0;       // kg/m
  double inertia = 0;    // kg m, rotary
};
using SectionAt = std::function<LineSection(double)>; // m along the line

class LineModel {
public:
  // A stretch that goes on from the last one, or starts anew where that one ends.
  void add_stretch(double from, double to, int elements, const SectionAt& section,
                   bool joined = true);

  // At the node nearest to s; of two that meet there the one of the later stretch, or the earlier.
  int node(double s, bool earlier = false) const;
  void add_mass(int node, double mass, double inertia = 0);
  void add_springs(int node, double translation, double rotation);
  void add_joint(int a, int b, double translation, double rotation);
  void fix(int node, bool deflection, bool rotation);

  // The lowest, with what they show at these places along the line; rigid motions are near zero.
  FoundModes modes(int count, const std::vector<double>& seen_at) const;

private:
  Eigen::VectorXd weights_at(double s) const; // of the unknowns in the deflection there
  Eigen::MatrixXd K_ = Eigen::MatrixXd(0, 0), M_ = Eigen::MatrixXd(0, 0);
  std::vector<double> s_; // of each node; two unknowns a node: deflection, rotation
  std::vector<int> fixed_;
};

} // namespace sealed
