// Numbers and names under which a superelement stands in the files of other programs.
//
// Boundary node k is grid first_node + k with DOFs 1..6; modal coordinate j is scalar point
// first_mode + j (DOF 1 where a program wants one); recovered point k is grid first_point + k.
#pragma once

#include "reduction/superelement.hpp"

namespace plica {

struct ElementLabels {
  int first_node = 101, first_mode = 1001, first_point = 500001;
  int element = 1;            // of the Abaqus user element
  std::string name = "PLICA"; // of sets and matrices, at most five letters and digits
  // A coordinate system of the deck in which nodes and matrices stand (CORD2R, *SYSTEM and
  // *TRANSFORM) and where it lies in that of the model: x = origin + axes x_own. 0 = none.
  int system = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

// Throws std::invalid_argument for numbers that overlap or have more than eight digits, and a name
// that is too long.
void check_labels(const ElementLabels& labels, const Superelement& s);

struct CoordinateLabel {
  int point = 0, dof = 0; // dof 0 = scalar point
};
CoordinateLabel coordinate_label(const Superelement& s, int coordinate,
                                 const ElementLabels& labels = {});

// Motion of the recovered points by the coordinates: six rows a point, ux uy uz rx ry rz.
Eigen::MatrixXd recovery_matrix(const Superelement& s);

// "left.uy", "mode 3": the DOF order of every file.
std::vector<std::string> coordinate_names(const Superelement& s);

// The matrices that are there: K, M and, with damping, C (viscous) and D (structural).
struct NamedMatrix {
  char letter = 'K';
  const Eigen::MatrixXd* matrix = nullptr;
};
std::vector<NamedMatrix> matrices_of(const Superelement& s);

} // namespace plica
