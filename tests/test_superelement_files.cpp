// A reduced case: its certificate, every file read back, and files that are damaged.
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/written.hpp"

#include "io/files/files.hpp"
#include "io/report/superelements.hpp"
#include "io/superelements/abaqus.hpp"
#include "io/superelements/hdf5.hpp"
#include "io/superelements/labels.hpp"
#include "io/superelements/matlab.hpp"
#include "io/superelements/matrix_market.hpp"
#include "io/superelements/nastran.hpp"
#include "io/superelements/op4.hpp"
#include "io/tables/certificate_words.hpp"
#include "io/write/write_superelement.hpp"
#include "run/analyses/response.hpp"
#include "run/study/reduce.hpp"
#include "solve/base_motion.hpp"
#include "solve/sparse_factor.hpp"
#include "solve/statics.hpp"
#include "solve/stress.hpp"
#include "words/input_error.hpp"

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include <fstream>

namespace plica::test {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;

Case sample_case() {
  Case data = verification_case("bellows_a", {20, 2, 3}, 4);
  data.caps[0].mass = 0.2;
  const BuiltCase built = build(data);
  const Eigen::Vector3d x = built.model.mesh.nodes[built.model.mesh.rings[40].nodes[3]];
  data.sensors = {{.name = "crown", .at = {x[0], x[1], x[2]}}};
  Force force;
  force.name = "tap";
  force.at = "bellows.crown[4]";
  data.analyses.response = Response{.bases = {1}, .forces = {force}, .band = {5, 900}};
  data.analyses.damping = {.modal = 0.02, .loss_factors = {{"bellows", 0.01}}};
  return data;
}

ReducedCase reduced(const Case& data, double cutoff = 2000) {
  return reduce_case(data, {.cutoff = cutoff, .boundary = {}}, [](const std::string&) {});
}

void expect_same(const MatrixXd& a, const MatrixXd& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      EXPECT_LE(std::abs(a(i, j) - b(i, j)), tolerance * std::abs(b(i, j))) << i << ", " << j;
}

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

// Force over displacement of the sensor by the rows is that of the whole field.
TEST(CertificateReport, escapes_what_did_not_pass_once) {
  ReducedCase r;
  r.element.name = "bellows";
  r.certificate.failures = {"K < 0 at \"left\""};
  const std::string html = certificate_report(r);
  EXPECT_NE(html.find("<li>K &lt; 0"), std::string::npos);
  EXPECT_EQ(html.find("&amp;lt;"), std::string::npos);
}

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

// A superelement of superelements against the unreduced part.
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

// Numbers that are rounding of their row and column are written as zero.
Superelement as_written(Superelement s) {
  const Eigen::VectorXd stiff = s.K.diagonal(), heavy = s.M.diagonal(), damped = s.C.diagonal();
  for (const auto& [A, size] : {std::pair{&s.K, &stiff}, std::pair{&s.M, &heavy},
                                std::pair{&s.C, &damped}, std::pair{&s.D, &stiff}})
    for (Eigen::Index i = 0; i < A->rows(); ++i)
      for (Eigen::Index j = 0; j < A->cols(); ++j)
        if (std::abs((*A)(i, j)) <=
            1e-14 * std::sqrt(std::abs((*size)[i])) * std::sqrt(std::abs((*size)[j])))
          (*A)(i, j) = 0;
  for (Eigen::Vector3d& x : s.nodes) x = (x.array().abs() < 1e-12).select(0, x);
  for (RecoveryRows& r : s.recovery)
    r.rows = (r.rows.array().abs() < 1e-14 * r.rows.cwiseAbs().maxCoeff()).select(0, r.rows);
  return s;
}

TEST(SuperelementFiles, come_back_as_they_were) {
  const TemporaryFolder folder("superelement");
  const ReducedCase r = reduced(sample_case());
  written(folder.path, [&](OutputFolder& out) { write_superelement(r, {}, out); });
  const Superelement s = as_written(r.element);
  const Superelement own = read_hdf5(folder.path / "superelement.h5");
  EXPECT_EQ(own.name, s.name);
  EXPECT_EQ(own.node_names, s.node_names);
  for (const auto& [a, b] : {std::pair{&own.K, &s.K}, std::pair{&own.M, &s.M},
                             std::pair{&own.C, &s.C}, std::pair{&own.D, &s.D}})
    expect_same(*a, *b, 0);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) EXPECT_EQ(own.nodes[k], s.nodes[k]);
  expect_same(own.recovery.at(0).rows, s.recovery[0].rows, 0);
  ASSERT_EQ(own.stresses.size(), s.stresses.size());
  expect_same(own.stresses.at(0).rows, s.stresses[0].rows, 0);
  ASSERT_EQ(own.loads.size(), 7u) << "six base motions and a force";
  for (std::size_t k = 0; k < s.loads.size(); ++k) {
    EXPECT_EQ(own.loads[k].name, s.loads[k].name);
    expect_same(own.loads[k].force, s.loads[k].force, 0);
  }
  const Superelement nastran = read_nastran_deck(folder.path / "superelement.bdf");
  expect_same(nastran.K, s.K, 1e-12);
  expect_same(nastran.M, s.M, 1e-12);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    EXPECT_LT((nastran.nodes[k] - s.nodes[k]).norm(), 1e-11);
  expect_same(nastran.C, s.C, 1e-12);
  expect_same(nastran.D, s.D, 1e-12);
  const auto op4 = read_op4(folder.path / "superelement.op4");
  ASSERT_EQ(op4.size(), 5u);
  expect_same(op4.at("OTMPLICA"), s.recovery[0].rows, 0);
  expect_same(op4.at("KPLICA"), s.K, 0);
  expect_same(op4.at("MPLICA"), s.M, 0);
  expect_same(op4.at("BPLICA"), s.C, 0);
  expect_same(op4.at("K4PLICA"), s.D, 0);
  const Superelement matlab = read_matlab(folder.path / "superelement.mat");
  EXPECT_EQ(matlab.node_names, s.node_names);
  EXPECT_EQ(matlab.units, s.units);
  for (const auto& [a, b] : {std::pair{&matlab.K, &s.K}, std::pair{&matlab.M, &s.M},
                             std::pair{&matlab.C, &s.C}, std::pair{&matlab.D, &s.D}})
    expect_same(*a, *b, 0);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) EXPECT_EQ(matlab.nodes[k], s.nodes[k]);
  const auto [user_k, user_m] = read_abaqus_user_element(s, folder.path / "superelement_user.inp");
  expect_same(user_k, s.K, 0);
  expect_same(user_m, s.M, 0);
  expect_same(read_abaqus_matrix(s, folder.path / "superelement_d.inp"), s.D, 0);
  expect_same(read_abaqus_matrix(s, folder.path / "superelement_k.inp"), s.K, 0);
  expect_same(read_abaqus_matrix(s, folder.path / "superelement_m.inp"), s.M, 0);
  expect_same(read_matrix_market(folder.path / "superelement_k.mtx"), s.K, 0);
  expect_same(read_matrix_market(folder.path / "superelement_m.mtx"), s.M, 0);
  const auto json = nlohmann::json::parse(read_whole(folder.path / "certificate.json"));
  EXPECT_EQ(json["passed"], true);
  const auto sidecar = nlohmann::json::parse(read_whole(folder.path / "superelement.json"));
  EXPECT_EQ(sidecar["coordinates"].size(), std::size_t(s.K.rows()));
  EXPECT_EQ(sidecar["coordinates"][7], "right.uy");
  for (const auto& entry : fs::directory_iterator(folder.path))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST(SuperelementFiles, damaged_are_refused_with_their_name_and_line) {
  const TemporaryFolder folder("superelement_damaged");
  const ReducedCase r = reduced(sample_case(), 500);
  written(folder.path, [&](OutputFolder& out) { write_superelement(r, {}, out); });
  const auto message = [](const auto& read) -> std::string {
    try {
      read();
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "no error";
  };
  const fs::path h5 = folder.path / "superelement.h5", deck = folder.path / "superelement.bdf",
                 matrix = folder.path / "superelement_k.inp";
  std::string bytes = read_whole(h5);
  write_whole(h5, bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("superelement.h5: "), std::string::npos);
  const std::size_t inside =
      bytes.find(std::string(reinterpret_cast<const char*>(&r.element.K(0, 0)), sizeof(double)));
  ASSERT_NE(inside, std::string::npos);
  std::string flipped = bytes;
  flipped[inside + 2] = char(flipped[inside + 2] ^ 1);
  write_whole(h5, flipped);
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("superelement.h5: "), std::string::npos);
  write_whole(h5, "no HDF5");
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("damaged, or no HDF5 file"), std::string::npos);
  std::string text = read_whole(deck);
  write_whole(deck, text.substr(0, text.find('\n', text.size() / 2) + 1));
  EXPECT_NE(message([&] { read_nastran_deck(deck); }).find("is cut off"), std::string::npos);
  text.replace(text.find("DMIG* "), 5, "DMGI*");
  write_whole(deck, text);
  EXPECT_NE(message([&] { read_nastran_deck(deck); }).find("unknown card"), std::string::npos);
  text = read_whole(matrix);
  write_whole(matrix, "101, 1, 101, x, 3\n" + text);
  EXPECT_NE(message([&] { read_abaqus_matrix(r.element, matrix); }).find("k.inp:1: "),
            std::string::npos);
  write_whole(matrix, text + "999, 1, 101, 1, 3\n");
  EXPECT_NE(message([&] { read_abaqus_matrix(r.element, matrix); }).find("has not"),
            std::string::npos);
  const fs::path op4 = folder.path / "superelement.op4", mat = folder.path / "superelement.mat",
                 user = folder.path / "superelement_user.inp";
  text = read_whole(op4);
  write_whole(op4, text.substr(0, text.size() / 3));
  EXPECT_NE(message([&] { read_op4(op4); }).find("superelement.op4:"), std::string::npos);
  text.replace(text.find("E+0"), 2, "Ex");
  write_whole(op4, text);
  EXPECT_NE(message([&] { read_op4(op4); }).find("is not a number"), std::string::npos);
  write_whole(mat, read_whole(mat).substr(0, 100));
  EXPECT_NE(message([&] { read_matlab(mat); }).find("superelement.mat: "), std::string::npos);
  text = read_whole(user);
  write_whole(user, text.substr(0, text.find("*MATRIX, TYPE=MASS")));
  EXPECT_NE(message([&] { read_abaqus_user_element(r.element, user); }).find("mass matrix"),
            std::string::npos);
  EXPECT_NE(message([&] { read_hdf5(folder.path / "absent.h5"); }).find("absent.h5"),
            std::string::npos);
  EXPECT_NE(message([&] {
              write_whole(folder.path / "superelement.h5" / "such", "x");
            }).find("cannot make the folder"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
