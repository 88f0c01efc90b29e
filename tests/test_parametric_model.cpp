// Reduced models under change, against the changed structure solved whole.
#include "reduction/parametric_model.hpp"
#include "solve/modes.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <gtest/gtest.h>

namespace plica {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A slender cantilever of beams, 12 elements, its left end the boundary.
Model cantilever() {
  Model model;
  model.components = {"beam"};
  const BeamProperties section =
      rectangle_section({.E = 70e9, .nu = 0.33, .rho = 2700}, 0.03, 0.004);
  for (int i = 0; i <= 12; ++i) add_node(model, {0, 0.05 * i, 0});
  for (int i = 0; i < 12; ++i)
    model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section, .up = {0, 0, 1}});
  return model;
}

VectorXd whole(Model model, int count) {
  const System system = assemble(model);
  std::vector<int> free;
  for (int i = 0; i < system.map.size(); ++i)
    if (system.map.full[i] / 6 != 0) free.push_back(i);
  const SparseMatrix K = restrict_to(system.K, free), M = restrict_to(system.M, free);
  BaseFactor base = factor_below_spectrum(K, M);
  return find_modes(K, M, {.count = count, .band = {}, .proof = true}, base).lambda.head(count);
}

VectorXd reduced(const AffineModel& f, const VectorXd& c, int count) {
  const MatrixXd K = f.stiffness(c), M = f.mass_matrix(c);
  const Eigen::Index n = K.rows() - f.boundary;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(K.bottomRightCorner(n, n),
                                                                 M.bottomRightCorner(n, n));
  return pairs.eigenvalues().head(count);
}

constexpr int watched = 4;

// Frequencies within so much of those of the whole structure.
void expect_near(const VectorXd& got, const VectorXd& want, double tolerance) {
  for (Eigen::Index i = 0; i < want.size(); ++i)
    EXPECT_NEAR(std::sqrt(got[i] / want[i]), 1, tolerance) << "mode " << i + 1;
}

ModelChange mass_at(int node, double mass) {
  return {[=](Model& m) {
    MassElement point{.node = node, .body = {}};
    point.body.mass = mass;
    m.masses.push_back(point);
  }};
}

TEST(ParametricModel, the_nominal_modes_are_exact) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  expect_near(reduced(model.with({}), {}, watched), whole(cantilever(), watched), 1e-9);
}

TEST(ParametricModel, follows_an_added_mass_of_any_size) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const AffineModel affine = model.with({model.prepare(mass_at(7, 1))});
  for (double mass : {0.005, 0.05, 0.5}) { // the beam weighs 0.19 kg
    Model changed = cantilever();
    mass_at(7, mass).apply(changed);
    expect_near(reduced(affine, VectorXd::Constant(1, mass), watched), whole(changed, watched),
                1e-3);
  }
}

TEST(ParametricModel, follows_a_spring_to_the_ground) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const auto spring = [](double k) {
    return ModelChange{[k](Model& m) {
      BushingElement b{.node1 = 9, .node2 = -1, .bushing = {}};
      b.bushing.law.diagonal().head<3>().setConstant(k);
      m.bushings.push_back(b);
    }};
  };
  const AffineModel affine = model.with({model.prepare(spring(1))});
  for (double k : {1e2, 1e4, 1e6}) {
    Model changed = cantilever();
    spring(k).apply(changed);
    expect_near(reduced(affine, VectorXd::Constant(1, k), watched), whole(changed, watched), 1e-3);
  }
}

TEST(ParametricModel, follows_a_stretch_that_loses_its_stiffness) {
  const auto soft = [](double loss) {
    return ModelChange{[loss](Model& m) {
      for (int e : {3, 4})
        for (double* n :
             {&m.beams[std::size_t(e)].section.EA, &m.beams[std::size_t(e)].section.EI_y,
              &m.beams[std::size_t(e)].section.EI_z, &m.beams[std::size_t(e)].section.GJ})
          *n *= 1 - loss;
    }};
  };
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const AffineModel affine = model.with({model.prepare(soft(0.5))});
  for (double loss : {0.1, 0.6, 0.9}) {
    Model changed = cantilever();
    soft(loss).apply(changed);
    expect_near(reduced(affine, VectorXd::Constant(1, loss / 0.5), watched),
                whole(changed, watched), 5e-3);
  }
}

