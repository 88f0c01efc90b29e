#include "reduction/certificate.hpp"

#include "solve/decompositions.hpp"
#include "solve/modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <numeric>

namespace plica {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double frequency_limit = 0.005; // what "good" means: the usual 0.5 %

double asymmetry(const MatrixXd& A) {
  return (A - A.transpose()).norm() / std::max(1e-300, A.norm());
}

// Sine of the largest angle between the column spaces.
double angle_between(const MatrixXd& A, const MatrixXd& B) {
  const MatrixXd Qa = orthonormal_columns(A), Qb = orthonormal_columns(B);
  return Eigen::JacobiSVD<MatrixXd>(Qb - Qa * (Qa.transpose() * Qb)).singularValues()[0];
}

// Rows and columns scaled so that N/m and Nm/rad count alike: to unit diagonal, or, where what is
// left free has a diagonal of rounding, by the masses.
MatrixXd balanced(const MatrixXd& K, const VectorXd& by) {
  const VectorXd s = by.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  return s.asDiagonal() * K * s.asDiagonal();
}

// Null space of K normalised to unit motion of the first node: rigid motions as the stiffness sees
// them. A rotation about z moves the node at x by e_z x (x - x_1).
double coordinate_error(const Superelement& s, const MatrixXd& null_space) {
  const MatrixXd N = null_space * null_space.topRows(6).inverse();
  double error = 0;
  for (std::size_t node = 1; node < s.nodes.size(); ++node) {
    const auto at = 6 * static_cast<Index>(node);
    const Eigen::Matrix3d W = N.block<3, 3>(at, 3); // columns e_j x d
    const Vector3d d(W(1, 2) - W(2, 1), W(2, 0) - W(0, 2), W(0, 1) - W(1, 0));
    error = std::max(error, (d / 2 - (s.nodes[node] - s.nodes[0])).norm());
  }
  return error;
}

// Pairs reduced frequencies with those of the part in order; up to `left_out` of the part's may be
// passed over. Of all such pairings the one with the smallest sum of squared errors in which none
// lies below its partner by more than rounding: a Ritz reduction comes from above.
std::vector<FrequencyCheck> elastic(const VectorXd& full, const VectorXd& reduced, int rigid,
                                    int left_out) {
  const int m = static_cast<int>(reduced.size()) - rigid, n = static_cast<int>(full.size()) - rigid;
  const int count = std::min(m, n);
  if (count <= 0) return {};
  const int skips = std::min(left_out, n - count);
  const auto error = [&](int i, int skip) {
    return frequency(reduced[rigid + i]) / frequency(full[rigid + i + skip]) - 1;
  };
  // cost(i, k): the best for the first i pairs with k passed over.
  constexpr double impossible = 1e300;
  MatrixXd cost = MatrixXd::Constant(count + 1, skips + 1, impossible);
  Eigen::MatrixXi from = Eigen::MatrixXi::Zero(count + 1, skips + 1);
  cost.row(0).setZero();
  for (int i = 1; i <= count; ++i)
    for (int k = 0; k <= skips; ++k) {
      Index best = 0;
      const double before = cost.row(i - 1).head(k + 1).minCoeff(&best);
      const double e = error(i - 1, k);
      const bool below = k > 0 && e < -1e-6;
      cost(i, k) = below ? impossible : before + e * e;
      from(i, k) = static_cast<int>(best);
    }
  Index k = 0;
  cost.row(count).minCoeff(&k);
  std::vector<FrequencyCheck> checks(count);
  for (int i = count; i > 0; k = from(i, k), --i)
    checks[i - 1] = {frequency(full[rigid + i - 1 + k]), frequency(reduced[rigid + i - 1])};
  return checks;
}

// How alike the boundary motions of a reduced mode and one of the part are, 0..1; of a degenerate
// group of the part as one space.
double likeness(const MatrixXd& motion, const VectorXd& lambda, Index mode, const VectorXd& own) {
  constexpr double one = 1e-6; // relative distance within a group
  double sum = 0;
  for (Index j = 0; j < lambda.size(); ++j) {
    if (std::abs(lambda[j] - lambda[mode]) > one * std::abs(lambda[mode])) continue;
    const double size = motion.col(j).norm() * own.norm();
    if (size > 0) sum += std::pow(motion.col(j).dot(own) / size, 2);
  }
  return sum;
}

// Pairs that stand in order are exchanged where the shapes say that two frequencies have crossed.
// `motion`: of the superelement's own free modes, one column each.
std::vector<FrequencyCheck> by_shape(std::vector<FrequencyCheck> checks, const PartReference& part,
                                     const Superelement& s, const MatrixXd& motion, int rigid) {
  if (part.free_motion.cols() == 0 || part.left_out > 0) return checks;
  // Rotations at the size of the part, so that they count as motions do.
  double size = 0;
  for (const Vector3d& x : s.nodes) size = std::max(size, (x - s.nodes.front()).norm());
  VectorXd scale = VectorXd::Ones(s.boundary());
  for (Index i = 0; i < scale.size(); ++i)
    if (i % 6 >= 3) scale[i] = std::max(size, 1e-3);
  const MatrixXd full = scale.asDiagonal() * part.free_motion,
                 reduced = scale.asDiagonal() * motion.topRows(s.boundary());
  const auto alike = [&](std::size_t check, std::size_t mode) {
    return likeness(full, part.free_lambda, rigid + Index(mode), reduced.col(rigid + Index(check)));
  };
  std::vector<std::size_t> of(checks.size()); // mode of the part, per reduced one
  std::iota(of.begin(), of.end(), std::size_t{0});
  constexpr double clearly = 0.5; // better in sum
  for (std::size_t pass = 0; pass < checks.size(); ++pass)
    for (std::size_t i = 1; i < checks.size(); ++i)
      if (alike(i - 1, of[i]) + alike(i, of[i - 1]) >
          alike(i - 1, of[i - 1]) + alike(i, of[i]) + clearly)
        std::swap(of[i - 1], of[i]);
  const std::vector<FrequencyCheck> in_order = checks;
  for (std::size_t i = 0; i < checks.size(); ++i)
    checks[of[i]] = {in_order[of[i]].full, in_order[i].reduced};
  return checks;
}

using SymmetricEigen = Eigen::SelfAdjointEigenSolver<MatrixXd>;
constexpr double zero = 1e-9; // of the largest eigenvalue

// What a rigid motion raises, `forces` on the boundary, beside the stiffness that is there.
double beside_stiffness(const Superelement& s, const MatrixXd& forces) {
  return forces.cwiseAbs().maxCoeff() /
         std::max(1e-300, s.K.topLeftCorner(s.boundary(), s.boundary()).cwiseAbs().maxCoeff());
}

// `c.rigid` must be known; `shapes`: of the free modes; `stiffness`: of K balanced.
void check_rigid_motions(Certificate& c, const Superelement& s, const PartReference& part,
                         const MatrixXd& shapes, const SymmetricEigen& stiffness) {
  if (c.preloaded) {
    const MatrixXd raised = (s.K * rigid_motions(s, s.nodes.front())).topRows(s.boundary());
    c.grounding = beside_stiffness(s, raised - part.preload);
  }
  if (!part.grounded && !c.preloaded) {
    const MatrixXd R = rigid_motions(s, s.nodes.front());
    c.grounding = beside_stiffness(s, s.K * R);
    c.rigid_modes = angle_between(shapes.leftCols(6), R);
    // Back from the balanced matrix.
    const VectorXd scale = s.K.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    c.coordinates = coordinate_error(s, scale.asDiagonal() * stiffness.eigenvectors().leftCols(6));
  }
  if (part.grounded && c.rigid > 0) {
    const MatrixXd R = rigid_motions(s, Vector3d::Zero()) * part.free_motions;
    c.grounding = beside_stiffness(s, s.K * R) / R.cwiseAbs().maxCoeff();
    c.rigid_modes = angle_between(shapes.leftCols(c.rigid), R);
  }
}

// What is held has no rigid motion to weigh it by, but those that the holds leave.
void check_mass(Certificate& c, const Superelement& s, const PartReference& part) {
  if (part.grounded && c.rigid > 0) {
    const MatrixXd& F = part.free_motions;
    const MatrixXd R = rigid_motions(s, Vector3d::Zero()) * F;
    const MatrixXd own = R.transpose() * s.M * R, whole = F.transpose() * part.rigid_mass * F;
    c.mass = (own - whole).norm() / whole.norm();
  }
  if (!part.grounded) {
    const MassProperties own = mass_properties(s), whole = mass_properties(part.rigid_mass);
    c.mass = std::abs(own.mass / whole.mass - 1);
    c.centre = (own.centre - whole.centre).norm();
    c.inertia = (own.inertia - whole.inertia).norm() / whole.inertia.norm();
  }
}

void check_statics(Certificate& c, const Superelement& s, const PartReference& part) {
  if (part.static_stiffness.size() == 0) return;
  const Index n = part.static_stiffness.rows();
  MatrixXd K_bb = s.K.topLeftCorner(n, n);
  if (const Index more = s.boundary() - n; more > 0) {
    const MatrixXd coupling = s.K.block(n, 0, more, n);
    K_bb -= coupling.transpose() * MatrixXd(s.K.block(n, n, more, more)).ldlt().solve(coupling);
  }
  c.statics_known_to = part.statics_known_to;
  const VectorXd size = part.static_stiffness.diagonal().cwiseSqrt();
  const MatrixXd scale = size * size.transpose();
  c.statics = (K_bb - part.static_stiffness).cwiseQuotient(scale).cwiseAbs().maxCoeff();
}

// Squared frequencies of the modal coordinates alone, the boundary held.
VectorXd fixed_interface(const Superelement& s) {
  const Index m = s.modal();
  if (m == 0) return {};
  return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(
             s.K.bottomRightCorner(m, m), s.M.bottomRightCorner(m, m), Eigen::EigenvaluesOnly)
      .eigenvalues();
}

// `in_order`: the free frequencies, which those of the part in order bound from below.
std::vector<std::string> failures_of(const Certificate& c,
                                     const std::vector<FrequencyCheck>& in_order) {
  std::vector<std::string> failures;
  const auto require = [&](bool good, const std::string& what) {
    if (!good) failures.push_back(what);
  };
  require(c.asymmetry < 1e-12, "K or M is not symmetric");
  require(c.smallest_mass > 0, "M is not positive definite");
  require(c.preloaded || (c.zero_stiffness == c.rigid && c.negative_stiffness > -zero),
          "K has " + std::to_string(c.zero_stiffness) + " zero eigenvalues, not " +
              std::to_string(c.rigid) + ", or a negative one");
  require(c.grounding < (c.preloaded ? 1e-6 : 1e-8),
          c.preloaded ? "a rigid motion raises other forces than the preload does"
                      : "a rigid motion raises forces");
  require(c.rigid_modes < 1e-4, "the lowest modes are not the rigid motions that nothing holds");
  require(c.coordinates < 1e-5, "the stiffness does not know where its nodes are");
  require(c.mass < 1e-8 && c.centre < 1e-8 && c.inertia < 1e-7, "mass, centre or inertia differ");
  require(!(c.statics >= std::max(1e-9, c.statics_known_to)),
          "the static stiffness is not that of the part");
  for (const FrequencyCheck& f : in_order)
    require(f.error() > -1e-6, "a frequency lies below that of the part: not a Ritz reduction");
  require(c.free.empty() || c.good_up_to > 0,
          "not even the first elastic frequency is met within 0.5 %");
  return failures;
}

} // namespace

