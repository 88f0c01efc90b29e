// Craig-Bampton: the cantilever of the reference values, exact statics, all modes kept, instances,
// and the symmetric route against the full mesh.
#include "tests/bellows_case.hpp"
#include "tests/support/fields.hpp"

#include "reduction/craig_bampton.hpp"
#include "solve/couplings.hpp"
#include "solve/statics.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <numbers>

namespace plica::test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Euler-Bernoulli cantilever L = EI = m = 1, 60 elements, bending in one plane.
Model beam(double from, double to, int elements) {
  Model model;
  BeamProperties section{.EA = 1e9, .EI_y = 1e9, .EI_z = 1, .GJ = 1e9, .mass = 1};
  for (int i = 0; i <= elements; ++i)
    model.mesh.nodes.emplace_back(from + (to - from) * i / elements, 0, 0);
  for (int i = 0; i < elements; ++i)
    model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section});
  return model;
}

VectorXd lowest(const Model& model, int count) {
  const System system = assemble(model);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(dense(system.K), dense(system.M));
  return modes.eigenvalues()
      .head(std::min<Eigen::Index>(count, system.K.rows()))
      .cwiseMax(0)
      .cwiseSqrt();
}

// Relative errors of the first eight bending frequencies, both parts reduced at the same cut-off.
VectorXd errors_at(double factor) {
  const std::vector<int> planar{0, 2, 3, 4};
  Model whole = beam(0, 1, 60);
  for (int i = 0; i <= 60; ++i) add_support(whole, {i}, planar, "plane");
  add_support(whole, {0}, {1, 5}, "root");
  const VectorXd exact = lowest(whole, 8);
  const double cutoff = factor * exact[7] / (2 * std::numbers::pi);
  Model assembly;
  const int cut = add_node(assembly, {0.6, 0, 0});
  add_support(assembly, {cut}, planar, "plane");
  for (const bool root : {true, false}) {
    Model part = root ? beam(0, 0.6, 36) : beam(0.6, 1, 24);
    const int last = root ? 36 : 24, boundary = root ? 36 : 0;
    for (int i = 0; i <= last; ++i)
      if (i != boundary) add_support(part, {i}, planar, "plane");
    if (root) add_support(part, {0}, {1, 5}, "root");
    // The boundary keeps its six DOFs; springs hold those out of the plane.
    BushingElement hold{.node1 = boundary, .node2 = -1, .bushing = {}};
    hold.bushing.law.diagonal() << 1, 0, 1, 1, 1, 0;
    part.bushings.push_back(hold);
    const Reduction r = craig_bampton(part, {boundary}, cutoff);
    EXPECT_TRUE(r.proved) << r.reason;
    add_superelement(assembly, r.element, {cut}, 0);
  }
  return lowest(assembly, 8).cwiseQuotient(exact).array() - 1;
}

// Largest errors over modes 1 to 8 with a cut-off at 1.5 and 3 times the eighth frequency: 0.41 %
// and 0.11 % (own reference calculation of the benchmark, 20 % on the error); upper bounds always.
TEST(CraigBampton, error_of_the_cut_cantilever_falls_as_published) {
  const VectorXd at_15 = errors_at(1.5), at_3 = errors_at(3);
  EXPECT_NEAR(100 * at_15.maxCoeff() / 0.41, 1, 0.2);
  EXPECT_NEAR(100 * at_3.maxCoeff() / 0.11, 1, 0.2);
  EXPECT_GT(at_15.minCoeff(), -1e-9);
  EXPECT_LT(errors_at(2).maxCoeff(), 0.005);
  const VectorXd digits =
      (VectorXd(8) << 8.9e-6, 5.4e-4, 2.8e-3, 6.6e-3, 6.3e-2, 3.3e-2, 2.7e-1, 4.1e-1).finished();
  for (int i = 2; i < 8; ++i) EXPECT_NEAR(100 * at_15[i] / digits[i], 1, 0.2) << i + 1;
}

// Two caps with mass and a liner; both ends free.
struct Pipe {
  BuiltCase built;
  std::vector<int> caps;
};