// The whole structure says what the error is; the estimate has the nominal stiffness in place of
// the changed one, which is a tenth of it here.
TEST(ParametricModel, estimates_the_error_of_its_frequencies) {
  const auto soft = [](double loss) { // all stiffness, so that K is linear in the loss
    return ModelChange{[loss](Model& m) {
      for (int e : {3, 4}) {
        BeamProperties& b = m.beams[std::size_t(e)].section;
        for (double* n : {&b.EA, &b.EI_y, &b.EI_z, &b.GJ, &b.GA_y, &b.GA_z}) *n *= 1 - loss;
      }
    }};
  };
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const auto changes = std::vector{model.prepare(soft(0.5))};
  const AffineModel affine = model.with(changes);
  std::vector<int> free;
  for (int i = affine.boundary; i < int(affine.K.rows()); ++i) free.push_back(i);
  EXPECT_LT(model.frequency_errors(changes, VectorXd::Zero(1), free, watched).maxCoeff(), 1e-9);
  const VectorXd c = VectorXd::Constant(1, 0.9 / 0.5);
  const VectorXd estimate = model.frequency_errors(changes, c, free, watched);
  Model changed = cantilever();
  soft(0.9).apply(changed);
  const VectorXd got = reduced(affine, c, watched), want = whole(changed, watched);
  for (Eigen::Index i = 0; i < watched; ++i) {
    const double error = std::sqrt(got[i] / want[i]) - 1;
    EXPECT_GT(estimate[i], 0.1 * error - 1e-9) << "mode " << i + 1;
    EXPECT_LT(estimate[i], 10 * error + 1e-6) << "mode " << i + 1;
  }
}

// Everything the change asks for is in the basis already: rounding must not join it.
TEST(ParametricModel, scales_with_the_modulus_of_the_whole) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const ModelChange doubled{[](Model& m) {
    for (BeamElement& b : m.beams)
      for (double* n : {&b.section.EA, &b.section.EI_y, &b.section.EI_z, &b.section.GJ,
                        &b.section.GA_y, &b.section.GA_z})
        *n *= 2;
  }};
  const AffineModel affine = model.with({model.prepare(doubled)});
  const VectorXd nominal = whole(cantilever(), watched);
  for (double factor : {0.1, 0.5, 3.})
    expect_near(reduced(affine, VectorXd::Constant(1, factor - 1), watched), factor * nominal,
                1e-9);
}

TEST(ParametricModel, weighs_what_is_added) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const AffineModel affine = model.with({model.prepare(mass_at(7, 0.3))});
  EXPECT_NEAR(affine.mass, 0.6 * 0.03 * 0.004 * 2700, 1e-12);
  EXPECT_NEAR(affine.d_mass[0], 0.3, 1e-12);
}

TEST(ParametricModel, a_released_boundary_on_springs_moves_as_the_whole_does) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const auto springs = [](double k) {
    return ModelChange{[k](Model& m) {
      BushingElement b{.node1 = 0, .node2 = -1, .bushing = {}};
      b.bushing.law.diagonal() << k, k, k, k / 100, k / 100, k / 100;
      m.bushings.push_back(b);
    }};
  };
  const AffineModel affine = model.with({model.prepare(springs(1))});
  Model changed = cantilever();
  springs(2e4).apply(changed);
  const System system = assemble(changed);
  BaseFactor base = factor_below_spectrum(system.K, system.M);
  const VectorXd want =
      find_modes(system.K, system.M, {.count = watched, .band = {}, .proof = true}, base)
          .lambda.head(watched);
  const MatrixXd K = affine.K + 2e4 * affine.dK[0];
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(K, affine.M);
  expect_near(pairs.eigenvalues().head(watched), want, 1e-3);
}

