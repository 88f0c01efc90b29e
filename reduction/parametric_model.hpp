// Reduced models of a structure that is changed in known ways, small enough to be solved thousands
// of times.
//
//   K(c) = K_0 + sum_k c_k dK_k,   M(c) = M_0 + sum_k c_k dM_k   over q,   u = V q,   V = [Psi | W]
//
// dK_k, dM_k: what a finite change k adds. Two that change the same elements have a product
// besides, c_j c_k (dK of both at once - dK_j - dK_k), where it is asked for. Psi: motions of the
// boundary nodes, the rest following (constraint modes). W, the boundary held: the lowest modes;
// static answers to forces on marked nodes; and for each change the first terms of its Neumann
// series, K^-1 (dK - lambda dM) phi and K^-1 dK Psi (combined approximations: Kirsch, J. Mech. Des.
// 113 (1991)), or, for a change of the whole, modes and constraint modes of the changed structure
// (multi-model basis: Balmes, Mech. Syst. Signal Process. 10 (1996) 381). Exact for c = 0 below the
// cut of the modes, in statics of boundary and marked nodes always.
//
// What a spring or a mass at a place that moves adds is no such sum; its motion is:
//   K(c) += x x',  x = sum_i c_i V' e_i   over the terms i of a motion (MotionTerm).
//
// A resonator has a coordinate y of its own behind q, sqrt(mass) times its motion:
//   K += [x; -w e_y] [x; -w e_y]',   M += e_y e_y',   load += sqrt(mass) along its motion
#pragma once

#include "reduction/affine_model.hpp"
#include "reduction/matrix_difference.hpp"
#include "solve/modes.hpp"

#include <functional>
#include <optional>

namespace plica {

// A finite change of a model that leaves its unknowns as they are: other sections, thicknesses,
// materials, further masses and springs on its nodes, the same mesh on another shape.
//   nominal  small: the nominal basis meets its frequencies and stiffness to first order
//   series   first terms of its Neumann series join the basis
//   modes    reaches all of a part: modes of the changed structure join the basis
enum class Follow { nominal, series, modes };
struct ModelChange {
  std::function<void(Model&)> apply;
  Follow follow = Follow::series;
  std::vector<OnMotion> on_motion = {}; // besides
  std::optional<MotionTerm> term = {};  // in place of both
};

// A change over the independent DOFs that it touches, with what it adds to the basis.
struct PreparedChange : MatrixDifference {
  Eigen::MatrixXd further; // columns over all independent DOFs
  // K_0 `further`, the boundary left out: over `dofs`, where there is nothing elsewhere, else over
  // all independent DOFs.
  Eigen::MatrixXd forces;
  // Of a product its two factors, by their numbers among the changes; it stands behind all that are
  // none.
  std::optional<std::array<int, 2>> product_of = {};
  std::optional<MotionTerm> term = {}; // then K and M are empty
  Eigen::VectorXd factors = {};        // of the term, over `dofs`
};

class ParametricModel {
public:
  // `boundary`, `marked`, `observed`: nodes; the last are looked at only, so that no static answers
  // are kept for them. Every boundary node has six independent DOFs. `held`: those of the boundary
  // that do not move in the nominal modes; none = all. `loose`: rigid motions that nothing but soft
  // springs holds, as combinations (6 x their number) of rigid_body_motions() about the origin; its
  // lowest modes may be these, which are then left out. Throws ConstraintError, std::runtime_error
  // for a structure without stiffness where it needs some.
  ParametricModel(Model model, std::vector<int> boundary, std::vector<int> marked, int modes,
                  const std::vector<int>& observed = {},
                  const std::optional<std::vector<int>>& held = std::nullopt,
                  const Eigen::MatrixXd& loose = Eigen::MatrixXd(6, 0));

  // All may be called from several threads. Several changes prepared together take less time.
  PreparedChange prepare(const ModelChange& change) const;
  std::vector<PreparedChange> prepare(const std::vector<ModelChange>& changes) const;
  // What two changes together have beyond their sum; none where they touch nothing in common.
  std::optional<PreparedChange> product(const ModelChange& both, const PreparedChange& a,
                                        const PreparedChange& b) const;
  AffineModel with(const std::vector<PreparedChange>& changes) const;

