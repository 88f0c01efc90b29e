// Superelement: a part by its matrices over boundary nodes and modal coordinates (Craig & Bampton,
// AIAA J. 6 (1968) 1313-1319).
//
//   u = Psi u_b + Phi q,   Psi = -K_ii^-1 K_ib,   Phi: modes with the boundary held
//   K = [K_bb 0; 0 Lambda],   M = [M_bb M_bq; M_qb I]
//
// Coordinates: ux uy uz rx ry rz of each boundary node in order, then the modal ones. Rigid motions
// lie in Psi, so they are exact. SI units unless `units` says otherwise.
#pragma once

#include "solve/model.hpp"

#include <functional>

namespace plica {

struct RecoveryRows { // displacements and rotations of one node inside
  std::string name;
  Eigen::Vector3d place;
  Eigen::MatrixXd rows; // 6 x coordinates
};

struct StressRows { // of the wall at one point: xx yy zz xy yz zx, face below
                    // the directors, then above, Pa
  std::string name;
  Eigen::Vector3d place;
  Eigen::MatrixXd rows; // 12 x coordinates
};

struct LoadVector { // force per unit amplitude
  std::string name;
  Eigen::VectorXd force; // over the coordinates
};

struct Superelement {
  std::string name;
  std::string units = "m kg s N rad";
  std::vector<std::string> node_names;
  std::vector<Eigen::Vector3d> nodes; // boundary, m
  Eigen::MatrixXd K, M;               // symmetric, full
  Eigen::MatrixXd C;                  // viscous damping, N s/m; empty = none
  Eigen::MatrixXd D;                  // structural damping: K (1 + i eta) = K + i D; empty = none
  std::vector<RecoveryRows> recovery;
  std::vector<StressRows> stresses;
  std::vector<LoadVector> loads; // forces of the case; base motions per m/s2 or rad/s2

  int boundary() const { return 6 * static_cast<int>(nodes.size()); }
  int modal() const { return static_cast<int>(K.rows()) - boundary(); }
};

// The six rigid motions about a point, coordinates x 6.
Eigen::MatrixXd rigid_motions(const Superelement& s, const Eigen::Vector3d& about);

// Force that rigid motions raise, K scaled to unit diagonal: zero for a free part but for rounding.
double grounding(const Eigen::MatrixXd& K, const std::vector<Eigen::Vector3d>& nodes);

// Stiffness between nodes with the forces that rigid motions raise taken out. They are the rounding
// of the part's own K (1e-16 of a membrane's stiffness, 1e-8 of a bellows'), and left in they would
// ground a larger model. K is returned as it is when a rigid motion raises more than 1e-6 of it:
// then the part is held. A single node has rigid motions alone: K is zero when it is rounding of
// `unreduced`, the largest number of the part's own K there.
Eigen::MatrixXd without_grounding(const Eigen::MatrixXd& K,
                                  const std::vector<Eigen::Vector3d>& nodes, double unreduced = 0);

// Force on one boundary coordinate over the displacement of another, all other ones held, undamped:
// K_bb - w^2 M_bb - w^4 M_bq (Lambda - w^2)^-1 M_qb. Per frequency.
Eigen::VectorXd dynamic_stiffness(const Superelement& s, int row, int column,
                                  const Eigen::VectorXd& hertz);

struct MassProperties {
  double mass = 0;
  Eigen::Vector3d centre{0, 0, 0};
  Eigen::Matrix3d inertia; // about the centre, kg m2
};
MassProperties mass_properties(const Eigen::Matrix<double, 6, 6>& about_origin); // r' M r
MassProperties mass_properties(const Superelement& s);

// The same in mm, t, s, N: translations in mm, modal masses stay 1, stresses in MPa.
Superelement in_millimetres(const Superelement& s);

// Another instance: x -> R x + t. R may be a rotation or a mirror image (det R = -1); rotations are
// axial vectors and follow det(R) R. Throws std::invalid_argument when R is not orthogonal.
Superelement placed(const Superelement& s, const Eigen::Matrix3d& R, const Eigen::Vector3d& t);

// Adds the element between nodes of a model, its modal coordinates as scalar points (six to a
// node), and returns those nodes.
std::vector<int> add_superelement(Model& model, const Superelement& s,
                                  const std::vector<int>& nodes, int component);

// Element and the way back: `field` gives all DOFs of the part (six per node, columns as given).
struct Reduction {
  Superelement element;
  Eigen::VectorXd lambda; // of the fixed-interface modes
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& coordinates)> field;
  // The same at chosen nodes, six rows each.
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& coordinates, const std::vector<int>& nodes)>
      field_at;
  bool proved = false; // no fixed-interface mode below the cut-off is missing
  std::string reason;  // why not
};

// Share of the interface mass that each mode carries, mean over the boundary DOFs of
// (M_bq)_ij^2 / (M_bb)_ii (after Kammer & Triller, J. Vib. Acoust. 118 (1996) 264): a mode that the
// boundary hardly feels has next to none.
Eigen::VectorXd effective_interface_mass(const Superelement& s);

// The reduction with these of its modes alone (increasing numbers from 0).
Reduction with_modes(const Reduction& reduction, const std::vector<int>& kept);

} // namespace plica