ModelChange term(int node, int dof, MotionTerm::Of of, bool begins) {
  return {.apply = {}, .term = MotionTerm{.nodes = {node}, .dof = dof, .of = of, .begins = begins}};
}

// A motion of one DOF is that DOF: the whole structure with a spring, with a mass.
TEST(ParametricModel, follows_what_acts_on_a_motion_of_its_own) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const std::vector<PreparedChange> changes = model.prepare(
      std::vector{term(8, 2, MotionTerm::Of::spring, true),
                  term(9, 2, MotionTerm::Of::spring, false), term(9, 0, MotionTerm::Of::mass, true),
                  term(9, 1, MotionTerm::Of::mass, true), term(9, 2, MotionTerm::Of::mass, true)});
  const AffineModel affine = model.with(changes);
  ASSERT_EQ(affine.sums.size(), 4U);
  std::vector<int> free;
  for (int i = affine.boundary; i < int(affine.K.rows()); ++i) free.push_back(i);
  for (double k : {1e2, 1e4, 1e6}) {
    Model changed = cantilever();
    BushingElement b{.node1 = 9, .node2 = -1, .bushing = {}};
    b.bushing.law.diagonal()[2] = k;
    changed.bushings.push_back(b);
    VectorXd c = VectorXd::Zero(5);
    c[1] = std::sqrt(k);
    expect_near(reduced(affine, c, watched), whole(changed, watched), 1e-3);
    EXPECT_LT(model.frequency_errors(changes, c, free, watched).maxCoeff(), 1e-3);
  }
  for (double mass : {0.005, 0.5}) {
    Model changed = cantilever();
    mass_at(9, mass).apply(changed);
    VectorXd c = VectorXd::Zero(5);
    c.tail<3>().setConstant(std::sqrt(mass));
    expect_near(reduced(affine, c, watched), whole(changed, watched), 1e-3);
    EXPECT_NEAR(affine.weight(c), affine.mass + mass, 1e-12);
    EXPECT_LT(model.frequency_errors(changes, c, free, watched).maxCoeff(), 1e-3);
  }
}

// The mean of two nodes, as a sum of terms and as a change of its own.
TEST(ParametricModel, a_motion_of_two_nodes_is_the_square_of_their_sum) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  for (const auto of : {MotionTerm::Of::spring, MotionTerm::Of::mass}) {
    const double size = of == MotionTerm::Of::spring ? 3e4 : 0.2;
    std::vector<ModelChange> terms;
    for (int dof : {0, 1, 2})
      for (int node : {5, 7}) terms.push_back(term(node, dof, of, node == 5));
    const AffineModel sums = model.with(model.prepare(terms));
    const bool spring = of == MotionTerm::Of::spring;
    const AffineModel mean = model.with({model.prepare(
        {.apply = {}, .on_motion = {on_mean_motion({5, 7}, spring ? 0 : 1, spring ? 1 : 0)}})});
    const VectorXd c = VectorXd::Constant(6, std::sqrt(size) / 2),
                   one = VectorXd::Constant(1, size);
    expect_near(reduced(sums, c, watched), reduced(mean, one, watched), 1e-6);
    EXPECT_NEAR(sums.weight(c), mean.weight(one), 1e-12);
    // What a translation of the base excites does not hang on the coordinates.
    const auto excited = [](const AffineModel& f, const VectorXd& x) {
      return MatrixXd(f.loads(x).transpose() * f.stiffness(x).ldlt().solve(f.loads(x)));
    };
    const auto held = [](const AffineModel& f) {
      std::vector<int> free;
      for (int i = f.boundary; i < int(f.K.rows()); ++i) free.push_back(i);
      return f.restricted_to(free);
    };
    const MatrixXd got = excited(held(sums), c), want = excited(held(mean), one);
    EXPECT_NEAR((got - want).norm() / want.norm(), 0, 1e-4); // of two bases
  }
}

