// A reduced case: its certificate, every file read back, and files that are damaged.
#include "tests/bellows_case.hpp"
#include "tests/support/temporary_folder.hpp"

#include "io/superelement_abaqus.hpp"
#include "io/superelement_hdf5.hpp"
#include "io/superelement_labels.hpp"
#include "io/superelement_nastran.hpp"
#include "io/write_superelement.hpp"
#include "model/reduce.hpp"

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
  data.analyses.damping = {.modal = 0.02, .loss_factors = {{"bellows", 0.01}}};
  return data;
}

ReducedCase reduced(const Case& data, double cutoff = 2000) {
  return reduce_case(data, cutoff, [](const std::string&) {});
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

TEST(SuperelementFiles, come_back_as_they_were) {
  const TemporaryFolder folder("superelement");
  const ReducedCase r = reduced(sample_case());
  write_superelement(r, folder.path);
  const Superelement& s = r.element;
  const Superelement own = read_hdf5(folder.path / "superelement.h5");
  EXPECT_EQ(own.name, s.name);
  EXPECT_EQ(own.node_names, s.node_names);
  for (const auto& [a, b] : {std::pair{&own.K, &s.K}, std::pair{&own.M, &s.M},
                             std::pair{&own.C, &s.C}, std::pair{&own.D, &s.D}})
    expect_same(*a, *b, 0);
  for (std::size_t k = 0; k < s.nodes.size(); ++k) EXPECT_EQ(own.nodes[k], s.nodes[k]);
  expect_same(own.recovery.at(0).rows, s.recovery[0].rows, 0);
  const Superelement nastran = read_nastran_deck(folder.path / "superelement.bdf");
  expect_same(nastran.K, s.K, 1e-12);
  expect_same(nastran.M, s.M, 1e-12);
  for (std::size_t k = 0; k < s.nodes.size(); ++k)
    EXPECT_LT((nastran.nodes[k] - s.nodes[k]).norm(), 1e-11);
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
  write_superelement(r, folder.path);
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
  write_whole(h5, "no HDF5");
  EXPECT_NE(message([&] { read_hdf5(h5); }).find("damaged, or no HDF5 file"), std::string::npos);
  std::string text = read_whole(deck);
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
  EXPECT_NE(message([&] { read_hdf5(folder.path / "absent.h5"); }).find("absent.h5"),
            std::string::npos);
  EXPECT_NE(message([&] { write_whole(folder.path / "no" / "such", "x"); }).find("cannot write"),
            std::string::npos);
}

} // namespace
} // namespace plica::test