  // How far the frequencies of the lowest modes may lie above those of the whole structure,
  // relative: r' K_0^-1 r / (2 lambda), r the forces that the reduced mode leaves unbalanced, K_0
  // the nominal stiffness. `free`: coordinates that are not held. An estimate: K_0 stands for the
  // changed stiffness. Not a number where the changed structure is not stable.
  Eigen::VectorXd frequency_errors(const std::vector<PreparedChange>& changes,
                                   const Eigen::VectorXd& coefficients,
                                   const std::vector<int>& free, int modes) const;

  const Model& model() const { return model_; }
  Eigen::MatrixXd nominal_shapes() const; // of the modes, over all DOFs
  Eigen::MatrixXd basis() const;          // V without changes, over all DOFs
  const Eigen::VectorXd& lambda() const { return nominal_.lambda; } // of the nominal modes
  // The part is free or hangs softly; its rigid motions are none of the nominal modes.
  bool leaves_rigid() const { return nominal_.suspended; }
  double highest_rigid() const { return nominal_.highest_rigid; } // its eigenvalue; 0: free
  const std::vector<int>& boundary() const { return boundary_; }
  int unknowns() const { return system_.map.size(); }

private:
  // What changes add to W: X, free of what W has; E: energies of [W | X]; T: unit energy, what adds
  // nothing dropped.
  struct Basis {
    Eigen::MatrixXd X, E, T;
  };
  // V' M V and Psi' M V, V = [W | X].
  struct InnerMass {
    Eigen::MatrixXd own, to_boundary;
  };
  struct Loaded {
    const std::vector<int>* dofs;
    Eigen::MatrixXd forces;
  };
  // The nominal modes: Psi `boundary` + W `inside`.
  struct NominalModes {
    Eigen::VectorXd lambda;
    Eigen::MatrixXd boundary, inside;
    bool suspended = false;
    double highest_rigid = 0; // eigenvalue, of a suspended one
  };
  NominalModes modes_inside() const;
  NominalModes modes_held_at(const std::vector<int>& nodes) const;
  Basis basis_of(const std::vector<PreparedChange>& changes) const;
  AffineModel reduced(const std::vector<PreparedChange>& changes, const Basis& basis) const;
  InnerMass inner_mass(const Eigen::MatrixXd& X) const;
  void add_changes(const std::vector<PreparedChange>& changes, const Basis& basis,
                   AffineModel& affine) const;
  void add_sums(const std::vector<PreparedChange>& changes, const Basis& basis,
                AffineModel& affine) const;
  Eigen::MatrixXd nominal_over_q(const InnerMass& mass, const Eigen::MatrixXd& T,
                                 const Eigen::MatrixXd& M) const;
  Eigen::MatrixXd loose_mass() const;
  Eigen::MatrixXd solve_inside(const Eigen::MatrixXd& force) const; // zero at the boundary
  Eigen::MatrixXd constraint_modes(const SparseMatrix& K, const SparseFactor& inside) const;
  Eigen::MatrixXd inner_columns(const Eigen::MatrixXd& inside) const;
  std::vector<Eigen::MatrixXd> answers(const std::vector<Loaded>& loads) const;
  void follow_series(const std::vector<PreparedChange*>& changes) const;
  void follow_modes(PreparedChange& change) const;

  Model model_;
  std::vector<int> boundary_, marked_;
  int count_ = 0;
  double mass_ = 0;       // of the whole, kg
  Eigen::MatrixXd loose_; // combinations of rigid motions
  System system_;
  std::vector<int> held_, inside_; // independent DOFs
  std::vector<int> row_inside_;    // of an independent DOF among those inside; -1 = held
  std::optional<SparseFactor> factor_;
  Eigen::VectorXd lambda_; // the boundary held
  NominalModes nominal_;
  // Over the independent DOFs. W: modes, then answers to forces on marked nodes; K Psi is zero but
  // at the boundary.
  Eigen::MatrixXd Psi_, W_, KW_, MPsi_, MW_, rigid_, Mr_;
  Eigen::MatrixXd PsiKPsi_, PsiMPsi_, WKW_, WMW_, PsiMW_, rigidMPsi_, rigidMW_;
  Eigen::SparseMatrix<double> markers_; // 6 rows per marked node, then per observed one
  Eigen::MatrixXd markedPsi_, markedW_;
};

} // namespace plica
