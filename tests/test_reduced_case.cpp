// A reduced case: its certificate, its sensors, loads and stresses beside those of the whole part.
#include "tests/reduced_bellows.hpp"

#include "io/report/superelements.hpp"
#include "io/tables/certificate_words.hpp"
#include "run/analyses/response.hpp"
#include "solve/base_motion.hpp"
#include "solve/sparse_factor.hpp"
#include "solve/statics.hpp"
#include "solve/stress.hpp"
#include "words/input_error.hpp"

#include <Eigen/Eigenvalues>

namespace plica::test {
namespace {

using Eigen::MatrixXd;

TEST(Certificate, of_a_bellows_passes_by_both_routes) {
  Case data = sample_case();
  for (const Symmetry route : {Symmetry::required, Symmetry::off}) {
    data.analyses.symmetry = route;
    const ReducedCase r = reduced(data);
    EXPECT_TRUE(r.proved) << r.reason;
    EXPECT_TRUE(r.certificate.passed)
        << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
    EXPECT_GT(r.certificate.good_up_to, 900);
    for (const FrequencyCheck& f : r.certificate.free)
      EXPECT_TRUE(f.full > 1000 || f.error() < 0.005) << f.full << ": half the cut-off";
    ASSERT_GE(r.certificate.free.size(), 4u);
  }
}

TEST(Certificate, sees_what_is_wrong_with_a_superelement) {
  ReducedCase r = reduced(sample_case());
  PartReference part;
  const MatrixXd R = rigid_motions(r.element, Eigen::Vector3d::Zero());
  part.rigid_mass = R.transpose() * r.element.M * R;
  part.static_stiffness = r.element.K.topLeftCorner<12, 12>();
  const auto failures = [&](const std::function<void(Superelement&)>& harm) {
    Superelement s = r.element;
    harm(s);
    return certificate(s, part).failures.size();
  };
  EXPECT_EQ(failures([](Superelement&) {}), 0u);
  EXPECT_GT(failures([](Superelement& s) { s.K(0, 0) *= 1.001; }), 0u) << "grounded";
  EXPECT_GT(failures([](Superelement& s) { s.M(13, 13) = -1; }), 0u) << "negative mass";
  EXPECT_GT(failures([](Superelement& s) { s.K(0, 1) += 1; }), 0u) << "not symmetric";
  EXPECT_GT(failures([](Superelement& s) { s.nodes[1].x() += 0.001; }), 0u) << "node elsewhere";
  EXPECT_GT(failures([](Superelement& s) { s.M *= 1.01; }), 0u) << "heavier";
}

TEST(CertificateReport, escapes_what_did_not_pass_once) {
  ReducedCase r;
  r.element.name = "bellows";
  r.certificate.failures = {"K < 0 at \"left\""};
  const std::string html = certificate_report(r, "mm t s N rad");
  EXPECT_NE(html.find("<li>K &lt; 0"), std::string::npos);
  EXPECT_EQ(html.find("&amp;lt;"), std::string::npos);
  EXPECT_NE(html.find("mm t s N rad"), std::string::npos);
}

// Force over displacement of the sensor by the rows is that of the whole field.
TEST(ReducedCase, recovers_its_sensor_and_carries_damping) {
  const Case data = sample_case();
  const ReducedCase r = reduced(data);
  ASSERT_EQ(r.element.recovery.size(), 1u);
  const MatrixXd R = rigid_motions(r.element, r.element.recovery[0].place);
  const MatrixXd motion = r.element.recovery[0].rows * R;
  EXPECT_LT((motion - MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-6)
      << "a rigid turn about the sensor moves it not";
  const Eigen::Index m = r.element.modal();
  ASSERT_GT(m, 0);
  const MatrixXd& K = r.element.K;
  for (Eigen::Index j = 12; j < K.rows(); ++j) {
    EXPECT_NEAR(r.element.C(j, j), 2 * 0.02 * std::sqrt(K(j, j)), 1e-9 * std::sqrt(K(j, j)));
    EXPECT_NEAR(r.element.D(j, j) / K(j, j), 0.01, 1e-6) << "all strain energy is in the wall";
  }
}

// A load of the case, the stress of the wall and a base motion from the superelement alone are
// those of the run that keeps the mesh.
TEST(ReducedCase, carries_loads_and_stresses_of_the_part) {
  Case data = sample_case();
  const ReducedCase r = reduced(data, 4000);
  const Superelement& s = r.element;
  ASSERT_EQ(s.loads[6].name, "tap per N");
  // Both caps held: statics of the modal coordinates, exact but for the modes above the cut-off.
  const Eigen::Index m = s.modal();
  const auto response = [&](const Eigen::VectorXd& force) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(s.K.rows());
    q.tail(m) = MatrixXd(s.K.bottomRightCorner(m, m)).ldlt().solve(force.tail(m));
    return q;
  };
  const BuiltCase built = build(data);
  const System full = assemble(built.model);
  std::vector<int> held;
  for (int node : built.held_nodes)
    for (int d = 0; d < 6; ++d) held.push_back(full.map.independent[6 * node + d]);
  std::sort(held.begin(), held.end());
  const std::vector<int> inner = complement(full.map.size(), held);
  SparseFactor factor(restrict_to(full.K, inner));
  factor.factorise(restrict_to(full.K, inner));
  const Excitations forces = excitations(*data.analyses.response, built);
  const BaseMotion base = base_motion(built.model, full, inner, {0, 0, 0});
  const Eigen::VectorXd tap = gather(full.map, forces.loads.force.col(1))(inner);
  for (const auto& [load, right] :
       {std::pair{6, tap}, std::pair{1, Eigen::VectorXd(base.force.col(1))}}) {
    MatrixXd x = MatrixXd::Zero(full.map.size(), 1);
    x(inner, 0) = factor.solve(right);
    const MatrixXd u = expand(full.map, x);
    const Eigen::VectorXd q = response(s.loads[std::size_t(load)].force);
    const int node = built.sensors[0].node;
    EXPECT_LT((s.recovery[0].rows.topRows<3>() * q - u.middleRows<3>(6 * node)).norm(),
              0.02 * u.middleRows<3>(6 * node).norm())
        << s.loads[std::size_t(load)].name;
    const StressField field = recover_stress(built.model, u);
    for (std::size_t point = 0; point < field.node_of_point.size(); ++point) {
      if (field.node_of_point[point] != node || load != 1) continue;
      EXPECT_LT(
          (s.stresses[0].rows * q - field.shell.middleRows<12>(12 * Eigen::Index(point))).norm(),
          0.05 * field.shell.middleRows<12>(12 * Eigen::Index(point)).norm());
    }
  }
}

TEST(ReducedCase, takes_sensors_into_the_boundary_by_symmetry) {
  const Case data = sample_case();
  const ReducedCase r = reduce_case(data, {.cutoff = 2000, .boundary = {"crown", "left", "right"}},
                                    [](const auto&) {});
  EXPECT_EQ(r.element.node_names, (std::vector<std::string>{"left", "right", "crown"}));
  EXPECT_NE(r.route.find("rotational symmetry"), std::string::npos);
  EXPECT_TRUE(r.certificate.passed)
      << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
  EXPECT_GT(r.certificate.good_up_to, 900);
  try {
    reduce_case(data, {.boundary = {"left", "crwon"}}, [](const auto&) {});
    FAIL() << "no error";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("'crwon'"), std::string::npos) << e.what();
  }
}

TEST(ReducedCase, leaves_out_modes_the_boundary_hardly_feels_and_says_so) {
  const Case data = sample_case();
  const ReducedCase all = reduced(data, 4000);
  const ReducedCase some = reduce_case(
      data, {.cutoff = 4000, .boundary = {}, .least_interface_mass = 5e-3}, [](const auto&) {});
  EXPECT_GT(some.left_out.count, 0);
  EXPECT_EQ(some.element.modal() + some.left_out.count, all.element.modal());
  EXPECT_LT(some.left_out.largest, 5e-3);
  EXPECT_TRUE(some.certificate.passed)
      << (some.certificate.failures.empty() ? "" : some.certificate.failures[0]);
  EXPECT_GT(some.certificate.good_up_to, 500);
  EXPECT_EQ(some.element.recovery[0].rows.cols(), some.element.K.cols());
}

TEST(ReducedCase, of_one_node_below_all_modes_is_a_mass) {
  const ReducedCase r =
      reduce_case(sample_case(), {.cutoff = 1, .boundary = {"left"}}, [](const auto&) {});
  EXPECT_EQ(r.element.modal(), 0);
  EXPECT_TRUE(r.element.K.isZero());
  EXPECT_TRUE(r.certificate.passed)
      << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
  EXPECT_NE(reach_of(r).find("nothing is known of modes"), std::string::npos);
  EXPECT_NE(reach_of(r).find("The case asks for 900.0 Hz"), std::string::npos) << reach_of(r);
}

TEST(ReducedCase, may_be_held_by_supports) {
  Case data = sample_case();
  data.supports.push_back({"bellows.crown[4]", {0, 1, 2}});
  const ReducedCase r = reduced(data);
  EXPECT_TRUE(r.certificate.passed)
      << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
  EXPECT_GT(r.certificate.good_up_to, 500);
}

TEST(ReducedCase, may_have_one_node_alone_or_a_sensor_beside_its_caps) {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"left"}, {"left", "right", "crown"}, {"crown", "right"}}) {
    const ReducedCase r =
        reduce_case(sample_case(), {.cutoff = 2000, .boundary = names}, [](const std::string&) {});
    EXPECT_TRUE(r.certificate.passed)
        << names.size() << ": "
        << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
    EXPECT_EQ(r.element.nodes.size(), names.size());
    EXPECT_TRUE(r.element.K.allFinite());
  }
}