// A mass on a spring, its DOF behind those of the cantilever, clamped at node 0.
struct WithResonator {
  MatrixXd K, M, rigid; // rigid: translations along x, y, z
  WithResonator(int node, int dof, double mass, double omega) {
    const Model model = cantilever();
    const System system = assemble(model);
    std::vector<int> free;
    int own = -1;
    for (int i = 0; i < system.map.size(); ++i) {
      if (system.map.full[i] / 6 == 0) continue;
      if (system.map.full[i] == 6 * node + dof) own = int(free.size());
      free.push_back(i);
    }
    const auto n = Eigen::Index(free.size());
    const auto dense = [&](const SparseMatrix& A) {
      MatrixXd all = MatrixXd::Zero(n + 1, n + 1);
      all.topLeftCorner(n, n) = MatrixXd(restrict_to(A, free)).selfadjointView<Eigen::Lower>();
      return all;
    };
    K = dense(system.K);
    M = dense(system.M);
    const double k = mass * omega * omega;
    K(own, own) += k;
    K(n, n) = k;
    K(own, n) = K(n, own) = -k;
    M(n, n) = mass;
    rigid = MatrixXd::Zero(n + 1, 3);
    rigid.topRows(n) = rigid_body_motions(model, system.map, {0, 0, 0})(free, Eigen::seqN(0, 3));
    rigid(n, dof) = 1;
  }
};

// Far below, near, between and above the modes of the cantilever; the mass up to half of its own.
TEST(ParametricModel, hangs_a_mass_by_a_spring_of_its_own) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const VectorXd nominal = whole(cantilever(), watched);
  const std::vector<PreparedChange> changes = model.prepare(std::vector{
      term(9, 2, MotionTerm::Of::resonator, true),
      ModelChange{.apply = {}, .term = MotionTerm{.nodes = {}, .of = MotionTerm::Of::resonator}}});
  const AffineModel affine = model.with(changes);
  std::vector<int> free;
  for (int i = affine.boundary; i < int(affine.K.rows()); ++i) free.push_back(i);
  const AffineModel held = affine.restricted_to(free);
  for (double lambda : {0.3 * nominal[0], nominal[0], nominal[1] / 2, 4 * nominal[2]})
    for (double mass : {0.005, 0.05}) {
      const double omega = std::sqrt(lambda);
      const WithResonator want(9, 2, mass, omega);
      const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> pairs(want.K, want.M);
      const VectorXd c = Eigen::Vector2d(std::sqrt(mass) * omega, omega);
      expect_near(reduced(affine, c, watched), pairs.eigenvalues().head(watched), 1e-3);
      EXPECT_LT(model.frequency_errors(changes, c, free, watched).maxCoeff(), 1e-3);
      const MatrixXd load = want.M * want.rigid, own = held.loads(c);
      const MatrixXd answer = load.transpose() * want.K.ldlt().solve(load);
      EXPECT_NEAR((own.transpose() * held.stiffness(c).ldlt().solve(own) - answer).norm() /
                      answer.norm(),
                  0, 1e-3);
    }
  const VectorXd none = VectorXd::Zero(2);
  expect_near(reduced(affine, none, watched), nominal, 1e-9);
  EXPECT_EQ(affine.weight(none), affine.mass);
}

// Along all axes, as it hangs in space; while there is none it weighs nothing.
TEST(ParametricModel, weighs_a_mass_that_hangs_by_a_spring) {
  const ParametricModel model(cantilever(), {0}, {12}, 10);
  const ModelChange frequency{.apply = {},
                              .term = MotionTerm{.nodes = {}, .of = MotionTerm::Of::resonator}};
  std::vector<ModelChange> terms;
  for (int dof : {0, 1, 2}) {
    terms.push_back(term(9, dof, MotionTerm::Of::resonator, true));
    terms.push_back(frequency);
  }
  const AffineModel affine = model.with(model.prepare(terms));
  VectorXd c(6);
  for (int axis = 0; axis < 3; ++axis)
    c.segment<2>(2 * axis) = Eigen::Vector2d(std::sqrt(0.02) * 300, 300);
  EXPECT_NEAR(affine.weight(c), affine.mass + 0.02, 1e-12);
  EXPECT_EQ(affine.weight(VectorXd::Zero(6)), affine.mass);
}

} // namespace
} // namespace plica