Pipe pipe_of(const Case& data) {
  Pipe pipe{.built = build(data), .caps = {}};
  for (const Cap& cap : data.caps) pipe.caps.push_back(pipe.built.cap_nodes.at(cap.name));
  return pipe;
}

Pipe pipe(const MeshDensity& mesh = {20, 2, 3}) {
  Case data = verification_case("bellows_a", mesh, 12);
  data.caps[0].mass = 0.2;
  add_liner(data, Attachment::synchronous);
  return pipe_of(data);
}

CyclicModel symmetric_model(const Model& model) {
  return std::get<CyclicModel>(cyclic_model(model));
}

// Boundary blocks to 1e-8, frequencies to 1e-9, the couplings of every eigenvalue.
void expect_symmetric_is_full(const Pipe& p, double cutoff) {
  const Reduction full = craig_bampton(p.built.model, p.caps, cutoff);
  const Reduction fast = craig_bampton(symmetric_model(p.built.model), p.caps, cutoff);
  ASSERT_TRUE(full.proved && fast.proved);
  const int n = 12;
  for (const auto& [a, b] :
       {std::pair{&full.element.K, &fast.element.K}, std::pair{&full.element.M, &fast.element.M}})
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        EXPECT_LE(std::abs((*a)(i, j) - (*b)(i, j)), 1e-8 * std::sqrt((*a)(i, i) * (*a)(j, j)))
            << i << ", " << j;
  // Modes of harmonics above 1 are in the full one alone, without a coupling to the boundary.
  std::vector<std::pair<double, int>> coupled;
  for (int j = 0; j < full.element.modal(); ++j) {
    const double strength = full.element.M.col(n + j).head(n).norm();
    if (strength > 1e-7) coupled.emplace_back(full.lambda[j], j);
  }
  VectorXd lambda = fast.lambda;
  std::sort(lambda.begin(), lambda.end());
  ASSERT_GE(lambda.size(), Eigen::Index(coupled.size()));
  for (const auto& [value, j] : coupled) {
    const auto near =
        std::min_element(lambda.begin(), lambda.end(), [&, v = value](double a, double b) {
          return std::abs(a - v) < std::abs(b - v);
        });
    EXPECT_NEAR(std::sqrt(*near / value), 1, 1e-9);
  }
  // M_bq M_qb of each eigenvalue, whatever the basis of a degenerate pair.
  for (const auto& [value, j] : coupled) {
    MatrixXd a = MatrixXd::Zero(n, n), b = a;
    for (int k = 0; k < full.element.modal(); ++k)
      if (std::abs(full.lambda[k] / value - 1) < 1e-6)
        a += full.element.M.col(n + k).head(n) * full.element.M.col(n + k).head(n).transpose();
    for (int k = 0; k < fast.element.modal(); ++k)
      if (std::abs(fast.lambda[k] / value - 1) < 1e-6)
        b += fast.element.M.col(n + k).head(n) * fast.element.M.col(n + k).head(n).transpose();
    EXPECT_LT((a - b).norm(), 1e-6 * a.norm()) << std::sqrt(value);
  }
}

TEST(CraigBampton, by_symmetry_is_that_of_the_full_mesh) {
  expect_symmetric_is_full(pipe(), 2000);
}

TEST(CraigBampton, by_symmetry_is_that_of_the_20928_quads_of_a2) {
  const Pipe p = pipe_of(read_case(std::string(PLICA_SOURCE_DIR) + "/bench/a2_peer.yaml").data);
  ASSERT_EQ(p.built.model.mesh.quads.size(), 20928U);
  expect_symmetric_is_full(p, 1000);
}