// A superelement of superelements against the unreduced part.
TEST(ReducedCase, may_be_nested) {
  Case data =
      read_case(std::string(PLICA_SOURCE_DIR) + "/cases/dual_assembly/dual_assembly.yaml").data;
  for (Part& part : data.parts)
    if (auto* b = std::get_if<Bellows>(&part.body)) b->mesh = {.around = 16, .arc = 2, .wall = 3};
  data.analyses.reduction = SuperelementsInRun{};
  const ReducedCase r = reduce_case(data, {.cutoff = 1000, .boundary = {"edge_left", "edge_right"}},
                                    [](const auto&) {});
  EXPECT_EQ(r.element.boundary(), 12);
  EXPECT_NE(r.route.find("5 superelements of 3 reductions"), std::string::npos) << r.route;
  EXPECT_TRUE(r.proved) << r.reason;
  EXPECT_TRUE(r.certificate.passed)
      << (r.certificate.failures.empty() ? "" : r.certificate.failures[0]);
  EXPECT_GT(r.certificate.good_up_to, 500);
  const MatrixXd rigid =
      r.element.recovery.at(0).rows * rigid_motions(r.element, r.element.recovery[0].place);
  EXPECT_LT((rigid - MatrixXd::Identity(6, 6)).cwiseAbs().maxCoeff(), 1e-5);
}