Certificate certificate(const Superelement& s, const PartReference& part) {
  Certificate c;
  c.asymmetry = std::max(asymmetry(s.K), asymmetry(s.M));
  const SymmetricEigen mass(balanced(s.M, s.M.diagonal())),
      stiffness(balanced(s.K, part.free_motions.cols() > 0 ? s.M.diagonal() : s.K.diagonal()));
  c.smallest_mass = mass.eigenvalues()[0] / mass.eigenvalues().maxCoeff();
  const VectorXd k = stiffness.eigenvalues() / std::max(1e-300, stiffness.eigenvalues().maxCoeff());
  c.zero_stiffness = static_cast<int>((k.array().abs() < zero).count());
  c.negative_stiffness = std::min(0., k[0]);
  c.preloaded = part.preload.size() > 0;
  c.rigid = c.preloaded ? 0 : part.grounded ? int(part.free_motions.cols()) : 6;
  const Index held = c.preloaded ? 6 : 0, n = s.K.rows() - held;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(s.K.bottomRightCorner(n, n),
                                                                 s.M.bottomRightCorner(n, n));
  check_rigid_motions(c, s, part, modes.eigenvectors(), stiffness);
  check_mass(c, s, part);
  check_statics(c, s, part);
  const std::vector<FrequencyCheck> in_order =
      elastic(part.free_lambda, modes.eigenvalues(), c.rigid, part.left_out);
  c.fixed = elastic(part.fixed_lambda, fixed_interface(s), 0, part.left_out);
  c.free = c.preloaded ? in_order : by_shape(in_order, part, s, modes.eigenvectors(), c.rigid);
  for (const FrequencyCheck& f : c.free) {
    if (std::abs(f.error()) > frequency_limit) break;
    c.good_up_to = f.full;
    c.error = std::max(c.error, std::abs(f.error()));
  }
  c.failures = failures_of(c, in_order);
  c.passed = c.failures.empty();
  return c;
}

} // namespace plica