// Caps, a node of the wall and a whole ring: statics of the full mesh, and the modes of the part
// with a lopsided body on the wall node.
TEST(CraigBampton, by_symmetry_reaches_nodes_on_the_wall) {
  const Pipe p = pipe({12, 2, 3});
  const auto& rings = p.built.model.mesh.rings;
  std::vector<int> boundary{p.caps[0], rings[rings.size() / 3].nodes[4], p.caps[1]};
  for (int node : rings[rings.size() / 2].nodes) boundary.push_back(node);
  const Reduction full = craig_bampton(p.built.model, boundary, 2000);
  const Reduction fast = craig_bampton(symmetric_model(p.built.model), boundary, 2000);
  ASSERT_TRUE(full.proved && fast.proved) << full.reason << fast.reason;
  const Superelement &a = full.element, &b = fast.element;
  for (int i = 0; i < a.boundary(); ++i)
    for (int j = 0; j < a.boundary(); ++j) {
      EXPECT_LE(std::abs(a.K(i, j) - b.K(i, j)), 1e-6 * std::sqrt(a.K(i, i) * a.K(j, j)));
      EXPECT_LE(std::abs(a.M(i, j) - b.M(i, j)), 1e-6 * std::sqrt(a.M(i, i) * a.M(j, j)));
    }
  const auto frequencies = [&](const Superelement* s) {
    Model model = s ? Model{} : p.built.model;
    std::vector<int> nodes = boundary;
    if (s) {
      nodes.clear();
      for (const Vector3d& x : s->nodes) nodes.push_back(add_node(model, x));
      add_superelement(model, *s, nodes, 0);
    }
    add_support(model, {nodes[0]}, all_dofs, "root");
    model.masses.push_back(
        {nodes[1],
         {.mass = 0.02, .offset = {0.01, 0, 0.02}, .inertia = 1e-6 * Matrix3d::Identity()}});
    const System system = assemble(model);
    BaseFactor base = factor_below_spectrum(system.K, system.M);
    return find_modes(system.K, system.M, {.count = 12}, base).lambda.cwiseSqrt().eval();
  };
  const VectorXd exact = frequencies(nullptr), reduced = frequencies(&b);
  for (int i = 0; i < 12; ++i) {
    EXPECT_GE(reduced[i] / exact[i], 1 - 1e-7) << i;
    EXPECT_LE(reduced[i] / exact[i], 1.002) << i << " at " << exact[i] / (2 * std::numbers::pi);
  }
}

TEST(CraigBampton, statics_and_rigid_motions_are_exact) {
  const Pipe p = pipe();
  const Reduction r = craig_bampton(symmetric_model(p.built.model), p.caps, 500);
  const MatrixXd R = rigid_motions(r.element, Vector3d::Zero());
  EXPECT_LT((r.element.K * R).norm(), 1e-9 * r.element.K.norm());
  const System full = assemble(p.built.model);
  const MatrixXd rigid =
      expand(full.map, rigid_body_motions(p.built.model, full.map, Vector3d::Zero()));
  // The shell's own K R is rounding of K, which a soft part answers with 1e-16 times the condition
  // of K_ii, some 1e7; a beam reaches 1e-10 below.
  EXPECT_LT((r.field(R) - rigid).cwiseAbs().maxCoeff(), 1e-8);
  const MassProperties m = mass_properties(r.element);
  const MatrixXd r0 = rigid_body_motions(p.built.model, full.map, Vector3d::Zero());
  const MassProperties whole =
      mass_properties(Eigen::Matrix<double, 6, 6>(r0.transpose() * symmetric_product(full.M, r0)));
  EXPECT_NEAR(m.mass / whole.mass, 1, 1e-9);
  EXPECT_LT((m.centre - whole.centre).norm(), 1e-9);
  EXPECT_LT((m.inertia - whole.inertia).norm(), 1e-9 * whole.inertia.norm());
}

Model bar() {
  Model model;
  for (int i = 0; i <= 5; ++i) model.mesh.nodes.emplace_back(0.2 * i, 0, 0);
  const BeamProperties section =
      rectangle_section({.E = 210e9, .nu = 0.3, .rho = 7800}, 0.03, 0.05);
  for (int i = 0; i < 5; ++i)
    model.beams.push_back({.node1 = i, .node2 = i + 1, .section = section});
  return model;
}