// In millimetres the same physics: frequencies, a deflection a thousand times the number.
TEST(ReducedCase, in_millimetres_is_the_same_part) {
  const Superelement s = reduced(sample_case()).element, t = in_millimetres(s);
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> a(s.K, s.M), b(t.K, t.M);
  for (Eigen::Index i = 6; i < s.K.rows(); ++i)
    EXPECT_NEAR(b.eigenvalues()[i] / a.eigenvalues()[i], 1, 1e-8);
  EXPECT_NEAR(t.K(1, 1), 1e-3 * s.K(1, 1), 1e-12 * s.K(1, 1)) << "N/mm";
  EXPECT_NEAR(t.K(4, 4), 1e3 * s.K(4, 4), 1e-9 * s.K(4, 4)) << "N mm";
  EXPECT_NEAR(mass_properties(t).mass, 1e-3 * mass_properties(s).mass, 1e-9) << "t";
  const Eigen::Index n = s.K.rows();
  Eigen::VectorXd q = Eigen::VectorXd::Random(n), p = q;
  for (Eigen::Index i = 0; i < n; ++i) p[i] *= i < 12 ? (i % 6 < 3 ? 1e3 : 1) : std::sqrt(1e3);
  EXPECT_LT(
      (t.recovery[0].rows.topRows<3>() * p - 1e3 * s.recovery[0].rows.topRows<3>() * q).norm(),
      1e-9 * (1e3 * s.recovery[0].rows.topRows<3>() * q).norm());
  EXPECT_LT((t.stresses[0].rows * p - 1e-6 * s.stresses[0].rows * q).norm(),
            1e-9 * (1e-6 * s.stresses[0].rows * q).norm());
}

} // namespace
} // namespace plica::test