TEST(CraigBampton, with_all_modes_is_the_part_itself) {
  const Model model = bar();
  const Reduction r = craig_bampton(model, {0, 5}, 1e9);
  ASSERT_EQ(r.element.K.rows(), 36);
  const System full = assemble(model);
  const MatrixXd rigid = rigid_body_motions(model, full.map, Vector3d::Zero());
  EXPECT_LT((r.field(rigid_motions(r.element, Vector3d::Zero())) - expand(full.map, rigid))
                .cwiseAbs()
                .maxCoeff(),
            1e-10);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> a(dense(full.K), dense(full.M)),
      b(r.element.K, r.element.M);
  for (int i = 6; i < 36; ++i) EXPECT_NEAR(b.eigenvalues()[i] / a.eigenvalues()[i], 1, 1e-8) << i;
}

TEST(Superelement, instances_turned_and_mirrored_have_the_same_frequencies) {
  const Pipe p = pipe();
  const Reduction r = craig_bampton(symmetric_model(p.built.model), p.caps, 1500);
  const auto frequencies = [](const Superelement& s, const Matrix3d& R) {
    // Held at the first node, a lopsided mass that turns along at the second.
    Model model;
    std::vector<int> nodes;
    for (const Vector3d& x : s.nodes) nodes.push_back(add_node(model, x));
    add_superelement(model, s, nodes, 0);
    add_support(model, {nodes[0]}, all_dofs, "root");
    const Matrix3d inertia = Vector3d(1e-3, 2e-3, 3e-3).asDiagonal();
    model.masses.push_back({nodes[1],
                            {.mass = 0.5,
                             .offset = R * Vector3d(0.01, 0.02, 0.03),
                             .inertia = R * inertia * R.transpose()}});
    return lowest(model, 20);
  };
  const VectorXd wanted = frequencies(r.element, Matrix3d::Identity());
  const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Matrix3d mirror = turn * Vector3d(1, -1, 1).asDiagonal();
  for (const Matrix3d& R : {turn, mirror}) {
    const VectorXd found = frequencies(placed(r.element, R, {1, 2, 3}), R);
    EXPECT_LT((found - wanted).cwiseQuotient(wanted).cwiseAbs().maxCoeff(), 1e-9);
  }
  EXPECT_THROW(placed(r.element, 2 * turn, Vector3d::Zero()), std::invalid_argument);
}

// The Schur complement of the part at a frequency, from its matrices in full.
TEST(Superelement, dynamic_stiffness_is_what_is_left_when_the_inside_is_condensed) {
  const Model part = bar();
  const Superelement s = craig_bampton(part, {0, 5}, 1e9).element;
  const MatrixXd K = dense(assemble(part).K), M = dense(assemble(part).M);
  constexpr int inside = 24, last = 6 + inside; // nodes 1 to 4, first DOF of node 5
  for (double hertz : {5., 80., 900.}) {
    const MatrixXd A = K - std::pow(2 * std::numbers::pi * hertz, 2) * M;
    MatrixXd to_ends(inside, 2); // uy of both
    to_ends << A.block(6, 1, inside, 1), A.block(6, last + 1, inside, 1);
    const MatrixXd S =
        to_ends.transpose() * A.block(6, 6, inside, inside).partialPivLu().solve(to_ends);
    const VectorXd at = VectorXd::Constant(1, hertz);
    EXPECT_NEAR(dynamic_stiffness(s, 1, 1, at)[0] / (A(1, 1) - S(0, 0)), 1, 1e-6) << hertz;
    EXPECT_NEAR(dynamic_stiffness(s, 1, 7, at)[0] / (A(1, last + 1) - S(0, 1)), 1, 1e-6) << hertz;
  }
}

TEST(CraigBampton, names_bad_boundaries) {
  const Pipe p = pipe();
  const auto message = [&](const std::vector<int>& boundary) -> std::string {
    try {
      craig_bampton(p.built.model, boundary, 100);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message({}).find("needs a boundary node"), std::string::npos);
  EXPECT_NE(message({p.caps[0], p.caps[0]}).find("given twice"), std::string::npos);
  EXPECT_NE(message({p.built.model.mesh.rings[0].nodes[0]}).find("dependent side of spider"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
